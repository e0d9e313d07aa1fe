//! Small declarations after every stage of the compiler. `cargo insta review` shows what a change does to them.

use mbs_tests::stages;

const PENDULUM: &str = r#"Pendulum {
    doc: "A uniform bar on a bearing.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    /// Length of the bar.
    length: Param(1.0_m),
    /// Mass of the bar.
    mass: Param(2.0_kg),

    bar: Bar(mass = mass, length = length, angle = -30.0_deg),
    pivot: Revolute(ground.origin, bar.a),

    tip: Output(bar.b),
}"#;

// ANCHOR: slider_crank
const SLIDER_CRANK: &str = r#"SliderCrank {
    doc: "A crank, a rod and a massless slider.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    crank_length: Param(0.15_m),
    rod_length: Param(0.4_m),
    crank_mass: Param(0.5_kg),
    rod_mass: Param(0.8_kg),

    crank: Bar(mass = crank_mass, length = crank_length, angle = 60.0_deg, rate = 10.0_rad_per_s),
    rod: Bar(mass = rod_mass, length = rod_length),

    bearing: Revolute(ground.origin, crank.a),
    pin: Revolute(crank.b, rod.a),
    guide: PointOnLine(rod.b, ground.origin, axis = X),

    stroke: Output(rod.b.x),
}"#;
// ANCHOR_END: slider_crank

const SLEIGH: &str = r#"Sleigh {
    doc: "A body on a knife edge, tied to the ground by a spring and damper.",
    world: Planar(),

    mass: Param(3.0_kg),
    inertia: Param(0.4_kg_m2),
    arm: Param(0.2_m),
    stiffness: Param(50.0_N_per_m),
    damping: Param(2.0_N_s_per_m),

    sleigh: Body(
        mass = mass,
        inertia = inertia,
        center_of_mass = [arm, 0.0_m],
        velocity = [1.0_m_per_s, 0.0_m_per_s]
    ),
    edge: Nonholonomic(dot(sleigh.velocity, sleigh.y)),
    tie: SpringDamper(
        ground.point(2.0_m, 1.0_m),
        sleigh.point(0.0_m, 0.1_m),
        stiffness = stiffness,
        damping = damping,
        length = 0.5_m
    ),

    heading: Output(sleigh.angle),
    sideways: Event(sleigh.angle.cos()),
}"#;

const FLAP: &str = r#"Flap {
    doc: "A body on a hinge with a spring, in space.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    mass: Param(2.0_kg),
    arm: Param(0.3_m),
    stiffness: Param(4.0_Nm),

    plate: Body(
        mass = mass,
        inertia = diag(0.01, 0.02, 0.03),
        center_of_mass = [arm, 0.0, 0.0],
    ),
    hinge: Revolute(ground.origin, plate.origin, axis = Y),
    spring: TorsionSpring(hinge, stiffness = stiffness, angle = 0.2),

    tip: Output(plate.point(2.0 * arm, 0.0, 0.0).z),
}"#;

const FIXTURES: [(&str, &str); 4] = [
    ("pendulum", PENDULUM),
    ("slider-crank", SLIDER_CRANK),
    ("sleigh", SLEIGH),
    ("flap", FLAP),
];

/// Stage 6, formatted.
fn rust(declaration: &str) -> String {
    let file = syn::parse2(mbs_macros_core::compile(stages::tokens(declaration)));
    prettyplease::unparse(&file.expect("generated Rust parses"))
}

/// The methods of the system with these names.
fn methods(declaration: &str, names: &[&str]) -> String {
    let mut file: syn::File =
        syn::parse2(mbs_macros_core::compile(stages::tokens(declaration))).expect("it parses");
    // The implementation is inside `const _: () = { … };`.
    let inner = file.items.iter().filter_map(|item| match item {
        syn::Item::Const(constant) => match &*constant.expr {
            syn::Expr::Block(block) => Some(&block.block.stmts),
            _ => None,
        },
        _ => None,
    });
    file.items = inner
        .flatten()
        .filter_map(|statement| match statement {
            syn::Stmt::Item(item) => Some(item.clone()),
            _ => None,
        })
        .collect();
    file.items.retain(|item| match item {
        syn::Item::Impl(block) => {
            let system = block
                .trait_
                .as_ref()
                .and_then(|(_, path, _)| path.segments.last());
            let hidden = block.attrs.iter().any(|attribute| {
                let syn::Meta::List(list) = &attribute.meta else {
                    return false;
                };
                list.path.is_ident("cfg") && list.tokens.to_string() == "rust_analyzer"
            });
            system.is_some_and(|segment| segment.ident == "System") && !hidden
        }
        _ => false,
    });
    for item in &mut file.items {
        if let syn::Item::Impl(block) = item {
            block.items.retain(|item| match item {
                syn::ImplItem::Fn(function) => names.iter().any(|name| function.sig.ident == name),
                _ => false,
            });
        }
    }
    prettyplease::unparse(&file)
}

#[test]
fn stages_1_to_5() {
    for (name, declaration) in FIXTURES {
        for (stage, text) in stages::texts(declaration) {
            insta::assert_snapshot!(format!("{name}-{stage}"), text);
        }
    }
}

#[test]
fn stage_6() {
    for (name, declaration) in FIXTURES {
        insta::assert_snapshot!(format!("{name}-6-rust"), rust(declaration));
    }
}

/// What an integrator evaluates most often.
#[test]
fn constraints() {
    for (name, declaration) in FIXTURES {
        insta::assert_snapshot!(
            format!("constraints-of-{name}"),
            methods(declaration, &["constraints"])
        );
    }
}

/// A snapshot whose test is gone would never be looked at again.
#[test]
fn every_snapshot_has_its_test() {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots");
    let stages = [
        "1-tree",
        "2-model",
        "3-system",
        "4-derived",
        "5-program",
        "6-rust",
    ];
    let mut expected: Vec<String> = FIXTURES
        .iter()
        .flat_map(|(name, _)| {
            let each = stages
                .iter()
                .map(move |stage| format!("snapshots__{name}-{stage}.snap"));
            each.chain([format!("snapshots__constraints-of-{name}.snap")])
        })
        .collect();
    expected.sort();
    let mut found: Vec<String> = std::fs::read_dir(directory)
        .expect("snapshots are checked in")
        .map(|entry| {
            entry
                .expect("readable")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .filter(|name| name.starts_with("snapshots__") && name.ends_with(".snap"))
        .collect();
    found.sort();
    assert_eq!(found, expected);
}

/// Nothing depends on the order of hash maps, or on what was compiled before.
#[test]
fn compiling_is_deterministic() {
    let scenes = mbs_examples::scenes::scenes();
    let small = scenes
        .iter()
        .filter(|scene| scene.model.coordinates.len() <= 20);
    let all: Vec<&str> = FIXTURES
        .iter()
        .map(|(_, declaration)| *declaration)
        .chain(small.map(|scene| scene.model.declaration))
        .collect();
    let forwards: Vec<String> = all.iter().map(|declaration| rust(declaration)).collect();
    let mut backwards: Vec<String> = all
        .iter()
        .rev()
        .map(|declaration| rust(declaration))
        .collect();
    backwards.reverse();
    assert!(
        forwards == backwards,
        "the same declaration gave different Rust"
    );
}
