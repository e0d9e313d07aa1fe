//! Initial values that are held: by `Exactly(…)` in the declaration, or by the program.

mod rigs;
mod stationary;

use mbs_runtime::{
    Level, Mechanism, Method, Settings, Simulation, SimulationError, System, UnknownName,
    mechanism, methods,
};

/// The angle and the rate of the crank differ from what was asked for by less.
const HELD: f64 = 1e-12;

macro_rules! six_bar {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            doc: "A Watt linkage with a guess that is far from closed.",
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            start: Param(0.4_rad),
            crank: Bar(
                mass = 1.0_kg,
                length = 0.5_m,
                angle = Exactly(start),
                rate = Exactly(9.0_rad_per_s),
            ),
            coupler: Bar(mass = 1.0_kg, length = 2.0_m, angle = 0.9_rad),
            rocker: Body(
                mass = 2.0_kg,
                inertia = 0.3_kg_m2,
                at = [2.0_m, 0.0],
                angle = 1.2_rad,
                rate = 1.0_rad_per_s,
            ),
            link: Bar(mass = 1.0_kg, length = 1.5_m, angle = 0.3_rad),
            lever: Bar(
                mass = 1.0_kg,
                length = 1.2_m,
                angle = 1.0_rad,
                rate = -2.0_rad_per_s
            ),
            a: Revolute(ground.origin, crank.a),
            b: Revolute(crank.b, coupler.a),
            c: Revolute(coupler.b, rocker.point(1.5_m, 0.0)),
            d: Revolute(ground.point(2.0_m, 0.0), rocker.origin),
            e: Revolute(rocker.point(1.0_m, -0.4_m), link.a),
            f: Revolute(link.b, lever.b),
            g: Revolute(ground.point(3.8_m, 0.0), lever.a),
            crank_angle: Output(crank.angle),
            crank_rate: Output(crank.rate),
            lever_angle: Output(lever.angle),
        });
    };
}

six_bar!(NaturalSixBar, Natural);
six_bar!(ReferenceSixBar, Reference);
six_bar!(JointSixBar, Joint);
six_bar!(SixBar, Auto);

macro_rules! bennett {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            doc: "Four bodies in a loop that only its special axes let move: three of its rows follow from the others.",
            world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = $coordinates),
            one: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [0.043412044416732604, 0.24620193825305201, 0.0],
                angular_velocity = Exactly([0.0, 0.0, 3.0_rad_per_s]),
            ),
            two: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [-0.10490018406208018, 0.20384099094128061, 0.116385746205799]
            ),
            three: Body(
                mass = 1.0_kg,
                inertia = diag(0.02, 0.03, 0.025),
                at = [-0.51378777849919866, -0.042360947311771251, 0.116385746205799]
            ),
            j0: Revolute(ground, one, at = [0.0, 0.0, 0.0], axis = [0.0, 0.0, 1]),
            j1: Revolute(
                one,
                two,
                at = [0.086824088833465207, 0.49240387650610401, 0.0],
                axis = [0.63302222155948895, -0.11161889704894969, 0.76604444311897801]
            ),
            j2: Revolute(
                two,
                three,
                at = [-0.29662445695762557, -0.084721894623542793, 0.232771492411598],
                axis = [-0.31845015678697797, 0.52887609041857986, 0.78668899739726061]
            ),
            j3: Revolute(
                ground,
                three,
                at = [-0.73095110004077168, 2.9143354396410359e-16, 0.0],
                axis = [4.4408920985006262e-16, 0.93969262078590832, 0.34202014332566882]
            ),
            turn: Output(j0.angle),
            turning: Output(j0.rate),
        });
    };
}

bennett!(NaturalBennett, Natural);
bennett!(ReferenceBennett, Reference);
bennett!(JointBennett, Joint);
bennett!(Bennett, Auto);

/// |φ| and |A v + b| are round-off.
fn is_consistent<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    simulation: &Simulation<S, Q, N, R>,
) {
    let sample = simulation.sample();
    assert!(sample.holonomic_error < 1e-11, "{}", sample.holonomic_error);
    assert!(sample.velocity_error < 1e-9, "{}", sample.velocity_error);
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < HELD, "{found} instead of {wanted}");
}

