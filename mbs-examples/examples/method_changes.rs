//! Runs with an accuracy of motions that change their character, beside runs with each of the two methods alone.
//!
//! `cargo run --release -p mbs-examples --example method_changes [-- --csv book/src/results/readme]`

use cpu_time::ProcessTime;
use mbs_examples::pages::method_changes::{COLUMNS, KEYS};
use mbs_examples::pages::record::{File, Recorder};
use mbs_runtime::{AnySimulation, Mechanism, Method, Settings, Simulation, System};
use mbs_runtime::{mechanism, methods};

mechanism!(Block {
    doc: "A block on a spring slides for 0.7 s and sticks.",
    world: Planar(),
    x: Coordinate(0.0_m, rate = 2.0_m_per_s),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    spring: SpringDamper(
        ground.point(-1.0_m, 0.0_m),
        block.origin,
        stiffness = 2.0_N_per_m,
        length = 1.0_m
    ),
    sole: Friction(
        x.rate,
        load = 9.81_N,
        coefficient = 0.2,
        static_coefficient = 0.4,
        stribeck_velocity = 0.05_m_per_s,
        regularization_velocity = 0.1_mm_per_s
    ),
});

mechanism!(Swing {
    doc: "A pendulum with friction in its bearing swings, and sticks beside the vertical.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod: Bar(mass = 1.0_kg, length = 0.5_m, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
    bush: Friction(
        rod.rate,
        load = 1.0_Nm,
        coefficient = 0.5,
        regularization_velocity = 1e-4_rad_per_s
    ),
});

mechanism!(Belt {
    doc: "A block on a spring sticks to a belt and slips, about twice in ten seconds.",
    world: Planar(),
    x: Coordinate(0.0_m),
    block: Particle(mass = 1.0_kg, position = [x, 0.0_m]),
    spring: SpringDamper(
        ground.point(-1.0_m, 0.0_m),
        block.origin,
        stiffness = 10.0_N_per_m,
        length = 1.0_m
    ),
    sole: Friction(
        x.rate - 0.1_m_per_s,
        load = 9.81_N,
        coefficient = 0.1,
        static_coefficient = 0.4,
        stribeck_velocity = 0.05_m_per_s,
        regularization_velocity = 0.1_mm_per_s
    ),
});

mechanism!(Door {
    doc: "Wind pushes a door against a stiff stop, where it bounces and comes to rest.",
    world: Planar(),
    leaf: Body(
        mass = 20.0_kg,
        inertia = 2.0_kg_m2,
        center_of_mass = [0.4_m, 0.0_m],
        rate = 0.5_rad_per_s
    ),
    hinge: Revolute(ground.origin, leaf.origin),
    wind: Torque(leaf, value = 2.0_Nm),
    limits: Stop(
        leaf.angle,
        lower = 0.0_deg,
        upper = 90.0_deg,
        stiffness = 5000.0_kNm,
        onset = 0.01_deg,
        dissipation = 2.0_s
    ),
});

mechanism!(SliderCrank {
    doc: "A motion that keeps its character.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    crank: Bar(mass = 0.36_kg, length = 0.15_m, angle = 40.0_deg),
    rod: Bar(mass = 0.15_kg, length = 0.40_m, angle = -14.0_deg),
    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),
});

const ACCURACIES: [f64; 2] = [1e-3, 1e-6];
const DURATION: f64 = 40.0;
/// The fastest of so many runs counts.
const REPEATED: usize = 3;
/// Of the run from which errors are measured.
const FINE: f64 = 1e-10;

fn main() -> Result<(), String> {
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example method_changes")?;
    recorder.check_names([])?;
    let mut file = recorder.file("method_changes.csv", &COLUMNS, KEYS)?;
    println!("{}", COLUMNS.join(", "));
    measure("block", &Block::default(), &mut file)?;
    measure("swing", &Swing::default(), &mut file)?;
    measure("belt", &Belt::default(), &mut file)?;
    measure("door", &Door::default(), &mut file)?;
    measure("slider-crank", &SliderCrank::default(), &mut file)
}

fn measure<M, S, const Q: usize, const N: usize, const R: usize>(
    name: &str,
    mechanism: &M,
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let run = |settings: Settings| -> Result<(Simulation<S, Q, N, R>, f64), String> {
        let mut best = f64::INFINITY;
        let mut last = None;
        for _ in 0..REPEATED {
            let mut simulation =
                Simulation::with_methods(mechanism.clone(), settings, methods::Accuracy)
                    .map_err(|error| error.to_string())?;
            let start = ProcessTime::now();
            simulation
                .run_until(DURATION)
                .map_err(|error| error.to_string())?;
            best = best.min(1e3 * start.elapsed().as_secs_f64());
            last = Some(simulation);
        }
        last.map(|last| (last, best)).ok_or("no run".to_owned())
    };
    let (fine, _) = run(Settings::for_tolerance(FINE))?;
    for accuracy in ACCURACIES {
        let (changing, time) = run(Settings::accuracy(accuracy))?;
        let tolerance = changing
            .settings()
            .tolerance
            .ok_or("an accuracy has a tolerance")?;
        let (_, explicit) = run(Settings {
            method: Method::Projected,
            order: 8,
            tolerance: Some(tolerance),
            ..Settings::default()
        })?;
        let radau = run(Settings {
            method: Method::Radau,
            tolerance: Some(tolerance),
            ..Settings::default()
        });
        let (_, two_level) = run(Settings::for_tolerance(tolerance))?;
        let error = (changing.positions() - fine.positions()).amax();
        let row = vec![
            name.to_owned(),
            format!("{accuracy:e}"),
            methods_of(&changing),
            format!("{:.3}", error / accuracy),
            format!("{time:.3}"),
            format!("{explicit:.3}"),
            radau.map_or("-".to_owned(), |(_, time)| format!("{time:.3}")),
            format!("{two_level:.3}"),
        ];
        println!("{}", row.join(", "));
        file.put(row)?;
    }
    Ok(())
}

/// The methods of a run, one after the other.
fn methods_of(run: &dyn AnySimulation) -> String {
    let changes = run.method_changes();
    let first = changes
        .first()
        .map_or(run.settings().method, |change| change.before);
    let mut text = first.name().to_owned();
    for change in changes {
        let (method, order, time) = (change.method.name(), change.order, change.time);
        text += &format!("; {method} {order} from {time:.1} s on");
    }
    text
}
