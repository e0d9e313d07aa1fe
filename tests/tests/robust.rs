//! For every input the compiler either accepts, or rejects with a message. It never panics. (Inputs by chance: `fuzz.rs`.)

use crate::alloc;
use mbs_macros_core::{analyse, dag, emit};
use proc_macro2::TokenStream;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The result of the compiler.
#[derive(Debug)]
enum Answer {
    Accepted,
    Rejected(Vec<String>),
}

/// Compiles; if the compiler panics, this panics with the declaration in the message.
fn answer(tokens: TokenStream) -> Answer {
    let text = tokens.to_string();
    let run = move || {
        let (declaration, outcome) = analyse(tokens);
        match (declaration, outcome) {
            (Some(declaration), Ok(analysis)) => {
                let program = dag::lower(&analysis.derived);
                emit::mechanism(&declaration, &analysis, &program);
                Answer::Accepted
            }
            (declaration, Err(failure)) => {
                if let Some(declaration) = declaration {
                    emit::fallback(&declaration);
                }
                let messages = failure.messages();
                Answer::Rejected(messages.into_iter().map(|(message, _)| message).collect())
            }
            (None, Ok(_)) => unreachable!("nothing was parsed, yet it was analysed"),
        }
    };
    match catch_unwind(AssertUnwindSafe(run)) {
        Ok(answer) => answer,
        Err(_) => panic!("the compiler panicked at\n{text}"),
    }
}

/// The messages with which a text is rejected.
fn rejected(text: &str) -> Vec<String> {
    match answer(text.parse().expect("these are tokens")) {
        Answer::Rejected(messages) => messages,
        Answer::Accepted => panic!("accepted:\n{text}"),
    }
}

/// A pendulum with an output.
fn with_output(expression: &str) -> String {
    format!(
        "Pendulum {{ world: Planar(), bar: Bar(mass = 1.0_kg, length = 1.0_m), \
         pivot: Revolute(ground.origin, bar.a), out: Output({expression}) }}"
    )
}

/// Small mechanisms that together have every joint and force of space.
const IN_SPACE: [&str; 6] = [
    "Hinged { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]), size: Param(0.3_m),
        arm: Body(mass = 1.0_kg, inertia = Cuboid(size, 0.2_m, 0.1_m), at = [0.0, 0.0, size],
            orientation = [turn(Z, 0.3), turn([1.0, 2.0, 0.5], 10.0_deg)], angular_velocity = [0.1, 0.0, 0.0]),
        nut: Body(mass = 1.0_kg, inertia = diag(0.1_kg, 0.1, 0.1) * size.powi(2), at = [0.0, 0.0, size]),
        hinge: Revolute(ground, arm, at = [0.0, 0.0, 0.0], axis = X),
        thread: Screw(arm, nut, at = [0.0, 0.0, size], axis = Z, pitch = 0.01_m),
        motor: Torque(hinge, value = 0.1_Nm * sin(1.0_per_s * t)),
        coil: TorsionSpring(hinge, stiffness = 2.0_Nm, damping = 0.1_Nm_s),
        out: Output(hinge.angle + thread.angle) }",
    "Yokes { deny: Redundant(), world: Spatial(),
        first: Bar(mass = 1.0_kg, from = [0.0, 0.0, 0.0], to = [1.0, 0.0, 0.0], radius = 0.1_m),
        second: Bar(mass = 1.0_kg, from = [1.0, 0.0, 0.0], to = [2.0, 0.0, 0.0], radius = 0.1_m),
        bearing: Cylindrical(ground, first, at = [0.0, 0.0, 0.0], axis = X),
        cross: Universal(first, second, at = [1.0, 0.0, 0.0], axis = Y, second_axis = Z),
        other: ConstantVelocity(second.b, ground.point(2.0, 0.0, 0.0), axis = X) }",
    "Table { world: Spatial(), plate: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
        slider: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, at = [0.0, 0.0, 1.0]),
        floor: Planar(ground, plate, at = [0.0, 0.0, 0.0], axis = Z),
        slide: Prismatic(plate.frame([0.0, 0.0, 1.0], X), slider.frame([0.0, 0.0, 0.0], X)),
        rack: RackPinion(floor, slide, radius = 0.1_m), out: Output(slide.stroke),
        push: Force(slider.origin, value = [1.0_N, 0.0, 0.0], axes = plate) }",
    "Rods { world: Spatial(gravity = [0.0, 0.0, -9.81]),
        rod: Bar(mass = 1.0_kg, to = [1.0, 0.0, 0.0]), bob: Particle(mass = 1.0_kg, at = [1.0, 0.0, 0.0]),
        ball: Spherical(ground.origin, rod.a), knot: Spherical(rod.b, bob),
        ledge: PointOnPlane(bob, ground.origin, normal = Y) }",
    "Mounted { world: Spatial(), block: Body(mass = 1.0_kg, inertia = Sphere(0.1_m), center_of_mass = [0.1, 0.0, 0.0]),
        tool: Body(mass = 1.0_kg, inertia = 0.1_kg_m2),
        mount: Bushing(ground, block, at = [0.0, 0.0, 0.0], stiffness = [1.0_N_per_m, 2.0, 3.0], torsion_stiffness = 1.0_Nm),
        weld: Fixed(block, tool, at = [0.0, 0.0, 0.0]), wire: PointOnLine(tool.origin, ground.origin, axis = Y), stir: Wrench(tool.origin, force = [1.0_N, 0.0, 0.0]) }",
    "Disk { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        disk: Body(mass = 2.0_kg, inertia = Cylinder(0.3_m, 0.01_m, Y), at = [0.0, 0.0, 0.3]),
        down: Let(-unit(reject(ground.z, disk.y))), contact: Let(disk.origin + 0.3_m * down),
        slip: Let(disk.velocity_at(contact)), touch: Holonomic(dot(contact, ground.z)),
        no_slip: Nonholonomic([dot(slip, ground.x), dot(slip, ground.y)]) }",
];

