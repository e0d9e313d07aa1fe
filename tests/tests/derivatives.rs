//! Every compiled function of every mechanism is compared with differences, with the interpreter of expressions, and
//! with the interpreter of programs.

use mbs_examples::scenes;
use mbs_macros_core::model;
use mbs_macros_core::schema::World;
use mbs_runtime::{Mechanism, System};
use mbs_tests::fixtures;
use mbs_tests::interpreted::{Interpreted, analysis};
use mbs_tests::random::{Arguments, Random};
use mbs_tests::tampered::{QUANTITIES, Tampered};
use mbs_tests::{compiled, differences};
use std::collections::BTreeSet;

/// States at which each mechanism is examined; fewer for large mechanisms.
fn count(size: usize) -> usize {
    if size > 20 { 1 } else { 3 }
}

/// A system whose inputs are not their defaults, and states for it.
fn prepare<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
) -> (S, Vec<Arguments<Q, N, R>>, Random)
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mut random = Random::of(<M as Mechanism>::MODEL.name);
    let mut system = mechanism.prepare().expect("default parameters are good");
    for input in system.inputs_mut() {
        *input += random.within(1.0);
    }
    let states = (0..count(N))
        .map(|_| Arguments::near(&system, &mut random))
        .collect();
    (system, states, random)
}

fn differences<M, S, const Q: usize, const N: usize, const R: usize>()
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (system, states, mut random) = prepare(&M::default());
    for at in &states {
        assert_none(
            differences::findings(&system, at, &mut random),
            S::MODEL.name,
        );
    }
}

fn interpreters<M, S, const Q: usize, const N: usize, const R: usize>()
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let mechanism = M::default();
    let (system, states, _) = prepare(&mechanism);
    let interpreted = Interpreted::new(&mechanism);
    for at in &states {
        let compiled = compiled::table(&system, at);
        let (symbolic, program) = interpreted.tables(&system, at);
        assert_none(compiled.differences(&symbolic, 1e-11, false), "expressions");
        assert_none(
            compiled.differences(&program, 4.0 * f64::EPSILON, true),
            "programs",
        );
        let (program, compiled) = (program.functions(), compiled.functions());
        let missing: Vec<_> = program.difference(&compiled).collect();
        assert!(missing.is_empty(), "only interpreted: {missing:?}");
    }
}

fn assert_none(findings: Vec<String>, what: &str) {
    assert!(
        findings.is_empty(),
        "{what}: {} findings\n{}",
        findings.len(),
        findings
            .iter()
            .take(20)
            .cloned()
            .collect::<Vec<_>>()
            .join("\n")
    );
}

macro_rules! mechanisms {
    ($($test:ident: $mechanism:ty;)*) => {
        mod against_differences {
            use super::*;
            $(#[test]
            fn $test() {
                differences::<$mechanism, _, _, _, _>();
            })*
        }

        mod against_interpreters {
            use super::*;
            $(#[test]
            fn $test() {
                interpreters::<$mechanism, _, _, _, _>();
            })*
        }

        /// Declarations of all mechanisms that are tested here.
        fn declarations() -> Vec<&'static str> {
            vec![$(<$mechanism as Mechanism>::MODEL.declaration),*]
        }
    };
}

mechanisms! {
    press: fixtures::Press;
    truss: fixtures::Truss;
    sled: fixtures::Sled;
    chain: fixtures::Chain;
    functions: fixtures::Functions;
    measured: fixtures::Measured;
    limited: fixtures::Limited;
    limited_in_space: fixtures::LimitedInSpace;
    pendulum: scenes::pendulum::Pendulum;
    pendulum_by_angle: scenes::pendulum::PendulumByAngle;
    double_pendulum: scenes::double_pendulum::DoublePendulum;
    slider_crank: scenes::slider_crank::SliderCrank;
    driven_slider_crank: scenes::driven_slider_crank::DrivenSliderCrank;
    double_four_bar: scenes::double_four_bar::DoubleFourBar;
    four_bar_10: scenes::four_bar_10::FourBar10;
    four_bar_40: scenes::four_bar_40::FourBar40;
    andrews: scenes::andrews::Andrews;
    chaplygin_sleigh: scenes::chaplygin_sleigh::ChaplyginSleigh;
    knife_edge: scenes::knife_edge::KnifeEdge;
    workshop: fixtures::Workshop;
    incline: fixtures::Incline;
    disks: fixtures::Disks;
    whip: fixtures::Whip;
    vice: fixtures::Vice;
    spine: fixtures::Spine;
    spherical_pendulum: scenes::spherical_pendulum::SphericalPendulum;
    heavy_top: scenes::heavy_top::HeavyTop;
    bricard: scenes::bricard::Bricard;
    bricard_reference: scenes::bricard::BricardReference;
    flyball_governor: scenes::flyball_governor::FlyballGovernor;
    cardan_shaft: scenes::cardan_shaft::CardanShaft;
    rolling_disk: scenes::rolling_disk::RollingDisk;
    rattleback: scenes::rattleback::Rattleback;
}

