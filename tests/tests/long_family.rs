//! A family of many members: its mobility, its code as loops over tables, and its motion.

use crate::alloc::largest;
use crate::sizes;
use mbs_macros_core::{analyse, emit};
use mbs_runtime::{
    AssemblyVerdict, Mechanism, Settings, Simulation, SimulationError, State, System, mechanism,
};
use mbs_tests::dense::Dense;

const LOOPS: usize = 130;

// So many that statements are written as loops: four-bars in a row, all cranks parallel.
mechanism!(Loops {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    mass: Param(1.0_kg),
    rate: Param(1.0_rad_per_s),
    crank: Each(0..=130, |i| Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg,
        rate = rate
    )),
    coupler: Each(1..=130, |i| Bar(mass = mass, length = length)),
    foot: Each(0..=130, |i| Revolute(
        ground.point(i * length, 0.0),
        crank[i].a
    )),
    left: Each(1..=130, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=130, |i| Revolute(coupler[i].b, crank[i].b)),
});

#[test]
fn its_model_names_every_member() {
    let model = Loops::MODEL;
    let mobility = model.mobility.expect("it assembles");
    assert_eq!((model.rows.len(), mobility.rank), (261, 261));
    assert_eq!(mobility.degrees_of_freedom, 1);
    let last = |name: &str| name.replace("[0]", "[130]");
    assert_eq!(model.coordinates[0].name, "crank[0].b.x");
    assert_eq!(model.coordinates[260].name, last("crank[0].b.x"));
    assert_eq!(model.velocities[261].name, last("crank[0].b.y'"));
    assert_eq!(model.rows[130].entry, last("crank[0]"));
    assert_eq!(model.parts[130].kind, "Bar");
    let reaction = model.reactions[model.reactions.len() - 1];
    assert_eq!((reaction.joint, reaction.component), ("right[130]", "fy"));
    let site = reaction.at.expect("it holds a point");
    assert!(model.points[site].contains("[130]"));
    let segment = model.segments[model.segments.len() - 1];
    assert_eq!(segment.part, "coupler[130]");
    assert_eq!(model.points[segment.from], "coupler[130].a");
    assert_eq!(model.reductions.len(), 2 * 131);
    let text = model.explain().to_string();
    assert!(text.contains("… and 130 more like this"), "{text}");
}

/// A main thread has 8 MB: room for a thousand loops, 2002 velocities, without optimisation.
#[test]
fn it_needs_four_kilobytes_of_stack_for_a_velocity() {
    let run = || {
        let mut simulation = Simulation::new(Loops::default()).expect("assembled");
        simulation.run_until(0.01).expect("the end");
    };
    let velocities = Loops::MODEL.velocities.len();
    let thread = std::thread::Builder::new().stack_size(4096 * velocities);
    thread.spawn(run).expect("a thread").join().expect("a run");
}

/// The same room is enough for other parameters, from which the mechanism follows.
#[test]
fn other_parameters_need_no_more_stack() {
    let run = || {
        let mut simulation = Simulation::new(Loops::default()).expect("assembled");
        let longer = Loops {
            length: 1.001,
            ..Loops::default()
        };
        let verdict = simulation.set_parameters(longer).expect("a mechanism");
        assert_eq!(verdict.rank, 2 * LOOPS + 1);
        simulation.run_until(0.01).expect("the end");
    };
    let velocities = Loops::MODEL.velocities.len();
    let thread = std::thread::Builder::new().stack_size(4096 * velocities);
    thread.spawn(run).expect("a thread").join().expect("a run");
}

