//! One entry stands for many.

use mbs_macros_core::{analyse, compile, dag::Program, emit, syntax};
use mbs_runtime::{Mechanism, Simulation, mechanism};
use mbs_tests::stages::tokens;

mechanism!(Row {
    doc: "Pendulums in a row, and one with the name that the second would have as a variable.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    // Used first, so that it is not the first of its family to be read.
    middle: Let(length[1]),

    /// Length of each pendulum.
    length: Each([1.0_m, 0.5_m, 0.25_m], |length| Param(length)),
    /// Torque of each motor.
    torque: Each(0..3, |i| Input(0.0_N_m)),
    gain: Each((0..2, 0..3), |row, column| Param(if row == 0 {
        column + 1.0
    } else {
        0.0
    })),

    bar: Each(0..3, |i| Bar(mass = 1.0_kg, length = length[i])),
    bar_1: Bar(mass = 1.0_kg, length = middle),
    pivot: Each(0..3, |i| Revolute(ground.point(i * 1.0_m, 0.0), bar[i].a)),
    pivot_1: Revolute(ground.origin, bar_1.a),
    motor: Each(0..3, |i| Torque(bar[i], value = torque[i])),

    height: Each((0..2, 0..3), |row, column| Output(
        gain[row][column] * bar[column].b.y
    )),
    tip: Each(0..3, |i| Output(bar[i].b)),
    below: Each(0..3, |i| Event(bar[i].b.y + 0.1_m)),
});

#[test]
fn values_of_families_are_arrays() {
    let row = Row {
        length: [1.0, 0.5, 2.0],
        ..Row::default()
    };
    assert_eq!(row.gain, [[1.0, 2.0, 3.0], [0.0; 3]]);
    assert_eq!(row.parameter("length[1]"), Some(0.5));
    assert_eq!(row.parameter("length[2]"), Some(2.0));
    let mut simulation = Simulation::new(row).expect("assembled");
    assert_eq!(simulation.outputs().tip[2].x, 4.0);
    // Torque against weight: this bar stays where it is, the others fall.
    simulation.inputs_mut().torque[1] = 0.5 * 0.5 * 9.81;
    simulation.run_until(0.1).expect("regular");
    let outputs = simulation.outputs();
    assert!(outputs.tip[1].y.abs() < 1e-9, "{}", outputs.tip[1]);
    assert!(outputs.tip[0].y < -0.05 && outputs.tip[2].y < -0.05);
    assert_eq!(outputs.height[0][2], 3.0 * outputs.tip[2].y);
    assert_eq!(outputs.height[1], [0.0; 3]);
}

#[test]
fn names_have_indices() {
    let mut row = Row::default();
    row.set_parameter("gain[1][2]", 4.0).expect("a parameter");
    assert_eq!(row.gain[1][2], 4.0);
    let unknown = row.set_parameter("gain[2][0]", 1.0);
    assert!(unknown.is_err());
    let model = Row::MODEL;
    // In the order of the declaration.
    let parameters = model.parameters.iter().map(|parameter| parameter.name);
    let parameters: Vec<&str> = parameters.take(4).collect();
    let in_order = ["length[0]", "length[1]", "length[2]", "gain[0][0]"];
    assert_eq!(parameters, in_order);
    let parts: Vec<&str> = model.parts.iter().map(|part| part.name).collect();
    assert_eq!(parts, ["bar[0]", "bar[1]", "bar[2]", "bar_1"]);
    let outputs = model.outputs.iter().map(|output| output.name);
    let outputs: Vec<&str> = outputs.skip(6).collect();
    let tips = ["tip[0].x", "tip[0].y", "tip[1].x", "tip[1].y"];
    assert_eq!(outputs[..4], tips);
    assert_eq!(model.events, ["below[0]", "below[1]", "below[2]"]);
    assert!(model.reactions.iter().any(|row| row.joint == "pivot[2]"));
}

/// What is derived and emitted for a declaration.
fn program(declaration: &str) -> (Program, String) {
    let (tree, analysis) = analyse(tokens(declaration));
    let analysis = analysis.unwrap_or_else(|failure| panic!("{:?}", failure.messages()));
    let rust = emit::mechanism(&tree.expect("a tree"), &analysis, &analysis.program);
    (analysis.program, rust.to_string())
}

/// With the names of members as one would write them without families: `crank[3]` is `crank3`.
fn without_indices(text: &str) -> String {
    text.replace(['[', ']', '_', ' '], "")
}

