//! Values with declared names.

/// Values that a generated struct holds as fields: the [inputs](super::Loads::Inputs) and
/// [outputs](super::Observables::Outputs) of a mechanism, in declared order.
pub trait NamedValues: Copy + PartialEq + core::fmt::Debug + Send + Sync + 'static {
    /// The values that `fill` writes into zeros.
    fn from_values(fill: impl FnOnce(&mut [f64])) -> Self;
    /// Passes the values to `read`.
    fn with_values<T>(&self, read: impl FnOnce(&[f64]) -> T) -> T;
}

/// No values.
impl NamedValues for () {
    fn from_values(_: impl FnOnce(&mut [f64])) -> Self {}

    fn with_values<T>(&self, read: impl FnOnce(&[f64]) -> T) -> T {
        read(&[])
    }
}
