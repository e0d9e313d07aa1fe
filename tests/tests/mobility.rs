//! Rank, degrees of freedom and redundant rows, found at compile time, with the names of the declaration.

use mbs_macros_core::mobility::Mobility;
use mbs_macros_core::{Analysis, analyse};
use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

// Three parallel cranks carry one coupler: as long as all are parallel, the row of the third follows from those of the
// other two. The count gives zero degrees of freedom.
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
            // Overconstrained mechanisms: six revolutes in a ring, two universal joints between fixed bearings.
            "bricard" | "bricard-slender" | "bricard-reference" | "cardan-shaft" => 1,
            _ => 0,
        };
        assert_eq!(mobility.redundant.len(), redundant, "{}", scene.name);
        let rank = scene.model.rows.len() - redundant;
        assert_eq!(mobility.rank, rank, "{}", scene.name);
    }
}

/// What the compiler says of a declaration without the name and world.
pub(crate) fn analysis(world: &str, entries: &str) -> Analysis {
    let text = format!("Tried {{ world: {world}, {entries} }}");
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    outcome.unwrap_or_else(|failure| panic!("{:?}\n{text}", failure.messages()))
}

fn mobility(world: &str, entries: &str) -> Mobility {
    let mobility = analysis(world, entries).mobility;
    mobility.expect("a pose is found")
}

pub(crate) const SPACE: &str = "Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2])";

#[test]
fn mobility_in_words() {
    let words = |name: &str| {
        let scenes = mbs_examples::scenes::scenes();
        let mut scene = scenes.iter().filter(|scene| scene.name == name);
        scene
            .next()
            .and_then(|scene| scene.model.mobility)
            .expect("it assembles")
            .summary
    };
    let bricard = words("bricard-reference");
    assert!(
        bricard.starts_with("30 rows, rank 29: one row of `hinge[5]` (rotation about "),
        "{bricard}"
    );
    assert!(
        bricard.ends_with(") follows from hinge[0]…hinge[4]; mobility 1; Grübler counts 0"),
        "{bricard}"
    );
    // With joints as coordinates the last joint of the ring has rows, and these depend on the other joints.
    let joints = words("bricard");
    assert!(
        joints.starts_with("5 rows, rank 4: one row of `j4` ("),
        "{joints}"
    );
    assert!(
        joints.contains("the joints that are coordinates, j1…j3, j5, j6; mobility 1"),
        "{joints}"
    );
    assert_eq!(words("slider-crank"), "2 rows, rank 2; mobility 1");
    assert_eq!(
        ThreeCranks::MODEL.mobility.expect("it assembles").summary,
        "4 rows, rank 3: the row of `third` follows from left, right; mobility 1; Grübler counts 0"
    );
}

#[test]
fn redundant_rows_leave_reactions_open() {
    // The third crank holds the coupler, so that all parts that carry the coupler share the load with it.
    let model = ThreeCranks::MODEL;
    for joint in ["third", "bearing_left", "bearing_right"] {
        assert!(!model.is_determined(joint), "{joint}");
    }
    for scene in mbs_examples::scenes::scenes() {
        let open = scene
            .model
            .reactions
            .iter()
            .any(|reaction| !scene.model.is_determined(reaction.joint));
        let redundant = scene
            .model
            .mobility
            .is_some_and(|mobility| !mobility.redundant.is_empty());
        assert_eq!(open, redundant, "{}", scene.name);
    }
    // A ring beside a plain pendulum: only the ring is open.
    let beside = mobility(SPACE, "a: Body(mass = 1.0_kg, inertia = 0.1_kg_m2), b: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
        once: Revolute(ground, a, at = [0.0, 0.0, 0.0], axis = X), twice: Revolute(ground, a, at = [1.0, 0.0, 0.0], axis = X),
        plain: Revolute(ground, b, at = [0.0, 0.0, 0.0], axis = Y),");
    assert_eq!(beside.undetermined, ["once", "twice"]);
}

// A door in both descriptions: by joints the rows of the second hinge are zero.
const DOOR: &str =
    "leaf: Body(mass = 20.0_kg, inertia = Cuboid(0.9_m, 0.04_m, 2.0_m), at = [0.3, 0.2, 1.0]),
    low: Param(0.2_m),
    lower: Revolute(ground, leaf, at = [0.0, 0.0, low], axis = [0.1, -0.2, 1.0]),
    upper: Revolute(ground, leaf, at = [0.16, -0.32, low + 1.6_m], axis = [0.1, -0.2, 1.0]),";

#[test]
fn rows_that_joint_coordinates_leave_nothing_to_hold_are_left_out() {
    let door = mobility("Spatial(coordinates = Joint)", DOOR);
    assert_eq!((door.rank, door.mobility), (0, 1));
    assert_eq!(door.redundant.len(), 5);
    for redundancy in &door.redundant {
        assert!(redundancy.vacuous && redundancy.row.starts_with("upper."));
        assert_eq!(redundancy.follows_from, ["lower"]);
    }
    assert_eq!(door.undetermined, ["lower", "upper"]);
    // In both descriptions the same rows are redundant and the same reactions undetermined.
    let rows = mobility("Spatial(coordinates = Reference)", DOOR);
    let names = |mobility: &Mobility| -> Vec<String> {
        let names = mobility.redundant.iter();
        names.map(|redundancy| redundancy.row.clone()).collect()
    };
    assert_eq!(names(&door), names(&rows));
    assert_eq!(door.mobility, rows.mobility);
    assert_eq!(door.undetermined, rows.undetermined);
}

#[test]
fn loops_of_the_plane_in_space_keep_two_rows() {
    let ring = "left: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.0, 0.0, 0.5]),
        top: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.6, 0.0, 1.1]),
        right: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [1.2, 0.0, 0.6]),
        a: Revolute(ground, left, at = [0.0, 0.0, 0.0], axis = Y),
        b: Revolute(left, top, at = [0.0, 0.0, 1.0], axis = Y),
        c: Revolute(top, right, at = [1.2, 0.0, 1.2], axis = Y),
        d: Revolute(right, ground, at = [1.2, 0.0, 0.0], axis = Y),";
    let ring = mobility("Spatial(coordinates = Joint)", ring);
    assert_eq!((ring.rank, ring.mobility), (2, 1));
    assert_eq!(ring.redundant.len(), 3);
    assert!(ring.redundant.iter().all(|redundancy| redundancy.vacuous));
    let mut open = ring.undetermined;
    open.sort();
    assert_eq!(open, ["a", "b", "c", "d"]);
}

