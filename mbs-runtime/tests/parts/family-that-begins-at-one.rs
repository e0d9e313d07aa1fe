use mbs_parts::planar::FourBar;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    linkage: Each(1..3, |i| Assembly(
        FourBar,
        left = ground.point(0.0_m, i * 1.0_m),
        right = ground.point(0.7_m, i * 1.0_m)
    )),
});

fn main() {}
