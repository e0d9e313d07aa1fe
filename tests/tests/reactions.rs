//! Joint reactions compared with formulas and with reference tables.

use mbs_examples::scenes;
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Mechanism, Settings, Simulation, State, System, mechanism};
use mbs_tests::reference;

fn reaction<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    simulation: &Simulation<S, Q, N, R>,
    joint: &str,
    component: &str,
) -> f64 {
    let known = S::MODEL.reactions;
    let index = known
        .iter()
        .position(|reaction| reaction.joint == joint && reaction.component == component)
        .unwrap_or_else(|| panic!("no reaction {joint}.{component} in {known:?}"));
    simulation.reactions().expect(joint).values[index]
}

fn simulation<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    step: f64,
) -> Simulation<S, Q, N, R>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    Simulation::with_settings(
        mechanism,
        Settings {
            step,
            ..Settings::default()
        },
    )
    .expect("it assembles")
}

/// Compares reactions with columns along a run; errors are relative to the largest value of the column.
fn along_a_run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    file: &str,
    step: f64,
    until: f64,
    pairs: &[(&str, &str, &str)],
    tolerance: f64,
    singular: impl Fn(&reference::Table, usize) -> bool,
) where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let table = reference::table(file);
    let mut simulation = simulation(mechanism, step);
    let mut compared = 0;
    let mut worst: f64 = 0.0;
    for (row, time) in table
        .times()
        .into_iter()
        .enumerate()
        .take_while(|(_, t)| *t <= until)
    {
        simulation.run_until(time).expect(file);
        if singular(&table, row) {
            continue;
        }
        for (joint, component, column) in pairs {
            let values = table.column(column);
            let size = values.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let found = reaction(&simulation, joint, component);
            worst = worst.max((found - values[row]).abs() / size);
            // At the start the state is exact, and so are the reactions.
            let tolerance = size * if row == 0 { 1e-11 } else { tolerance };
            assert!(
                (found - values[row]).abs() <= tolerance,
                "{joint}.{component} at {time} s: {found}, but {column} is {}",
                values[row]
            );
            compared += 1;
        }
    }
    println!("{file}: {worst:.1e} of the largest");
    assert!(
        compared > 10 * pairs.len(),
        "only {compared} values were compared"
    );
}

/// Tension m (v²/L + g·e) of the pendulum: at every state of a run, to round-off.
#[test]
fn pendulum_tension() {
    let pendulum = scenes::pendulum::Pendulum {
        length: 0.8,
        mass: 1.7,
    };
    let mut simulation = simulation(pendulum, 1e-2);
    for _ in 0..150 {
        simulation.step().expect("it swings");
        let [x, y, vx, vy] =
            ["x", "y", "vx", "vy"].map(|name| simulation.output(name).expect("declared"));
        let along = [x / pendulum.length, y / pendulum.length];
        let tension = pendulum.mass * ((vx * vx + vy * vy) / pendulum.length - 9.81 * along[1]);
        for (joint, component, direction) in [
            ("pivot", "fx", along[0]),
            ("pivot", "fy", along[1]),
            ("joint", "fx", along[0]),
            ("joint", "fy", along[1]),
        ] {
            let found = reaction(&simulation, joint, component);
            assert!(
                (found + tension * direction).abs() < 1e-10,
                "{joint}.{component}: {found}, tension {tension}"
            );
        }
    }
}

#[test]
fn slider_crank() {
    along_a_run(
        scenes::slider_crank::SliderCrank::default(),
        "slider_crank_singular_gravity.csv",
        1e-3,
        2.0,
        &[
            ("main_bearing", "fx", "ground_on_rod1_fx_N"),
            ("main_bearing", "fy", "ground_on_rod1_fy_N"),
            ("crank_pin", "fx", "rod1_on_rod2_at_p1_fx_N"),
            ("crank_pin", "fy", "rod1_on_rod2_at_p1_fy_N"),
            ("guide", "fy", "guide_on_slider_fy_N"),
        ],
        2e-4,
        |table, row| table.column("theta_rad")[row].cos().abs() < 0.1,
    );
}