#[test]
fn mechanisms_of_space_are_accepted() {
    for text in IN_SPACE {
        let tokens = text.parse().expect("these are tokens");
        let answer = answer(tokens);
        assert!(matches!(answer, Answer::Accepted), "{answer:?}\n{text}");
    }
}

/// Runs on a stack of the size that the compiler has.
fn on_compiler_stack(run: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(8 << 20);
    let outcome = thread.spawn(run).expect("a thread starts").join();
    outcome.expect("the thread ends");
}

#[test]
fn deep_nesting_is_refused() {
    on_compiler_stack(|| {
        let around = |open: &str, close: &str, depth: usize| {
            format!("{}bar.angle{}", open.repeat(depth), close.repeat(depth))
        };
        for depth in [1_000, 5_000] {
            for expression in [
                around("(", ")", depth),
                around("[", "]", depth),
                around("sin(", ")", depth),
                around("-", "", depth),
                around("", ".sin()", depth),
                around("", ".a", depth),
                around("", " + 1.0", depth),
                around("1.0 * ", "", depth),
                around("1.0 - (", ")", depth),
            ] {
                let messages = rejected(&with_output(&expression));
                let start = &expression[..12];
                assert!(
                    matches!(messages.as_slice(), [one] if one.contains("nested too deeply")),
                    "{depth} times, from `{start}`: {messages:?}"
                );
            }
        }
    });
}

#[test]
fn what_people_write_is_not_too_deep() {
    on_compiler_stack(|| {
        let sum = " + 0.5 * bar.angle.sin()".repeat(100);
        let nested = format!("{}bar.angle{}", "sin(".repeat(100), ")".repeat(100));
        for expression in [format!("1.0{sum}"), nested] {
            let tokens = with_output(&expression).parse().expect("these are tokens");
            assert!(matches!(answer(tokens), Answer::Accepted), "{expression}");
        }
    });
}

#[test]
fn long_chains_of_names_are_answered() {
    let chain = |names: &mut dyn Iterator<Item = usize>| {
        let lets: Vec<String> = names
            .map(|i| format!("a{}: Let(sin(a{i})),", i + 1))
            .collect();
        format!(
            "Chain {{ world: Planar(), bar: Bar(mass = 1.0_kg, length = 1.0_m, free = true), \
             {} a0: Let(bar.angle), out: Output(a1000) }}",
            lets.concat()
        )
    };
    let (forwards, backwards) = (chain(&mut (0..1000)), chain(&mut (0..1000).rev()));
    on_compiler_stack(move || {
        let tokens = forwards.parse().expect("these are tokens");
        assert!(matches!(answer(tokens), Answer::Accepted));
        for message in rejected(&backwards) {
            assert!(
                message.contains("declare names before their use"),
                "{message}"
            );
        }
    });
}

