//! The toolkit against equations written for one mechanism, and an accuracy against Baumgarte's terms.

/// Columns of both files; the first three identify a row. The other cells are empty if no run stays within the bound.
pub const COLUMNS: [&str; 9] = [
    "scene",
    "bound_J",
    "family",
    "setting",
    "value",
    "tried",
    "finer_ones_that_hold",
    "instructions",
    "time_ms",
];
/// How many of them identify a row.
pub const KEYS: usize = 3;
/// Who is compared with equations in bar angles.
pub const FAMILIES: [&str; 4] = ["accuracy", "ours", "symbolic 8", "symbolic 4"];
/// Who is compared with Baumgarte's terms.
pub const STABILISED: [&str; 3] = ["accuracy", "Baumgarte 4", "Baumgarte 8"];
