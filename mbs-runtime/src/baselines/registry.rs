//! The rules by the method of the settings.

use super::adaptive::Adaptive;
use super::baumgarte::Explicit;
use super::bdf::Bdf;
use super::bench::Bench;
use super::generalized_alpha::GeneralizedAlpha;
use super::index3_projections::Index3;
use super::penalty::Penalty;
use super::radau::Radau;
use super::rattle::Rattle;
use super::rule::{AnyRule, MakeRule};
use crate::fault::Fault;
use crate::{Settings, System};

/// The rule of Baumgarte's method, with constant steps or with a tolerance.
pub(crate) fn baumgarte<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &Bench<S, Q, N, R>,
    settings: &Settings,
) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
    Explicit::stabilised(bench, settings).or_else(|| Adaptive::rule(bench, settings))
}

/// The rule of any baseline.
pub(crate) fn any<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &Bench<S, Q, N, R>,
    settings: &Settings,
) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
    let makes: [MakeRule<S, Q, N, R>; 8] = [
        Explicit::projected,
        baumgarte,
        Rattle::rule,
        Penalty::rule,
        Index3::rule,
        GeneralizedAlpha::rule,
        Bdf::rule,
        Radau::rule,
    ];
    makes.iter().find_map(|make| make(bench, settings))
}