#[test]
fn driven_slider_crank() {
    along_a_run(
        scenes::driven_slider_crank::DrivenSliderCrank::default(),
        "driven_slider_crank.csv",
        2e-4,
        0.05,
        &[
            ("drive", "torque", "drive_torque_on_crank_Nm"),
            ("main_bearing", "fx", "ground_on_crank_fx_N"),
            ("main_bearing", "fy", "ground_on_crank_fy_N"),
            ("crank_pin", "fx", "crank_on_rod_fx_N"),
            ("crank_pin", "fy", "crank_on_rod_fy_N"),
            ("gudgeon_pin", "fx", "rod_on_slider_fx_N"),
            ("gudgeon_pin", "fy", "rod_on_slider_fy_N"),
            ("guide", "fy", "guide_on_slider_fy_N"),
        ],
        1e-9,
        |_, _| false,
    );
}

#[test]
fn andrews() {
    along_a_run(
        scenes::andrews::Andrews::default(),
        "a03_andrews_bari.csv",
        2e-6,
        0.006,
        &[
            ("e_bde", "fx", "lambda1_N"),
            ("e_bde", "fy", "lambda2_N"),
            ("e_ge", "fx", "lambda3_N"),
            ("e_ge", "fy", "lambda4_N"),
            ("e_he", "fx", "lambda5_N"),
            ("e_he", "fy", "lambda6_N"),
        ],
        1e-4,
        |_, _| false,
    );
}

#[test]
fn knife_edge() {
    along_a_run(
        scenes::knife_edge::KnifeEdge::default(),
        "knife_edge_incline.csv",
        5e-3,
        4.0,
        &[("edge", "lambda", "lateral_force_N")],
        1e-4,
        |_, _| false,
    );
}

#[test]
fn chaplygin_sleigh() {
    along_a_run(
        scenes::chaplygin_sleigh::ChaplyginSleigh::default(),
        "chaplygin_sleigh.csv",
        5e-3,
        4.0,
        &[("edge", "lambda", "lateral_force_N")],
        1e-4,
        |_, _| false,
    );
}

/// The force of the pivot on the top, of some 5 kN.
#[test]
fn heavy_top() {
    along_a_run(
        scenes::heavy_top::HeavyTop::default(),
        "heavy_top.csv",
        2e-4,
        0.5,
        &[
            ("pivot", "fx", "pivot_force_on_top_x_N"),
            ("pivot", "fy", "pivot_force_on_top_y_N"),
            ("pivot", "fz", "pivot_force_on_top_z_N"),
        ],
        5e-5,
        |_, _| false,
    );
}

/// The force of the plane on the disk: the multipliers of the rows.
#[test]
fn rolling_disk() {
    along_a_run(
        scenes::rolling_disk::RollingDisk::default(),
        "rolling_disk.csv",
        2e-3,
        3.0,
        &[
            ("no_slip", "lambda[0]", "contact_force_x_N"),
            ("no_slip", "lambda[1]", "contact_force_y_N"),
            ("touch", "lambda", "contact_force_z_N"),
        ],
        2e-4,
        |_, _| false,
    );
}

/// The coin, whose force on the plane varies by more than its weight.
#[test]
fn rolling_coin() {
    let coin = scenes::rolling_disk::RollingDisk {
        mass: 0.4,
        radius: 0.0375,
        lean: 1.2,
        turning: 18.0,
        rolling: -14.0,
    };
    along_a_run(
        coin,
        "rolling_disk_tilted.csv",
        1e-4,
        0.3,
        &[
            ("no_slip", "lambda[0]", "contact_force_x_N"),
            ("no_slip", "lambda[1]", "contact_force_y_N"),
            ("touch", "lambda", "contact_force_z_N"),
        ],
        1e-3,
        |_, _| false,
    );
}

