//! Expressions that read forces of springs, stops, friction, motors and bushings.

use crate::common::expansion::{accepted, refused};
use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

fn law([length, rate, free]: [f64; 3]) -> (f64, [f64; 3]) {
    (5.0 * (length - free) + 0.5 * rate, [5.0, 0.5, -5.0])
}

mechanism!(Pulled {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    tension: Table(
        [-1.0_m, 0.0_m, 0.5_m, 2.0_m],
        [-4.0_N, 0.0_N, 3.0_N, 20.0_N]
    ),
    free: Param(0.8_m),
    pull: Input(1.5_N),
    bob: Particle(
        mass = 2.0_kg,
        at = [0.7_m, -0.4_m],
        velocity = [1.0_m_per_s, 0.3_m_per_s]
    ),
    linear: SpringDamper(
        ground.origin,
        bob,
        stiffness = 30.0_N_per_m,
        damping = 2.0_N_s_per_m,
        length = 0.5_m
    ),
    curved: SpringDamper(
        bob,
        ground.point(2.0_m, 0.0),
        law = tension,
        damping = 0.3_N_s_per_m,
        length = 1.0_m
    ),
    own: SpringDamper(ground.point(0.0, 1.0_m), bob, law = law(free)),
    wind: Force(bob, value = [pull, 0.2_N]),

    place: Output(bob.origin),
    acceleration: Output(bob.acceleration),
    linear_force: Output(linear.force),
    curved_force: Output(curved.force),
    own_force: Output(own.force),
    wind_force: Output(wind.force),
});

/// m a is the weight and what the springs pull towards their other ends.
#[test]
fn springs_have_their_tension() {
    let settings = Settings::accuracy(1e-8);
    let mut simulation = Simulation::with_settings(Pulled::default(), settings).unwrap();
    for tick in 0..20 {
        simulation.run_until(0.1 * f64::from(tick)).unwrap();
        let now = simulation.outputs();
        let mut force = [now.wind_force[0], now.wind_force[1] - 2.0 * 9.81];
        let ends = [
            ([0.0, 0.0], now.linear_force),
            ([2.0, 0.0], now.curved_force),
            ([0.0, 1.0], now.own_force),
        ];
        for (end, tension) in ends {
            let way = [end[0] - now.place[0], end[1] - now.place[1]];
            let length = way[0].hypot(way[1]);
            force[0] += tension * way[0] / length;
            force[1] += tension * way[1] / length;
        }
        for (force, acceleration) in force.into_iter().zip(&now.acceleration) {
            assert!(
                (force - 2.0 * acceleration).abs() < 1e-11,
                "{tick}: {force}"
            );
        }
    }
}

mechanism!(Buffered {
    world: Planar(),
    x: Coordinate(0.0_m, rate = 1.0_m_per_s),
    block: Particle(mass = 2.0_kg, position = [x, 0.0_m]),
    buffer: Stop(
        x,
        lower = -0.1_m,
        upper = 0.1_m,
        stiffness = 1.0_kN_per_m,
        onset = 1.0_mm,
        dissipation = 0.4_s_per_m
    ),
    shoe: Friction(
        x.rate,
        load = 0.1 * abs(buffer.force) + 3.0_N,
        coefficient = 0.2,
        regularization_velocity = 1.0_mm_per_s,
        damping = 0.1_N_s_per_m
    ),
    heat: State(initial = 0.0_J, rate = -shoe.force * x.rate),
    touches: Event(abs(buffer.force) - 1.0_N),
    speed: Output(x.rate),
    acceleration: Output(block.acceleration.x),
    loads: Output([buffer.force, shoe.force]),
});

