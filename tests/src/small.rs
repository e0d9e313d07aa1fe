//! Small declarations that are followed through the compiler. Every derived quantity is nonzero in at least one of
//! them: `tests/flipped_signs.rs` counts.

// ANCHOR: slider_crank
/// Constant M, and rows: the example of the book.
pub const SLIDER_CRANK: &str = r#"SliderCrank {
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

/// M(q), so that Γ has Christoffel's symbols, and ∂p/∂q and ∂F/∂v are not zero; a spring and a damper.
pub const DOUBLE_PENDULUM: &str = r#"DoublePendulum {
    doc: "Two bars in a row, with a spring and a damper at the elbow.",
    world: Planar(gravity = [0.0, -9.81_m_per_s2], coordinates = Joint),

    /// Length of the upper bar.
    length: Param(1.0_m),
    upper_mass: Param(2.0_kg),
    lower_mass: Param(1.0_kg),
    stiffness: Param(5.0_Nm),
    damping: Param(0.1_Nm_s),

    upper: Bar(mass = upper_mass, length = length, angle = -60.0_deg),
    lower: Bar(mass = lower_mass, length = 0.8_m, angle = -30.0_deg),
    pivot: Revolute(ground.origin, upper.a),
    elbow: Revolute(upper.b, lower.a),
    spring: TorsionSpring(lower, upper, stiffness = stiffness, damping = damping),

    tip: Output(lower.b),
    straight: Event(sin(lower.angle - upper.angle)),
}"#;

/// A rotation of space, so that Γ has ω × J ω; a holonomic and a nonholonomic row, both with b; a force that depends on
/// orientation and velocity.
pub const SKATE: &str = r#"Skate {
    doc: "A body in space that glides on a deck which rises and falls, across a stream.",
    world: Spatial(gravity = [0.0, 0.0, -9.81_m_per_s2]),

    mass: Param(2.0_kg),
    arm: Param(0.3_m),
    lift: Param(0.1_m),
    damping: Param(3.0_N_s_per_m),

    skate: Body(
        mass = mass,
        inertia = diag(0.01, 0.02, 0.03),
        velocity = [1.0, 0.0, 0.0],
    ),
    deck: Holonomic(dot(skate.point(arm, 0.0, 0.0), ground.z) - lift * sin(3.0_per_s * t)),
    edge: Nonholonomic(dot(skate.velocity, skate.y) - 0.2_m_per_s * cos(2.0_per_s * t)),
    drag: Force(skate.origin, value = -damping * dot(skate.velocity, skate.x) * skate.x),

    heading: Output(skate.x),
}"#;

/// All of them, by name.
pub const ALL: [(&str, &str); 3] = [
    ("slider-crank", SLIDER_CRANK),
    ("double-pendulum", DOUBLE_PENDULUM),
    ("skate", SKATE),
];

/// Scenes of which the formulas are checked in.
pub const SCENES: [&str; 5] = [
    "slider-crank",
    "driven-slider-crank",
    "andrews",
    "bricard",
    "rolling-disk",
];

/// The declaration of a scene.
pub fn scene(name: &str) -> &'static str {
    let mut scenes = mbs_examples::scenes::scenes().iter();
    let scene = scenes.find(|scene| scene.name == name);
    scene.expect("there is such a scene").model.declaration
}