fn six_bar_starts_as_asked<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() -> Result<(), Box<dyn std::error::Error>> {
    let declared = Simulation::new(M::default())?;
    near(declared.output("crank_angle")?, 0.4);
    near(declared.output("crank_rate")?, 9.0);
    is_consistent(&declared);

    let mut other = M::default();
    other.set_parameter("start", 2.5)?;
    let other = Simulation::new(other)?;
    near(other.output("crank_angle")?, 2.5);
    near(other.output("crank_rate")?, 9.0);
    is_consistent(&other);
    Ok(())
}

#[test]
fn a_six_bar_starts_as_declared() -> Result<(), Box<dyn std::error::Error>> {
    six_bar_starts_as_asked::<NaturalSixBar, _, _, _, _>()?;
    six_bar_starts_as_asked::<ReferenceSixBar, _, _, _, _>()?;
    six_bar_starts_as_asked::<JointSixBar, _, _, _, _>()?;
    six_bar_starts_as_asked::<SixBar, _, _, _, _>()
}

fn bennett_starts_as_asked<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() -> Result<(), Box<dyn std::error::Error>> {
    let declared = Simulation::new(M::default())?;
    near(declared.output("turn")?, 0.0);
    near(declared.output("turning")?, 3.0);
    is_consistent(&declared);

    // The same rate as the declaration, in a pose far from the home pose.
    let turned = Simulation::start(M::default())
        .hold("turn", 1.3)
        .hold_rate("turn", 3.0)
        .settings(Settings::default())
        .begin()?;
    near(turned.output("turn")?, 1.3);
    near(turned.output("turning")?, 3.0);
    is_consistent(&turned);
    Ok(())
}

#[test]
fn a_bennett_linkage_starts_as_asked() -> Result<(), Box<dyn std::error::Error>> {
    bennett_starts_as_asked::<NaturalBennett, _, _, _, _>()?;
    bennett_starts_as_asked::<ReferenceBennett, _, _, _, _>()?;
    bennett_starts_as_asked::<JointBennett, _, _, _, _>()?;
    bennett_starts_as_asked::<Bennett, _, _, _, _>()
}

macro_rules! four_bar {
    ($name:ident, $coordinates:ident) => {
        mechanism!($name {
            world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = $coordinates),
            crank: Bar(
                mass = 1.0_kg,
                length = 1.0_m,
                angle = 60.0_deg,
                rate = 1.0_rad_per_s
            ),
            coupler: Bar(mass = 1.0_kg, length = 2.0_m),
            rocker: Bar(mass = 1.0_kg, length = 1.5_m, angle = -80.0_deg),
            left: Revolute(ground.origin, crank.a),
            top: Revolute(crank.b, coupler.a),
            other: Revolute(coupler.b, rocker.a),
            right: Revolute(ground.point(2.0_m, 0.0), rocker.b),
            crank_angle: Output(crank.angle),
            crank_rate: Output(crank.rate),
            tip: Output(crank.b),
            corner: Output(rocker.a),
            swing: Output(rocker.a.velocity),
        });
    };
}

four_bar!(NaturalFourBar, Natural);
four_bar!(ReferenceFourBar, Reference);
four_bar!(JointFourBar, Joint);

fn program_holds<
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
    const Q: usize,
    const N: usize,
    const R: usize,
>() -> Result<(), Box<dyn std::error::Error>> {
    // Without held values the guess is one among others.
    let free = Simulation::new(M::default())?;
    assert!((free.output("crank_angle")? - 60_f64.to_radians()).abs() > 1e-3);

    let end = std::f64::consts::PI - 1e-6;
    let angles = (0..31).map(|k| end * (f64::from(k) / 15.0 - 1.0));
    for angle in angles {
        let held = Simulation::start(M::default())
            .hold("crank_angle", angle)
            .hold_rate("crank_angle", 9.0)
            .begin()?;
        near(held.output("crank_angle")?, angle);
        near(held.output("crank_rate")?, 9.0);
        assert!(held.output("corner.y")? > 0.0, "the rocker stays up");
        is_consistent(&held);
    }
    let accurate = Simulation::start(M::default())
        .hold("crank_angle", 2.5)
        .settings(Settings::accuracy(1e-6))
        .begin_with_methods(methods::Accuracy)?;
    near(accurate.output("crank_angle")?, 2.5);
    assert_eq!(accurate.settings().method, Method::Projected);
    let slow = Simulation::start(M::default())
        .hold("crank_angle", 0.4)
        .hold("crank_rate", 0.0)
        .begin()?;
    near(slow.output("crank_rate")?, 0.0);
    // An output of velocities is held as it is, and positions other than angles are held, too.
    let held = Simulation::start(M::default())
        .hold("corner.x", 1.7)
        .hold("swing.x", -0.3)
        .begin()?;
    near(held.output("corner.x")?, 1.7);
    near(held.output("swing.x")?, -0.3);

    // The verdict names what has moved.
    let velocities = held.assembly().changes.iter();
    let velocities = velocities
        .filter(|change| change.unit.ends_with("/s"))
        .count();
    assert!(velocities > 0 && velocities < held.assembly().changes.len());
    Ok(())
}

