//! Parameters that make no mechanism are refused before the motion starts, in the words that the compiler has for numbers.

use mbs_runtime::{Mechanism, ParameterError, mechanism};

mechanism!(Planar {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    rod_mass: Param(1.0_kg),
    rod_length: Param(1.0_m),
    body_mass: Param(2.0_kg),
    body_inertia: Param(0.1_kg_m2),
    rope: Param(1.5_m),
    highest: Param(1.0_rad),
    grip: Param(0.4),
    rod: Bar(mass = rod_mass, length = rod_length, angle = 0.3_rad),
    bob: Body(
        mass = body_mass,
        inertia = 0.5 * body_inertia,
        at = [2.0_m, 0.3]
    ),
    dot: Particle(mass = 2.0 * body_mass, at = [3.0_m, 0.0]),
    pivot: Revolute(ground.origin, rod.a),
    tie: Distance(rod.b, bob.origin, length = rope),
    string: Distance(bob.point(0.1_m, 0.0), dot, length = rope - 0.5_m),
    end: Stop(
        pivot.angle,
        lower = -1.0_rad,
        upper = highest,
        stiffness = 100.0_Nm,
        onset = 0.01_rad
    ),
    rub: Friction(
        pivot.rate,
        coefficient = 0.3,
        static_coefficient = grip,
        stribeck_velocity = 0.1_rad_per_s,
        load = 1.0_Nm,
        regularization_velocity = 0.01_rad_per_s
    ),
});

mechanism!(Spatial {
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),
    moment: Param(0.02_kg_m2),
    product: Param(0.0_kg_m2),
    radius: Param(0.05_m),
    height: Param(0.4_m),
    one: Body(
        mass = 1.0_kg,
        inertia = [
            [moment, product, 0.0],
            [product, 0.03, 0.0],
            [0.0, 0.0, 0.025]
        ],
    ),
    two: Body(
        mass = 1.0_kg,
        inertia = Cylinder(0.1_m, height),
        at = [1.0_m, 0.0, 0.0]
    ),
    three: Bar(
        mass = 1.0_kg,
        from = [1.0_m, 0.0, 0.0],
        to = [2.0_m, 0.0, 0.0],
        radius = radius
    ),
    j1: Revolute(ground, one, at = [0.0, 0.0, 0.0], axis = Z),
    j2: Revolute(one, two, at = [1.0, 0.0, 0.0], axis = Y),
    j3: Revolute(two, three, at = [1.0, 0.0, 0.0], axis = Y),
});

mechanism!(Row {
    doc: "A family is checked once.",
    world: Planar(),
    link: Param(0.2_kg),
    bars: Each(0..40, |i| Bar(mass = link, length = 0.1_m)),
    joints: Each(0..40, |i| Revolute(
        if i == 0 { ground.origin } else { bars[i - 1].b },
        bars[i].a
    )),
});

fn refused<M: Mechanism>(name: &str, value: f64) -> ParameterError {
    let mut mechanism = M::default();
    mechanism.set_parameter(name, value).expect("it exists");
    mechanism.prepare().err().expect("it is refused")
}

#[test]
fn messages_name_entry_argument_and_value() {
    let planar = [
        (
            "rod_mass",
            -0.3,
            "`mass` of `rod` is negative (-0.3); give it a positive value",
        ),
        (
            "rod_length",
            0.0,
            "`length` of `rod` is 0: a bar has a positive length; for a point mass use `Particle`",
        ),
        (
            "body_mass",
            -1.0,
            "`mass` of `bob` is negative (-1); give it a positive value",
        ),
        (
            "body_inertia",
            -0.2,
            "`inertia` of `bob` is negative (-0.1); give it a positive value",
        ),
        (
            "rope",
            0.5,
            "`length` of `string` is 0: the distance must be positive; to hold two points together use `Revolute`",
        ),
        (
            "rope",
            -1.0,
            "`length` of `tie` is -1: the distance must be positive; to hold two points together use `Revolute`",
        ),
        (
            "highest",
            -1.5,
            "`upper - lower` of `end` is -0.5: the upper stop has to begin above the lower one",
        ),
        (
            "grip",
            0.05,
            "`static_coefficient - coefficient` of `rub` is negative (-0.25); give it a positive value",
        ),
    ];
    for (name, value, message) in planar {
        assert_eq!(refused::<Planar>(name, value).to_string(), message);
    }
    let spatial = [
        (
            "moment",
            -0.01,
            "the inertia of `one` is not positive definite: its principal moments are -0.010000, 0.030000 and 0.025000 kg m²; all three have to be positive",
        ),
        (
            "moment",
            0.1,
            "no body has the inertia of `one`: its principal moments are 0.100000, 0.030000 and 0.025000 kg m², and none of them may exceed the sum of the other two",
        ),
        (
            "height",
            0.0,
            "`inertia` of `two` is 0: the size of a shape has to be positive",
        ),
        (
            "radius",
            -0.05,
            "`radius` of `three` is -0.05: a round bar has a positive radius; for a slender one leave it out",
        ),
    ];
    for (name, value, message) in spatial {
        assert_eq!(refused::<Spatial>(name, value).to_string(), message);
    }
    let products = refused::<Spatial>("product", 0.05);
    assert!(
        matches!(
            products,
            ParameterError::InertiaNotPositive { body: "one", .. }
        ),
        "{products}"
    );
    let row = refused::<Row>("link", -1.0).to_string();
    assert_eq!(
        row,
        "`mass` of `bars[0]` is negative (-1); give it a positive value"
    );
}

#[test]
fn defaults_and_limits_pass() {
    assert!(Planar::default().prepare().is_ok());
    assert!(Spatial::default().prepare().is_ok());
    // A plate: one moment is the sum of the others.
    assert!(
        Spatial {
            moment: 0.055,
            ..Spatial::default()
        }
        .prepare()
        .is_ok()
    );
}

/// The reasons are those of the compiler.
#[test]
fn words_are_those_of_the_compiler() {
    let reasons = [
        ("bar-length-negative", refused::<Planar>("rod_length", -1.0)),
        (
            "param-length-negative",
            refused::<Planar>("rod_length", -1.0),
        ),
    ];
    for (program, error) in reasons {
        let path = format!("{}/tests/ui/{program}.stderr", env!("CARGO_MANIFEST_DIR"));
        let message = std::fs::read_to_string(path).expect("the message");
        let ParameterError::NotPositive { because, .. } = error else {
            panic!("another error");
        };
        assert!(message.contains(because), "{message}");
    }
}
