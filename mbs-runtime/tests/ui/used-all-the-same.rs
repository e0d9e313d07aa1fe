use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),

    lever: Param(1.0_m),
    bar: Bar(mass = 1.0_kg, length = levre),
    pivot: Revolute(ground.origin, bar.a),
});

/// Of a declaration that is wrong, its struct is there all the same: nothing is said about its use.
fn main() {
    let wrong = Wrong {
        lever: 2.0,
        ..Wrong::default()
    };
    println!("{}", wrong.lever);
}
