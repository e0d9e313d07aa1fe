//! Angles that joints and drives hold against bars in natural coordinates. The sine of a difference vanishes half a turn off,
//! too.

use mbs_runtime::{Method, Settings, Simulation, mechanism};

mechanism!(Corner {
    world: Planar(coordinates = Natural),
    bend: Param(120.0_deg),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 10.0_deg),
    hand: Bar(mass = 1.0_kg, length = 0.5_m, angle = 10.0_deg),
    pivot: Revolute(ground.origin, arm.a),
    weld: Fixed(arm.b, hand.a, angle = bend),
    cos: Output(2.0 * dot(arm.b - arm.a, hand.b - hand.a)),
    sin: Output(2.0 * cross(arm.b - arm.a, hand.b - hand.a)),
});

mechanism!(Mast {
    world: Planar(coordinates = Natural),
    mast: Bar(mass = 1.0_kg, length = 1.0_m, angle = 10.0_deg),
    yard: Bar(mass = 1.0_kg, length = 0.5_m),
    foot: Fixed(ground.origin, mast.a, angle = 150.0_deg),
    weld: Fixed(mast.b, yard.a, angle = -120.0_deg),
    foot_cos: Output(mast.b.x),
    cos: Output(2.0 * (yard.b - yard.a).x),
    sin: Output(2.0 * (yard.b - yard.a).y),
});

mechanism!(Pointer {
    world: Planar(coordinates = Natural),
    wanted: Input(100.0_deg),
    hand: Bar(mass = 1.0_kg, length = 1.0_m),
    other: Bar(mass = 1.0_kg, length = 1.0_m),
    pin: Revolute(ground.origin, hand.a),
    second_pin: Revolute(ground.origin, other.a),
    drive: Drive(hand.angle, value = wanted),
    clock: Drive(other.angle, value = 170.0_deg + 1.0_rad_per_s * t),
    x: Output(hand.b.x),
    y: Output(hand.b.y),
    other_x: Output(other.b.x),
});

mechanism!(Rider {
    world: Planar(coordinates = Reference),
    arm: Bar(mass = 1.0_kg, length = 1.0_m, angle = 20.0_deg),
    pin: Revolute(ground.origin, arm.a),
    rider: Body(
        mass = 0.5_kg,
        inertia = 0.1_kg_m2,
        frame = Frame([arm.b.x, arm.b.y], arm.angle)
    ),
    tip: Bar(mass = 0.2_kg, length = 0.3_m),
    weld: Fixed(rider.origin, tip.a, angle = 130.0_deg),
    sin: Output(sin(tip.angle - arm.angle)),
});

mechanism!(Plate {
    world: Planar(coordinates = Natural),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.5_m,
        angle = 90.0_deg,
        rate = 10.0_rad_per_s
    ),
    coupler: Bar(mass = 1.0_kg, length = 1.5_m),
    rocker: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        from = [1.5_m, 0.0],
        angle = 80.0_deg
    ),
    foot: Revolute(ground.origin, crank.a),
    left: Revolute(crank.b, coupler.a),
    right: Revolute(coupler.b, rocker.b),
    other_foot: Revolute(ground.point(1.5_m, 0.0), rocker.a),
    plate: Bar(mass = 1e-9_kg, length = 0.1_m, angle = 40.0_deg),
    rivet: Fixed(coupler.a, plate.a),
    rib: Bar(mass = 1e-9_kg, length = 0.1_m),
    corner: Fixed(coupler.a, rib.a, angle = 100.0_deg),
    sin: Output(10.0 * cross(coupler.b - coupler.a, rib.b - rib.a) / 1.5_m2),
    rate: Output(crank.rate),
    slope: Output((coupler.b - coupler.a).y / 1.5_m),
});

mechanism!(Press {
    world: Planar(coordinates = Natural, gravity = [0.0, -9.81_m_per_s2]),
    rate: Param(0.0_rad_per_s),
    turn: Param(0.0_rad),
    wanted: Input(0.0_rad),
    crank: Bar(mass = 1.0_kg, length = 0.1_m, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 0.3_m, angle = -0.2_rad),
    pin: Revolute(ground.origin, crank.a),
    knuckle: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    drive: Drive(
        crank.angle,
        value = wanted + rate * t + turn * (1.0 + tanh((t - 1.013_s) / 0.1_s))
    ),
    angle: Output(crank.angle),
    x: Output(crank.b.x),
    y: Output(crank.b.y),
});

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} is not {b}");
}

