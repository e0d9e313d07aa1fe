//! The numbers that are kept of a run at an instant.

use mbs_runtime::Model;

use super::probe::{Instant, Probe};

/// A number of a run at an instant. Joints, components, outputs and rows are named as the model names them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// T + V, J.
    Energy,
    /// Its error, J.
    EnergyError,
    /// An output.
    Output(&'static str),
    /// A reaction at the instant, from the equations at acceleration level.
    Reaction(&'static str, &'static str),
    /// The largest reaction since the last instant. Each is the mean over a step and follows from the change of
    /// momentum.
    StepReaction(&'static str, &'static str),
    /// The same for the reactions that the method applied, from its multipliers.
    OwnPeak(&'static str, &'static str),
    /// A reaction that the method applied in the last step.
    Own(&'static str, &'static str),
    /// φ of a row.
    Row(&'static str),
    /// φ̇ of a row.
    Rate(&'static str),
    /// m̄ of a row.
    Mass(&'static str),
    /// The shortest step of Algorithm 1 since the instant before, s.
    Step,
    /// The largest penalty of a row since the instant before.
    Penalty(&'static str),
}

impl Column {
    /// Name in the heading of a file.
    pub fn name(&self) -> String {
        match self {
            Column::Energy => "energy_J".to_owned(),
            Column::EnergyError => "energy_error_J".to_owned(),
            Column::Output(name) => (*name).to_owned(),
            Column::Reaction(joint, component) => format!("{joint}.{component}"),
            Column::StepReaction(joint, component) => format!("step {joint}.{component}"),
            Column::OwnPeak(joint, component) => format!("own peak {joint}.{component}"),
            Column::Own(joint, component) => format!("own {joint}.{component}"),
            Column::Row(row) => format!("phi {row}"),
            Column::Rate(row) => format!("rate {row}"),
            Column::Mass(row) => format!("mass {row}"),
            Column::Step => "step_s".to_owned(),
            Column::Penalty(row) => format!("penalty {row}"),
        }
    }

    /// Whether it needs the state after each step.
    pub fn is_of_steps(&self) -> bool {
        matches!(
            self,
            Column::StepReaction(..) | Column::OwnPeak(..) | Column::Step | Column::Penalty(_)
        )
    }

    /// Whether it compares the ends of a step.
    pub fn is_of_a_force(&self) -> bool {
        matches!(
            self,
            Column::StepReaction(..) | Column::OwnPeak(..) | Column::Own(..)
        )
    }
}

/// Collects the numbers during a run.
pub struct Numbers<'a> {
    columns: &'a [Column],
    /// For columns that depend on steps: the value for the steps since the last instant.
    steps: Vec<Option<f64>>,
}

impl<'a> Numbers<'a> {
    /// Before the first step.
    pub fn new(columns: &'a [Column]) -> Self {
        Numbers {
            columns,
            steps: vec![None; columns.len()],
        }
    }

    /// Records a step.
    pub fn step(&mut self, probe: &dyn Probe, before: Option<&Instant>) {
        let model = probe.model();
        let (shortest, penalties) = probe.algorithm();
        let wants = |kind: fn(&Column) -> bool| self.columns.iter().any(kind);
        let mean = before
            .filter(|_| wants(|c| matches!(c, Column::StepReaction(..))))
            .map(|before| probe.mean_reactions(before));
        let own = before.and_then(|before| probe.own_reactions(before));
        for (column, kept) in self.columns.iter().zip(&mut self.steps) {
            match column {
                Column::Step if shortest > 0.0 => {
                    *kept = Some(kept.unwrap_or(f64::INFINITY).min(shortest));
                }
                Column::Penalty(row) if shortest > 0.0 => {
                    let value = index(model, row).and_then(|i| penalties.get(i).copied());
                    *kept = value.map(|value| kept.unwrap_or(0.0).max(value));
                }
                Column::StepReaction(joint, component) => {
                    keep_largest(kept, reaction(model, joint, component, mean.as_deref()));
                }
                Column::OwnPeak(joint, component) => {
                    keep_largest(kept, reaction(model, joint, component, own.as_deref()));
                }
                Column::Own(joint, component) => {
                    *kept = reaction(model, joint, component, own.as_deref());
                }
                _ => {}
            }
        }
    }

    /// The numbers at this instant; `None` if the method does not have a number. Then the record of steps is cleared.
    pub fn look(&mut self, probe: &dyn Probe) -> Vec<Option<f64>> {
        let model = probe.model();
        let wants = |kind: fn(&Column) -> bool| self.columns.iter().any(kind);
        let rows = wants(|c| matches!(c, Column::Row(_) | Column::Rate(_))).then(|| probe.rows());
        let masses = wants(|c| matches!(c, Column::Mass(_))).then(|| probe.effective_masses());
        let reactions = wants(|c| matches!(c, Column::Reaction(..)))
            .then(|| probe.reactions().ok())
            .flatten();
        let energy = probe.energy();
        let outputs = probe.outputs();
        let of_row = |values: Option<&Vec<f64>>, row: &str| {
            values.and_then(|values| values.get(index(model, row)?).copied())
        };
        let steps = std::mem::replace(&mut self.steps, vec![None; self.columns.len()]);
        let value = |(column, kept): (&Column, Option<f64>)| match column {
            Column::Energy => Some(energy.kinetic + energy.potential),
            Column::EnergyError => Some(energy.error),
            Column::Output(name) => {
                let at = model.outputs.iter().position(|output| output.name == *name);
                at.and_then(|at| outputs.get(at).copied())
            }
            Column::Reaction(joint, component) => {
                let values = reactions.as_ref().map(|found| found.values.as_slice());
                reaction(model, joint, component, values)
            }
            Column::Row(row) => of_row(rows.as_ref().map(|[phi, _]| phi), row),
            Column::Rate(row) => of_row(rows.as_ref().map(|[_, rate]| rate), row),
            Column::Mass(row) => of_row(masses.as_ref(), row),
            Column::StepReaction(..)
            | Column::OwnPeak(..)
            | Column::Own(..)
            | Column::Step
            | Column::Penalty(_) => kept,
        };
        self.columns.iter().zip(steps).map(value).collect()
    }
}

fn index(model: &Model, row: &str) -> Option<usize> {
    model.rows.iter().position(|known| known.name == row)
}

fn reaction(model: &Model, joint: &str, component: &str, values: Option<&[f64]>) -> Option<f64> {
    let named = |r: &mbs_runtime::Reaction| r.joint == joint && r.component == component;
    values?
        .get(model.reactions.iter().position(named)?)
        .copied()
}

fn keep_largest(kept: &mut Option<f64>, value: Option<f64>) {
    if let Some(value) = value
        && !(kept.unwrap_or(0.0).abs() > value.abs())
    {
        *kept = Some(value);
    }
}