#[test]
fn no_scene_is_forgotten() {
    let known = declarations();
    for scene in scenes::scenes() {
        assert!(
            known.contains(&scene.model.declaration),
            "add the mechanism of `{}` to the list in this file",
            scene.name
        );
    }
}

#[test]
fn every_kind_of_the_schema_is_used() {
    let mut used = BTreeSet::new();
    for declaration in declarations() {
        let mut errors = mbs_macros_core::diagnostics::Errors::new();
        let tree = mbs_macros_core::syntax::parse(
            declaration.parse().unwrap(),
            model::kinds(),
            &mut errors,
        );
        errors.stop_if_any().expect("it compiled");
        let tree = tree.expect("it compiled");
        let world = tree.world_kind().describe();
        used.extend(
            tree.entries
                .iter()
                .map(|entry| (world, entry.kind.to_string())),
        );
    }
    let mut missing: Vec<(&str, &str)> = Vec::new();
    for world in World::ALL.map(World::describe) {
        let own = World::ALL.into_iter().filter(|w| w.describe() == world);
        let kinds = own.flat_map(|world| model::kinds().own(world));
        missing.extend(
            kinds
                .map(|kind| (world, kind.name))
                .filter(|(_, name)| !used.contains(&(world, (*name).to_owned()))),
        );
    }
    let commonly_used = |name: &str| used.iter().any(|(_, kind)| kind == name);
    let common = model::kinds()
        .common()
        .iter()
        .map(|kind| ("both", kind.name));
    missing.extend(common.filter(|(_, name)| !commonly_used(name)));
    assert_eq!(missing, Vec::new());
}

/// Whether an error in a function is found in a mechanism.
fn finds<M, S, const Q: usize, const N: usize, const R: usize>(wrong: &'static str) -> bool
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let (system, states, mut random) = prepare(&M::default());
    let tampered = Tampered::new(system, wrong);
    states
        .iter()
        .any(|at| !differences::findings(&tampered, at, &mut random).is_empty())
}

/// A small error in any function is found in at least one mechanism.
#[test]
fn an_error_in_any_function_is_found() {
    let finds = |wrong| {
        finds::<fixtures::Truss, _, _, _, _>(wrong)
            || finds::<fixtures::Chain, _, _, _, _>(wrong)
            || finds::<scenes::pendulum::Pendulum, _, _, _, _>(wrong)
    };
    for &wrong in QUANTITIES {
        assert!(finds(wrong), "an error in `{wrong}` is not found");
    }
    assert!(!finds("nothing"));
}

/// In space, too, where coordinates are not integrals of velocities.
#[test]
fn an_error_in_any_function_of_space_is_found() {
    let finds = |wrong| {
        finds::<scenes::heavy_top::HeavyTop, _, _, _, _>(wrong)
            || finds::<scenes::rolling_disk::RollingDisk, _, _, _, _>(wrong)
            || finds::<fixtures::Workshop, _, _, _, _>(wrong)
    };
    for &wrong in QUANTITIES {
        assert!(finds(wrong), "an error in `{wrong}` is not found");
    }
    assert!(!finds("nothing"));
}

/// The interpreters have as many rows and coordinates as the compiled code.
#[test]
fn declarations_compile_to_the_same_sizes_again() {
    for scene in scenes::scenes() {
        let analysis = analysis(scene.model.declaration);
        assert_eq!(analysis.derived.system.size, scene.model.velocities.len());
        assert_eq!(analysis.derived.system.rows.len(), scene.model.rows.len());
    }
}

