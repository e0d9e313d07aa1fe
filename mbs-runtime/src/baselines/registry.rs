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

/// Velocities and rows of a mechanism for which Radau is a candidate, at most.
const SMALL: usize = 48;

/// Whether Radau is a candidate of an accuracy.
pub(crate) const fn has_radau<S, const Q: usize, const N: usize, const R: usize>() -> bool
where
    S: System<Q, N, R>,
{
    S::STRUCTURE.velocity_forces && N + R <= SMALL
}

/// The rule of a candidate of an accuracy.
pub(crate) fn accuracy<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    bench: &Bench<S, Q, N, R>,
    settings: &Settings,
) -> Option<Result<AnyRule<S, Q, N, R>, Fault>> {
    match const { has_radau::<S, Q, N, R>() } {
        true => Explicit::projected(bench, settings).or_else(|| Radau::rule(bench, settings)),
        false => Explicit::projected(bench, settings),
    }
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
