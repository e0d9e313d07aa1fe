//! Large mechanisms: steps with sparse elimination are the same as with dense arrays.

#[allow(dead_code)]
use crate::common;
use mbs_examples::scenes::four_bar_10::FourBar10;
use mbs_examples::scenes::four_bar_40::{FourBar40, FourBar40Simulation};
use mbs_macros_core::dag::{self, Sparse};
use mbs_runtime::generated::pattern::{self, Pattern};
use mbs_runtime::nalgebra::{SMatrix, SVector};
use mbs_runtime::{
    BaselineStepper, BaumgarteSettings, Mechanism, Method, Settings, Simulation, State, System,
    TwoLevelStepper, mechanism,
};
use mbs_tests::random::Random;
use mbs_tests::tampered::Tampered;

// A truss that swings about a pin, pulled by a spring. One diagonal of each panel would be enough: five rows are
// redundant.
mechanism!(Truss {
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Natural),
    m: Param(1.0_kg),
    l: Param(1.0_m),
    d: Param(1.4142135623730951_m),

    post0: Bar(mass = m, length = l, angle = 90.0_deg),
    bottom1: Bar(mass = m, length = l, angle = 0.0_deg),
    top1: Bar(mass = m, length = l, angle = 0.0_deg),
    post1: Bar(mass = m, length = l, angle = 90.0_deg),
    rise1: Bar(mass = m, length = d, angle = 45.0_deg),
    fall1: Bar(mass = m, length = d, angle = -45.0_deg),
    bottom2: Bar(mass = m, length = l, angle = 0.0_deg),
    top2: Bar(mass = m, length = l, angle = 0.0_deg),
    post2: Bar(mass = m, length = l, angle = 90.0_deg),
    rise2: Bar(mass = m, length = d, angle = 45.0_deg),
    fall2: Bar(mass = m, length = d, angle = -45.0_deg),
    bottom3: Bar(mass = m, length = l, angle = 0.0_deg),
    top3: Bar(mass = m, length = l, angle = 0.0_deg),
    post3: Bar(mass = m, length = l, angle = 90.0_deg),
    rise3: Bar(mass = m, length = d, angle = 45.0_deg),
    fall3: Bar(mass = m, length = d, angle = -45.0_deg),
    bottom4: Bar(mass = m, length = l, angle = 0.0_deg),
    top4: Bar(mass = m, length = l, angle = 0.0_deg),
    post4: Bar(mass = m, length = l, angle = 90.0_deg),
    rise4: Bar(mass = m, length = d, angle = 45.0_deg),
    fall4: Bar(mass = m, length = d, angle = -45.0_deg),
    bottom5: Bar(mass = m, length = l, angle = 0.0_deg),
    top5: Bar(mass = m, length = l, angle = 0.0_deg),
    post5: Bar(mass = m, length = l, angle = 90.0_deg),
    rise5: Bar(mass = m, length = d, angle = 45.0_deg),
    fall5: Bar(mass = m, length = d, angle = -45.0_deg),

    pin: Revolute(ground.origin, post0.a),
    a1: Revolute(post0.a, bottom1.a),
    b1: Revolute(post0.b, top1.a),
    c1: Revolute(bottom1.b, post1.a),
    d1: Revolute(top1.b, post1.b),
    e1: Revolute(post0.a, rise1.a),
    f1: Revolute(top1.b, rise1.b),
    g1: Revolute(post0.b, fall1.a),
    h1: Revolute(bottom1.b, fall1.b),
    a2: Revolute(bottom1.b, bottom2.a),
    b2: Revolute(top1.b, top2.a),
    c2: Revolute(bottom2.b, post2.a),
    d2: Revolute(top2.b, post2.b),
    e2: Revolute(bottom1.b, rise2.a),
    f2: Revolute(top2.b, rise2.b),
    g2: Revolute(top1.b, fall2.a),
    h2: Revolute(bottom2.b, fall2.b),
    a3: Revolute(bottom2.b, bottom3.a),
    b3: Revolute(top2.b, top3.a),
    c3: Revolute(bottom3.b, post3.a),
    d3: Revolute(top3.b, post3.b),
    e3: Revolute(bottom2.b, rise3.a),
    f3: Revolute(top3.b, rise3.b),
    g3: Revolute(top2.b, fall3.a),
    h3: Revolute(bottom3.b, fall3.b),
    a4: Revolute(bottom3.b, bottom4.a),
    b4: Revolute(top3.b, top4.a),
    c4: Revolute(bottom4.b, post4.a),
    d4: Revolute(top4.b, post4.b),
    e4: Revolute(bottom3.b, rise4.a),
    f4: Revolute(top4.b, rise4.b),
    g4: Revolute(top3.b, fall4.a),
    h4: Revolute(bottom4.b, fall4.b),
    a5: Revolute(bottom4.b, bottom5.a),
    b5: Revolute(top4.b, top5.a),
    c5: Revolute(bottom5.b, post5.a),
    d5: Revolute(top5.b, post5.b),
    e5: Revolute(bottom4.b, rise5.a),
    f5: Revolute(top5.b, rise5.b),
    g5: Revolute(top4.b, fall5.a),
    h5: Revolute(bottom5.b, fall5.b),

    spring: SpringDamper(
        ground.point(3.0, 4.0),
        top3.b,
        stiffness = 200.0_N_per_m,
        length = 1.0_m
    ),
});

