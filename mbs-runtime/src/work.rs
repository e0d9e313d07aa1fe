//! Operations of stages, from the counts of the generated functions: an estimate by which methods are compared.

use crate::{Flow, Method, Model, Report, Settings};

/// What a stage, or a correction, costs beside its functions: calls, copies, comparisons.
const STAGE: f64 = 60.0;

/// A counted operation of an implicit flow takes so many times as long as one of an explicit method: the iterations of the flow
/// are not counted, and its matrices are not of constants. On five scenes with such flows 2.4 to 3.7 was measured, on eight
/// scenes with the leapfrog flow 0.5 to 0.9.
const IMPLICIT: f64 = 3.0;

/// The same for Radau, whose matrices are not of constants. On seven scenes 1.0 to 2.6 was measured.
const COLLOCATION: f64 = 1.5;

/// The part of the steps of Radau that make new factors.
const RENEWED: f64 = 0.5;

/// The operations of a stage and of a correction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Work {
    stage: f64,
    correction: f64,
}

impl Work {
    /// Of a method; `planned` are the operations of a factor and of a solution where the elimination is planned.
    pub(crate) fn of(
        model: &Model,
        settings: &Settings,
        flow: Flow,
        planned: Option<[u64; 2]>,
    ) -> Self {
        let (n, r) = (model.velocities.len() as f64, model.rows.len() as f64);
        let of = |name: &str| model.cost_of(name).map(|cost| cost as f64);
        let cost = |name: &str| of(name).unwrap_or(0.0);
        let constraints = cost("constraints");
        let metric =
            || of("metric").unwrap_or(cost("solve_mass_rows") + cost("delassus") + 2.0 * r * r);
        // Of a dense elimination with its metric, or of a planned one with its products; a solution; products with A.
        let (metric, elimination, solution, products) = match planned {
            Some([factor, solution]) => (0.0, factor as f64, solution as f64, 0.0),
            None => (metric(), r * r * r / 3.0, 2.0 * r * r, 4.0 * n * r),
        };
        let tangents = || of("balance_tangents").unwrap_or(cost("force_tangents"));
        let balance = || of("balance").unwrap_or(cost("forces"));
        let (stage, correction) = match (settings.method, flow) {
            (Method::Projected, _) => {
                let dense = constraints
                    + metric
                    + cost("constraint_rates")
                    + of("free_forces").unwrap_or(cost("forces"))
                    + elimination
                    + solution
                    + products;
                let written = ["partitioned_accelerations", "accelerations"].map(of);
                let mut written = written.into_iter().flatten().filter(|&cost| cost > 0.0);
                (written.next().unwrap_or(dense), constraints)
            }
            (Method::Radau, _) => {
                let size = n + r;
                let real = 2.0 / 3.0 * n * n * n + 2.0 * n * r * (n + r) + elimination;
                let factors = tangents() + real + 8.0 / 3.0 * size * size * size;
                let end = constraints + metric + elimination + 2.0 * solution + products;
                let stage = (RENEWED * factors + end) / 3.0;
                let correction = 3.0 * (constraints + balance()) + 10.0 * size * size + products;
                (COLLOCATION * stage, COLLOCATION * correction)
            }
            (_, Flow::Leapfrog) => (
                constraints + metric + cost("acceleration") + 3.0 * elimination + 2.0 * products,
                constraints + solution + 0.5 * products,
            ),
            _ => {
                let factor = 2.0 / 3.0 * n * n * n;
                let stage = constraints
                    + metric
                    + tangents()
                    + factor
                    + 2.0 * n * n * r
                    + 3.0 * elimination;
                let correction = constraints + balance() + 2.0 * n * n + solution + products;
                (IMPLICIT * stage, IMPLICIT * correction)
            }
        };
        Work {
            stage: stage + STAGE,
            correction: correction + STAGE,
        }
    }

    /// Of the stages and corrections between two reports of a run.
    pub(crate) fn between(&self, before: &Report, after: &Report) -> f64 {
        let stages = after.stages - before.stages;
        let corrections = after.iterations - before.iterations;
        stages as f64 * self.stage + corrections as f64 * self.correction
    }
}