mechanism!(Wound {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(
        mass = 3.0_kg,
        length = 1.0_m,
        angle = 0.3,
        rate = 2.0_rad_per_s
    ),
    pivot: Revolute(ground.origin, rod.a),
    coil: TorsionSpring(
        pivot,
        stiffness = 4.0_Nm,
        damping = 0.7_N_m_s,
        angle = 1.0_rad
    ),
    motor: Torque(pivot, value = 0.5_Nm * sin(3.0_rad_per_s * t)),
    brake: Friction(
        rod.rate,
        load = 2.0_Nm,
        coefficient = 0.1,
        regularization_velocity = 0.1_rad_per_s
    ),
    limit: Stop(
        rod.angle,
        upper = 0.5_rad,
        stiffness = 50.0_Nm,
        onset = 0.01_rad
    ),
    spin: Output(rate(rod.rate)),
    level: Output(rod.b.x),
    torques: Output(motor.torque + brake.torque + limit.torque - coil.torque),
});

#[test]
fn stops_friction_and_motors_have_their_force() {
    let settings = Settings::accuracy(1e-7);
    let mut buffered = Simulation::with_settings(Buffered::default(), settings).unwrap();
    let mut most = 0.0_f64;
    for tick in 0..200 {
        buffered.run_until(1e-3 * f64::from(tick)).unwrap();
        let now = buffered.outputs();
        let (buffer, shoe) = (now.loads.x, now.loads.y);
        assert!(
            (buffer + shoe - 2.0 * now.acceleration).abs() < 1e-9,
            "{tick}"
        );
        assert!(buffer <= 0.0, "the upper stop pushes back: {buffer} N");
        let way = 0.2 * (0.1 * buffer.abs() + 3.0) * (now.speed / 1e-3).tanh();
        assert!(
            (shoe + way + 0.1 * now.speed).abs() < 1e-12,
            "{tick}: {shoe} N"
        );
        most = most.max(-buffer);
    }
    assert!(most > 20.0, "it came to the stop: {most} N");
    let mut wound = Simulation::with_settings(Wound::default(), settings).unwrap();
    for tick in 0..20 {
        wound.run_until(0.05 * f64::from(tick)).unwrap();
        let now = wound.outputs();
        let torque = now.torques - 3.0 * 9.81 * 0.5 * now.level;
        assert!((torque - now.spin).abs() < 1e-10, "{tick}: {torque}");
    }
    let outputs = Wound::MODEL.outputs;
    assert_eq!(outputs[outputs.len() - 1].unit, "N m");
}

mechanism!(Mounted {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    carrier: Body(
        mass = 2.0_kg,
        inertia = diag(0.03_kg_m2, 0.04_kg_m2, 0.05_kg_m2),
        orientation = turn(X, 0.4),
        angular_velocity = [1.0_rad_per_s, -0.7_rad_per_s, 0.4_rad_per_s]
    ),
    engine: Body(
        mass = 1.5_kg,
        inertia = 0.02_kg_m2,
        at = [0.02_m, 0.01_m, -0.03_m],
        orientation = turn(unit([1.0, 2.0, -1.0]), 0.9),
        velocity = [0.3_m_per_s, 0.1_m_per_s, -0.2_m_per_s],
        angular_velocity = [9.0_rad_per_s, -4.0_rad_per_s, 6.0_rad_per_s]
    ),
    held: Bushing(
        ground,
        carrier,
        at = [0.0, 0.0, 0.0],
        stiffness = 900.0_N_per_m,
        torsion_stiffness = 40.0_Nm
    ),
    mount: Bushing(
        carrier,
        engine,
        at = engine.origin,
        stiffness = [200.0_N_per_m, 300.0_N_per_m, 400.0_N_per_m],
        damping = [2.0_N_s_per_m, 1.0_N_s_per_m, 3.0_N_s_per_m],
        torsion_stiffness = [5.0_Nm, 6.0_Nm, 7.0_Nm],
        torsion_damping = [0.02_N_m_s, 0.03_N_m_s, 0.04_N_m_s],
        cross_stiffness = [
            [0.0, 10.0_N, 0.0],
            [-10.0_N, 0.0, 5.0_N],
            [0.0, -5.0_N, 0.0]
        ]
    ),
    force: Output(
        mount.force.x * carrier.x + mount.force.y * carrier.y + mount.force.z * carrier.z
    ),
    torque: Output(
        mount.torque.x * carrier.x + mount.torque.y * carrier.y + mount.torque.z * carrier.z
    ),
    acceleration: Output(engine.acceleration),
    spin: Output(engine.angular_acceleration),
});

