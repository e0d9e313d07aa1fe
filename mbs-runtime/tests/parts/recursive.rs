use mbs_runtime::assembly;

assembly!(Tree {
    world: Planar(),
    root: Port(Point),
    stem: Bar(mass = 1.0_kg, length = 1.0_m),
    joint: Revolute(root, stem.a),
    branch: Assembly(Tree, root = stem.b),
});

fn main() {}