/// The largest difference of positions and of velocities, and how far the first has moved.
fn apart<const Q: usize, const N: usize, const R: usize>(
    sparse: &State<Q, N, R>,
    dense: &State<Q, N, R>,
    start: &State<Q, N, R>,
) -> [f64; 3] {
    [
        (sparse.positions - dense.positions).amax(),
        (sparse.velocities - dense.velocities).amax(),
        (sparse.positions - start.positions).amax(),
    ]
}

/// The largest difference of positions and of velocities between the two after these steps, and how far it moved.
fn difference<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    steps: usize,
) -> [f64; 3]
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    assert!(S::ELIMINATION.is_some());
    let system = mechanism.prepare().expect("parameters");
    let start = Simulation::with_settings(mechanism, settings).expect("assembled");
    let state = start.state().clone();
    let dense = Tampered::new(system.clone(), "nothing");
    let mut sparse = TwoLevelStepper::new(system, state.clone(), &settings).expect("settings");
    let mut dense = TwoLevelStepper::new(dense, state.clone(), &settings).expect("settings");
    for _ in 0..steps {
        sparse.step(settings.step).expect("a step");
        dense.step(settings.step).expect("a step");
    }
    apart(sparse.state(), dense.state(), &state)
}

#[test]
fn loops_move_as_with_dense_arrays() {
    // Up to 0.6 s: the first singular pose is at 0.72 s.
    for (order, step, steps) in [(2, 2e-3, 300), (4, 2e-2, 30), (8, 2e-2, 30)] {
        let settings = Settings {
            order,
            step,
            ..Settings::default()
        };
        let [positions, velocities, moved] = difference(FourBar10::default(), settings, steps);
        println!("order {order}: {positions:.1e} m, {velocities:.1e} m/s");
        assert!(moved > 0.5);
        assert!(positions < 1e-10 && velocities < 1e-9);
    }
}

/// The same with an explicit method.
fn explicit_difference<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
    settings: Settings,
    steps: usize,
) -> [f64; 3]
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let system = mechanism.prepare().expect("parameters");
    let start = Simulation::with_any_method(mechanism, settings).expect("assembled");
    let state = start.state().clone();
    let dense = Tampered::new(system.clone(), "nothing");
    let mut sparse = BaselineStepper::new(system, state.clone(), &settings).expect("settings");
    let mut dense = BaselineStepper::new(dense, state.clone(), &settings).expect("settings");
    for _ in 0..steps {
        sparse.step(settings.step).expect("a step");
        dense.step(settings.step).expect("a step");
    }
    apart(sparse.state(), dense.state(), &state)
}

#[test]
fn explicit_steps_are_as_with_dense_arrays() {
    let stabilised = |adaptive| {
        Method::Baumgarte(BaumgarteSettings {
            adaptive,
            ..BaumgarteSettings::default()
        })
    };
    let methods = [
        (Method::Projected, 4),
        (Method::Projected, 8),
        (stabilised(None), 4),
        (stabilised(Some(1e-8)), 4),
    ];
    for (method, order) in methods {
        let settings = Settings {
            method,
            order,
            step: 2e-2,
            ..Settings::default()
        };
        let loops = explicit_difference(FourBar10::default(), settings, 30);
        let truss = explicit_difference(Truss::default(), settings, 50);
        for [positions, velocities, moved] in [loops, truss] {
            println!("{method:?}: {positions:.1e} m, {velocities:.1e} m/s");
            assert!(moved > 0.1);
            assert!(positions < 1e-10 && velocities < 1e-9);
        }
    }
}

