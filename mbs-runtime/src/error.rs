//! Errors of the runtime: what happened, where (joint, row, parameter, time), and what to do.

#[cfg(feature = "std")]
#[path = "error/unknown_name.rs"]
mod unknown_name;
#[cfg(not(feature = "std"))]
#[path = "error/unlisted_name.rs"]
mod unknown_name;

pub use unknown_name::UnknownName;

use core::fmt;

/// Parameters that do not make a mechanism.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ParameterError {
    /// A parameter is NaN or infinite.
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A mass or inertia is negative.
    Negative {
        /// The entry.
        entry: &'static str,
        /// Its argument.
        argument: &'static str,
        /// Its value.
        value: f64,
    },
    /// A length is zero or negative.
    NotPositive {
        /// The entry.
        entry: &'static str,
        /// Its argument.
        argument: &'static str,
        /// Its value.
        value: f64,
        /// Why it has to be positive.
        because: &'static str,
    },
    /// M is not positive definite: a motion has no mass.
    MassNotPositive {
        /// The coordinate at which the factorisation met a pivot that is not positive.
        coordinate: &'static str,
    },
    /// An inertia tensor is not positive definite.
    InertiaNotPositive {
        /// The body.
        body: &'static str,
        /// Its principal moments, kg m².
        moments: [f64; 3],
    },
    /// A principal moment exceeds the sum of the other two.
    InertiaTriangle {
        /// The body.
        body: &'static str,
        /// Its principal moments, kg m².
        moments: [f64; 3],
    },
    /// The arguments of a table do not increase.
    TableNotIncreasing {
        /// The table.
        table: &'static str,
        /// The index of the argument that is not larger than the one before, from 0 on.
        index: usize,
        /// This argument.
        argument: f64,
        /// The one before.
        before: f64,
    },
    /// A table that is repeated does not end with the value with which it begins.
    TableNotPeriodic {
        /// The table.
        table: &'static str,
        /// The first and the last value.
        ends: [f64; 2],
    },
    /// The curve through the points of a table is not finite.
    TableNotFinite {
        /// The table.
        table: &'static str,
    },
}

impl fmt::Display for ParameterError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ParameterError::NotFinite { name, value } => {
                write!(out, "parameter `{name}` is {value}; give it a finite value")
            }
            ParameterError::Negative {
                entry,
                argument,
                value,
            } => write!(
                out,
                "`{argument}` of `{entry}` is negative ({value}); give it a positive value"
            ),
            ParameterError::NotPositive {
                entry,
                argument,
                value,
                because,
            } => write!(out, "`{argument}` of `{entry}` is {value}: {because}"),
            ParameterError::MassNotPositive { coordinate } => write!(
                out,
                "the mass matrix is not positive definite at coordinate `{coordinate}`: give the parts that move with it a positive mass and inertia"
            ),
            ParameterError::InertiaNotPositive { body, moments } => write!(
                out,
                "the inertia of `{body}` is not positive definite: its principal moments are {} kg m²; all three have to be positive",
                List(moments)
            ),
            ParameterError::InertiaTriangle { body, moments } => write!(
                out,
                "no body has the inertia of `{body}`: its principal moments are {} kg m², and none of them may exceed the sum of the other two",
                List(moments)
            ),
            ParameterError::TableNotIncreasing {
                table,
                index,
                argument,
                before,
            } => write!(
                out,
                "the arguments of the table `{table}` have to increase, but the one of index {index} is {argument}, and the one before it {before}; give a larger one"
            ),
            ParameterError::TableNotPeriodic { table, ends } => write!(
                out,
                "the periodic table `{table}` begins with the value {} and ends with {}: give both the same value",
                ends[0], ends[1]
            ),
            ParameterError::TableNotFinite { table } => write!(
                out,
                "the curve through the points of the table `{table}` is not finite: give smaller values, or arguments farther apart"
            ),
        }
    }
}

/// Three numbers as text.
struct List<'a>(&'a [f64; 3]);

impl fmt::Display for List<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let List([a, b, c]) = self;
        write!(out, "{a:.6}, {b:.6} and {c:.6}")
    }
}

impl core::error::Error for ParameterError {}
