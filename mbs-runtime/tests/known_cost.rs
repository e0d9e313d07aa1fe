//! Steps of known cost: the calls they make, the bound they keep, what they leave of the rows, and where they are refused.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    Configuration, Constraints, Inertia, Loads, MatrixSink, Mechanism, Model, Observables,
    Settings, Simulation, SimulationError, Structure, System, TensorSink, TwoLevelStepper,
    mechanism,
};

mechanism!(SliderCrank {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = 45.0_deg,
        rate = 2.0_rad_per_s
    ),
    rod: Bar(
        mass = 1.0_kg,
        length = 1.0_m,
        angle = -45.0_deg,
        rate = -2.0_rad_per_s
    ),
    main_bearing: Revolute(ground.origin, crank.a),
    crank_pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

mechanism!(Damped {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, rod.a),
    anchor: Point([2.0_m, 0.0]),
    damper: SpringDamper(
        anchor,
        rod.b,
        damping = 1.0_N_s_per_m,
        stiffness = 1.0_N_per_m,
        length = 2.0_m
    ),
});

type Calls = Arc<Mutex<BTreeMap<&'static str, usize>>>;

/// A system that counts what is asked of it.
#[derive(Clone)]
struct Counted<S> {
    inner: S,
    calls: Calls,
}

macro_rules! forward {
    ($($name:ident($($argument:ident: $kind:ty),*) $(-> $result:ty)?;)*) => {
        $(#[allow(clippy::too_many_arguments)]
        fn $name(&self, $($argument: $kind),*) $(-> $result)? {
            *self.calls.lock().unwrap().entry(stringify!($name)).or_default() += 1;
            self.inner.$name($($argument),*)
        })*
    };
}

impl<S: Configuration<Q, N>, const Q: usize, const N: usize> Configuration<Q, N> for Counted<S> {
    const ROTATIONS: &'static [usize] = S::ROTATIONS;
    forward! {
        guess() -> (SVector<f64, Q>, SVector<f64, N>);
        advance(q: &SVector<f64, Q>, v: &SVector<f64, N>, h: f64) -> SVector<f64, Q>;
        difference(from: &SVector<f64, Q>, to: &SVector<f64, Q>) -> SVector<f64, N>;
        free_flight(q: &mut SVector<f64, Q>, v: &mut SVector<f64, N>, h: f64);
    }
}

impl<S: Inertia<Q, N>, const Q: usize, const N: usize> Inertia<Q, N> for Counted<S> {
    type Mass = S::Mass;
    forward! {
        mass_matrix(q: &SVector<f64, Q>, mass: &mut impl MatrixSink);
        factor_mass(q: &SVector<f64, Q>) -> Option<Self::Mass>;
        solve_mass(mass: &Self::Mass, x: &mut SVector<f64, N>);
        momentum(q: &SVector<f64, Q>, v: &SVector<f64, N>, p: &mut SVector<f64, N>);
        affinities(q: &SVector<f64, Q>, gamma: &mut impl TensorSink);
        kinetic_energy(q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64;
    }
}

impl<S: Constraints<Q, N, R>, const Q: usize, const N: usize, const R: usize> Constraints<Q, N, R>
    for Counted<S>
{
    forward! {
        holonomic(t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>);
        constraints(t: f64, q: &SVector<f64, Q>, phi: &mut SVector<f64, R>, a: &mut impl MatrixSink, b: &mut SVector<f64, R>);
        constraint_rates(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, a_rate: &mut impl MatrixSink, gamma: &mut SVector<f64, R>);
        solve_mass_rows(mass: &Self::Mass, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>);
        delassus(a: &SMatrix<f64, N, R>, w: &SMatrix<f64, N, R>, delassus: &mut SMatrix<f64, R, R>);
        metric(mass: &Self::Mass, t: f64, q: &SVector<f64, Q>, a: &SMatrix<f64, N, R>, w: &mut SMatrix<f64, N, R>, delassus: &mut SMatrix<f64, R, R>);
        row_rates(a: &SMatrix<f64, N, R>, v: &SVector<f64, N>, rates: &mut SVector<f64, R>);
    }
}

impl<S: Loads<Q, N>, const Q: usize, const N: usize> Loads<Q, N> for Counted<S> {
    type Inputs = S::Inputs;

