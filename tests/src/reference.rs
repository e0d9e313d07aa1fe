//! The thinned reference tables in `tests/reference/`.

use mbs_examples::scene::Scene;
use mbs_runtime::AnySimulation;
use std::path::Path;

/// A table of reference values.
#[derive(Debug, Clone)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<f64>>,
}

/// Reads a table; a missing table is a failure, and does not skip a test.
pub fn table(file: &str) -> Table {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("reference")
        .join(file);
    let text = std::fs::read_to_string(&path)
        .unwrap_or_else(|error| panic!("{}: {error} (see the README beside it)", path.display()));
    let mut lines = text.lines();
    let header = lines
        .next()
        .expect("a header")
        .split(',')
        .map(str::to_owned)
        .collect();
    let row = |line: &str| -> Vec<f64> {
        line.split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect()
    };
    Table {
        header,
        rows: lines.map(row).collect(),
    }
}

impl Table {
    /// A column by name.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let index = self.header.iter().position(|other| other == name);
        let index = index.unwrap_or_else(|| panic!("no column `{name}` in {:?}", self.header));
        self.rows.iter().map(|row| row[index]).collect()
    }

    /// The instants.
    pub fn times(&self) -> Vec<f64> {
        self.column("time_s")
    }
}

/// The largest deviation of any compared output at any instant up to `until`.
pub fn deviation(
    simulation: &mut dyn AnySimulation,
    scene: &Scene,
    table: &Table,
    until: f64,
) -> f64 {
    let reference = scene.reference.as_ref().expect("checked by the caller");
    let columns: Vec<(usize, Vec<f64>)> = reference
        .columns
        .iter()
        .map(|(output, column)| {
            let index = scene
                .model
                .outputs
                .iter()
                .position(|other| other.name == *output);
            (index.expect("an output of the scene"), table.column(column))
        })
        .collect();
    let mut largest: f64 = 0.0;
    for (row, time) in table.times().into_iter().enumerate() {
        if time > until * (1.0 + 1e-12) {
            break;
        }
        simulation.run_until(time).expect(scene.name);
        let outputs = simulation.outputs();
        for (index, values) in &columns {
            let error = (outputs[*index] - values[row]).abs();
            assert!(error.is_finite(), "{}", scene.name);
            largest = largest.max(error);
        }
    }
    largest
}
