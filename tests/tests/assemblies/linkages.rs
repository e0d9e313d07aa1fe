//! Linkages and gear trains.

use mbs_parts::planar::{FourBar, GearTrain, ScissorStage};
use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

mechanism!(OneByHand {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(
        mass = 0.3_kg,
        length = 0.3_m,
        angle = 60.0_deg,
        rate = 5.0_rad_per_s
    ),
    coupler: Bar(mass = 0.8_kg, length = 0.8_m, angle = 23.0_deg),
    rocker: Bar(mass = 0.6_kg, length = 0.6_m, angle = 72.0_deg),
    main: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, coupler.a),
    top: Revolute(coupler.b, rocker.b),
    foot: Revolute(ground.point(0.7_m, 0.0_m), rocker.a),
    middle: Output(coupler.center),
});

mechanism!(TwoInOne {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    first: Assembly(
        FourBar,
        left = ground.origin,
        right = ground.point(0.7_m, 0.0_m),
        rate = 5.0_rad_per_s
    ),
    others: Each(0..2, |i| Assembly(
        FourBar,
        left = ground.point(0.0_m, 2.0_m + i * 1.0_m),
        right = ground.point(0.7_m, 2.0_m + i * 1.0_m),
        rate = (1.0 - i) * 5.0_rad_per_s,
        mass = 2.0_kg_per_m
    )),
    middle: Output(first.coupler.center),
    raised: Output(others[0].coupler.center),
});

#[test]
fn an_assembly_moves_as_its_entries() {
    let settings = Settings {
        order: 4,
        ..Settings::default()
    };
    let mut one = Simulation::with_settings(OneByHand {}, settings).expect("it assembles");
    let mut two = Simulation::with_settings(TwoInOne::default(), settings).expect("it assembles");
    one.run_until(1.0).expect("it runs");
    two.run_until(1.0).expect("it runs");
    let (one, two) = (one.outputs(), two.outputs());
    let apart = (one.middle - two.middle).norm();
    assert!(apart < 1e-10, "{apart}");
    // Twice the mass everywhere is the same motion, two metres higher.
    let apart = (one.middle - two.raised).norm() - 2.0;
    assert!(apart.abs() < 1e-10, "{apart}");
}

#[test]
fn names_and_parameters_nest() {
    let mut mechanism = TwoInOne {
        first: FourBar {
            crank_length: 0.25,
            ..FourBar::default()
        },
        ..TwoInOne::default()
    };
    assert_eq!(mechanism.others[1].mass, 2.0);
    assert_eq!(mechanism.first.mass, 1.0);
    mechanism
        .set_parameter("others[1].crank_length", 0.2)
        .expect("a parameter");
    assert_eq!(mechanism.others[1].crank_length, 0.2);
    assert_eq!(mechanism.parameter("first.crank_length"), Some(0.25));
    let parts: Vec<&str> = TwoInOne::MODEL.parts.iter().map(|part| part.name).collect();
    assert_eq!(
        parts[..4],
        [
            "first.crank",
            "first.coupler",
            "first.rocker",
            "others[0].crank"
        ]
    );
    let simulation = Simulation::new(mechanism).expect("it assembles");
    simulation
        .reaction("others[0].main", "fx")
        .expect("a reaction");
}

mechanism!(Gears {
    world: Planar(),
    train: Assembly(GearTrain, carrier = ground, count = 4, rate = 2.0_rad_per_s),
    last: Output(train.wheel[3].rate),
});

#[test]
fn gears_turn_in_opposite_senses() {
    let mut simulation = Simulation::new(Gears::default()).expect("it assembles");
    simulation.run_until(10.0).expect("it runs");
    assert!((simulation.outputs().last + 2.0).abs() < 1e-12);
}

mod inside {
    use mbs_runtime::assembly;

    assembly!(Hand {
        world: Planar(),
        /// What holds it.
        wrist: Port(Point),
        length: Param(0.1_m),
        pull: Input(0.0_N),
        finger: Each(0..2, |i| Bar(
            mass = 0.1_kg,
            length = length,
            angle = i * 90.0_deg
        )),
        joint: Each(0..2, |i| Revolute(wrist, finger[i].a)),
        push: Each(0..2, |i| Force(finger[i].b, value = [pull, 0.0])),
        tip: Each(0..2, |i| Output(finger[i].b)),
    });

    assembly!(Arm {
        world: Planar(),
        shoulder: Port(Point),
        length: Param(0.5_m),
        rod: Bar(mass = 1.0_kg, length = length),
        joint: Revolute(shoulder, rod.a),
        hand: Assembly(Hand, wrist = rod.b, length = 0.2_m),
        weight: Let(rod.center),
    });
}

use inside::{Arm, Hand};

mechanism!(Robot {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    arm: Each(0..2, |i| Assembly(
        Arm,
        shoulder = ground.point(i * 2.0_m, 0.0_m),
        length = 0.7_m
    )),
    third: Assembly(Hand, wrist = arm[1].hand.finger[0].b),
    reach: Output(arm[1].hand.finger[1].b),
});

