//! Physical dimensions and the units of literals.

use std::fmt;

/// Exponents of length, mass, time and electric current. Angles have none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension(pub [i8; 4]);

impl Dimension {
    /// A pure number or an angle.
    pub const NONE: Dimension = Dimension([0; 4]);
    /// m
    pub const LENGTH: Dimension = Dimension([1, 0, 0, 0]);
    /// kg
    pub const MASS: Dimension = Dimension([0, 1, 0, 0]);
    /// s
    pub const TIME: Dimension = Dimension([0, 0, 1, 0]);
    /// A
    pub const CURRENT: Dimension = Dimension([0, 0, 0, 1]);
    /// m/s
    pub const VELOCITY: Dimension = Dimension([1, 0, -1, 0]);
    /// rad/s
    pub const RATE: Dimension = Dimension([0, 0, -1, 0]);
    /// m/s²
    pub const ACCELERATION: Dimension = Dimension([1, 0, -2, 0]);
    /// N
    pub const FORCE: Dimension = Dimension([1, 1, -2, 0]);
    /// N m
    pub const TORQUE: Dimension = Dimension([2, 1, -2, 0]);
    /// kg m²
    pub const INERTIA: Dimension = Dimension([2, 1, 0, 0]);
    /// N/m
    pub const STIFFNESS: Dimension = Dimension([0, 1, -2, 0]);
    /// N s/m
    pub const DAMPING: Dimension = Dimension([0, 1, -1, 0]);
    /// N m s (per radian)
    pub const TORSION_DAMPING: Dimension = Dimension([2, 1, -1, 0]);

    /// The dimension of a product.
    pub fn times(self, other: Dimension) -> Dimension {
        self.zip(other, |a, b| a + b)
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Dimension) -> Dimension {
        self.zip(other, |a, b| a - b)
    }

    /// The dimension of a power.
    pub fn power(self, exponent: i8) -> Dimension {
        Dimension(self.0.map(|e| bounded(i32::from(e) * i32::from(exponent))))
    }

    /// The dimension of a square root, if it has one.
    pub fn root(self) -> Option<Dimension> {
        self.0
            .iter()
            .all(|e| e % 2 == 0)
            .then(|| Dimension(self.0.map(|e| e / 2)))
    }

    fn zip(self, other: Dimension, combine: impl Fn(i32, i32) -> i32) -> Dimension {
        Dimension(std::array::from_fn(|i| {
            bounded(combine(i32::from(self.0[i]), i32::from(other.0[i])))
        }))
    }

    /// The usual SI unit: derived units by name, others by their exponents; empty for a pure number.
    pub fn unit(self) -> String {
        const NAMED: [(Dimension, &str); 13] = [
            (Dimension::NONE, ""),
            (Dimension::FORCE, "N"),
            (Dimension::TORQUE, "N m"),
            (Dimension::STIFFNESS, "N/m"),
            (Dimension::DAMPING, "N s/m"),
            (Dimension::TORSION_DAMPING, "N m s"),
            (Dimension([2, 1, -3, 0]), "W"),
            (Dimension::INERTIA, "kg m²"),
            (Dimension::VELOCITY, "m/s"),
            (Dimension::ACCELERATION, "m/s²"),
            (Dimension::RATE, "rad/s"),
            (Dimension([0, 0, -2, 0]), "rad/s²"),
            (Dimension([2, 1, -3, -1]), "V"),
        ];
        if let Some((_, name)) = NAMED.iter().find(|(dimension, _)| *dimension == self) {
            return (*name).to_owned();
        }
        let part = |positive: bool| -> Vec<String> {
            ["m", "kg", "s", "A"]
                .iter()
                .zip(self.0)
                .filter(|(_, exponent)| (*exponent > 0) == positive && *exponent != 0)
                .map(|(unit, exponent)| match exponent.abs() {
                    1 => (*unit).to_owned(),
                    power => format!("{unit}^{power}"),
                })
                .collect()
        };
        let (above, below) = (part(true), part(false));
        match (above.is_empty(), below.is_empty()) {
            (false, true) => above.join(" "),
            (true, false) => format!("1/({})", below.join(" ")),
            _ => format!("{}/({})", above.join(" "), below.join(" ")),
        }
    }
}

/// Exponents beyond all physics are not told apart.
fn bounded(exponent: i32) -> i8 {
    exponent.clamp(-127, 127) as i8
}

impl fmt::Display for Dimension {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        const NAMES: [(Dimension, &str); 14] = [
            (Dimension::NONE, "a pure number or angle"),
            (Dimension::LENGTH, "a length (m)"),
            (Dimension::MASS, "a mass (kg)"),
            (Dimension::TIME, "a time (s)"),
            (Dimension::VELOCITY, "a velocity (m/s)"),
            (Dimension::RATE, "a rate (rad/s)"),
            (Dimension::ACCELERATION, "an acceleration (m/s²)"),
            (Dimension::FORCE, "a force (N)"),
            (Dimension::TORQUE, "a torque or energy (N m)"),
            (Dimension::INERTIA, "a moment of inertia (kg m²)"),
            (Dimension::STIFFNESS, "a stiffness (N/m)"),
            (Dimension::DAMPING, "a damping (N s/m)"),
            (Dimension::TORSION_DAMPING, "a torsional damping (N m s)"),
            (Dimension([2, 0, 0, 0]), "an area (m²)"),
        ];
        match NAMES.iter().find(|(dimension, _)| dimension == self) {
            Some((_, name)) => out.write_str(name),
            None => write!(out, "a quantity in {}", self.unit()),
        }
    }
}

