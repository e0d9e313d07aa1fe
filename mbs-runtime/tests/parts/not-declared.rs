mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    linkage: Assembly(FiveBar, left = ground.origin),
});

fn main() {}
