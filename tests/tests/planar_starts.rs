//! Starts in the plane that follow from joints: the same in each order of the entries, and as declared where this fits.

use mbs_runtime::{Mechanism, Simulation, System, mechanism};

/// The outputs of a mechanism at the start.
fn start<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    mechanism: impl Mechanism<System = S>,
) -> Vec<f64> {
    let simulation = Simulation::new(mechanism).expect("it assembles");
    simulation.output_values().to_vec()
}

fn near(found: &[f64], wanted: &[f64]) {
    assert_eq!(found.len(), wanted.len());
    let gaps = found.iter().zip(wanted).map(|(a, b)| (a - b).abs());
    assert!(gaps.fold(0.0, f64::max) < 1e-12, "{found:?}, {wanted:?}");
}

macro_rules! four_bar {
    ($name:ident, $coordinates:ident, $($last:ident: $joint:ident($parent:expr, $child:expr)),+) => {
        mechanism!($name {
            world: Planar(coordinates = $coordinates),
            crank: Bar(mass = 1.0_kg, length = 0.3_m, angle = 40.0_deg),
            rod: Bar(mass = 1.0_kg, length = 0.8_m, angle = 20.0_deg),
            rocker: Bar(mass = 1.0_kg, length = 0.6_m),
            bearing: Revolute(ground.point(0.1_m, 0.0_m), crank.a),
            pin: Revolute(crank.b, rod.a),
            $($last: $joint($parent, $child),)+
            spring: TorsionSpring(ground, rocker, stiffness = 10.0_Nm, angle = 65.0_deg),
            angle: Output(rocker.angle),
        });
    };
}

four_bar!(EndFirst, Natural, tip: Revolute(rod.b, rocker.b), foot: Revolute(ground.point(0.8_m, 0.0_m), rocker.a));
four_bar!(FootFirst, Natural, foot: Revolute(ground.point(0.8_m, 0.0_m), rocker.a), tip: Revolute(rod.b, rocker.b));
four_bar!(EndFirstByAngles, Reference, tip: Revolute(rod.b, rocker.b), foot: Revolute(ground.point(0.8_m, 0.0_m), rocker.a));
four_bar!(EndFirstByJoints, Joint, tip: Revolute(rod.b, rocker.b), foot: Revolute(ground.point(0.8_m, 0.0_m), rocker.a));

/// A bar whose end `b` was placed before its end `a` started a turn off, and wound up its torsion spring.
#[test]
fn two_points_give_an_angle_within_half_a_turn() {
    let angles = [
        start(FootFirst::default()),
        start(EndFirst::default()),
        start(EndFirstByAngles::default()),
        start(EndFirstByJoints::default()),
    ];
    for angle in angles {
        assert!((angle[0] - 1.129).abs() < 1e-3, "{angle:?}");
    }
}

macro_rules! pendulum {
    ($name:ident, $place:literal, $first:ident, $second:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2]),
            $first: Bar(mass = 1.0_kg, length = 0.3_m),
            $second: Bar(mass = 1.0_kg, length = 0.3_m),
            pivot: Revolute(ground.point($place, 0.0_m), upper.a),
            elbow: Revolute(upper.b, lower.a),
            middle: Output(upper.b),
            tip: Output(lower.b),
        });
    };
}

pendulum!(TipFirst, 0.1_m, lower, upper);
pendulum!(TipLast, 0.1_m, upper, lower);
pendulum!(TipFirstAtOrigin, 0.0_m, lower, upper);

macro_rules! slider_crank {
    ($name:ident, $($part:ident: $kind:ident($($argument:tt)*)),+) => {
        mechanism!($name {
            world: Planar(),
            $($part: $kind($($argument)*),)+
            bearing: Revolute(ground.point(0.1_m, 0.0_m), crank.a),
            pin: Revolute(crank.b, rod.a),
            eye: Revolute(rod.b, slider.origin),
            guide: Prismatic(ground.origin, slider.origin),
            crank_angle: Output(crank.angle),
            rod_angle: Output(rod.angle),
            place: Output(slider.origin.x),
        });
    };
}

slider_crank!(CrankFirst, crank: Bar(mass = 1.0_kg, length = 0.3_m, angle = 40.0_deg),
    rod: Bar(mass = 1.0_kg, length = 0.8_m), slider: Body(mass = 1.0_kg, inertia = 0.01_kg_m2));
slider_crank!(SliderFirst, slider: Body(mass = 1.0_kg, inertia = 0.01_kg_m2),
    rod: Bar(mass = 1.0_kg, length = 0.8_m), crank: Bar(mass = 1.0_kg, length = 0.3_m, angle = 40.0_deg));
slider_crank!(RodFirst, rod: Bar(mass = 1.0_kg, length = 0.8_m),
    slider: Body(mass = 1.0_kg, inertia = 0.01_kg_m2), crank: Bar(mass = 1.0_kg, length = 0.3_m, angle = 40.0_deg));

/// The first part of the declaration started at the origin, although a later one was joined to the ground.
#[test]
fn the_order_of_the_parts_does_not_matter() {
    near(&start(TipLast::default()), &[0.4, 0.0, 0.7, 0.0]);
    near(&start(TipFirst::default()), &[0.4, 0.0, 0.7, 0.0]);
    near(&start(TipFirstAtOrigin::default()), &[0.3, 0.0, 0.6, 0.0]);
    let wanted = start(CrankFirst::default());
    assert!((wanted[0] - 0.6815).abs() < 1e-3, "{wanted:?}");
    near(&start(SliderFirst::default()), &wanted);
    near(&start(RodFirst::default()), &wanted);
}

mechanism!(Cart {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    place: Coordinate(0.2_m, rate = 1.0_m_per_s),
    cart: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        frame = Frame([place, 0.0], 0.0)
    ),
    arm: Bar(mass = 1.0_kg, length = 0.4_m, angle = -90.0_deg),
    pivot: Revolute(cart.origin, arm.a),
    at: Output(place),
    speed: Output(rate(place)),
    angle: Output(arm.angle),
    rate: Output(arm.rate),
});

mechanism!(Wheel {
    world: Planar(),
    turn: Coordinate(0.3_rad, rate = 2.0_rad_per_s),
    wheel: Body(
        mass = 1.0_kg,
        inertia = 1.0_kg_m2,
        frame = Frame([0.0_m, 1.0_m], turn)
    ),
    spoke: Bar(mass = 1.0_kg, length = 0.4_m),
    weld: Fixed(wheel.point(0.1_m, 0.0_m), spoke.a),
    hand: Bar(mass = 1.0_kg, length = 0.4_m, angle = -90.0_deg),
    pin: Revolute(wheel.point(0.0_m, 0.2_m), hand.a),
    at: Output(turn),
    rate: Output(rate(turn)),
    spoke_angle: Output(spoke.angle),
    spoke_rate: Output(spoke.rate),
    hand_angle: Output(hand.angle),
    hand_rate: Output(hand.rate),
});

/// Parts started at the origin and at rest beside those that follow coordinates, and moved the declared values.
#[test]
fn joints_to_parts_that_follow_coordinates_place_others() {
    let down = -std::f64::consts::FRAC_PI_2;
    near(&start(Cart::default()), &[0.2, 1.0, down, 0.0]);
    near(&start(Wheel::default()), &[0.3, 2.0, 0.3, 2.0, down, 0.0]);
}