#[test]
fn expressions_deeper_than_later_stages_can_follow_are_refused() {
    let lets: String = (0..2000)
        .map(|i| format!("a{}: Let(1.0 + 2.0 * a{i} * bar.rate * 1.0_s),", i + 1))
        .collect();
    let text = format!(
        "Chain {{ world: Planar(), bar: Bar(mass = 1.0_kg, length = 1.0_m, free = true), \
         a0: Let(bar.angle), {lets} motor: Torque(bar, value = 1.0_Nm * a2000) }}"
    );
    on_compiler_stack(move || {
        let messages = rejected(&text);
        assert!(
            matches!(messages.as_slice(), [one] if one.contains("operations deep")),
            "{messages:?}"
        );
    });
}

#[test]
fn long_sums_and_long_documentation_are_accepted() {
    let sines = |from: usize| -> String {
        (from..from + 30)
            .map(|i| format!(" + sin({i}.0 * bar.angle)"))
            .collect()
    };
    let groups: String = (0..30)
        .map(|k| format!("g{k}: Let(1.0{}),", sines(30 * k)))
        .collect();
    let sum: Vec<String> = (0..30).map(|k| format!("g{k}")).collect();
    let lines = "#[doc = \"One line.\"] ".repeat(1000);
    let text = format!(
        "{lines} Sum {{ world: Planar(), {lines} bar: Bar(mass = 1.0_kg, length = 1.0_m, free = true), \
         {groups} motor: Torque(bar, value = 1.0_Nm * ({})) }}",
        sum.join(" + ")
    );
    on_compiler_stack(move || {
        let tokens = text.parse().expect("these are tokens");
        assert!(matches!(answer(tokens), Answer::Accepted));
    });
}

#[test]
fn sums_that_grow_name_by_name_are_not_copied_for_each() {
    let bytes = |count: usize| {
        let lets: String = (0..count)
            .map(|i| format!("a{}: Let(a{i} + sin({i}.0 * bar.angle)),", i + 1))
            .collect();
        let text = format!(
            "Sum {{ world: Planar(), bar: Bar(mass = 1.0_kg, length = 1.0_m, free = true), \
             a0: Let(bar.angle), {lets} out: Output(a{count}) }}"
        );
        let tokens = text.parse().expect("these are tokens");
        let before = alloc::bytes();
        assert!(analyse(tokens).1.is_ok());
        (alloc::bytes() - before) as f64
    };
    on_compiler_stack(move || {
        // Measured: 2.003 times the memory for twice the names; 5.2 times if each name holds its whole sum.
        let growth = bytes(4000) / bytes(2000);
        assert!(growth < 2.2, "{growth}");
    });
}

/// Bars on the ground, coupled each with the one before it, or with the first. What a compilation does is counted by its
/// allocations.
#[test]
fn work_for_couplings_of_many_bars_is_not_cubic() {
    let work = |count: usize, rows: &str| {
        let text = format!(
            "Train {{ world: Planar(), b: Each(0..{count}, |i| Bar(mass = 1.0_kg, length = 1.0_m)), \
             pin: Each(0..{count}, |i| Revolute(ground.point(1.0_m * i, 0.0), b[i].a)), \
             row: Each(1..{count}, |i| {rows}) }}"
        );
        let tokens = text.parse().expect("these are tokens");
        let before = alloc::count();
        assert!(matches!(answer(tokens), Answer::Accepted));
        (alloc::count() - before) as f64
    };
    let growth = |counts: [usize; 2], rows: &str| {
        let [small, large] = counts.map(|count| work(count, rows));
        large / small
    };
    // 2.3; with a search over all pairs of rows for each block 4.1.
    let star = growth([50, 100], "Coupling(b[0].angle, b[i].angle, ratio = 0.9)");
    assert!(star < 3.0, "{star}");
    // 3.4, with products of all ratios before; 4.5.
    let train = growth([100, 200], "Gear(b[i - 1], b[i], ratio = 0.9)");
    assert!(train < 4.0, "{train}");
}

#[test]
fn names_that_double_are_answered_in_wrong_declarations() {
    // A look at both factors of each name, again for each name that uses it, would not end.
    let lets: String = (0..60)
        .map(|i| format!("a{}: Let(a{i} * sin(a{i})),", i + 1))
        .collect();
    let messages = rejected(&format!(
        "Wrong {{ world: Planar(), bar: Bar(mass = 1.0_kg, length = 1.0_m, free = true), \
         a0: Let(bar.angle), {lets} out: Output(a60), wrong: Output(nothing) }}"
    ));
    assert_eq!(messages.len(), 1, "{messages:?}");
}

