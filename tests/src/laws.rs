//! Laws of the fixtures: value and partials, called by compiled code and by the interpreters alike.

use mbs_macros_core::model::Law;
use quote::ToTokens;

/// A stiffening spring with a little damping: tension of [length, rate].
pub fn stiffening([length, rate]: [f64; 2]) -> (f64, [f64; 2]) {
    let stretch = length - 0.5;
    (
        40.0 * stretch + 9.0 * stretch.powi(3) + 0.3 * rate * length,
        [40.0 + 27.0 * stretch.powi(2) + 0.3 * rate, 0.3 * length],
    )
}

/// A torque against turning: of [angle, rate].
pub fn saturating([angle, rate]: [f64; 2]) -> (f64, [f64; 2]) {
    let tanh = (2.0 * rate).tanh();
    (0.7 * angle + 0.2 * tanh, [0.7, 0.4 * (1.0 - tanh * tanh)])
}

/// Three arguments, as called by `law(…)` in an expression.
pub fn blend([x, y, z]: [f64; 3]) -> (f64, [f64; 3]) {
    (
        x * y + (z * x).sin(),
        [y + z * (z * x).cos(), x, x * (z * x).cos()],
    )
}

/// Evaluates the law that a declaration names.
pub fn call(law: &Law, arguments: &[f64]) -> (f64, Vec<f64>) {
    fn with<const K: usize>(
        function: fn([f64; K]) -> (f64, [f64; K]),
        arguments: &[f64],
    ) -> (f64, Vec<f64>) {
        let (value, partials) = function(arguments.try_into().expect("as many as declared"));
        (value, partials.to_vec())
    }
    let path = law.path.to_token_stream().to_string();
    match path.rsplit("::").next().map(str::trim) {
        Some("stiffening") => with(stiffening, arguments),
        Some("saturating") => with(saturating, arguments),
        Some("blend") => with(blend, arguments),
        _ => panic!("the interpreters do not know the law `{path}`"),
    }
}