#[test]
fn assemblies_nest() {
    let mut robot = Robot::default();
    assert_eq!(
        robot.arm[0],
        Arm {
            length: 0.7,
            hand: Hand { length: 0.2 }
        }
    );
    assert_eq!(robot.third, Hand { length: 0.1 });
    robot.arm[1].hand.length = 0.3;
    let mut simulation = Simulation::new(robot).expect("it assembles");
    simulation.inputs_mut().arm[0].hand.pull = 1.0;
    simulation.inputs_mut().third.pull = 2.0;
    let before = simulation.outputs();
    assert!((before.reach - before.arm[1].hand.tip[1]).norm() < 1e-15);
    let lengths: Vec<f64> = (0..2)
        .map(|arm| {
            let tip = before.arm[arm].hand.tip;
            (tip[0] - tip[1]).norm() / 2.0_f64.sqrt()
        })
        .collect();
    assert!(
        (lengths[0] - 0.2).abs() < 1e-9 && (lengths[1] - 0.3).abs() < 1e-9,
        "{lengths:?}"
    );
    simulation.run_until(0.5).expect("it runs");
    let after = simulation.outputs();
    // The arms differ in the pull and the length of their hands.
    assert!((after.arm[0].hand.tip[0] - after.arm[1].hand.tip[0]).norm() > 0.01);
    let names: Vec<&str> = Robot::MODEL.inputs.iter().map(|input| input.name).collect();
    assert_eq!(
        names,
        ["arm[0].hand.pull", "arm[1].hand.pull", "third.pull"]
    );
}

mechanism!(Lift {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    slide: Particle(mass = 0.5_kg, at = [0.75_m, 0.0]),
    rail: Holonomic(slide.origin.y),
    stage: Each(0..3, |i| Assembly(
        ScissorStage,
        left = if i == 0 {
            ground.origin
        } else {
            stage[i - 1].falling.b
        },
        right = if i == 0 {
            slide.origin
        } else {
            stage[i - 1].rising.b
        }
    )),
    plate: Body(mass = 2.0_kg, inertia = 0.1_kg_m2),
    hinge: Revolute(stage[2].falling.b, plate.origin),
    roller: Holonomic(dot(stage[2].rising.b - plate.origin, plate.y)),
    level: Holonomic(plate.angle),
});

#[test]
fn long_lists_of_names_are_short() {
    let mobility = Lift::MODEL.mobility.expect("it assembles");
    assert_eq!(
        mobility.summary,
        "23 rows, rank 22: the row of `level` follows from rail, stage[0].foot…stage[2].foot, \
         stage[0].other_foot…stage[2].other_foot, stage[0].pin…stage[2].pin, hinge, roller; mobility 1; Grübler counts 0"
    );
}

mechanism!(Turned {
    world: Planar(),
    line: Param(0.0_deg),
    linkage: Assembly(
        FourBar,
        left = ground.origin,
        right = ground.point(0.7_m * cos(line), 0.7_m * sin(line)),
        angle = Exactly(line + 50.0_deg),
        rate = Exactly(5.0_rad_per_s),
        line = line
    ),
    slide: Particle(mass = 0.5_kg, at = [0.8_m * cos(line), 0.8_m * sin(line)]),
    rail: Holonomic(slide.origin.y * cos(line) - slide.origin.x * sin(line)),
    stage: Assembly(
        ScissorStage,
        left = ground.origin,
        right = slide.origin,
        angle = Exactly(40.0_deg + line),
        rate = Exactly(0.5_rad_per_s),
        line = line
    ),
    carrier: Body(
        mass = 0.2_kg,
        inertia = 0.001_kg_m2,
        angle = line,
        rate = 1.0_rad_per_s
    ),
    hub: Revolute(ground.origin, carrier.origin),
    train: Assembly(
        GearTrain,
        carrier = carrier,
        rate = 2.0_rad_per_s,
        angle = line,
        turning = 1.0_rad_per_s
    ),
    bars: Output([linkage.crank.angle - line, linkage.rocker.angle - line]),
    arms: Output([stage.rising.angle - line, stage.falling.angle - line]),
    rates: Output([linkage.crank.rate, stage.rising.rate]),
    wheels: Output([train.wheel[0].rate - carrier.rate, carrier.rate]),
});

/// Guesses were those of a level line: in other poses the branch was another one, and a carrier was moved by its wheels.
#[test]
fn parts_start_in_turned_poses_as_they_are_told() {
    let level = Simulation::new(Turned::default())
        .expect("it assembles")
        .outputs();
    for turn in 1..12 {
        let line = (30.0 * f64::from(turn)).to_radians();
        let turned = Simulation::new(Turned {
            line,
            ..Turned::default()
        });
        let turned = turned
            .unwrap_or_else(|error| panic!("{turn}: {error}"))
            .outputs();
        for (name, found, wanted) in [
            ("crank", turned.bars.x, 50f64.to_radians()),
            ("rocker", turned.bars.y, level.bars.y),
            ("rising", turned.arms.x, 40f64.to_radians()),
            ("falling", turned.arms.y, 140f64.to_radians()),
            ("rate of the crank", turned.rates.x, 5.0),
            ("rate of the stage", turned.rates.y, 0.5),
            ("wheel", turned.wheels.x, 2.0),
            ("carrier", turned.wheels.y, 1.0),
        ] {
            assert!(
                (found - wanted).abs() < 1e-9,
                "{turn}, {name}: {found} for {wanted}"
            );
        }
    }
}