#[test]
fn many_unknown_names_are_answered_soon() {
    let outputs: String = (0..2000)
        .map(|i| format!("name_{i}: Output(nome_{i}),"))
        .collect();
    let start = std::time::Instant::now();
    let messages = rejected(&format!("Wrong {{ world: Planar(), {outputs} }}"));
    assert!(messages.len() >= 2000, "{}", messages.len());
    assert!(
        messages[0].contains("did you mean `name_0`?"),
        "{}",
        messages[0]
    );
    // Without a bound it took minutes.
    assert!(start.elapsed().as_secs() < 10, "{:?}", start.elapsed());
}

#[test]
fn home_poses_are_compared_on_the_scale_of_the_parts() {
    let turned = |size: f64| {
        format!(
            "Turned {{ world: Spatial(), n: Let(unit([0.9, 0.35, 0.6])), q: Param(0.2_rad),
            body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, orientation = turn(n, q),
                center_of_mass = [{0:e}, {1:e}, {2:e}]),
            pivot: Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = n) }}",
            0.16 * size,
            0.2 * size,
            0.02 * size
        )
    };
    // The loop of a four-bar in all sizes: assembled with the same relative accuracy.
    let loop_of = |size: f64| {
        format!(
            "Loop {{ world: Planar(), a: Param({0:e}_m), b: Param({1:e}_m),
            crank: Bar(mass = 1.0_kg, length = a, angle = 1.0_rad), rod: Bar(mass = 1.0_kg, length = b), rocker: Bar(mass = 1.0_kg, length = b),
            p1: Revolute(ground.origin, crank.a), p2: Revolute(crank.b, rod.a), p3: Revolute(rod.b, rocker.b),
            p4: Revolute(rocker.a, ground.point(b, 0.0)) }}",
            size,
            2.0 * size
        )
    };
    for exponent in [-9, -6, -3, 0, 3, 6] {
        for text in [turned(10f64.powi(exponent)), loop_of(10f64.powi(exponent))] {
            let answer = answer(text.parse().expect("these are tokens"));
            assert!(matches!(answer, Answer::Accepted), "{answer:?}\n{text}");
        }
    }
}

/// A law would be called where the compiler needs a number.
#[test]
fn laws_are_refused_where_the_motion_has_not_started() {
    let plane = |arguments: &str, joint: &str, world: &str| {
        format!(
            "Lawful {{ world: Planar({world}), k: Param(1.0), body: Body({arguments}), pivot: {joint}, out: Output(k) }}"
        )
    };
    let space = |arguments: &str, joint: &str| {
        format!(
            "Lawful {{ world: Spatial(), k: Param(1.0), body: Body({arguments}), pivot: {joint}, out: Output(k) }}"
        )
    };
    let sound = "mass = 1.0_kg, inertia = 0.1_kg_m2";
    let pin = "Revolute(ground.origin, body.origin)";
    let hinge = "Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = X)";
    for text in [
        plane("mass = 1.0_kg * law(f, k), inertia = 0.1_kg_m2", pin, ""),
        plane("mass = 1.0_kg, inertia = 0.1_kg_m2 * law(f, k)", pin, ""),
        plane(
            sound,
            "Revolute(ground.origin, body.point(law(f, k), 0.0))",
            "coordinates = Joint",
        ),
        plane(
            sound,
            "Distance(ground.origin, body.origin, length = 1.0_m * law(f, k))",
            "",
        ),
        plane(sound, pin, "gravity = [0.0, law(f, k)]"),
        space(
            "mass = 1.0_kg, inertia = diag(0.1_kg_m2 * law(f, k), 0.1, 0.1)",
            hinge,
        ),
        space(
            "mass = 1.0_kg, inertia = Cuboid(law(f, k), 0.1, 0.1)",
            hinge,
        ),
        space(
            sound,
            "Revolute(ground, body, at = [law(f, k), 0.0, 0.0], axis = X)",
        ),
        space(
            sound,
            "Revolute(ground, body, at = [0.0, 0.0, 0.0], axis = [1.0, law(f, k), 0.0])",
        ),
        space(
            sound,
            "Revolute(ground.frame([law(f, k), 0.0, 0.0], X), body.frame([0.0, 0.0, 0.0], X))",
        ),
        space(
            "mass = 1.0_kg, inertia = 0.1_kg_m2, orientation = turn(X, law(f, k))",
            hinge,
        ),
    ] {
        let messages = rejected(&text);
        assert!(
            matches!(messages.as_slice(), [one] if one.contains("a law is called during the motion")),
            "{messages:?}\n{text}"
        );
    }
}