#[test]
fn redundant_rows_and_springs_move_as_with_dense_arrays() {
    for (order, step, steps) in [(2, 2e-3, 500), (6, 2e-2, 50)] {
        let settings = Settings {
            order,
            step,
            ..Settings::default()
        };
        let [positions, velocities, moved] = difference(Truss::default(), settings, steps);
        println!("order {order}: {positions:.1e} m, {velocities:.1e} m/s");
        assert!(moved > 0.5);
        assert!(positions < 1e-10 && velocities < 1e-9);
    }
    // Not compared with dense arrays, which solve for redundant rows by the proximal method.
    let mut simulation = Simulation::new(Truss::default()).expect("assembled");
    simulation.run_until(1.0).expect("the end");
    let report = simulation.report();
    assert_eq!((report.rank, report.regularised_solves), (21, 0));
}

#[test]
fn energy_is_kept_through_singular_poses() {
    // In ten seconds it passes the singular pose ten times.
    for (order, step, energy) in [(2, 1e-2, 0.5), (8, 2.5e-2, 1e-6)] {
        let settings = Settings {
            order,
            step,
            ..Settings::default()
        };
        let mut simulation =
            Simulation::with_settings(FourBar10::default(), settings).expect("assembled");
        simulation.run_until(10.0).expect("the end");
        let report = simulation.report();
        println!("order {order}: {report:?}");
        assert!(report.energy_error < energy);
        assert!(report.rank_losses >= 8);
        assert!(report.holonomic_error < 1e-10 && report.velocity_error < 1e-10);
        // Only a few steps with dense arrays.
        assert!(report.regularised_solves < report.stages / 50);
        // The parallelogram branch: all cranks are parallel.
        let q = simulation.positions();
        for crank in 1..=10 {
            let (x, y) = (q[2 * crank] - crank as f64, q[2 * crank + 1]);
            assert!((x - q[0]).abs() < 1e-6 && (y - q[1]).abs() < 1e-6);
        }
    }
}

/// Where rows are nearly dependent the dense equations take over.
#[test]
fn explicit_steps_pass_singular_poses() {
    let settings = Settings {
        method: Method::Projected,
        order: 8,
        ..Settings::for_tolerance(1e-8)
    };
    let mut simulation =
        Simulation::with_any_method(FourBar10::default(), settings).expect("assembled");
    simulation.run_until(10.0).expect("the end");
    let report = simulation.report();
    println!("{report:?}");
    assert!(report.energy_error < 1e-5);
    assert!(report.rank_losses >= 8);
    assert!(report.holonomic_error < 1e-10 && report.velocity_error < 1e-10);
}

/// How a scene is eliminated.
fn elimination(name: &str) -> Sparse {
    let declarations = common::declarations();
    let found = declarations.into_iter().find(|(known, _)| known == name);
    let (_, analysis) = mbs_macros_core::analyse(found.expect("declared").1);
    let program = dag::lower(&analysis.expect("correct").derived);
    program.sparse.expect("a large mechanism")
}

#[test]
fn a_chain_is_eliminated_in_loops() {
    let [short, long] = ["FourBar10", "FourBar40"].map(|name| elimination(name).rows);
    let written = |e: &dag::Elimination| e.stretches.iter().map(|s| s.period).sum::<usize>();
    assert_eq!(written(&short), written(&long));
    // Four unknowns a loop, and fill that does not grow.
    assert_eq!(long.columns.len() - short.columns.len(), 30 * 4);
    assert_eq!(long.slots - short.slots, 30 * 21);
    assert!(long.columns.iter().all(|column| column.below.len() <= 6));
}

#[test]
fn a_row_is_eliminated_after_the_velocities_it_couples() {
    for name in ["FourBar10", "FourBar40"] {
        let Sparse {
            rows,
            jacobian,
            size,
            ..
        } = elimination(name);
        for (row, column) in jacobian {
            assert!(rows.positions[size + row] > rows.positions[column]);
        }
    }
}

/// The pattern of an elimination, as generated code has it in statics.
fn pattern(elimination: &dag::Elimination) -> Pattern {
    let dag::Table {
        starts,
        positions,
        lists,
        crossings,
        is_row,
    } = elimination.table();
    Pattern {
        starts: starts.leak(),
        positions: positions.leak(),
        lists: lists.leak(),
        crossings: crossings.leak(),
        is_row: is_row.leak(),
    }
}

