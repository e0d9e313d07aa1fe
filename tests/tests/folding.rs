//! Linkages through the poses in which they fold: a spherical one, whose rows are redundant everywhere and dependent there,
//! and a damped slider-crank.

#[path = "../../mbs-examples/src/scenes/passages/spherical.rs"]
mod spherical;

use mbs_runtime::{Settings, Simulation, mechanism, methods};

mod by_bodies {
    super::spherical::spherical!(Spherical, Reference);
}
mod by_joints {
    super::spherical::spherical!(Spherical, Auto);
}

/// The proximal solve follows the multipliers of nearly dependent rows slowly: the step is taken with kicks.
#[test]
fn an_implicit_step_that_does_not_settle_is_taken_with_kicks() {
    let linkage = by_bodies::Spherical {
        phase: -0.8232662763334841,
        rate: -1.5391129603267426,
        damping: 0.0,
    };
    let settings = Settings {
        step: 0.0011550351156728454,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(linkage, settings).expect("assembled");
    for piece in 1..=130 {
        let end = f64::from(piece) * 0.0053883841654237714;
        simulation.run_until(end).expect("no step is refused");
    }
    assert!(simulation.energy().error.abs() < 1e-3);
    assert!(simulation.output("astray").expect("declared").abs() < 1e-3);
}

/// A step much too long reaches poses in which M is not positive definite: it is shortened.
#[test]
fn a_step_without_a_mass_matrix_is_shortened() {
    let linkage = by_joints::Spherical {
        phase: -1.2556326990292377,
        rate: -3.7180246443058858,
        damping: 0.010970697247441312,
    };
    let accuracy = 1.2012313838710853e-5;
    let settings = Settings::accuracy(accuracy);
    let mut simulation =
        Simulation::with_methods(linkage, settings, methods::Projected).expect("assembled");
    for piece in 1..=15 {
        let end = f64::from(piece) * 0.3327642665900511;
        simulation.run_until(end).expect("no step is refused");
    }
    let energy = simulation.energy();
    let whole = energy.kinetic + energy.potential;
    assert!(energy.error.abs() < accuracy * whole);
    assert!(simulation.output("astray").expect("declared").abs() < 1e-3);
}

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    phase: Param(1.8950176179762153_rad),
    rate: Param(3.979325863090426_rad_per_s),
    damping: Param(0.008008250742840289),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, angle = phase, rate = rate),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = -phase, rate = -rate),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
    brake: TorsionSpring(ground, crank, damping = damping),
    astray: Output(rod.b.x - 2.0 * crank.b.x),
});

/// One column of an extrapolated step turns into the other branch: the columns do not agree, and the step is halved.
#[test]
fn columns_on_different_branches_are_no_step() {
    let settings = Settings {
        order: 4,
        step: 0.029059611786399604,
        ..Settings::default()
    };
    let mut simulation =
        Simulation::with_settings(SliderCrank::default(), settings).expect("assembled");
    for piece in 1..=6 {
        let end = f64::from(piece) * 0.4744267482697948;
        simulation.run_until(end).expect("no step is refused");
    }
    assert!(simulation.energy().error.abs() < 1e-2);
    assert!(simulation.output("astray").expect("declared").abs() < 1e-6);
}

/// Rows of a start beside a singular pose were solved by the proximal solve, which left the velocity of another branch in them.
#[test]
fn a_start_beside_a_pose_has_the_velocities_of_its_branch() {
    for before in [6e-4, 3e-4, 1e-4] {
        let linkage = by_bodies::Spherical {
            phase: std::f64::consts::PI - before,
            rate: -2.4,
            damping: 0.2,
        };
        let settings = Settings {
            order: 8,
            step: 0.019,
            ..Settings::default()
        };
        let mut simulation = Simulation::with_settings(linkage, settings).expect("assembled");
        assert!(simulation.report().velocity_error < 1e-12);
        simulation.run_until(0.1).expect("no step is refused");
        assert!(simulation.energy().error.abs() < 1e-9);
        assert!(simulation.output("astray").expect("declared").abs() < 1e-9);
    }
}

/// With redundant rows the explicit method left its rows open by 1e-9 beside a pose, and stopped there.
#[test]
fn explicit_steps_satisfy_redundant_rows_beside_a_pose() {
    let linkage = by_bodies::Spherical {
        phase: -0.3631044404722348,
        rate: 2.6726622923076433,
        damping: 0.0,
    };
    let settings = Settings::accuracy(2.2651201498471374e-6);
    let mut simulation =
        Simulation::with_methods(linkage, settings, methods::Projected).expect("assembled");
    simulation.run_until(1.8).expect("no step is refused");
    assert!(simulation.report().holonomic_error < 1e-12);
    // The accuracy, of 21 J.
    assert!(simulation.energy().error.abs() < 2.3e-6 * 21.0);
    assert!(simulation.output("astray").expect("declared").abs() < 1e-6);
}

/// The last step to an instant, 4e-7 s long and beside a pose: round-off of positions, divided by σ and by the step, is no small
/// correction of velocities.
#[test]
fn a_remainder_beside_a_pose_is_a_step() {
    let mechanism = SliderCrank {
        phase: -1.1967281747973761,
        rate: -3.4383429382743866,
        damping: 0.002626362454258937,
    };
    let settings = Settings {
        step: 0.0007818904926369348,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(mechanism, settings).expect("assembled");
    for piece in 1..=502 {
        let end = f64::from(piece) * 0.006255508407803829;
        simulation.run_until(end).expect("no step is refused");
    }
    assert!(simulation.energy().error.abs() < 1e-4);
    assert!(simulation.output("astray").expect("declared").abs() < 1e-6);
}
