//! Multibody mechanisms declared in Rust, simulated with ALF-3F.

mod error;
mod mechanism;
mod model;
mod sink;

pub use error::{ParameterError, UnknownName};
pub use mbs_macros::mechanism;
pub use mechanism::{Mechanism, System};
pub use model::{
    Coordinate, FunctionCost, Model, Part, Quantity, Reaction, Row, RowKind, Segment, Structure,
};
pub use sink::{MatrixSink, TensorSink};
