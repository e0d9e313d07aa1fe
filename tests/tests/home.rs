//! Crates that have mbs-runtime under another name, or through another crate.

use mbs_macros_core::compile;
use proc_macro2::{TokenStream, TokenTree};

/// A crate that hands the runtime on.
mod product {
    pub use mbs_runtime as mbs;
}

use product::mbs::{Simulation, assembly, mechanism};

assembly!(
    crate = crate::home::product::mbs,
    Arm {
        world: Planar(),
        at: Port(Point),
        length: Param(1.0_m),
        bar: Bar(mass = 1.0_kg, length = length, angle = 0.0_deg),
        pin: Revolute(at, bar.a),
    }
);

mechanism!(
    crate = product::mbs,
    pub(crate) Pendulum {
        world: Planar(gravity = [0.0, -9.81_m_per_s2]),
        arm: Assembly(Arm, at = ground.origin),
        height: Output(arm.bar.b.y),
    }
);

#[test]
fn a_renamed_runtime_is_used() {
    let mut simulation: PendulumSimulation = Simulation::new(Pendulum::default()).unwrap();
    simulation.run_until(0.1).unwrap();
    assert!(simulation.outputs().height < 0.0);
}

const PENDULUM: &str = "Pendulum {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    length: Param(1.0_m),
    push: Input(0.0_N_m),
    bar: Bar(mass = 1.0_kg, length = length),
    pin: Revolute(ground.origin, bar.a),
    motor: Torque(bar, value = push),
    height: Output(bar.b.y),
}";

/// Every use of the usual name is replaced, and nothing else is changed: the other name put back gives the usual code.
#[test]
fn no_code_names_the_runtime_otherwise() {
    for declaration in [PENDULUM, &PENDULUM.replace("bar.a)", "bar.c)")] {
        let usual = compile(declaration.parse().unwrap());
        let renamed = format!("crate = ::other, {declaration}");
        let renamed = compile(renamed.parse().unwrap());
        assert!(names(&usual, "mbs_runtime") > 5);
        assert_eq!(names(&renamed, "mbs_runtime"), 0);
        let back = renamed.to_string().replace(":: other", ":: mbs_runtime");
        assert_eq!(back, usual.to_string());
    }
}

/// How often a word occurs.
fn names(tokens: &TokenStream, word: &str) -> usize {
    let count = |token: TokenTree| match token {
        TokenTree::Group(group) => names(&group.stream(), word),
        TokenTree::Ident(ident) => usize::from(ident == word),
        _ => 0,
    };
    tokens.clone().into_iter().map(count).sum()
}

#[test]
fn a_path_of_the_user_that_has_this_name_in_it_stays() {
    let law = PENDULUM.replace(
        "value = push",
        "value = law(own::mbs_runtime::friction, push)",
    );
    let code = compile(format!("crate = other, {law}").parse().unwrap()).to_string();
    assert!(code.contains("own :: mbs_runtime :: friction"), "{code}");
}

#[test]
fn a_missing_path_is_one_error() {
    let code = compile("crate, Pendulum { }".parse().unwrap()).to_string();
    assert_eq!(code.matches("compile_error").count(), 1);
    assert!(code.contains("expected the path of mbs-runtime in this crate"));
}
