use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    linkage: Assembly(
        FourBar,
        left = ground.origin,
        right = ground.point(0.7_m, 0.0_m),
        crank_lenght = 0.2_m
    ),
});

fn main() {}