#[test]
fn it_moves_like_one_crank() {
    let settings = Settings {
        order: 8,
        step: 1e-2,
        ..Settings::default()
    };
    let mut simulation = Simulation::with_settings(Loops::default(), settings).expect("assembled");
    let count = LOOPS as f64;
    // In units of m l² and m l: inertia about the feet, and its first moment.
    let (inertia, moment) = ((count + 1.0) / 3.0 + count, (count + 1.0) / 2.0 + count);
    let energy = simulation.energy();
    assert!((energy.kinetic - 0.5 * inertia).abs() < 1e-9 * inertia);
    assert!((energy.potential - 9.81 * moment).abs() < 1e-9 * 9.81 * moment);
    let tips = simulation.points();
    for (name, tip) in Loops::MODEL.points.iter().zip(tips) {
        if let Some(i) = name.strip_prefix("crank[") {
            let (i, end) = i.split_once("].").expect("a member");
            let i: f64 = i.parse().expect("its index");
            let height = if end == "b" { 1.0 } else { 0.0 };
            assert!(
                (tip[0] - i).abs() < 1e-12 && (tip[1] - height).abs() < 1e-12,
                "{name}: {tip:?}"
            );
        }
    }
    // The feet carry all, less what turns downwards: cranks stand upright with 1 rad/s.
    let reactions = simulation.reactions().expect("reactions");
    assert!(reactions.unique);
    let reactions = reactions.values;
    // By elimination of rows, and by dense matrices.
    let mut dynamics = simulation.dynamics().expect("dense equations");
    for (of, &found) in Loops::MODEL.reactions.iter().zip(&reactions) {
        let dense = dynamics.reaction(of.joint, of.component);
        let dense = dense.expect("a component");
        let error = (found - dense).abs();
        assert!(error < 1e-9 * 9.81 * count, "{of:?}: {found} {dense}");
    }
    let names = Loops::MODEL.reactions.iter();
    let feet = names
        .zip(&reactions)
        .filter(|(of, _)| of.joint.starts_with("foot") && of.component == "fy");
    let carried: f64 = feet.map(|(_, force)| force).sum();
    let weight = 9.81 * (2.0 * count + 1.0) - moment;
    assert!(
        (carried - weight).abs() < 1e-8 * weight,
        "{carried} {weight}"
    );

    simulation.run_until(0.05).expect("the end");
    let mut state = [std::f64::consts::FRAC_PI_2, 1.0];
    let slope = |[angle, rate]: [f64; 2]| [rate, -9.81 * moment / inertia * angle.cos()];
    let moved =
        |state: [f64; 2], by: [f64; 2], h: f64| [state[0] + h * by[0], state[1] + h * by[1]];
    let h = 1e-3;
    for _ in 0..50 {
        let a = slope(state);
        let b = slope(moved(state, a, 0.5 * h));
        let c = slope(moved(state, b, 0.5 * h));
        let d = slope(moved(state, c, h));
        let sum = [0, 1].map(|k| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0);
        state = moved(state, sum, h);
    }
    for i in [0, 64, 130] {
        let tip = simulation.point(&format!("crank[{i}].b")).expect("a point");
        let off = [tip[0] - i as f64 - state[0].cos(), tip[1] - state[0].sin()];
        println!("{i}: {off:?}");
        assert!(off.iter().all(|x| x.abs() < 1e-11));
    }
}

#[test]
fn its_code_does_not_grow_with_the_count() {
    let statements = |count: usize| {
        let (tree, analysis) = analyse(sizes::families(count).parse().expect("tokens"));
        let analysis = analysis.expect("a mechanism");
        let (code, size) =
            emit::written(&tree.expect("a declaration"), &analysis, &analysis.program);
        let tokens = code.to_string().split_whitespace().count();
        (size.statements(), tokens)
    };
    let (few, many) = (statements(200), statements(400));
    println!("{few:?} {many:?}");
    assert!(many.0 < few.0 + few.0 / 10);
}

#[test]
fn its_functions_are_loops_without_tables() {
    let (tree, analysis) = analyse(sizes::families(1000).parse().expect("tokens"));
    let analysis = analysis.expect("a mechanism");
    let program = &analysis.program;
    let (code, _) = emit::written(&tree.expect("a declaration"), &analysis, program);
    let code = code.to_string();
    for name in ["constraints", "kinetic_energy"] {
        let function = program.function(name).expect("a function");
        assert!(program.parts(function).is_some(), "{name} is long");
        let table = format!("{}_TABLE", name.to_uppercase());
        assert!(!code.contains(&table), "{name}");
    }
}