/// A chain of bars in joint coordinates: of the plane, or of space with axes in turn.
fn chain(links: usize, spatial: bool) -> String {
    let world = match spatial {
        true => "Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint)",
        false => "Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint)",
    };
    let mut out = format!("Chain {{ world: {world},");
    for k in 0..links {
        let before = match k {
            0 => "ground".to_owned(),
            k => format!("link{}", k - 1),
        };
        let (next, axis) = (k + 1, ["X", "Y"][k % 2]);
        out += &match (spatial, k) {
            (true, _) => format!(
                "link{k}: Bar(mass = 1.0_kg, from = [0.0, 0.0, -{k}.0], to = [0.0, 0.0, -{next}.0], radius = 0.05_m),
                joint{k}: Revolute({before}, link{k}, at = [0.0, 0.0, -{k}.0], axis = {axis}),"
            ),
            (false, 0) => "link0: Bar(mass = 1.0_kg, length = 1.0_m),
                joint0: Revolute(ground.origin, link0.a),"
                .to_owned(),
            (false, _) => format!(
                "link{k}: Bar(mass = 1.0_kg, length = 1.0_m),
                joint{k}: Revolute({before}.b, link{k}.a),"
            ),
        };
    }
    out + "}"
}

/// Affinities are generated if their code is short, for any number of velocities.
#[test]
fn affinities_are_generated_where_they_are_short() {
    let operations = |declaration: &str| {
        let program = mbs_macros_core::dag::lower(&analysis(declaration).derived);
        let function = program.function("affinities");
        function.map(|function| function.cost().total())
    };
    for scene in scenes::scenes() {
        assert!(
            operations(scene.model.declaration).is_some(),
            "{}",
            scene.name
        );
    }
    let planar = operations(&chain(12, false));
    assert!(planar.is_some_and(|count| count > 0), "{planar:?}");
    // The same fixture tests the affinities that the runtime computes instead.
    let whip = <fixtures::Whip as Mechanism>::MODEL.declaration;
    assert_eq!(operations(whip), None);
}

/// Deriving affinities that are too long stops on the way. (With all of them, twice the length of this chain gives 5.7 times
/// the expressions.)
#[test]
fn deriving_long_affinities_stops_early() {
    let derived = |links| analysis(&chain(links, true)).derived;
    let (short, long) = (derived(12), derived(24));
    assert!(short.affinities.is_none() && long.affinities.is_none());
    let (short, long) = (short.system.graph.len(), long.system.graph.len());
    assert!(long < 4 * short, "{long} nodes against {short}");
}

/// M and the tangents of inertia of a chain are those of composite bodies, and its forces without rows take operations in
/// proportion to its length. (Entry by entry M takes 26 n², the tangents 80 n².)
#[test]
fn long_chains_have_composite_bodies() {
    for links in [20, 30] {
        let program = mbs_macros_core::dag::lower(&analysis(&chain(links, true)).derived);
        let operations = |name: &str| {
            let function = program.function(name);
            function.expect("M varies").cost().total()
        };
        let square = links * links;
        assert!(operations("mass_matrix") < 11 * square);
        assert!(operations("balance_tangents") < 50 * square);
        assert!(operations("free_forces") < 250 * links);
    }
}

/// The rows that close a long ring are derived in passes, whose operations grow with its length. (Entry by entry γ takes 230 n²
/// operations for n rods, and A 33 n².)
#[test]
fn the_rows_of_a_long_ring_are_derived_in_passes() {
    let ring = |rods: usize| {
        let turn = format!("360.0_deg / {rods}.0");
        format!(
            "Ring {{
                world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2], coordinates = Joint),
                turn: Let({turn}),
                x: Each(0..={rods}, |i| Let(1.0_m * cos(i * turn))),
                z: Each(0..={rods}, |i| Let(1.0_m * sin(i * turn))),
                rod: Each(0..{rods}, |i| Bar(
                    mass = 0.1_kg, radius = 0.01_m,
                    from = [x[i], 0.0_m, z[i]], to = [x[i + 1], 0.0_m, z[i + 1]],
                )),
                hook: Revolute(ground, rod[0], at = rod[0].a, axis = X),
                joint: Each(1..{rods}, |i| Universal(
                    rod[i - 1], rod[i], at = rod[i].a,
                    axis = Y, second_axis = [cos((i + 0.5) * turn), 0.0, sin((i + 0.5) * turn)],
                )),
                clasp: Spherical(rod[{last}], rod[0], at = rod[0].a),
            }}",
            last = rods - 1
        )
    };
    for rods in [8, 16] {
        let program = mbs_macros_core::dag::lower(&analysis(&ring(rods)).derived);
        let operations = |name: &str| {
            let function = program.function(name);
            function.expect("there are rows").cost().total()
        };
        assert!(operations("constraints") < 150 * rods);
        assert!(operations("constraint_rates") < 600 * rods);
    }
}
