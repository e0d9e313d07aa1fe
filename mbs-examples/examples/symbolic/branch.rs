//! Where a motion should end.

use mbs_examples::reference::ReferenceTable;
use mbs_runtime::Model;
use mbs_runtime::output::Frame;

/// A run that ends this far away, m or rad, is on another branch.
const ASTRAY: f64 = 0.3;

/// A name in which the number of a member of a family is written like a part of it: `crank2.b` for `crank[2].b`.
pub fn without_brackets(name: &str) -> String {
    name.replace(['[', ']'], "")
}

/// What the end of a run is compared with.
pub enum Branch {
    /// The angle of the crank, whose rods are mirror images.
    SliderCrank(f64),
    /// The angle of all cranks, which stand one metre apart.
    Cranks(f64),
    /// A table, in these columns.
    Reference(ReferenceTable, &'static [&'static str]),
}

impl Branch {
    /// Whether a run that ends with these points and outputs at this time is on the branch.
    pub fn holds(&self, model: &Model, time: f64, points: &[[f64; 3]], outputs: Vec<f64>) -> bool {
        if let Branch::Reference(table, columns) = self {
            return near_reference(table, columns, time, outputs);
        }
        let mut compared = 0;
        for (name, point) in model.points.iter().zip(points) {
            let Some([x, y]) = self.expected(name) else {
                continue;
            };
            compared += 1;
            if !((point[0] - x).hypot(point[1] - y) < ASTRAY) {
                return false;
            }
        }
        compared > 0
    }

    /// Where a point should be, m.
    fn expected(&self, name: &str) -> Option<[f64; 2]> {
        match self {
            Branch::SliderCrank(angle) => match name {
                "crank.b" => Some([angle.cos(), angle.sin()]),
                "rod.b" => Some([2.0 * angle.cos(), 0.0]),
                _ => None,
            },
            Branch::Cranks(angle) => {
                let name = without_brackets(name);
                let number = name.strip_prefix("crank")?.strip_suffix(".b")?;
                let base: f64 = number.parse().ok()?;
                Some([base + angle.cos(), angle.sin()])
            }
            Branch::Reference(..) => None,
        }
    }
}

fn near_reference(table: &ReferenceTable, columns: &[&str], time: f64, outputs: Vec<f64>) -> bool {
    let frame = Frame {
        time,
        outputs,
        ..Frame::default()
    };
    let deviations = table.compare(&[frame]);
    let mut compared = deviations
        .iter()
        .filter(|deviation| columns.contains(&deviation.column))
        .peekable();
    compared.peek().is_some()
        && compared.all(|deviation| deviation.at_end.is_some_and(|off| off < ASTRAY))
}