#[test]
fn a_redundant_row_among_many_is_named() {
    let text = sizes::families(60).replace(
        " }",
        ", brace: Distance(crank[7].b, crank[8].b, length = length) }",
    );
    let (_, analysis) = analyse(text.parse().expect("tokens"));
    let mobility = analysis
        .expect("a mechanism")
        .mobility
        .expect("it assembles");
    assert_eq!((mobility.rank, mobility.mobility), (121, 1));
    let [redundancy] = mobility.redundant.as_slice() else {
        panic!("{mobility:?}")
    };
    assert_eq!(redundancy.row, "brace");
    assert_eq!(redundancy.follows_from, ["coupler[8]"]);
}

const BRACED: usize = 80;
const BRACED_VELOCITIES: usize = 2 * (BRACED + 1);

// Four-bars in a row with couplers that are there twice, and stays over two loops. The cranks lean more and more, so that
// the guess is not assembled unless `lean` is zero.
mechanism!(Braced {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    mass: Param(1.0_kg),
    rate: Param(1.0_rad_per_s),
    start: Param(90.0_deg),
    lean: Param(0.0_rad),
    crank: Each(0..=80, |i| Bar(
        mass = mass,
        length = length,
        angle = start + i * lean,
        rate = rate
    )),
    coupler: Each(1..=80, |i| Bar(mass = mass, length = length)),
    twin: Each(50..=52, |i| Bar(mass = mass, length = length)),
    foot: Each(0..=80, |i| Revolute(
        ground.point(i * length, 0.0),
        crank[i].a
    )),
    left: Each(1..=80, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=80, |i| Revolute(coupler[i].b, crank[i].b)),
    twin_left: Each(50..=52, |i| Revolute(crank[i - 1].b, twin[i].a)),
    twin_right: Each(50..=52, |i| Revolute(twin[i].b, crank[i].b)),
    brace: Each(30..=33, |i| Distance(
        crank[i - 1].b,
        crank[i].b,
        length = length
    )),
    stay: Each(10..=11, |i| Distance(
        crank[i - 1].b,
        crank[i + 1].b,
        length = 2.0 * length
    )),
});

// A brace that is too long, where a coupler is there already.
mechanism!(Contradiction {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    long: Param(1.1_m),
    mass: Param(1.0_kg),
    crank: Each(0..=80, |i| Bar(
        mass = mass,
        length = length,
        angle = 90.0_deg
    )),
    coupler: Each(1..=80, |i| Bar(mass = mass, length = length)),
    foot: Each(0..=80, |i| Revolute(
        ground.point(i * length, 0.0),
        crank[i].a
    )),
    left: Each(1..=80, |i| Revolute(crank[i - 1].b, coupler[i].a)),
    right: Each(1..=80, |i| Revolute(coupler[i].b, crank[i].b)),
    brace: Distance(crank[40].b, crank[41].b, length = long),
});

fn start<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: M,
) -> Result<(AssemblyVerdict, State<Q, N, R>), SimulationError>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let simulation = Simulation::new(mechanism)?;
    Ok((simulation.assembly().clone(), simulation.state().clone()))
}

#[test]
fn sparse_and_dense_starts_find_the_same_rows() {
    // Upright; in one line, where a row for each loop is dependent; and beside that pose, up to where the parts in which
    // rows differ are round-off.
    for angle in [1.5, 0.3, 1e-4, 1e-6, 1e-7, 1e-9, 0.0] {
        let braced = Braced {
            start: angle,
            ..Braced::default()
        };
        let (sparse, _) = start(braced).expect("assembled");
        let (dense, _) = start(Dense(braced)).expect("assembled");
        println!("{angle}: {} {:?}", sparse.rank, sparse.redundant_rows);
        assert_eq!(sparse.rank, dense.rank, "{angle}");
        assert_eq!(sparse.redundant_rows, dense.redundant_rows, "{angle}");
        assert_eq!(sparse.worst_rows, dense.worst_rows);
        let flat = if angle < 1e-8 { BRACED } else { 0 };
        assert_eq!(sparse.rank, 2 * BRACED + 1 - flat);
        assert_eq!(sparse.redundant_rows.len(), 9 + flat);
        for name in [
            "coupler[11].length",
            "coupler[30].length",
            "twin[51].length",
        ] {
            assert!(sparse.redundant_rows.contains(&name), "{name}");
        }
    }
}