/// Mechanisms whose code would be too long are eliminated by tables; here one that is not, both ways.
#[test]
fn tables_eliminate_like_code() {
    let system = FourBar40::default().prepare().expect("valid");
    eliminate_both_ways(&system, &pattern(&elimination("FourBar40").rows));
}

fn eliminate_both_ways<S: System<Q, N, R>, const Q: usize, const N: usize, const R: usize>(
    system: &S,
    pattern: &Pattern,
) {
    let plan = S::ELIMINATION.expect("a large mechanism");
    let (q, _) = system.guess();
    let mut random = Random::of("tables");
    let mut mass = Box::new(SMatrix::<f64, N, N>::zeros());
    system.mass_matrix(&q, &mut mass);
    // K at the guess, and at another instant, where the rows are others.
    let entries = [0.0, 0.1].map(|size| {
        let mut entries = vec![0.0; plan.slots];
        for &(i, j, slot) in plan.mass {
            entries[slot] = mass[(i, j)];
        }
        let moved: SVector<f64, Q> = q + random.vector(1.0) * size;
        let (mut phi, mut b) = (SVector::zeros(), SVector::zeros());
        system.sparse_constraints(0.0, &moved, &mut phi, &mut entries, &mut b);
        entries
    });
    let room = plan.slots + plan.unknowns;
    let both = entries.map(|entries| {
        let mut roomy = entries.clone();
        roomy.resize(room, 0.0);
        (entries, roomy)
    });
    let [(mut f, mut f_tabled), (mut g, mut g_tabled)] = both;
    let right: SVector<f64, R> = random.vector(1.0);
    let start = f.clone();
    let (mut c, mut c_tabled) = (vec![0.0; plan.unknowns], vec![0.0; plan.unknowns]);
    let most = (plan.factor)(&mut f, &mut c);
    let most_tabled = pattern::factor(pattern, &mut f_tabled, &mut c_tabled);
    near(&[most], &[most_tabled]);
    near(&c, &c_tabled);
    near(&f, &f_tabled[..plan.slots]);

    let (mut x, mut v, mut kappa) = (vec![0.0; plan.unknowns], SVector::zeros(), SVector::zeros());
    (plan.solve)(&f, &right, &mut x, &mut v, &mut kappa);
    let mut x_tabled = vec![0.0; plan.unknowns];
    for (&(position, _), value) in plan.pivots.iter().zip(right.iter()) {
        x_tabled[position] = *value;
    }
    let spread = x_tabled.clone();
    pattern::solve(pattern, &f_tabled, &mut x_tabled);
    near(&x, &x_tabled);

    f_tabled[..plan.slots].copy_from_slice(&start);
    f = start;
    let kicks = plan.kicks.as_ref().expect("holonomic rows");
    let most = (kicks.factor_pair)(&mut f, &mut g, &c);
    let most_tabled = pattern::factor_pair(pattern, &mut f_tabled, &mut g_tabled, &c);
    near(&[most], &[most_tabled]);
    near(&f, &f_tabled[..plan.slots]);
    // The diagonal is in the lower triangle.
    for &start in pattern.starts {
        g_tabled[start as usize] = g.get(start as usize).copied().unwrap_or(0.0);
    }
    near(&g, &g_tabled[..plan.slots]);
    (kicks.solve_pair)(&f, &g, &right, &mut x, &mut v, &mut kappa);
    let mut x_tabled = spread;
    pattern::solve_pair(pattern, &f_tabled, &g_tabled, &mut x_tabled);
    near(&x, &x_tabled);
}

fn near(a: &[f64], b: &[f64]) {
    assert_eq!(a.len(), b.len());
    let size = a.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    for (a, b) in a.iter().zip(b) {
        assert!((a - b).abs() <= 1e-12 * size, "{a} {b}");
    }
}

/// M⁻¹ and all matrices of a step are on the heap.
#[test]
fn a_large_simulation_needs_little_stack() {
    const VELOCITIES: usize = 82;
    let matrix = size_of::<[[f64; VELOCITIES]; VELOCITIES]>();
    assert!(size_of::<FourBar40Simulation>() < matrix);
    let run = || {
        let mut simulation = Simulation::new(FourBar40::default()).expect("assembled");
        simulation.run_until(0.1).expect("the end");
    };
    // Unoptimised, construction would need some twenty copies of M⁻¹ if it were part of the simulation.
    let thread = std::thread::Builder::new().stack_size(12 * matrix);
    thread.spawn(run).expect("a thread").join().expect("a run");
}
