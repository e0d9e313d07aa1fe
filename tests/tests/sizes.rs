//! Nothing is zero because it is small in metres: of a mechanism in all sizes the coordinates and rows are the same, and the start
//! is in proportion.

use mbs_macros_core::Analysis;
use mbs_macros_core::symbolic::{Evaluator, Symbol};
use mbs_tests::interpreted::analysis;

const SIZES: [f64; 4] = [1e-9, 1e-6, 1.0, 1e6];

/// A mechanism in space, in joint coordinates, with these entries, beside an arm as long as its size.
fn beside_an_arm(size: f64, entries: &str) -> Analysis {
    analysis(&format!(
        "Sized {{ world: Spatial(coordinates = Joint), size: Param({size:e}_m),
        arm: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [size, 0.0, 0.0]),
        pin: Revolute(ground, arm, at = [0.0, 0.0, 0.0], axis = Z), {entries} }}"
    ))
}

/// A body that slides from the origin along x, at a place.
fn slider(name: &str, place: &str) -> String {
    format!(
        "{name}: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [{place}, 0.0, 0.0]),
        guide_of_{name}: Prismatic(ground.origin, {name}.origin, axis = X),"
    )
}

/// The value at which a coordinate or velocity starts, with these values of the parameters.
fn start(analysis: &Analysis, name: &str, parameters: &[f64]) -> f64 {
    let system = &analysis.derived.system;
    let mut stored = system
        .layout
        .coordinates
        .iter()
        .chain(&system.layout.velocities);
    let stored = stored.find(|stored| stored.name == name).expect("its name");
    let symbols = |symbol| match symbol {
        Symbol::Parameter(index) => parameters[index as usize],
        other => panic!("{other:?} is not known from parameters"),
    };
    let laws = |_: u32, _: &[f64]| unreachable!();
    Evaluator::new(&system.graph, &symbols, &laws).value(stored.guess)
}

/// The rows that are left, and those that were solved.
fn rows(analysis: &Analysis) -> (Vec<&str>, Vec<&str>) {
    let rows = analysis.derived.system.rows.iter();
    let solved = analysis.outline.solved.iter();
    (
        rows.map(|row| row.entry.as_str()).collect(),
        solved.map(String::as_str).collect(),
    )
}

fn near(found: f64, wanted: f64) {
    assert!(
        (found - wanted).abs() <= 1e-12 * wanted.abs(),
        "{found:e} instead of {wanted:e}"
    );
}

#[test]
fn strokes_start_in_proportion() {
    for size in SIZES {
        let small = beside_an_arm(size, &slider("a", &format!("{:e}_m", 5e-4 * size)));
        near(start(&small, "guide_of_a.stroke", &[size]), 5e-4 * size);
    }
}

#[test]
fn rounding_is_no_stroke() {
    for size in SIZES {
        let [one, two, three] = [0.1, 0.2, 0.3].map(|x| format!("{:e}_m", x * size));
        let rounded = beside_an_arm(size, &slider("a", &format!("{one} + {two} - {three}")));
        assert_eq!(start(&rounded, "guide_of_a.stroke", &[size]), 0.0);
    }
}

/// The stroke is zero with the defaults, and not with other values.
#[test]
fn parameters_with_the_same_default_are_different() {
    for (stroke, [a, b]) in [
        ("a - b", [0.5, 0.3]),
        ("max(a - b, 0.0_m)", [0.5, 0.3]),
        ("max(b - a, 0.0_m)", [0.3, 0.5]),
    ] {
        let entries = format!("a: Param(0.3_m), b: Param(0.3_m), {}", slider("c", stroke));
        let equal = beside_an_arm(1.0, &entries);
        near(start(&equal, "guide_of_c.stroke", &[1.0, a, b]), 0.2);
    }
}

/// Without an angular velocity the nearest velocities that the joint allows: J + m l² is 1.3 m l².
#[test]
fn velocities_start_in_proportion() {
    for size in SIZES {
        let turning = analysis(&format!(
            "Turning {{ world: Spatial(coordinates = Joint), size: Param({size:e}_m), mass: Let(1.0_kg),
            arm: Body(mass = mass, inertia = mass * size.powi(2) * diag(0.1, 0.2, 0.3), at = [size, 0.0, 0.0],
                velocity = [0.0, {:e}_m_per_s, 0.0]),
            pin: Revolute(ground, arm, at = [0.0, 0.0, 0.0], axis = Z) }}",
            5e-3 * size
        ));
        near(start(&turning, "pin.angle'", &[size]), 5e-3 / 1.3);
    }
}

#[test]
fn a_start_that_contradicts_a_row_does_so_in_all_sizes() {
    for size in SIZES {
        let place = format!("{:e}_m", 5e-4 * size);
        let tie = "tie: Holonomic(guide_of_a.stroke - guide_of_b.stroke)";
        let tied = |other: &str| {
            let sliders = slider("a", &place) + &slider("b", other);
            beside_an_arm(size, &(sliders + tie))
        };
        assert_eq!(rows(&tied("0.0")), (vec!["tie"], vec![]), "{size}");
        assert_eq!(rows(&tied(&place)), (vec![], vec!["tie"]), "{size}");
    }
}

#[test]
fn rows_with_small_coefficients_are_solved() {
    for size in SIZES {
        let tied = analysis(&format!(
            "Tied {{ world: Planar(coordinates = Reference), a: Bar(mass = 1.0_kg, length = {size:e}_m),
            b: Bar(mass = 1.0_kg, length = {size:e}_m), p: Revolute(ground.origin, a.a), q: Revolute(ground.origin, b.a),
            tie: Holonomic({0:e}_m * a.angle - {0:e}_m * b.angle) }}",
            5e-4 * size
        ));
        assert_eq!(rows(&tied).1, ["tie"], "{size}");
    }
}

/// A square of a small length is no zero.
#[test]
fn a_distance_squared_is_a_row_in_all_sizes() {
    for size in SIZES {
        let tied = analysis(&format!(
            "Tied {{ world: Planar(coordinates = Joint), a: Bar(mass = 1.0_kg, length = {size:e}_m, angle = 50.0_deg),
            b: Bar(mass = 1.0_kg, length = {size:e}_m, angle = 100.0_deg), p: Revolute(ground.origin, a.a),
            q: Revolute(ground.point({size:e}_m, 0.0), b.a),
            tie: Holonomic((a.b.x - b.b.x).powi(2) + (a.b.y - b.b.y).powi(2) - ({size:e}_m).powi(2)) }}"
        ));
        assert_eq!(rows(&tied).0, ["tie"], "{size}");
    }
}

/// With other values of the parameters, too, as far as there is a root.
#[test]
fn a_second_hinge_is_vacuous_in_all_sizes() {
    for size in SIZES {
        let door = analysis(&format!(
            "Door {{ world: Spatial(coordinates = Joint), l: Param({:e}_m), h: Param({:e}_m),
            x: Let((l.powi(2) - (2.0 * h).powi(2)).sqrt()), n: Let(unit([1.0, 2.0, 0.5])),
            door: Body(mass = 1.0_kg, inertia = diag(0.1, 0.2, 0.3), at = [x, 0.0, 0.0]),
            low: Revolute(ground, door, at = [x, 0.0, 0.0], axis = n),
            high: Revolute(ground, door, at = [x, 0.0, 0.0] + x * n, axis = n) }}",
            1.2 * size,
            0.5 * size
        ));
        assert_eq!(rows(&door).0, [""; 0], "{size}");
    }
}