/// The factor to SI and the dimension of a unit written as a suffix: `m_per_s2`, `N_s_per_m`, `deg`.
pub fn unit(suffix: &str) -> Option<(f64, Dimension)> {
    let (mut factor, mut dimension, mut sign) = (1.0, Dimension::NONE, 1);
    let mut tokens = suffix.trim_start_matches('_').split('_').peekable();
    while let Some(token) = tokens.next() {
        if token == "per" && tokens.peek().is_some() {
            sign = -1;
            continue;
        }
        let digits = token
            .find(|c: char| c.is_ascii_digit())
            .unwrap_or(token.len());
        let exponent: i8 = if digits == token.len() {
            1
        } else {
            token[digits..]
                .parse()
                .ok()
                .filter(|power| (1..=9).contains(power))?
        };
        let (base, base_dimension) = base_unit(&token[..digits])?;
        factor *= f64::powi(base, i32::from(sign * exponent));
        dimension = dimension.times(base_dimension.power(sign * exponent));
    }
    Some((factor, dimension))
}

/// Units that a literal may carry: name, factor to SI, dimension. Shown in error messages and in the book.
pub const UNITS: &[(&str, f64, Dimension)] = &[
    ("m", 1.0, Dimension::LENGTH),
    ("km", 1e3, Dimension::LENGTH),
    ("cm", 1e-2, Dimension::LENGTH),
    ("mm", 1e-3, Dimension::LENGTH),
    ("kg", 1.0, Dimension::MASS),
    ("g", 1e-3, Dimension::MASS),
    ("t", 1e3, Dimension::MASS),
    ("s", 1.0, Dimension::TIME),
    ("ms", 1e-3, Dimension::TIME),
    ("min", 60.0, Dimension::TIME),
    ("h", 3600.0, Dimension::TIME),
    ("rad", 1.0, Dimension::NONE),
    ("deg", std::f64::consts::PI / 180.0, Dimension::NONE),
    ("rev", 2.0 * std::f64::consts::PI, Dimension::NONE),
    ("rpm", std::f64::consts::PI / 30.0, Dimension::RATE),
    ("N", 1.0, Dimension::FORCE),
    ("kN", 1e3, Dimension::FORCE),
    ("MN", 1e6, Dimension::FORCE),
    ("Nm", 1.0, Dimension::TORQUE),
    ("kNm", 1e3, Dimension::TORQUE),
    ("J", 1.0, Dimension::TORQUE),
    ("kJ", 1e3, Dimension::TORQUE),
    ("W", 1.0, Dimension([2, 1, -3, 0])),
    ("kW", 1e3, Dimension([2, 1, -3, 0])),
    ("Pa", 1.0, Dimension([-1, 1, -2, 0])),
    ("A", 1.0, Dimension::CURRENT),
    ("V", 1.0, Dimension([2, 1, -3, -1])),
    ("ohm", 1.0, Dimension([2, 1, -3, -2])),
];

/// Units of several that are often written, of which a suffix may be a misspelling.
pub const JOINED: [&str; 8] = [
    "kg_m2",
    "m_per_s",
    "m_per_s2",
    "rad_per_s",
    "N_per_m",
    "N_s",
    "N_s_per_m",
    "N_m_s",
];

/// Units by other abbreviations.
const ABBREVIATIONS: [(&str, &str); 3] = [("sec", "s"), ("second", "s"), ("mps", "m_per_s")];

/// The unit that a suffix is with other abbreviations, if it is one.
pub fn abbreviated(suffix: &str) -> Option<String> {
    let token = |token: &str| {
        let name = token.trim_end_matches(|c: char| c.is_ascii_digit());
        match ABBREVIATIONS.iter().find(|(other, _)| *other == name) {
            Some((_, own)) => format!("{own}{}", &token[name.len()..]),
            None => token.to_owned(),
        }
    };
    let tokens: Vec<String> = suffix.split('_').map(token).collect();
    let meant = tokens.join("_");
    (meant != suffix && unit(&meant).is_some()).then_some(meant)
}

/// Units that people may write and that are no units here: name, what it is, and what to write instead.
const FOREIGN: &[(&str, &str)] = &[
    ("in", "inches are not known here; one is `25.4_mm`"),
    ("inch", "inches are not known here; one is `25.4_mm`"),
    ("ft", "feet are not known here; one is `304.8_mm`"),
    ("lb", "pounds are not known here; one is `0.45359237_kg`"),
    ("lbm", "pounds are not known here; one is `0.45359237_kg`"),
    (
        "lbf",
        "pounds of force are not known here; one is `4.4482216152605_N`",
    ),
    ("oz", "ounces are not known here; one is `28.349523125_g`"),
    (
        "psi",
        "pounds per square inch are not known here; one is `6894.757293168_Pa`",
    ),
    ("bar", "bars are not known here; one is `1e5_Pa`"),
    (
        "kgf",
        "kilograms of force are not known here; one is `9.80665_N`",
    ),
    ("um", "micrometres are not known here; one is `1e-6_m`"),
    ("mN", "millinewtons are not known here; one is `1e-3_N`"),
    (
        "Hz",
        "it does not say whether turns or radians are counted: an angular rate is in `rev_per_s`, `rpm` or `rad_per_s`, another frequency in `per_s`",
    ),
];

/// What to write instead of a unit that is not known here, if one is in a suffix.
pub fn foreign(suffix: &str) -> Option<&'static str> {
    suffix.split('_').find_map(|token| {
        let name = token.trim_end_matches(|c: char| c.is_ascii_digit());
        let unit = FOREIGN.iter().find(|(unit, _)| *unit == name);
        unit.map(|(_, advice)| *advice)
    })
}

fn base_unit(name: &str) -> Option<(f64, Dimension)> {
    UNITS
        .iter()
        .find(|(unit, ..)| *unit == name)
        .map(|&(_, factor, dimension)| (factor, dimension))
}
