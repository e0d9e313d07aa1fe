use mbs_runtime::mechanism;

mechanism!(Wrong);

fn main() {}