    fn inputs(&self) -> &[f64] {
        self.inner.inputs()
    }
    fn inputs_mut(&mut self) -> &mut [f64] {
        self.inner.inputs_mut()
    }
    forward! {
        applied_forces(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>);
        forces(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f: &mut SVector<f64, N>);
        applied_force_tangents(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f_q: &mut impl MatrixSink, f_v: &mut impl MatrixSink);
        force_tangents(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, f_q: &mut impl MatrixSink, f_v: &mut impl MatrixSink, p_q: &mut impl MatrixSink);
        acceleration(t: f64, q: &SVector<f64, Q>, acceleration: &mut SVector<f64, N>);
        potential_energy(q: &SVector<f64, Q>) -> f64;
        nonconservative_power(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>) -> f64;
    }
}

impl<S: Observables<Q, N, R>, const Q: usize, const N: usize, const R: usize> Observables<Q, N, R>
    for Counted<S>
{
    type Outputs = S::Outputs;

    forward! {
        outputs(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, outputs: &mut [f64]);
        events(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, events: &mut [f64]);
        points(t: f64, q: &SVector<f64, Q>, points: &mut [[f64; 3]]);
        reactions(t: f64, q: &SVector<f64, Q>, v: &SVector<f64, N>, acceleration: &SVector<f64, N>, lambda: &SVector<f64, R>, reactions: &mut [f64]);
    }
}

impl<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize> System<Q, N, R>
    for Counted<S>
{
    const MODEL: &'static Model = S::MODEL;
    const STRUCTURE: Structure = S::STRUCTURE;
}

fn settings(corrections: usize) -> Settings {
    Settings {
        fixed_iterations: Some(corrections),
        ..Settings::default()
    }
}

/// Steps through singular poses, counted one by one.
fn count<M, S, const Q: usize, const N: usize, const R: usize>(mechanism: M, corrections: usize)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let calls = Calls::default();
    let state = Simulation::new(mechanism.clone()).unwrap().state().clone();
    let system = Counted {
        inner: mechanism.prepare().unwrap(),
        calls: calls.clone(),
    };
    let mut stepper = TwoLevelStepper::new(system, state, &settings(corrections)).unwrap();
    let bound = M::MODEL.step_flops(corrections).unwrap();
    let cost = |name: &str| {
        let function = M::MODEL.operations.iter().find(|f| f.function == name);
        function.map(|f| f.additions + f.multiplications + 5 * f.divisions + 20 * f.calls)
    };
    for _ in 0..1500 {
        calls.lock().unwrap().clear();
        stepper.step(1e-3).unwrap();
        let calls = calls.lock().unwrap();
        let times = |name: &str| calls.get(name).copied().unwrap_or(0);
        assert_eq!(times("constraints"), corrections + 1);
        assert_eq!(times("metric"), 1);
        assert_eq!(times("delassus"), 1);
        assert_eq!(times("acceleration"), 1);
        assert!(times("row_rates") <= 3, "{calls:?}");
        let spent: usize = calls
            .iter()
            .map(|(name, times)| times * cost(name).unwrap_or(2 * N * N * R))
            .sum();
        assert!(spent < bound, "{spent} of {bound}: {calls:?}");
        let known = [
            "constraints",
            "metric",
            "delassus",
            "acceleration",
            "row_rates",
        ];
        assert!(calls.keys().all(|name| known.contains(name)), "{calls:?}");
    }
}

#[test]
fn calls_are_those_of_the_bound() {
    for corrections in [1, 2, 4] {
        count(SliderCrank::default(), corrections);
    }
}

#[test]
fn residuals_are_reported_and_do_not_grow() {
    for (corrections, bound) in [(1, 1e-10), (2, 1e-13), (3, 1e-13)] {
        let mut simulation =
            Simulation::with_settings(SliderCrank::default(), settings(corrections)).unwrap();
        simulation.run_until(0.3).unwrap();
        let early = simulation.report().holonomic_error;
        simulation.run_until(5.0).unwrap();
        let report = simulation.report();
        println!("{corrections} corrections: {early:.1e} before the first pose, {report:?}");
        assert_eq!(report.iterations, corrections as u64 * report.stages);
        assert_eq!((report.steps, report.placed_steps), (5000, 0));
        assert!(report.rank_losses > 2, "{report:?}");
        assert!(early < bound, "{early:e}");
        assert!(report.holonomic_error < 1e-9, "{report:?}");
        assert!(report.energy_error < 1e-2, "{report:?}");
    }
}

#[test]
fn the_bound_grows_with_the_corrections() {
    let bound = |n| SliderCrank::MODEL.step_flops(n);
    let (one, two, three) = (bound(1).unwrap(), bound(2).unwrap(), bound(3).unwrap());
    assert!(one < two && three - two == two - one);
    println!("bounds: {one}, {two}, {three}");
    assert_eq!(bound(0), None);
    assert_eq!(Damped::MODEL.step_flops(2), None);
}

#[test]
fn costs_that_are_not_known_are_refused() {
    let refused = |error: Option<SimulationError>| {
        let Some(SimulationError::Setting { name, .. }) = error else {
            panic!("{error:?}");
        };
        assert_eq!(name, "fixed_iterations");
    };
    refused(Simulation::with_settings(Damped::default(), settings(2)).err());
    refused(Simulation::with_settings(SliderCrank::default(), settings(0)).err());
    let paced = Settings {
        tolerance: Some(1e-6),
        ..settings(2)
    };
    refused(Simulation::with_settings(SliderCrank::default(), paced).err());
}
