//! The implicit step of damped mechanisms ends in round-off, at any step and any distance from the origin. Of the random
//! mechanisms of each kind the first 1000 are taken; more of them: `CASES=10000 cargo test --release -p mbs-runtime
//! small_implicit_steps::`.

use mbs_runtime::{Flow, Mechanism, Settings, Simulation, System, mechanism};

mechanism!(Locked {
    doc: "Two bodies that cannot move, beside a damped pendulum.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    x: Param(1.3_m),
    turn: Param(0.2_rad),
    size: Param(0.7_m),
    damping: Param(0.5_N_m_s),
    wall: Point([x, 0.2_m]),
    block: Body(
        mass = 2.0_kg,
        inertia = 0.1_kg_m2,
        at = [x, 0.2_m],
        angle = turn
    ),
    lock: Fixed(wall, block.origin, angle = turn),
    arm: Body(mass = 1.0_kg, inertia = 0.05_kg_m2, angle = 0.4_rad + turn),
    hold: Fixed(
        block.point(0.3_m, 0.1_m),
        arm.point(0.2_m, -0.3_m),
        angle = 0.4_rad
    ),
    rod: Bar(mass = 1.3_kg, length = size, angle = turn),
    pivot: Revolute(ground.origin, rod.a),
    damper: TorsionSpring(ground, rod, stiffness = 2.0_Nm, damping = damping),
});

mechanism!(FourBar {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Reference),
    x: Param(1.0_m),
    turn: Param(0.2_rad),
    size: Param(1.0_m),
    damping: Param(0.05_N_m_s),
    left: Point([x, 0.0]),
    right: Point([x + 1.3 * size, 0.0]),
    crank: Bar(
        mass = 1.0_kg,
        length = 0.4 * size,
        angle = turn,
        rate = 5.0_rad_per_s
    ),
    rod: Bar(mass = 1.0_kg, length = 1.1 * size, angle = 10.0_deg),
    rocker: Bar(mass = 1.0_kg, length = 0.9 * size, angle = 80.0_deg),
    main: Revolute(left, crank.a),
    pin: Revolute(crank.b, rod.a),
    top: Revolute(rod.b, rocker.b),
    foot: Revolute(right, rocker.a),
    damper: TorsionSpring(ground, crank, damping = damping),
});

/// Numbers from 0 to 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A number of random mechanisms and steps: x, turn, size and damping.
fn ends<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: impl Fn([f64; 4]) -> M)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut numbers = Numbers(88_172_645_463_325_252);
    let wanted = std::env::var("CASES")
        .ok()
        .and_then(|text| text.parse().ok());
    for number in 0..wanted.unwrap_or(1000) {
        let x = [0.0, 1.0, 50.0, 1e4][number % 4] * numbers.next();
        let turn = 6.0 * numbers.next();
        let size = 0.3 + 2.0 * numbers.next();
        let damping = 10.0_f64.powf(-3.0 + 4.0 * numbers.next());
        let step = 10.0_f64.powf(-3.0 - 5.0 * numbers.next());
        let settings = Settings {
            step,
            ..Settings::default()
        };
        let built = Simulation::with_settings(mechanism([x, turn, size, damping]), settings);
        let mut simulation = built.expect("assembles");
        assert_eq!(simulation.flow(), Flow::Implicit);
        for _ in 0..40 {
            simulation
                .step()
                .unwrap_or_else(|error| panic!("{number}: {error}"));
        }
        assert_eq!(
            simulation.report().rejected_steps,
            0,
            "{number}: h = {step} s"
        );
    }
}

#[test]
fn of_a_locked_block_and_arm() {
    ends(|[x, turn, size, damping]| Locked {
        x,
        turn,
        size,
        damping,
    });
}

#[test]
fn of_moving_four_bars() {
    ends(|[x, turn, size, damping]| FourBar {
        x,
        turn,
        size,
        damping,
    });
}