#[test]
fn sparse_and_dense_starts_move_a_guess_alike() {
    for lean in [1e-4, 1e-3] {
        let braced = Braced {
            lean,
            ..Braced::default()
        };
        let (sparse, at) = start(braced).expect("assembled");
        let (dense, dense_at) = start(Dense(braced)).expect("assembled");
        assert!(sparse.residual_before > 1e-4 * lean && sparse.residual < 1e-10);
        assert_eq!(sparse.residual_before, dense.residual_before);
        assert_eq!(sparse.redundant_rows, dense.redundant_rows);
        assert!((sparse.moved - dense.moved).abs() < 1e-9 * dense.moved);
        let apart = (at.positions - dense_at.positions).amax();
        let velocities_apart = (at.velocities - dense_at.velocities).amax();
        println!("{lean}: {apart:e} m, {velocities_apart:e} m/s");
        assert!(apart < 1e-10 && velocities_apart < 1e-10);
        let names = |verdict: &AssemblyVerdict| {
            let changes = verdict.changes.iter();
            changes
                .map(|change| change.name)
                .collect::<std::collections::BTreeSet<_>>()
        };
        assert!(names(&sparse).len() > BRACED);
        assert_eq!(names(&sparse), names(&dense));
    }
}

#[test]
fn other_parameters_move_sparse_and_dense_alike() {
    let longer = |length| Braced {
        length,
        ..Braced::default()
    };
    let mut sparse = Simulation::new(longer(1.0)).expect("assembled");
    let mut dense = Simulation::new(Dense(longer(1.0))).expect("assembled");
    for length in [1.001, 0.9995] {
        let verdict = sparse.set_parameters(longer(length)).expect("a mechanism");
        let same = dense.set_parameters(Dense(longer(length)));
        let same = same.expect("a mechanism");
        let apart = (sparse.positions() - dense.positions()).amax();
        let velocities_apart = (sparse.velocities() - dense.velocities()).amax();
        println!("{length}: {apart:e} m, {velocities_apart:e} m/s");
        assert!(verdict.moved > 1e-4 && apart < 1e-9 && velocities_apart < 1e-9);
        assert!((verdict.moved - same.moved).abs() < 1e-9);
        assert_eq!(verdict.redundant_rows, same.redundant_rows);
        assert!((verdict.residual_before - same.residual_before).abs() < 1e-12);
    }
}

#[test]
fn contradicting_rows_are_refused_alike() {
    let message = |refused: Result<_, SimulationError>| match refused {
        Err(error) => error.to_string(),
        Ok(_) => panic!("it cannot be assembled"),
    };
    let contradiction = Contradiction::default();
    let sparse = message(start(contradiction).map(|_| ()));
    assert_eq!(sparse, message(start(Dense(contradiction)).map(|_| ())));
    assert!(sparse.contains("brace"), "{sparse}");
}

#[test]
fn no_dense_array_is_allocated() {
    let dense_array = BRACED_VELOCITIES * BRACED_VELOCITIES * size_of::<f64>();
    let starts_and_moves = || {
        let mut simulation = Simulation::new(Braced::default()).expect("assembled");
        simulation.run_until(0.01).expect("the end");
    };
    let sparse = largest(starts_and_moves);
    let dense = largest(|| {
        start(Dense(Braced::default())).expect("assembled");
    });
    println!("{sparse} {dense} {dense_array}");
    assert!(sparse < dense_array && dense >= dense_array);
}

#[test]
fn reactions_need_no_dense_array() {
    let simulation = Simulation::new(Loops::default()).expect("assembled");
    let velocities = Loops::MODEL.velocities.len();
    let dense_array = velocities * velocities * size_of::<f64>();
    let sparse = largest(|| {
        simulation.reactions().expect("reactions");
    });
    let dense = largest(|| {
        simulation.dynamics().expect("dense equations");
    });
    println!("{sparse} {dense} {dense_array}");
    assert!(sparse < dense_array && dense >= dense_array);
}