#[test]
fn reactions_are_asked_for_by_name() {
    let simulation =
        mbs_runtime::Simulation::new(scenes::pendulum::Pendulum::default()).expect("it assembles");
    // At rest in the horizontal the massless bar carries nothing, and its mass falls freely.
    assert!(
        simulation
            .reaction("pivot", "fx")
            .expect("it is there")
            .abs()
            < 1e-12
    );
    let message = |result: Result<f64, mbs_runtime::SimulationError>| {
        result.expect_err("it is not there").to_string()
    };
    let wrong_joint = message(simulation.reaction("pivott", "fx"));
    assert!(
        wrong_joint.contains("`pivott`") && wrong_joint.contains("pivot, joint"),
        "{wrong_joint}"
    );
    let wrong_component = message(simulation.reaction("pivot", "fz"));
    assert!(
        wrong_component.contains("`fz`") && wrong_component.contains("fx, fy"),
        "{wrong_component}"
    );
}

#[test]
fn a_step_that_the_clock_cannot_count_is_refused() {
    let settings = mbs_runtime::Settings {
        step: 1e-90,
        ..Default::default()
    };
    let mut simulation =
        mbs_runtime::Simulation::with_settings(scenes::pendulum::Pendulum::default(), settings)
            .expect("it assembles");
    let error = simulation
        .run_until(1.0)
        .expect_err("it would never end")
        .to_string();
    assert!(error.contains("setting `step`"), "{error}");
}

/// A link of very little mass bears a load.
macro_rules! cranes {
    ($($name:ident $coordinates:ident;)*) => { $(
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            light: Param(1e-5_kg),
            link: Bar(mass = light, length = 1.0_m, angle = -60.0_deg),
            load: Body(mass = 1000.0_kg, inertia = 100.0_kg_m2),
            hook: Revolute(ground.origin, link.a),
            eye: Revolute(link.b, load.origin),
            pull: Output([eye.reaction.fx, eye.reaction.fy]),
            fall: Output(load.acceleration.y),
        });
    )* };
}
cranes! {
    CraneByBodies Reference;
    CraneByJoints Joint;
}

/// Rows with small pivots were taken as dependent: the pull was 15 N, and the load fell freely.
#[test]
fn a_light_link_bears_its_load() {
    // A body hinged at its centre of mass on a link without mass: m g cos 30°, and −g sin² 30°.
    let (pull, fall) = (9810.0 * 30f64.to_radians().cos(), -9.81 * 0.25);
    for light in [1e-3, 1e-5, 1e-7] {
        let bodies = Simulation::new(CraneByBodies { light }).expect("it assembles");
        let joints = Simulation::new(CraneByJoints { light }).expect("it assembles");
        assert!(bodies.reactions().expect("they exist").unique);
        let (by_bodies, by_joints) = (bodies.outputs(), joints.outputs());
        for (name, found, wanted) in [
            ("pull by bodies", by_bodies.pull.norm(), pull),
            ("pull by joints", by_joints.pull.norm(), pull),
            ("fall by bodies", by_bodies.fall, fall),
            ("fall by joints", by_joints.fall, fall),
        ] {
            assert!(
                (found / wanted - 1.0).abs() < 1e-5,
                "{light} {name}: {found} for {wanted}"
            );
        }
    }
}

/// A body on each joint of space that holds it off its axes, with its centre of mass at the origin.
macro_rules! held {
    ($name:ident, $($joint:tt)*) => {
        mechanism!($name {
            world: Spatial(coordinates = Reference),
            body: Body(mass = 2.0_kg, inertia = 0.5_kg_m2),
            joint: $($joint)*,
            load: Wrench(
                body.origin,
                force = [10.0_N, 2.0, -8.0],
                torque = [1.0_Nm, 0.0, 3.0]
            ),
        });
    };
}

held!(
    OnShaft,
    ConstantVelocity(ground, body, at = [0.0_m, 0.0, 0.0], axis = Z)
);
held!(
    OnWire,
    PointOnLine(body.origin, ground.origin, axis = [3.0, 4.0, 0.0])
);
held!(
    OnTable,
    PointOnPlane(body.point(0.5_m, 0.0, 0.0), ground.point(0.5_m, 0.0, 0.0))
);