#[test]
fn programs_hold_outputs() -> Result<(), Box<dyn std::error::Error>> {
    program_holds::<NaturalFourBar, _, _, _, _>()?;
    program_holds::<ReferenceFourBar, _, _, _, _>()?;
    program_holds::<JointFourBar, _, _, _, _>()
}

#[test]
fn programs_hold_coordinates_and_velocities() -> Result<(), Box<dyn std::error::Error>> {
    let held = Simulation::start(ReferenceFourBar::default())
        .hold("crank.angle", 0.4)
        .hold_rate("crank.angle", 9.0)
        .begin()?;
    assert_eq!(held.output("crank_angle")?, 0.4);
    near(held.output("crank_rate")?, 9.0);
    let held = Simulation::start(NaturalFourBar::default())
        .hold("crank.b.x", 0.3)
        .hold("crank.b.y'", 0.5)
        .begin()?;
    near(held.output("tip.x")?, 0.3);
    is_consistent(&held);
    Ok(())
}

fn refusal(holds: &[(&str, f64)], rates: &[(&str, f64)]) -> String {
    refused(holds, rates).to_string()
}

fn refused(holds: &[(&str, f64)], rates: &[(&str, f64)]) -> SimulationError {
    let mut start = Simulation::start(NaturalFourBar::default());
    for (name, value) in holds {
        start = start.hold(name, *value);
    }
    for (name, value) in rates {
        start = start.hold_rate(name, *value);
    }
    start.begin().expect_err("it is refused")
}

#[test]
fn refusals_name_the_values() {
    let too_many = refusal(&[("crank_angle", 0.4), ("corner.x", 1.0)], &[]);
    assert!(
        too_many
            .starts_with("the positions that are held cannot all be had: in the nearest start `"),
        "{too_many}"
    );
    assert!(
        too_many.ends_with("; 2 values are held, and the joints leave 1 free: hold 1 at most, and declare the others as guesses"),
        "{too_many}"
    );
    let too_far = refusal(&[("corner.x", 5.0)], &[]);
    assert!(too_far.contains("`corner.x` is off by -"), "{too_far}");
    assert!(
        too_far.ends_with(
            "; the joints do not allow these values together: change one, or declare it as a guess"
        ),
        "{too_far}"
    );
    let rates = refusal(&[("crank_rate", 1.0)], &[("corner.x", 1.0)]);
    assert!(
        rates.starts_with("the velocities that are held cannot all be had: "),
        "{rates}"
    );
    assert!(rates.contains("`rate of corner.x` is off by "), "{rates}");
    let nan = refusal(&[("crank_angle", f64::NAN)], &[]);
    assert!(nan.contains("a held value is NaN"), "{nan}");
}

#[test]
fn refusals_are_typed() {
    let SimulationError::Held {
        level,
        held,
        open,
        degrees_of_freedom,
    } = refused(&[("crank_angle", 0.4), ("corner.x", 1.0)], &[])
    else {
        panic!("another error");
    };
    assert_eq!((level, degrees_of_freedom), (Level::Position, 1));
    assert_eq!(held, ["crank_angle", "corner.x"]);
    assert_eq!(open.len(), 2);
    let SimulationError::UnknownName(UnknownName { name, known, .. }) =
        refused(&[("crank.angel", 0.4)], &[])
    else {
        panic!("another error");
    };
    assert_eq!(name, "crank.angel");
    assert!(
        known.contains(&"crank_angle") && known.contains(&"crank.b.x"),
        "{known:?}"
    );
    let error = refused(&[], &[("crank_rate", 0.4)]).to_string();
    assert!(
        error.starts_with(
            "no coordinate, velocity or output of positions alone is named `crank_rate`; there are: "
        ),
        "{error}"
    );
}

