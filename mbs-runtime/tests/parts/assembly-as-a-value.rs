use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    linkage: Assembly(FourBar, left = ground.origin, right = ground.point(0.7_m, 0.0_m)),
    tip: Output(linkage),
});

fn main() {}