#[test]
fn auto_takes_the_hinge_of_a_door_for_its_coordinate() {
    mechanism!(Door {
        world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        door: Body(
            mass = 20.0_kg,
            inertia = Cuboid(0.9_m, 0.04_m, 2.0_m),
            at = [0.45, 0.0, 1.0]
        ),
        lower: Revolute(ground, door, at = [0.0, 0.0, 0.2], axis = Z),
        upper: Revolute(ground, door, at = [0.0, 0.0, 1.8], axis = Z),
    });
    assert_eq!(Door::MODEL.formulation, "Joint");
    assert_eq!(
        (Door::MODEL.velocities.len(), Door::MODEL.rows.len()),
        (1, 0)
    );
    let summary = Door::MODEL.mobility.expect("it assembles").summary;
    assert!(
        summary.starts_with("no rows; left out: 5 rows of `upper` ("),
        "{summary}"
    );
    assert!(
        summary.ends_with("follow from lower; mobility 1; Grübler counts -4"),
        "{summary}"
    );
    let simulation = Simulation::new(Door::default()).expect("it assembles");
    let reactions = simulation.reactions().expect("they are known");
    assert!(!reactions.unique);
    // The hinges share the weight and the moment about the lower hinge in an undetermined way, but the sums hold the
    // door.
    let sum = |component: &str| {
        let of = |joint| simulation.reaction(joint, component).expect("it is there");
        of("lower") + of("upper")
    };
    assert!((sum("fz") - 20.0 * 9.81).abs() < 1e-9);
    for component in ["fx", "fy"] {
        assert!(sum(component).abs() < 1e-9, "{component}");
    }
    // Hinges that fit for some values of a parameter only are not left out.
    let text = format!(
        "Tried {{ world: Spatial(coordinates = Joint), {} }}",
        DOOR.replace("low + 1.6_m]", "1.8_m]")
    );
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    let messages = outcome
        .map(|_| ())
        .expect_err("other heights would not fit")
        .messages();
    assert!(messages[0].0.contains("`upper` holds"), "{messages:?}");
}

#[test]
fn denied_redundancy_is_an_error() {
    let hinges = "a: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
        once: Revolute(ground, a, at = [0.0, 0.0, 0.0], axis = X),
        twice: Cylindrical(ground, a, at = [1.0, 0.0, 0.0], axis = X),";
    let tried = |deny: &str, entries: &str| {
        let text = format!("Tried {{ {deny} world: {SPACE}, {entries} }}");
        let (_, outcome) = analyse(text.parse().expect("these are tokens"));
        outcome.map(|_| ()).map_err(|failure| failure.messages())
    };
    assert!(tried("", hinges).is_ok());
    let messages = tried("deny: Redundant(),", hinges).expect_err("it is denied");
    let [(message, _)] = messages.as_slice() else {
        panic!("{messages:?}")
    };
    assert!(
        message.starts_with("4 rows of `twice` (") && message.contains("follow from once"),
        "{message}"
    );
    let plain = hinges.lines().take(2).collect::<String>();
    assert!(tried("deny: Redundant(),", &plain).is_ok());
}