/// Joints given by frames are at angle zero in the home pose, whatever the axes across theirs are.
#[test]
fn frames_of_joints_have_no_twist_in_the_home_pose() {
    for orientation in [
        "turn(Z, 0.7)",
        "turn(Z, q)",
        "[turn(X, 0.5), turn(Z, -2.0)]",
    ] {
        let axis = match orientation.starts_with('[') {
            true => "[0.0, -sin(0.5), cos(0.5)]",
            false => "Z",
        };
        let text = format!(
            "Framed {{ world: Spatial(coordinates = Joint), q: Param(0.7_rad),
            body: Body(mass = 1.0_kg, inertia = 0.1_kg_m2, orientation = {orientation}),
            hinge: Revolute(ground.frame([0.0, 0.0, 0.0], {axis}), body.frame([0.0, 0.0, 0.0], Z)),
            out: Output(hinge.angle + q) }}"
        );
        let (_, outcome) = analyse(text.parse().expect("these are tokens"));
        let analysis = outcome.unwrap_or_else(|failure| panic!("{:?}", failure.messages()));
        let system = &analysis.derived.system;
        let parameters = &analysis.outline.parameters;
        let symbols = |symbol| match symbol {
            mbs_macros_core::symbolic::Symbol::Parameter(i) => parameters[i as usize].default,
            other => panic!("{other:?} in a guess"),
        };
        let laws = |_: u32, _: &[f64]| (0.0, Vec::new());
        let mut numbers = mbs_macros_core::symbolic::Evaluator::new(&system.graph, &symbols, &laws);
        assert_eq!(system.layout.coordinates.len(), 1);
        let guess = numbers.value(system.layout.coordinates[0].guess);
        assert!(guess.abs() < 1e-12, "{orientation}: {guess}");
    }
}

/// The one message about an output.
fn refusal(expression: &str) -> String {
    let mut messages = rejected(&with_output(expression));
    assert_eq!(messages.len(), 1, "{expression}: {messages:?}");
    messages.remove(0)
}

#[test]
fn huge_numbers_are_refused() {
    assert!(refusal("1e999_m").contains("this number is too large"));
    for expression in [
        "1e308 * 1e308",
        "1e200 * (1e200 * bar.angle)",
        "0.0.powi(-1)",
        "ln(0.0)",
        "sqrt(-1.0)",
    ] {
        let message = refusal(expression);
        assert!(
            message.contains("no finite number"),
            "{expression}: {message}"
        );
    }
}

#[test]
fn huge_exponents_are_refused() {
    for expression in [
        "bar.angle.powi(1000000000)",
        "bar.angle.powi(-1000000000)",
        "bar.angle.powf(1e300)",
        "bar.angle.powi(99999999999999999999)",
    ] {
        let message = refusal(expression);
        assert!(
            message.contains("exponents go up to 1000"),
            "{expression}: {message}"
        );
    }
    assert!(refusal("bar.b.x.powi(100)").contains("small integer"));
    for unit in ["m99999", "m128", "m10", "m0", "per_m128", "per"] {
        let message = refusal(&format!("1.0_{unit}"));
        assert!(
            message.starts_with(&format!("there is no unit `{unit}`")),
            "{message}"
        );
    }
}

#[test]
fn exponents_do_not_overflow() {
    for expression in [
        "bar.angle.powi(1000).powi(1000).powi(1000).powi(1000)",
        "bar.angle.powi(1000).powi(1000).powi(1000) * bar.angle.powi(1000).powi(1000).powi(1000) * bar.angle.powi(1000).powi(1000).powi(1000)",
        "bar.b.x.powi(20).powi(20)",
        "1.0_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9",
        "1.0_per_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9_m9 / bar.b.x",
    ] {
        let tokens = with_output(expression).parse().expect("these are tokens");
        assert!(matches!(answer(tokens), Answer::Accepted), "{expression}");
    }
}
