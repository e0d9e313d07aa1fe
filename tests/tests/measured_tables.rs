//! Tables whose points are parameters: the curve is that of a table of numbers, and belongs to one mechanism.

use crate::alloc::count;
use mbs_macros_core::symbolic::{self, INTEGRAL};
use mbs_runtime::generated::{Beyond, Interpolation, MeasuredTable, PeriodicTable};
use mbs_runtime::{Mechanism, ParameterError, Settings, Simulation, assembly, mechanism};

const X: [f64; 6] = [-1.0, 0.0, 0.5, 2.0, 3.0, 4.5];
/// With and without extrema, steep ends, straight lines.
const Y: [[f64; 6]; 4] = [
    [2.0, 2.0, 5.0, 5.5, 5.0, -1.0],
    [-3.0, -1.0, 0.0, 0.1, 7.0, 7.1],
    [0.0, 1.0, 1.5, 3.0, 4.0, 5.5],
    [1e3, -1e-3, 4.0, 4.0, -2e2, 5e2],
];

/// The pieces are computed twice, by the compiler and at run time: to the last bit alike.
#[test]
fn pieces_are_those_of_the_compiler() {
    let interpolations = [
        (Interpolation::Cubic, symbolic::Interpolation::Cubic),
        (Interpolation::Linear, symbolic::Interpolation::Linear),
    ];
    let ends = [
        (Beyond::Linear, symbolic::Beyond::Linear),
        (Beyond::Constant, symbolic::Beyond::Constant),
        (Beyond::Periodic, symbolic::Beyond::Periodic),
    ];
    for (interpolation, of_compiler) in interpolations {
        for (beyond, beyond_of_compiler) in ends {
            for mut y in Y {
                if beyond == Beyond::Periodic {
                    y[5] = y[0];
                }
                let name = || (0, "y".to_owned());
                let found = MeasuredTable::<6, 7>::through("y", X, y, interpolation, beyond);
                let found = found.expect("a table");
                let wanted = symbolic::Table::new(name(), &X, &y, of_compiler, beyond_of_compiler);
                assert!(wanted.pieces().eq(found.as_table().pieces.iter().copied()));
                if beyond == Beyond::Periodic {
                    are_alike(found.as_table().periodic(), &wanted);
                    // Without 0 among its arguments.
                    let x = X.map(|x| x + 2.0);
                    let found = MeasuredTable::<6, 7>::through("y", x, y, interpolation, beyond);
                    let found = found.expect("a table");
                    let wanted =
                        symbolic::Table::new(name(), &x, &y, of_compiler, beyond_of_compiler);
                    are_alike(found.as_table().periodic(), &wanted);
                }
                let second = if beyond == Beyond::Periodic {
                    y[0]
                } else {
                    y[1]
                };
                let [x, y] = [[X[0], X[1]], [y[0], second]];
                let found = MeasuredTable::<2, 3>::through("y", x, y, interpolation, beyond);
                let found = found.expect("a table");
                let wanted = symbolic::Table::new(name(), &x, &y, of_compiler, beyond_of_compiler);
                assert!(wanted.pieces().eq(found.as_table().pieces.iter().copied()));
            }
        }
    }
}

/// In several periods, with the integral and the derivatives.
fn are_alike(found: PeriodicTable<'_>, wanted: &symbolic::Table) {
    for k in -200..200 {
        let x = 0.1 * f64::from(k) + 0.037;
        let values = [
            (INTEGRAL, found.integral(x)),
            (0, found.value(x)),
            (1, found.slope(x)),
            (2, found.second(x)),
            (3, found.third(x)),
        ];
        for (order, value) in values {
            assert_eq!(value, wanted.value(x, order), "{order} at {x}");
        }
    }
}