/// The reaction on the body, which starts at rest at the origin, turned by `angle` about X.
fn held_at<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    angle: f64,
    wanted: &[(&str, f64)],
) where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (sin, cos) = (0.5 * angle).sin_cos();
    let mut positions = SVector::<f64, Q>::zeros();
    positions.as_mut_slice()[Q - 4..].copy_from_slice(&[cos, sin, 0.0, 0.0]);
    let state = State::new(0.0, positions, SVector::zeros());
    let simulation = Simulation::resume(mechanism, Settings::default(), state);
    let simulation = simulation.expect("the rows hold");
    for (component, wanted) in wanted {
        let found = reaction(&simulation, "joint", component);
        assert!(
            (found - wanted).abs() < 1e-12,
            "{component}: {found} for {wanted}"
        );
    }
}

/// The joint transmits the torque along the bisector of the shafts, and leaves the turning about both other axes.
#[test]
fn the_torque_of_a_constant_velocity_joint_is_along_the_bisector() {
    // n = (0, −sin 30°, cos 30°) halves the angle between (0, 0, 1) and (0, −sin 60°, cos 60°): −(M · n) n, M = (1, 0, 3) N m.
    let (sin, cos) = (0.5, 0.75f64.sqrt());
    let torque = -3.0 * cos;
    let wanted = [
        ("fx", -10.0),
        ("fy", -2.0),
        ("fz", 8.0),
        ("tx", 0.0),
        ("ty", -sin * torque),
        ("tz", cos * torque),
    ];
    held_at(OnShaft::default(), 60f64.to_radians(), &wanted);
}

/// What of the load is not along the line: F − (F · d) d, d = (0.6, 0.8, 0), F · d = 7.6 N.
#[test]
fn a_line_in_space_bears_the_force_across_it() {
    let wanted = [("fx", -5.44), ("fy", 4.08), ("fz", 8.0)];
    held_at(OnWire::default(), 0.0, &wanted);
}

/// With the point at r = (0.5, 0, 0) m from the centre of mass the body turns: n · (a + α × r) = 0, a = (F + λ n) / m and
/// α = (M + r × λ n) / J, so that −4 + λ/2 + λ/2 = 0.
#[test]
fn a_plane_bears_the_force_along_its_normal() {
    let wanted = [("fx", 0.0), ("fy", 0.0), ("fz", 4.0)];
    held_at(OnTable::default(), 0.0, &wanted);
}

mechanism!(HalfShafts {
    world: Spatial(),
    bend: Param(20.0_deg),
    inner: Body(
        mass = 1.0_kg,
        inertia = 0.01_kg_m2,
        angular_velocity = [1.0_rad_per_s, 0.0, 0.0]
    ),
    outer: Body(
        mass = 3.0_kg,
        inertia = 0.05_kg_m2,
        orientation = turn(Z, bend)
    ),
    left: Revolute(ground, inner, at = [0.0_m, 0.0, 0.0], axis = X),
    joint: ConstantVelocity(
        inner.frame([0.0_m, 0.0, 0.0], X),
        outer.frame([0.0_m, 0.0, 0.0], X)
    ),
    right: Revolute(
        ground,
        outer,
        at = [0.0_m, 0.0, 0.0],
        axis = [cos(bend), sin(bend), 0.0]
    ),
    motor: Torque(left, value = 1.0_Nm),
    slip: Output(left.rate - right.rate),
    angle: Output(left.angle),
    twist: Output(left.angle - right.angle),
});

/// Shafts that are at an angle in the home pose are given by frames; with `axis = X` they turn at different rates.
#[test]
fn shafts_at_an_angle_turn_at_the_same_rate() {
    let mut shafts = simulation(HalfShafts::default(), 1e-3);
    shafts.run_until(2.0).expect("it runs");
    let outputs = shafts.outputs();
    assert!(outputs.angle > 30.0, "{}", outputs.angle);
    assert!(
        outputs.slip.abs() < 1e-6 && outputs.twist.abs() < 1e-6,
        "{} rad/s, {} rad",
        outputs.slip,
        outputs.twist
    );
}