/// A value that follows from the joints may be held, if it is the one that follows.
#[test]
fn what_follows_may_be_said() -> Result<(), Box<dyn std::error::Error>> {
    let first = Simulation::start(NaturalFourBar::default())
        .hold("crank_angle", 0.4)
        .begin()?;
    let both = Simulation::start(NaturalFourBar::default())
        .hold("crank_angle", 0.4)
        .hold("tip.x", 0.4_f64.cos())
        .begin()?;
    near(both.output("corner.x")?, first.output("corner.x")?);
    Ok(())
}

mechanism!(Driven {
    world: Planar(),
    wanted: Param(2.0_rad_per_s),
    crank: Bar(mass = 1.0_kg, length = 1.0_m, rate = Exactly(wanted),),
    pivot: Revolute(ground.origin, crank.a),
    motor: Drive(crank.angle, value = 2.0_rad_per_s * t),
    rate: Output(crank.rate),
});

/// A value that a drive prescribes may be held, another one may not.
#[test]
fn drives_prescribe_velocities() -> Result<(), Box<dyn std::error::Error>> {
    near(Simulation::new(Driven::default())?.output("rate")?, 2.0);
    let error = Simulation::new(Driven { wanted: 3.0 }).err();
    let error = error.expect("it contradicts the drive").to_string();
    assert!(
        error.starts_with(
            "the velocities that are held cannot all be had: in the nearest start `crank.rate` is off by "
        ),
        "{error}"
    );
    assert!(
        error.ends_with(
            " rad/s; the joints leave nothing free that could be held: declare these values as guesses"
        ),
        "{error}"
    );
    Ok(())
}

mechanism!(Drifting {
    world: Planar(),
    block: Particle(mass = 1.0_kg, at = [0.1_m, 0.0], free = true),
    drift: Output(block.origin.x - 2.0_m_per_s * t),
});

/// Its rate at the start is not that of the motion alone: 0 held it at −2 m/s.
#[test]
fn a_rate_that_changes_with_time_is_not_held() {
    let start = Simulation::start(Drifting::default()).hold_rate("drift", 0.0);
    let error = start.begin().expect_err("it has no rate of positions");
    let error = error.to_string();
    assert!(
        error.starts_with("no coordinate, velocity or output of positions alone is named `drift`"),
        "{error}"
    );
    let start = Simulation::start(Drifting::default()).hold("drift", 0.3);
    let held = start.begin().expect("its value is that of time zero");
    near(held.outputs().drift, 0.3);
}

mechanism!(Sleigh {
    world: Planar(),
    body: Body(mass = 1.0_kg, inertia = 0.2_kg_m2, at = [0.0_m, 0.0]),
    charge: State(initial = 1.0, rate = -1.0_per_s),
    runner: Nonholonomic(dot(body.velocity, body.y)),
    x: Output(body.origin.x),
    y: Output(body.origin.y),
    sum: Output(body.origin.x + body.origin.y),
    angle: Output(body.angle),
});

/// A velocity row leaves all positions free, and a state is none.
#[test]
fn as_many_positions_are_held_as_holonomic_rows_leave() {
    let start = Simulation::start(Sleigh::default());
    let all = start
        .hold("x", 1.0)
        .hold("y", 2.0)
        .hold("angle", 0.7)
        .begin();
    near(all.expect("they are free").outputs().sum, 3.0);
    let start = Simulation::start(Sleigh::default());
    let contradiction = start.hold("x", 1.0).hold("y", 2.0).hold("sum", 2.0).begin();
    let error = contradiction.expect_err("x + y is 3").to_string();
    assert!(
        error.contains("do not allow these values together"),
        "{error}"
    );
    let start = Simulation::start(Sleigh::default());
    let too_many = start
        .hold_rate("x", 1.0)
        .hold_rate("y", 2.0)
        .hold_rate("angle", 0.7)
        .begin();
    let error = too_many.expect_err("the runner takes one").to_string();
    assert!(
        error.contains("3 values are held, and the joints leave 2 free"),
        "{error}"
    );
}
