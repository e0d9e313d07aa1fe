use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    length: Param(0.2_m),
    linkage: Assembly(
        FourBar,
        left = ground.origin,
        right = ground.point(0.7_m, 0.0_m),
        crank_length = length
    ),
});

fn main() {}
