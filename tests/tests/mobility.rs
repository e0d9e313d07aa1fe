//! Rank, degrees of freedom and redundant rows, told at compile time by the names of the declaration.

use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

// Three parallel cranks carry one coupler: the third holds nothing that the other two do not hold already, as long as all
// are parallel. Counting says zero degrees of freedom.
mechanism!(ThreeCranks {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    middle: Param(1.0_m),
    left: Bar(
        mass = 1.0_kg,
        length = length,
        angle = 60.0_deg,
        rate = 1.0_rad_per_s
    ),
    right: Bar(
        mass = 1.0_kg,
        length = length,
        angle = 60.0_deg,
        rate = 1.0_rad_per_s
    ),
    coupler: Bar(mass = 1.0_kg, length = 2.0_m),
    bearing_left: Revolute(ground.origin, left.a),
    bearing_right: Revolute(ground.point(2.0_m, 0.0), right.a),
    pin_left: Revolute(left.b, coupler.a),
    pin_right: Revolute(right.b, coupler.b),
    third: Distance(ground.point(middle, 0.0), coupler.center, length = length),
    tip: Output(left.b),
});

#[test]
fn a_third_parallel_crank_is_redundant() {
    let mobility = ThreeCranks::MODEL.mobility.expect("it assembles");
    assert_eq!(
        (
            ThreeCranks::MODEL.coordinates.len(),
            ThreeCranks::MODEL.rows.len()
        ),
        (4, 4)
    );
    assert_eq!((mobility.rank, mobility.degrees_of_freedom), (3, 1));
    let [redundancy] = mobility.redundant else {
        panic!("{mobility:?}")
    };
    assert_eq!(redundancy.row, "third");
    assert_eq!(redundancy.follows_from, ["left", "right"]);
}

#[test]
fn a_redundant_row_is_ordinary_input() {
    let settings = Settings {
        step: 5e-4,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::with_settings(ThreeCranks::default(), settings).expect("it assembles");
    assert_eq!(simulation.assembly().rank, 3);
    simulation.run_until(2.0).expect("it runs");
    let report = simulation.report();
    assert!(report.energy_error < 1e-4, "{report:?}");
    assert!(report.holonomic_error < 1e-10, "{report:?}");
    // The parallelogram branch: the coupler does not turn.
    let (x, y) = (
        simulation.output("tip.x").unwrap(),
        simulation.output("tip.y").unwrap(),
    );
    assert!((x.hypot(y) - 1.0).abs() < 1e-10);
    assert!(!simulation.reactions().expect("there are reactions").unique);
}

#[test]
fn the_rank_is_that_of_the_parameters() {
    // A third crank elsewhere locks the mechanism: assembly says so for the actual parameters.
    let verdict = Simulation::new(ThreeCranks {
        middle: 1.1,
        ..ThreeCranks::default()
    });
    assert!(verdict.is_err() || verdict.is_ok_and(|simulation| simulation.assembly().rank == 4));
}

#[test]
fn singular_starts_do_not_count() {
    // The double four-bar with horizontal bars would have rank 3 there; its rank is 5.
    for scene in mbs_examples::scenes::scenes() {
        let mobility = scene
            .model
            .mobility
            .unwrap_or_else(|| panic!("{} does not assemble", scene.name));
        let redundant = match scene.name {
            // Overconstrained by nature: six revolutes in a ring, two universal joints between fixed bearings.
            "bricard" | "bricard-slender" | "bricard-reference" | "cardan-shaft" => 1,
            _ => 0,
        };
        assert_eq!(mobility.redundant.len(), redundant, "{}", scene.name);
        let rank = scene.model.rows.len() - redundant;
        assert_eq!(mobility.rank, rank, "{}", scene.name);
    }
}

/// Which joints a redundant row depends on, and how many degrees of freedom are left where counting gives none.
#[test]
fn overconstrained_mechanisms_of_space_move() {
    let scenes = mbs_examples::scenes::scenes();
    let all = ["j1", "j2", "j3", "j4", "j5", "j6"];
    let shafts = ["cross1", "cross2"];
    for (name, size, last, joints) in [
        ("bricard-reference", 30, "j6", &all[..]),
        // Five of the six joints are coordinates; the one that closes the loop says too much by itself.
        ("bricard", 5, "j4", &["j4"][..]),
        ("bricard-slender", 5, "j4", &["j4"][..]),
        ("cardan-shaft", 8, "cross2", &shafts[..]),
    ] {
        let scene = scenes.iter().find(|scene| scene.name == name).expect(name);
        let model = scene.model;
        assert_eq!((model.velocities.len(), model.rows.len()), (size, size));
        let mobility = model.mobility.expect(name);
        assert_eq!((mobility.rank, mobility.degrees_of_freedom), (size - 1, 1));
        let [redundancy] = mobility.redundant else {
            panic!("{name}: {mobility:?}")
        };
        // Of dependent rows the last is named, and it closes the whole loop.
        assert!(redundancy.row.starts_with(last), "{name}: {redundancy:?}");
        assert_eq!(redundancy.follows_from, joints, "{name}");
        let settings = Settings {
            step: scene.step,
            ..Settings::default()
        };
        let simulation = (scene.build)(&[], settings).expect(name);
        assert_eq!(simulation.report().rank, size - 1, "{name}");
    }
}