#[test]
fn loops_that_cannot_close_are_found_for_certain_only() {
    let tried = |distance: f64| {
        let text = format!(
            "Tried {{ world: Planar(), a: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.4),
            b: Bar(mass = 1.0_kg, length = 1.0_m), c: Bar(mass = 1.0_kg, length = 1.0_m),
            p: Revolute(ground.origin, a.a), q: Revolute(a.b, b.a), r: Revolute(b.b, c.a),
            s: Revolute(c.b, ground.point({distance:?}, 0.0)) }}"
        );
        let (_, outcome) = analyse(text.parse().expect("these are tokens"));
        outcome
            .map(|analysis| analysis.mobility)
            .map_err(|failure| failure.messages())
    };
    for distance in [0.5, 2.0, 2.9, 2.99] {
        assert!(tried(distance).is_ok(), "{distance} m can be bridged");
    }
    for distance in [3.01, 4.0, 30.0] {
        let messages = tried(distance).expect_err("three bars of 1 m are too short");
        let [(message, _)] = messages.as_slice() else {
            panic!("{messages:?}")
        };
        // Each of the three would have to be longer by as much.
        let missing = format!("`a.length` by {:.3} m", distance / 3.0 - 1.0);
        assert!(
            message.contains("cannot close") && message.contains(&missing),
            "{message}"
        );
    }
    // Two ropes between the same points contradict each other; the least residual is at the mean length.
    let text = format!("Tried {{ world: {SPACE}, a: Particle(mass = 1.0_kg, at = [1.0, 0.0, 0.0]),
        long: Distance(ground.origin, a.origin, length = 2.0_m), short: Distance(ground.origin, a.origin, length = 1.0_m) }}");
    let (_, outcome) = analyse(text.parse().expect("these are tokens"));
    let messages = outcome
        .map(|_| ())
        .expect_err("it has two lengths")
        .messages();
    assert!(
        messages.len() == 1
            && messages[0].0.contains("`long` by")
            && messages[0].0.contains("`short` by"),
        "{messages:?}"
    );
}

#[test]
fn a_bushing_alone_holds() {
    // Oscillations at 2 Hz show its stiffness in all directions.
    mechanism!(Mounted {
        world: Spatial(),
        block: Body(
            mass = 1.0_kg,
            inertia = 0.1_kg_m2,
            velocity = [0.1_m_per_s, 0.0, 0.0]
        ),
        mount: Bushing(
            ground,
            block,
            at = [0.0, 0.0, 0.0],
            stiffness = 157.91_N_per_m
        ),
        x: Output(block.origin.x),
    });
    let mut simulation = Simulation::new(Mounted::default()).expect("it assembles");
    simulation.run_until(0.125).expect("it runs");
    let amplitude = 0.1 / 157.91f64.sqrt();
    let x = simulation.output("x").expect("it is an output");
    assert!((x - amplitude).abs() < 1e-4 * amplitude, "{x}");
}

/// The joints on which a redundant row depends, and the degrees of freedom of mechanisms for which the count gives
/// none.
#[test]
fn overconstrained_mechanisms_of_space_move() {
    let scenes = mbs_examples::scenes::scenes();
    let all = [0, 1, 2, 3, 4, 5].map(|i| format!("hinge[{i}]"));
    let all = all.each_ref().map(String::as_str);
    for (name, size, last, joints) in [
        ("bricard-reference", 30, "hinge[5]", &all[..]),
        // Five of the six joints are coordinates; the joint that closes the loop has a redundant row.
        ("bricard", 5, "j4", &["j4"][..]),
        ("bricard-slender", 5, "j4", &["j4"][..]),
        ("cardan-shaft", 4, "cross2", &["cross2"][..]),
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

/// A loop that closes, and one with a coupler that is too short for its bearings: the same verdict at any size.
#[test]
fn loops_close_at_any_size() {
    let four_bar = |length: f64, coupler: f64| {
        let text = format!(
            "FourBar {{ world: Planar(), length: Param({length}_m),
                crank: Bar(mass = 1.0_kg, length = length, angle = 50.0_deg),
                coupler: Bar(mass = 1.0_kg, length = {coupler} * length, angle = 5.0_deg),
                rocker: Bar(mass = 1.0_kg, length = length, angle = 120.0_deg),
                far: Point([3.9 * length, 0.0_m]),
                bearing: Revolute(ground.origin, crank.a), other: Revolute(far, rocker.a),
                left: Revolute(crank.b, coupler.a), right: Revolute(rocker.b, coupler.b) }}"
        );
        analyse(text.parse().expect("these are tokens")).1
    };
    for length in [1.0, 3e-5, 1e-6, 1e-7, 1e7] {
        let Ok(Analysis { mobility, .. }) = four_bar(length, 2.0) else {
            panic!("a loop of {length} m is refused");
        };
        assert_eq!(mobility.expect("it assembles").mobility, 1, "{length} m");
        let Err(failure) = four_bar(length, 1.8) else {
            panic!("an open loop of {length} m is accepted");
        };
        let messages = format!("{:?}", failure.messages());
        assert!(messages.contains("close"), "{length} m: {messages}");
    }
}