/// m a = F + m g and, with the same inertia about all axes, J α = τ.
#[test]
fn bushings_have_force_and_torque_on_the_second_partner() {
    let settings = Settings::accuracy(1e-6);
    let mut mounted = Simulation::with_settings(Mounted::default(), settings).unwrap();
    for tick in 0..20 {
        mounted.run_until(0.05 * f64::from(tick)).unwrap();
        let now = mounted.outputs();
        for k in 0..3 {
            let weight = if k == 2 { 1.5 * 9.81 } else { 0.0 };
            let error = now.force[k] - weight - 1.5 * now.acceleration[k];
            assert!(error.abs() < 1e-9, "{tick}: force {k} is off by {error}");
            let error = now.torque[k] - 0.02 * now.spin[k];
            assert!(error.abs() < 1e-9, "{tick}: torque {k} is off by {error}");
        }
    }
}

mechanism!(Pushed {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    rotor: Body(
        mass = 1.5_kg,
        inertia = 0.02_kg_m2,
        at = [0.2_m, 0.1_m, 0.0],
        orientation = turn(unit([1.0, 2.0, -1.0]), 0.9),
        angular_velocity = [3.0_rad_per_s, -2.0_rad_per_s, 1.0_rad_per_s]
    ),
    screw: Wrench(
        rotor.origin,
        force = [2.0_N, 1.0_N * sin(3.0_rad_per_s * t), -0.5_N],
        torque = [0.03_Nm, -0.02_Nm, 0.04_Nm * t / 1.0_s],
        axes = rotor
    ),
    wind: Force(
        rotor.origin,
        value = [-1.0_N_s_per_m * rotor.origin.velocity.x, 0.3_N, 0.0_N]
    ),
    twist: Torque(rotor, value = [0.0_Nm, 0.01_Nm, 0.02_Nm]),

    force: Output(
        screw.force.x * rotor.x + screw.force.y * rotor.y + screw.force.z * rotor.z + wind.force
    ),
    torque: Output(
        screw.torque.x * rotor.x
            + screw.torque.y * rotor.y
            + screw.torque.z * rotor.z
            + twist.torque
    ),
    acceleration: Output(rotor.acceleration),
    spin: Output(rotor.angular_acceleration),
});

/// The components of a wrench are along its `axes`.
#[test]
fn wrenches_have_force_and_torque() {
    let settings = Settings::accuracy(1e-6);
    let mut pushed = Simulation::with_settings(Pushed::default(), settings).unwrap();
    for tick in 0..20 {
        pushed.run_until(0.05 * f64::from(tick)).unwrap();
        let now = pushed.outputs();
        for k in 0..3 {
            let weight = if k == 2 { 1.5 * 9.81 } else { 0.0 };
            let error = now.force[k] - weight - 1.5 * now.acceleration[k];
            assert!(error.abs() < 1e-9, "{tick}: force {k} is off by {error}");
            let error = now.torque[k] - 0.02 * now.spin[k];
            assert!(error.abs() < 1e-9, "{tick}: torque {k} is off by {error}");
        }
    }
}

mod sledges {
    use mbs_runtime::{assembly, mechanism};

    assembly!(Sledge {
        world: Planar(),
        start: Port(Number),
        body: Body(
            mass = 2.0_kg,
            inertia = 0.1_kg_m2,
            at = [0.6 * start, 0.8 * start]
        ),
        arm: Bar(
            mass = 3.0_kg,
            length = 1.0_m,
            angle = 0.3,
            rate = 2.0_rad_per_s
        ),
        guide: Prismatic(ground.origin, body.origin, axis = [0.6, 0.8]),
        pin: Revolute(ground.origin, arm.a),
        push: Force(guide, value = 4.0_N - 3.0_N_s_per_m * guide.speed),
        motor: Torque(pin, value = 0.5_Nm - 0.1_N_m_s * pin.rate),
        forces: Output(push.force),
        torques: Output(motor.torque),
    });

