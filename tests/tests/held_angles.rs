//! Angles that joints and drives hold against bars in natural coordinates. Such a row is a sine, which vanishes half a turn
//! off, too.

use mbs_runtime::{Simulation, mechanism};

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
