//! What an editor is given: Rust that has the tokens of a declaration, right or wrong.

use mbs_macros_core::emit;
use mbs_macros_core::model::kinds;

fn sketch(declaration: &str) -> String {
    let tokens = declaration.parse().expect("tokens");
    emit::sketch(&tokens, kinds()).to_string()
}

/// The part that depends on the declaration, without spaces.
fn own(declaration: &str) -> String {
    let text = sketch(declaration);
    let (_, own) = text.split_once("fn declaration ()").expect("its function");
    own.split_whitespace().collect()
}

#[test]
fn names_are_items_and_kinds_are_structs() {
    let declaration = "/// Mine.\npub Crane { world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
        jib: Bar(mass = 2.0_kg, length = reach), reach: Param(1.5_m), loads: Param([1.0_N, 2.0_N]), hinge: Revolute(ground.origin, jib.a, axis = Y),
        /// Of a chain.
        link: Each((0..3, 0..2), |i, j| if i == 0 { Body(mass = i * 1.0_kg) } else { Particle(mass = 1.0_kg) }),
        middle: Let(0.5 * jib.b.z), load: Output(hinge.reaction.fx), rope: SpringDamper(jib.b, ground.origin), }";
    syn::parse_str::<syn::File>(&sketch(declaration)).expect("it is Rust");
    let own = own(declaration);
    for expected in [
        "staticjib:members::Bar=any();",
        "staticreach:f64=any();",
        "staticloads:members::Family<f64>=any();",
        "statichinge:members::Revolute=any();",
        "staticrope:members::SpringDamper=any();",
        "#[doc=\"Ofachain.\"]",
        "staticlink:members::Family<members::Family<members::Body>>=any();",
        "letmiddle=0.5*jib.b.z;",
        "Spatial{gravity:given([0.0,0.0,-9.81_m_per_s2]),..any()};",
        "Bar{mass:given(2.0_kg),length:given(reach),..any()};",
        "Revolute{parent:given(ground.origin),child:given(jib.a),axis:given(Y),..any()};",
        "let_=|i,j|{Body{mass:given(i*1.0_kg),..any()};Particle{mass:given(1.0_kg),..any()};};",
    ] {
        assert!(own.contains(expected), "{expected}\nis not in\n{own}");
    }
}

#[test]
fn wrong_declarations_keep_their_tokens() {
    let own = own(
        "Crane { world: Planar(), jib: Bar(mass = 2.0_kg, len), hinge: Revo, pin: Revolute(jib., rod.a), what, 3: x, lone: }",
    );
    for expected in [
        "Bar{mass:given(2.0_kg),len,..any()}",
        "Revo{..any()};",
        "parent:given(jib.),child:given(rod.a),",
        "staticlone:f64=any();",
    ] {
        assert!(own.contains(expected), "{expected}\nis not in\n{own}");
    }
    assert!(sketch("").contains("fn declaration"));
    assert!(sketch("A { a: Each(), b: Each(0..2, |i|), # }").contains("fn declaration"));
}