mechanism!(Numbers {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    line: Table([-0.1_m, 0.0_m, 0.2_m], [-9.0_N, 0.0_N, 12.0_N]),
    slope: Table([-2.0_m_per_s, 0.5_m_per_s], [-0.8_N, 0.2_N]),
    bob: Particle(mass = 0.8_kg, at = [0.3_m, -0.9_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        law = line,
        damping = slope,
        length = 0.7_m
    ),
    place: Output(bob.origin),
});

mechanism!(Parameters {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    elongation: Param([-0.1_m, 0.0_m, 0.2_m]),
    force: Param([-9.0_N, 0.0_N, 12.0_N]),
    /// Of two dampers.
    rate: Each((0..2, 0..2), |i, k| Param(
        (1 + i) * (2.5_m_per_s * k - 2.0_m_per_s)
    )),
    least: Param(-0.8_N),
    line: Table(elongation, force),
    slope: Table(rate[0], [least, 0.2_N]),
    bob: Particle(mass = 0.8_kg, at = [0.3_m, -0.9_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        law = line,
        damping = slope,
        length = 0.7_m
    ),
    place: Output(bob.origin),
});

#[test]
fn a_step_allocates_nothing() {
    let mut simulation = Simulation::new(Parameters::default()).expect("it assembles");
    simulation.step().expect("it runs");
    let before = count();
    for _ in 0..100 {
        simulation.step().expect("it runs");
    }
    assert_eq!(count() - before, 0);
}

/// With the same data a mechanism moves to the last bit as with a table of numbers.
#[test]
fn the_motion_is_that_of_numbers() {
    let mut numbers = Simulation::new(Numbers::default()).expect("it assembles");
    let mut parameters = Simulation::new(Parameters::default()).expect("it assembles");
    numbers.run_until(3.0).expect("it runs");
    parameters.run_until(3.0).expect("it runs");
    assert_eq!(numbers.outputs().place, parameters.outputs().place);
    assert_eq!(numbers.energy(), parameters.energy());
}

mechanism!(Catapult {
    doc: "A mass on a rubber whose force was measured.",
    world: Planar(),
    force: Param([0.0_N, 5.0_N, 13.0_N, 30.0_N, 80.0_N]),
    rubber: Table([0.0_m, 0.1_m, 0.2_m, 0.3_m, 0.4_m], force),
    x: Coordinate(0.35_m),
    stone: Particle(mass = 0.8_kg, position = [x, 0.0_m]),
    spring: SpringDamper(
        ground.point(-1.0_m, 0.0_m),
        stone.origin,
        law = rubber,
        length = 1.0_m
    ),
    speed: Output(x.rate),
    back: Event(x),
});

/// Each of two simulations has its own rubber: the energy at the point without force is the area under its curve.
#[test]
fn each_mechanism_has_its_own_curve() {
    for force in [[0.0, 5.0, 13.0, 30.0, 80.0], [0.0, 20.0, 30.0, 35.0, 36.0]] {
        let curve = symbolic::Table::new(
            (0, "rubber".into()),
            &[0.0, 0.1, 0.2, 0.3, 0.4],
            &force,
            symbolic::Interpolation::Cubic,
            symbolic::Beyond::Linear,
        );
        let settings = Settings {
            step: 1e-4,
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_settings(Catapult { force }, settings).expect("it assembles");
        let area = curve.value(0.35, INTEGRAL);
        assert!((simulation.energy().potential - area).abs() < 1e-13);
        simulation.run_to_event("back", 1.0).expect("it comes back");
        let speed = (2.0 * area / 0.8_f64).sqrt();
        let found = simulation.outputs().speed;
        // Measured: 5.8e-7 and 1.4e-6 m/s, 1.7e-6 and 5.2e-6 J.
        assert!((found + speed).abs() < 3e-6, "{found}, {speed}");
        assert!(simulation.energy().error.abs() < 1e-5);
    }
}

#[test]
fn points_are_set_by_name() {
    let mut catapult = Catapult::default();
    catapult.set_parameter("force[4]", 90.0).expect("its name");
    assert_eq!(catapult.force, [0.0, 5.0, 13.0, 30.0, 90.0]);
    assert_eq!(catapult.parameter("force[1]"), Some(5.0));
}

#[test]
fn data_that_are_no_curve_are_refused() {
    let refused = |change: fn(&mut Parameters)| {
        let mut parameters = Parameters::default();
        change(&mut parameters);
        parameters.prepare().expect_err("no curve")
    };
    let unsorted = refused(|p| p.elongation = [-0.1, 0.3, 0.2]);
    assert_eq!(
        unsorted,
        ParameterError::TableNotIncreasing {
            table: "line",
            index: 2,
            argument: 0.2,
            before: 0.3
        }
    );
    assert_eq!(
        unsorted.to_string(),
        "the arguments of the table `line` have to increase, but the one of index 2 is 0.2, and the one before it 0.3; give a larger one"
    );
    let twice = refused(|p| p.rate[0] = [0.5, 0.5]);
    assert!(matches!(
        twice,
        ParameterError::TableNotIncreasing {
            table: "slope",
            index: 1,
            ..
        }
    ));
    let infinite = refused(|p| p.force[1] = f64::INFINITY);
    assert!(matches!(
        infinite,
        ParameterError::NotFinite {
            name: "force[1]",
            ..
        }
    ));
    let too_large = refused(|p| p.force = [-1e308, 0.0, 1e308]);
    assert_eq!(too_large, ParameterError::TableNotFinite { table: "line" });
    assert!(too_large.to_string().contains("`line` is not finite"));
}

mechanism!(Turned {
    doc: "A rotor with the torque of a cylinder, which follows its angle, and one with a torque that follows the time.",
    world: Planar(),
    torque: Param([3.0_Nm, -1.0_Nm, 0.5_Nm, 3.0_Nm]),
    of_gas: Table(
        [0.0_deg, 90.0_deg, 200.0_deg, 360.0_deg],
        torque,
        beyond = Periodic
    ),
    of_network: Table(
        [0.0_s, 0.25_s, 0.5_s, 1.0_s],
        [0.0_Nm, 0.3_Nm, -0.1_Nm, 0.0_Nm],
        interpolation = Linear,
        beyond = Periodic
    ),
    engine: Bar(mass = 1.0_kg, length = 1.0_m, rate = -30.0_rad_per_s),
    generator: Bar(mass = 3.0_kg, length = 1.0_m),
    crank: Revolute(ground.origin, engine.a),
    shaft: Revolute(ground.origin, generator.a),
    gas: Torque(engine, value = of_gas(crank.angle)),
    network: Torque(generator, value = of_network(t)),
    angle: Output(crank.angle),
    rate: Output(crank.rate),
    momentum: Output(1.0_kg * 1.0_m * 1.0_m * shaft.rate),
});

/// The work of a torque that is repeated with each turn is the area under its curve; so is the angular momentum from one that is
/// repeated in time.
#[test]
fn a_periodic_table_is_repeated() {
    let degrees = [0.0_f64, 90.0, 200.0, 360.0].map(f64::to_radians);
    let cylinder = ([3.0, -1.0, 0.5, 3.0], symbolic::Interpolation::Cubic);
    let load = ([0.0, 0.3, -0.1, 0.0], symbolic::Interpolation::Linear);
    let [gas, network] =
        [(degrees, cylinder), ([0.0, 0.25, 0.5, 1.0], load)].map(|(x, (y, kind))| {
            let name = (0, "curve".to_owned());
            symbolic::Table::new(name, &x, &y, kind, symbolic::Beyond::Periodic)
        });
    let mut simulation = Simulation::with_accuracy(Turned::default(), 1e-9).expect("it assembles");
    simulation.run_until(7.6).expect("it runs");
    let outputs = simulation.outputs();
    let (angle, rate) = (outputs.angle, outputs.rate);
    assert!(angle < -100.0, "{angle}");
    let gained = (rate * rate - 900.0) / 6.0;
    let work = gas.value(angle, INTEGRAL);
    // Measured: 1.0e-6 J.
    assert!((gained - work).abs() < 5e-6, "{gained}, {work}");
    // Seven periods, and 0.6 s.
    let area = 7.0 * 0.0375 + (0.0375 + 0.025 - 0.009);
    assert!((network.value(7.6, INTEGRAL) - area).abs() < 1e-15);
    assert!(
        (outputs.momentum - area).abs() < 1e-7,
        "{}",
        outputs.momentum
    );
}

#[test]
fn a_periodic_table_ends_as_it_begins() {
    let torque = [3.0, -1.0, 0.5, 2.0];
    let refused = Turned { torque }.prepare().expect_err("no period");
    assert_eq!(
        refused.to_string(),
        "the periodic table `of_gas` begins with the value 3 and ends with 2: give both the same value"
    );
}

mechanism!(Heavy {
    doc: "Constants that follow from a table: a mass, and one from another table.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    temperature: Param(20.0),
    density: Param([3.0, 1.0, 0.5]),
    of: Table([0.0, 20.0, 60.0], density),
    // A name of the generated code.
    table_0: Let(2.0 * of(30.0)),
    bob: Particle(mass = 1.0_kg * of(temperature), at = [1.0_m, 0.0_m]),
    spring: SpringDamper(
        ground.origin,
        bob.origin,
        stiffness = 10.0_N_per_m * table_0,
        length = 1.0_m
    ),
});

#[test]
fn constants_follow_from_the_data() {
    let potential = |density| {
        let heavy = Heavy {
            density,
            ..Heavy::default()
        };
        let mut simulation = Simulation::new(heavy)?;
        let start = simulation.energy();
        simulation.run_until(0.1)?;
        let end = simulation.energy();
        Ok::<_, mbs_runtime::SimulationError>((start.kinetic + start.potential, end.kinetic))
    };
    let [light, heavy] =
        [[3.0, 1.0, 0.5], [6.0, 2.0, 1.0]].map(|density| potential(density).expect("it runs"));
    // Mass and stiffness twice as large: the same motion, with twice the energy.
    assert!((heavy.1 - 2.0 * light.1).abs() < 1e-12 * heavy.1);
    assert!(light.1 > 0.0);
    let refused = potential([3.0, -1.0, 0.5]).expect_err("a negative mass");
    assert_eq!(
        refused.to_string(),
        "`mass` of `bob` is negative (-1); give it a positive value"
    );
}

assembly!(Leg {
    doc: "A mass on a spring that each leg has measured.",
    world: Planar(),
    foot: Port(Point),
    force: Param([-6.0_N, 0.0_N, 8.0_N]),
    coil: Table([-0.1_m, 0.0_m, 0.1_m], force),
    bob: Particle(mass = 0.5_kg, at = [foot.x, -0.3_m]),
    spring: SpringDamper(foot, bob.origin, law = coil, length = 0.25_m),
});

mechanism!(Stand {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    leg: Each(0..2, |i| Assembly(
        Leg,
        foot = ground.point(1.0_m * i, 0.0_m)
    )),
    height: Each(0..2, |i| Output(leg[i].bob.origin.y)),
});

#[test]
fn assemblies_have_their_own_data() {
    let mut stand = Stand::default();
    stand.leg[1].force = [-600.0, 0.0, 800.0];
    let mut simulation = Simulation::new(stand).expect("it assembles");
    simulation.run_until(0.1).expect("it runs");
    let [soft, stiff] = simulation.outputs().height;
    assert!(soft < stiff - 1e-3, "{soft}, {stiff}");
    stand.leg[0].force = stand.leg[1].force;
    let mut simulation = Simulation::new(stand).expect("it assembles");
    simulation.run_until(0.1).expect("it runs");
    let [left, right] = simulation.outputs().height;
    assert!((left - right).abs() < 1e-12, "{left}, {right}");
}
