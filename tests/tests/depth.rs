//! Nesting that would exhaust the stack of the compiler is refused, also what no declaration has a use for.

use crate::common::expansion::{accepted, messages};

/// Runs on a stack of the size that the compiler has.
fn on_compiler_stack(run: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(8 << 20);
    let outcome = thread.spawn(run).expect("a thread starts").join();
    outcome.expect("the thread ends");
}

fn family(member: &str) -> String {
    format!(
        "mechanism!(M {{ world: Planar(), p: Each(0..2, |i| {member}), o: Output(p[0].origin.x) }});"
    )
}

fn with_mass(mass: &str) -> String {
    family(&format!("Particle(mass = {mass}, free = true)"))
}

#[test]
fn chains_of_words_and_brackets_are_refused() {
    on_compiler_stack(|| {
        for depth in [1_000, 20_000] {
            let before = |word: &str| with_mass(&(word.repeat(depth) + "1.0_kg"));
            let behind = |word: &str| with_mass(&("i".to_owned() + &word.repeat(depth)));
            let choices = "if i == 0 { Particle(mass = 1.0_kg, free = true) } else ".repeat(depth);
            for program in [
                before("return "),
                before("match "),
                before("break "),
                before("yield "),
                before("if "),
                before("while "),
                before("for x in "),
                before("&"),
                before("! "),
                before("*"),
                behind("[0]"),
                behind("()"),
                behind(" as f64"),
                behind("?"),
                family(&(choices + "{ Particle(mass = 1.0_kg, free = true) }")),
            ] {
                let found = messages(&program);
                assert!(
                    matches!(found.as_slice(), [(one, _)] if one.contains("nested too deeply")),
                    "{depth} times: {found:?} of {}",
                    &program[..120]
                );
            }
        }
    });
}

#[test]
fn a_hundred_choices_are_accepted() {
    on_compiler_stack(|| {
        let choices: String = (0..100)
            .map(|i| format!("if i == {i} {{ {i}.5_kg }} else "))
            .collect();
        accepted(&with_mass(&(choices + "{ 1.0_kg }")));
    });
}
