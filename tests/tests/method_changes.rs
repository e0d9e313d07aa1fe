//! An accuracy chooses its method again where the motion has changed its character.

use mbs_runtime::{AnySimulation, Method, Settings, Simulation, mechanism, methods};

mechanism!(pub(crate) Block {
    doc: "A block on a spring is pulled, slides, and sticks where friction holds it: there friction is a stiff damper.",
    world: Planar(),
    pull: Input(5.0_N),
    stiffness: Param(0.5_N_per_m),
    x: Coordinate(0.0_m, rate = 2.0_m_per_s),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    spring: SpringDamper(
        ground.point(-1.0_m, 0.0_m),
        block.origin,
        stiffness = stiffness,
        length = 1.0_m
    ),
    cable: Force(block.origin, value = [pull, 0.0_N]),
    sole: Friction(
        x.rate,
        load = 9.81_N,
        coefficient = 0.2,
        static_coefficient = 0.4,
        stribeck_velocity = 0.05_m_per_s,
        regularization_velocity = 0.1_mm_per_s
    ),
    place: Output(x),
});

mechanism!(SliderCrank {
    doc: "A motion of one character.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(mass = 0.36_kg, length = 0.15_m, angle = 40.0_deg),
    rod: Bar(mass = 0.15_kg, length = 0.40_m, angle = -14.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

const ACCURACY: f64 = 1e-5;

fn block() -> impl AnySimulation {
    Simulation::with_accuracy(Block::default(), ACCURACY).expect("it assembles")
}

/// The same motion with another method all the time.
fn alone(settings: Settings) -> impl AnySimulation {
    Simulation::with_methods(Block::default(), settings, methods::Projected).expect("it assembles")
}

/// It is pulled for two seconds, within its first slide: the trials at the start see nothing of a stop.
fn let_go(block: &mut dyn AnySimulation) {
    block.run_until(2.0).expect("it runs");
    block.set_input("pull", 0.0).expect("an input");
}

#[test]
fn a_block_that_sticks_gets_an_implicit_method() {
    let mut block = block();
    assert_eq!(block.settings().method, Method::Projected);
    let_go(&mut block);
    block.run_until(16.0).expect("it runs");
    let [change] = block.method_changes() else {
        panic!("{:?}", block.method_changes())
    };
    assert_eq!(
        [change.before, change.method],
        [Method::Projected, Method::Radau]
    );
    assert_eq!(block.settings().method, Method::Radau);
    assert_eq!(block.report().method_changes, 1);
    assert!(change.time > 2.0 && change.time < 9.0, "{change:?}");
    assert!(
        change.operations[1] < 0.01 * change.operations[0],
        "{change:?}"
    );

    let mut explicit = alone(Settings {
        method: Method::Projected,
        order: 8,
        tolerance: block.settings().tolerance,
        ..Settings::default()
    });
    let_go(&mut explicit);
    explicit.run_until(16.0).expect("it runs");
    let [changing, constant] = [&block, &explicit as &dyn AnySimulation].map(|s| s.report().stages);
    assert!(5 * changing < constant, "{changing}, {constant}");
}

/// A change has no effect on the motion, on its energy balance, and on instants between steps.
#[test]
fn the_motion_goes_on() {
    // Explicit steps would be as short as the time in which friction reverses.
    let settings = Settings {
        method: Method::Radau,
        tolerance: Some(1e-9),
        ..Settings::default()
    };
    let mut fine = Simulation::with_methods(Block::default(), settings, methods::Accuracy)
        .expect("it assembles");
    let mut block = block();
    let_go(&mut fine);
    let_go(&mut block);
    for tick in 1..=100 {
        let time = 2.0 + 0.1 * f64::from(tick);
        fine.run_until(time).expect("it runs");
        block.run_past(time, 12.0).expect("it runs");
        let exact = fine.output("place").expect("an output");
        let mut seen = f64::NAN;
        block
            .look_at(time, &mut |block| {
                seen = block.output("place").expect("an output");
            })
            .expect("an instant of the last step");
        assert!((seen - exact).abs() < 3.0 * ACCURACY, "{time}: {seen}");
    }
    assert_eq!(block.method_changes().len(), 1);
    let (energy, exact) = (block.energy(), fine.energy());
    assert!(energy.error.abs() < 1e-4, "{energy:?}");
    let works = energy.nonconservative_work / exact.nonconservative_work;
    assert!((works - 1.0).abs() < 1e-4, "{energy:?}");
}

/// With two candidates; collocation would serve this motion better than both.
#[test]
fn an_input_brings_the_explicit_method_back() {
    let mut block = alone(Settings::accuracy(ACCURACY));
    let_go(&mut block);
    block.run_until(10.0).expect("it runs");
    assert_eq!(block.settings().method, Method::TwoLevel);
    // It swings to and fro, and never sticks for long.
    for tick in 0..400 {
        let time = 10.0 + 0.1 * f64::from(tick);
        block
            .set_input("pull", 100.0 * (1.4 * time).sin())
            .expect("an input");
        block.run_until(time + 0.1).expect("it runs");
    }
    let methods: Vec<_> = block.method_changes().iter().map(|c| c.method).collect();
    assert_eq!(methods, [Method::TwoLevel, Method::Projected]);
}

mechanism!(Creeping {
    doc: "A crank in honey sinks to the lowest pose, where all rods hang: there its rows are dependent.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    start: Param(-20.0_deg),
    damping: Param(30.0_N_m_s_per_rad),
    crank: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = start,
        rate = 1.0_rad_per_s
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = -start,
        rate = -1.0_rad_per_s
    ),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    brake: TorsionSpring(ground, crank, damping = damping),
    angle: Output(crank.angle),
});

/// Its angle after twenty seconds, with all changes of the method.
fn sunk(creeping: Creeping, settings: Settings) -> (f64, Vec<[Method; 2]>) {
    let simulation = Simulation::with_methods(creeping, settings, methods::Accuracy);
    let mut simulation = simulation.expect("it assembles");
    simulation.run_until(20.0).expect("it runs");
    let changes = simulation.method_changes().iter();
    let changes = changes
        .map(|change| [change.before, change.method])
        .collect();
    (simulation.output("angle").expect("an output"), changes)
}

#[test]
fn collocation_leaves_a_motion_that_comes_to_a_singular_pose() {
    let exact = Settings {
        method: Method::Projected,
        order: 8,
        tolerance: Some(1e-9),
        ..Settings::default()
    };
    // Rods that hang, an early pose, and one from which they sink for minutes.
    for (start, damping, poses) in [(-20.0_f64, 40.0, 1), (10.0, 40.0, 1), (80.0, 300.0, 0)] {
        let creeping = || Creeping {
            start: start.to_radians(),
            damping,
        };
        let (angle, changes) = sunk(creeping(), Settings::accuracy(1e-3));
        let (exact, _) = sunk(creeping(), exact);
        println!("{start}: {angle} for {exact}, {changes:?}");
        assert!((angle - exact).abs() < 1e-3, "{angle} for {exact}");
        assert_eq!(changes, vec![[Method::Radau, Method::Projected]; poses]);
    }
}

#[test]
fn a_motion_of_one_character_keeps_its_method() {
    let mut simulation =
        Simulation::with_accuracy(SliderCrank::default(), ACCURACY).expect("it assembles");
    let before = *simulation.settings();
    simulation.run_until(100.0).expect("it runs");
    assert!(simulation.method_changes().is_empty());
    assert_eq!(*simulation.settings(), before);
}

/// Operations are counted, not timed.
#[test]
fn a_run_is_the_same_again() {
    let end = || {
        let mut block = block();
        block.run_until(3.0).expect("it runs");
        (
            block.coordinates(),
            block.report(),
            block.method_changes().to_vec(),
        )
    };
    assert_eq!(end(), end());
}
