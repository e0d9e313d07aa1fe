//! A family of many members: its mobility, its code as loops over tables, and its motion.

use crate::sizes;
use mbs_macros_core::{analyse, emit};
use mbs_runtime::{Mechanism, Settings, Simulation, mechanism};

const LOOPS: usize = 130;

// So many that lists and statements are written as texts and loops: four-bars in a row, all cranks parallel.
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
    let reactions = simulation.reactions().expect("reactions").values;
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