/// A family is the same program as its members written one by one.
#[test]
fn a_family_stands_for_its_members() {
    let (family, rust) = program(
        "Chain { world: Planar(gravity = [0.0, -9.81_m_per_s2]), length: Param(1.0_m),
            bar: Each(0..4, |i| if i != 2 { Bar(mass = (i + 1) * 1.0_kg, length = length) }),
            pin: Each([0, 1, 3], |i, to| Revolute(
                if i == 0 { ground.origin } else { bar[to - if i < 2 { 1 } else { 2 }].b }, bar[to].a)),
            coil: Each(0..1, |i| TorsionSpring(bar[3], bar[i], stiffness = 1.0_Nm)),
            tip: Output(bar[7 % 4].angle) }",
    );
    let (single, other) = program(
        "Chain { world: Planar(gravity = [0.0, -9.81_m_per_s2]), length: Param(1.0_m),
            bar0: Bar(mass = 1.0_kg, length = length), bar1: Bar(mass = 2.0_kg, length = length),
            bar3: Bar(mass = 4.0_kg, length = length), pin0: Revolute(ground.origin, bar0.a),
            pin1: Revolute(bar0.b, bar1.a), pin2: Revolute(bar1.b, bar3.a),
            coil0: TorsionSpring(bar3, bar0, stiffness = 1.0_Nm), tip: Output(bar3.angle) }",
    );
    for (one, other) in family.functions.iter().zip(&single.functions) {
        assert!(one.computes_the_same(other), "{}", one.name);
    }
    // Beside the declaration itself.
    let [rust, other] = [rust, other].map(|text| without_indices(&text));
    let lines = |text: &str| text.matches(';').count();
    assert_eq!(lines(&rust), lines(&other));
}

/// The same mistake in all members is told once.
#[test]
fn a_mistake_is_told_once() {
    let messages = |closure: &str| -> Vec<String> {
        let text = format!(
            "Wrong {{ world: Planar(), bar: Each(0..40, {closure}),
                pivot: Each(0..40, |i| Revolute(ground.origin, bar[i].a)) }}"
        );
        let (_, outcome) = analyse(tokens(&text));
        let failure = outcome.expect_err("a mistake");
        let messages = failure.messages().into_iter();
        messages.map(|(message, _)| message).collect()
    };
    assert_eq!(
        messages("|i| Bar(mass = 1.0_kg, length = lengt)"),
        ["in `bar[0]`: nothing here is named `lengt` (and the same in 39 other members)"]
    );
    assert_eq!(
        messages("|i| Bar(mass = if i == 7 { 1.0_m } else { 1.0_kg }, length = 1.0_m)"),
        ["in `bar[7]`: `mass` is a mass (kg), but this is a length (m)"]
    );
}

/// Editors complete the fields of a wrong declaration, and the user's program has no other errors.
#[test]
fn arrays_are_there_beside_errors() {
    let fallback = |entries: &str| {
        let text = format!("Wrong {{ world: Planar(), {entries} }}");
        compile(tokens(&text)).to_string().replace(' ', "")
    };
    let output = fallback(
        "length: Each(0..6, |i| Param(1.0_m)), leg: Each((0..2, 0..3), |i, j| Input(0.0_N)), bar: Bar()",
    );
    assert!(output.contains("publength:[f64;6usize]"), "{output}");
    assert!(output.contains("publeg:[[f64;3usize];2usize]"), "{output}");
    assert!(fallback("length: Each(0..6, |i| Parm(1.0_m))").contains("publength:[f64;6usize]"));
    let states = fallback("charge: Each(0..2, |i| State(rate = wrong))");
    assert!(states.contains("pubcharge:[f64;2usize]"), "{states}");
    assert!(fallback("length: Each(0.., |i| Param(1.0_m))").contains("publength:[f64;0usize]"));
}

/// The most members, and a number that is far from any.
#[test]
fn members_are_bounded() {
    for range in [
        "0..=10000",
        "(0..5000000000, 0..5000000000)",
        "0..99999999999999999999",
    ] {
        let text = format!(
            "Wrong {{ world: Planar(), bar: Each({range}, |i{}| Particle(mass = 1.0_kg)) }}",
            if range.starts_with('(') { ", j" } else { "" }
        );
        let (_, outcome) = analyse(tokens(&text));
        let messages = outcome.expect_err("too many").messages();
        assert_eq!(messages.len(), 1, "{messages:?}");
    }
    let mut errors = mbs_macros_core::diagnostics::Errors::new();
    let text =
        "Right { world: Planar(), p: Each(0..10000, |i| Particle(mass = 1.0_kg, free = true)) }";
    let tree = syntax::parse(tokens(text), mbs_macros_core::model::kinds(), &mut errors);
    assert_eq!(tree.map(|tree| tree.entries.len()), Some(10_000));
    assert!(errors.is_empty());
}
