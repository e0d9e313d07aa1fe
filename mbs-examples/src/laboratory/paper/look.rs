//! The styles of curves: dash and lightness differ also in grey.

use super::run::{BDF, COLD, M_ALF, PAPER, STRICT, TWO_LEVEL};

/// Colour, width and dash.
pub type Look = (&'static str, f64, &'static str);

/// The styles of curves that are not methods, in their order.
const OTHERS: [Look; 9] = [
    ("#14507d", 2.4, ""),
    ("#c2410c", 2.0, "7 3"),
    ("#2f8a3d", 2.0, "2 3"),
    ("#7b4b9e", 1.8, "9 3 2 3"),
    ("#1d2126", 1.4, ""),
    ("#c99700", 1.8, "4 2"),
    ("#5aa9d6", 1.6, "12 4"),
    ("#e2737b", 1.4, ""),
    ("#6f7680", 1.4, "1 2"),
];

/// The style of the curve with this label, the i-th of its panel.
pub fn look(label: &str, i: usize) -> Look {
    match label {
        "exact" => ("#b9bdc2", 5.0, ""),
        TWO_LEVEL => ("#14507d", 2.2, ""),
        PAPER => ("#b3202a", 2.0, "7 3"),
        COLD => ("#e9a08f", 1.6, "1 3"),
        STRICT => ("#e2737b", 2.0, "2 3"),
        M_ALF => ("#c99700", 1.8, "9 3 2 3"),
        _ if label.ends_with("k̄ c̄") => ("#7b4b9e", 1.8, "12 4"),
        _ if label == BDF[0] => ("#2f8a3d", 1.8, ""),
        _ if label == BDF[1] => ("#1f5c2a", 1.6, "5 3"),
        _ if label == BDF[2] => ("#7cc487", 1.6, "1 2"),
        "index3-projections" => ("#6f7680", 1.8, "12 4"),
        _ => OTHERS[i % OTHERS.len()],
    }
}