#[test]
fn bars_are_welded_at_an_obtuse_angle() {
    for bend in [120.0_f64, -100.0, 180.0, 10.0] {
        let bend = bend.to_radians();
        let corner = Simulation::new(Corner { bend }).expect("it assembles");
        close(corner.outputs().cos, bend.cos());
        close(corner.outputs().sin, bend.sin());
    }
}

#[test]
fn what_the_ground_holds_is_carried_on() {
    let mast = Simulation::new(Mast::default()).expect("it assembles");
    close(mast.outputs().foot_cos, 150.0_f64.to_radians().cos());
    close(mast.outputs().cos, 30.0_f64.to_radians().cos());
    close(mast.outputs().sin, 30.0_f64.to_radians().sin());
}

/// Inputs may turn a bar by any angle: the row of such a drive has one zero.
#[test]
fn drives_turn_bars_by_any_angle() {
    let mut pointer = Simulation::new(Pointer::default()).expect("it assembles");
    close(pointer.outputs().other_x, 170.0_f64.to_radians().cos());
    let mut time = 0.0;
    for wanted in [100.0_f64, -75.0, 95.0, 250.0, 60.0] {
        let wanted = wanted.to_radians();
        pointer.set_input("wanted", wanted).expect("it is reached");
        close(pointer.outputs().x, wanted.cos());
        close(pointer.outputs().y, wanted.sin());
        time += 0.05;
        pointer.run_until(time).expect("it runs");
        close(pointer.outputs().y, wanted.sin());
    }
}

/// A step of more than a quarter turn began nearer to the other zero of a sine.
#[test]
fn long_steps_end_at_the_prescribed_angle() {
    let quick = Press {
        turn: 1.5,
        ..Press::default()
    };
    let steady = Press {
        rate: 300.0,
        ..Press::default()
    };
    for (press, step, until, angle) in [(quick, 0.2, 3.0, 3.0), (steady, 0.005, 0.5, 150.0)] {
        for (method, order) in [
            (Method::TwoLevel, 2),
            (Method::TwoLevel, 4),
            (Method::Projected, 4),
        ] {
            let settings = Settings {
                method,
                order,
                step,
                ..Settings::default()
            };
            let mut simulation = Simulation::with_any_method(press, settings).unwrap();
            simulation.run_until(until).unwrap();
            let outputs = simulation.outputs();
            close(outputs.angle, angle);
            close(outputs.x, 0.1 * angle.cos());
            close(outputs.y, 0.1 * angle.sin());
        }
    }
}

#[test]
fn the_angle_of_a_driven_bar_is_that_of_its_drive() {
    let mut press = Simulation::with_accuracy(Press::default(), 1e-6).unwrap();
    let mut time = 0.0;
    for wanted in [1.0, 3.0, 5.0, 10.0, 3.0, -9.0] {
        press.set_input("wanted", wanted).unwrap();
        close(press.outputs().angle, wanted);
        close(press.outputs().x, 0.1 * wanted.cos());
        time += 0.1;
        press.run_until(time).unwrap();
        close(press.outputs().angle, wanted);
    }
}

/// A part that follows another one has no known angle before that one has.
#[test]
fn a_follower_carries_no_angle_that_is_not_known() {
    let rider = Simulation::new(Rider::default()).expect("it assembles");
    close(rider.outputs().sin, 130.0_f64.to_radians().sin());
}

/// What two points of a part give counts more than the declared angle of a part that is fixed to it.
#[test]
fn points_come_before_carried_angles() {
    let plate = Simulation::new(Plate::default()).expect("it assembles");
    assert!(
        (plate.outputs().rate - 10.0).abs() < 1.0,
        "{}",
        plate.outputs().rate
    );
    assert!(plate.outputs().slope.abs() < 0.5);
    // And the angle of the coupler is carried to a part that has none.
    close(plate.outputs().sin, 100.0_f64.to_radians().sin());
}