    mechanism!(Train {
        world: Planar(gravity = [0.0, -9.81_m_per_s2]),
        one: Assembly(Sledge, start = 0.1_m),
        several: Each(0..3, |i| Assembly(Sledge, start = 0.1_m * (i + 1))),
        bob: Each(0..2, |i| Particle(mass = 2.0_kg, at = [0.1_m, 0.2_m * i])),
        pull: Each(0..2, |i| SpringDamper(
            ground.point(0.0, 1.0_m),
            bob[i],
            stiffness = 5.0_N_per_m * (i + 1)
        )),
        wind: Each(0..2, |i| Force(bob[i], value = [1.0_N * (i + 1), 0.0])),

        push: Output(one.push.force),
        along: Output(rate(one.guide.speed)),
        pushes: Output([several[1].push.force, several[2].push.force]),
        speeds: Output([rate(several[1].guide.speed), rate(several[2].guide.speed)]),
        torque: Output(several[2].motor.torque),
        spin: Output(rate(several[2].arm.rate)),
        level: Output(several[2].arm.b.x),
        bobs: Each(0..2, |i| Output(
            bob[i].acceleration.x - wind[i].force.x / 2.0_kg
                + pull[i].force / 2.0_kg * bob[i].origin.x
                    / norm(bob[i].origin - ground.point(0.0, 1.0_m))
        )),
    });
}

/// m a along each guide is the push and the weight, J α about each pin is the motor's torque and that of the weight.
#[test]
fn forces_on_joints_in_assemblies_and_families() {
    let settings = Settings::accuracy(1e-7);
    let mut train = Simulation::with_settings(sledges::Train::default(), settings).unwrap();
    for tick in 0..20 {
        train.run_until(0.05 * f64::from(tick)).unwrap();
        let now = train.outputs();
        let pushes = [now.push, now.pushes.x, now.pushes.y];
        let along = [now.along, now.speeds.x, now.speeds.y];
        for (push, along) in pushes.into_iter().zip(along) {
            let error = push - 2.0 * 9.81 * 0.8 - 2.0 * along;
            assert!(error.abs() < 1e-9, "{tick}: {push} N is off by {error}");
        }
        let error = now.torque - 3.0 * 9.81 * 0.5 * now.level - now.spin;
        assert!(error.abs() < 1e-9, "{tick}: the torque is off by {error}");
        for error in now.bobs {
            assert!(error.abs() < 1e-9, "{tick}: {error} m/s²");
        }
    }
}

#[test]
fn loads_that_are_not_there_are_named() {
    refused(
        "mechanism!(Rig {
    world: Planar(),
    bob: Particle(mass = 1.0_kg),
    spring: SpringDamper(ground.origin, bob, stiffness = 1.0_N_per_m),
    turning: Output(spring.torque),
                           ~~~~~~ `spring` has no `torque` (it has: force)
    length: Output(spring.length),
                          ~~~~~~ `spring` has no `length` (it has: force)
    whole: Output(spring),
                  ~~~~~~ `spring` is declared as `SpringDamper`, which has no value that an expression could use; read `spring.force`
});",
    );
    refused(
        "mechanism!(Rig {
    world: Planar(),
    x: Coordinate(0.0_m),
    bob: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    one: Friction(x.rate, load = abs(two.force), coefficient = 0.1, regularization_velocity = 1.0_mm_per_s),
    two: Friction(x.rate, load = abs(one.force), coefficient = 0.1, regularization_velocity = 1.0_mm_per_s),
                                     ~~~ `one` depends on itself; let it name only entries that do not lead back to it
});",
    );
    refused(
        "mechanism!(Rig {
    world: Planar(),
    bob: Particle(mass = 1.0_kg),
    spring: SpringDamper(ground.origin, bob, stiffness = spring),
                                                         ~~~~~~ `spring` is declared as `SpringDamper`, which has no value that an expression could use
});",
    );
    accepted(
        "mechanism!(Rig {
    world: Planar(),
    bob: Particle(mass = 1.0_kg),
    spring: Each(0..2, |i| SpringDamper(ground.point(i * 1.0_m, 0.0), bob, stiffness = 1.0_N_per_m)),
    both: Output(spring[0].force + spring[1].force),
});",
    );
}
