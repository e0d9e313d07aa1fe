use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    linkage: Assembly(FourBar, left = ground.origin),
});

fn main() {}
