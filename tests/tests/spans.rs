//! Where errors point: the source line, and `~` under what is wrong.

use mbs_macros_core::analyse;

/// Compiles a mechanism with this line among its entries. It is wrong, and the only message points at the marked tokens
/// and contains `message`.
fn points_at(line: &str, marks: &str, message: &str) {
    for (others, ready) in [
        (PENDULUM, line.contains("bar.") || line.contains("bar,")),
        (ALONE, true),
    ] {
        if ready {
            check(others, line, marks, message);
            return;
        }
    }
}

/// What the lines may refer to.
const PENDULUM: &str = "world: Planar(gravity = [0.0, -9.81_m_per_s2]),
bar: Bar(mass = 1.0_kg, length = 1.0_m),
pivot: Revolute(ground.origin, bar.a),
";

/// The same without what a line declares anew.
const ALONE: &str = "world: Planar(gravity = [0.0, -9.81_m_per_s2]),
";
