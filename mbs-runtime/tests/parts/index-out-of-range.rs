use mbs_parts::planar::GearTrain;

mbs_runtime::mechanism!(Wrong {
    world: Planar(),
    train: Assembly(GearTrain, carrier = ground, count = 3),
    last: Output(train.wheel[3].rate),
});

fn main() {}
