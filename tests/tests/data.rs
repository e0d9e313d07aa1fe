//! State, settings, samples and frames as data of `serde`.

use mbs_runtime::output::Frame;
use mbs_runtime::{Method, PaperSettings, Sample, Settings, Simulation, State, mechanism};

mechanism!(pub(crate) Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 1.0_m, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
    height: Output(rod.b.y),
    tip: Output(rod.b),
    rate: Output(rod.rate),
});

/// Order 4 with a tolerance: the state then has multipliers of stages and a step controller.
#[test]
fn a_state_from_a_file_goes_on_bit_for_bit() {
    let settings = Settings::for_tolerance(1e-3);
    let mut simulation = Simulation::with_settings(Pendulum {}, settings).unwrap();
    simulation.run_until(0.7).unwrap();
    let file = serde_json::to_string(&(settings, simulation.state())).unwrap();
    let (again, state) = serde_json::from_str(&file).unwrap();
    assert_eq!(settings, again);
    assert_same(&state, simulation.state());
    let mut resumed = Simulation::resume(Pendulum {}, again, state).unwrap();
    resumed.run_until(1.5).unwrap();
    simulation.run_until(1.5).unwrap();
    assert_same(resumed.state(), simulation.state());
}

/// So that the type of the read state is that of the simulation.
fn assert_same<const Q: usize, const N: usize, const R: usize>(
    a: &State<Q, N, R>,
    b: &State<Q, N, R>,
) {
    assert_eq!(a, b);
}

#[test]
fn settings_from_a_file_may_leave_fields_out_but_have_no_others() {
    let settings: Settings = serde_json::from_str(r#"{"order": 4, "step": 0.01}"#).unwrap();
    let expected = Settings {
        order: 4,
        step: 0.01,
        ..Settings::default()
    };
    assert_eq!(settings, expected);
    let wrong = serde_json::from_str::<Settings>(r#"{"setp": 0.01}"#).unwrap_err();
    assert!(
        wrong.to_string().contains("unknown field `setp`"),
        "{wrong}"
    );
    let settings = Settings {
        method: Method::MAlf(PaperSettings::m_alf()),
        ..expected
    };
    let text = serde_json::to_string(&settings).unwrap();
    assert_eq!(settings, serde_json::from_str(&text).unwrap());
}

#[test]
fn samples_come_back_from_a_file() {
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let samples: Result<Vec<Sample>, _> = simulation.samples(0.1, 0.05).collect();
    let samples = samples.unwrap();
    let text = serde_json::to_string(&samples).unwrap();
    assert_eq!(samples, serde_json::from_str::<Vec<Sample>>(&text).unwrap());
    assert_eq!(samples.len(), 3);
    assert!(text.contains(r#""outputs":["#));
}

/// JSON has no NaN: what is not known is null there.
#[test]
fn what_is_not_known_comes_back_from_a_file() {
    let simulation = Simulation::new(Pendulum {}).unwrap();
    let mut frame = Frame::record(&simulation);
    frame.outputs[0] = f64::NAN;
    frame.reactions.fill(f64::NAN);
    frame.points[1][2] = f64::NAN;
    frame.energy.error = f64::NAN;
    let text = serde_json::to_string(&frame).unwrap();
    let again: Frame = serde_json::from_str(&text).unwrap();
    assert_eq!(format!("{again:?}"), format!("{frame:?}"));
    // Nor has it an infinity.
    frame.outputs[0] = f64::INFINITY;
    assert_eq!(serde_json::to_string(&frame).unwrap(), text);
    let mut sample = simulation.sample();
    sample.outputs[0] = f64::NAN;
    sample.holonomic_error = f64::NAN;
    let text = serde_json::to_string(&sample).unwrap();
    let again: Sample = serde_json::from_str(&text).unwrap();
    assert_eq!(format!("{again:?}"), format!("{sample:?}"));
    // Whole numbers are numbers; words are none.
    let wrong = text.replace("null", "\"much\"");
    assert!(serde_json::from_str::<Sample>(&wrong).is_err());
    let whole = text.replace("null", "3");
    let whole: Sample = serde_json::from_str(&whole).unwrap();
    assert_eq!((whole.outputs[0], whole.holonomic_error), (3.0, 3.0));
}
