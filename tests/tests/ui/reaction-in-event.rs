use mbs_runtime::mechanism;

mechanism!(Wrong {
    world: Planar(),
    rod: Bar(mass = 1.0_kg, length = 1.0_m),
    pivot: Revolute(ground.origin, rod.a),
    lifts_off: Event(pivot.reaction.fy),
});

fn main() {}
