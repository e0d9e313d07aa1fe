//! Elementary functions of f64 without the standard library, by `libm`.
//!
//! With the standard library they are methods of f64 itself, which come before those of this trait: then nothing calls it.

macro_rules! elementary {
    ($($name:ident($($argument:ident)?) = $function:path;)+) => {
        /// Elementary functions, as the standard library names them.
        pub trait Elementary: Sized {
            $(
                #[doc = concat!("`", stringify!($function), "`.")]
                fn $name(self $(, $argument: Self)?) -> Self;
            )+
            /// x to an integer power, by squares.
            fn powi(self, exponent: i32) -> Self;
            /// `libm::sincos`.
            fn sin_cos(self) -> (Self, Self);
        }

        impl Elementary for f64 {
            $(
                #[inline(always)]
                fn $name(self $(, $argument: f64)?) -> f64 {
                    $function(self $(, $argument)?)
                }
            )+

            #[inline]
            fn powi(self, exponent: i32) -> f64 {
                power(self, exponent)
            }

            #[inline(always)]
            fn sin_cos(self) -> (f64, f64) {
                libm::sincos(self)
            }
        }
    };
}

elementary! {
    sqrt() = libm::sqrt;
    sin() = libm::sin;
    cos() = libm::cos;
    tan() = libm::tan;
    asin() = libm::asin;
    acos() = libm::acos;
    atan() = libm::atan;
    atan2(other) = libm::atan2;
    exp() = libm::exp;
    ln() = libm::log;
    powf(exponent) = libm::pow;
    hypot(other) = libm::hypot;
    sinh() = libm::sinh;
    cosh() = libm::cosh;
    tanh() = libm::tanh;
    floor() = libm::floor;
    ceil() = libm::ceil;
    round() = libm::round;
    trunc() = libm::trunc;
}

/// x to an integer power, in the order of multiplications of the standard library.
#[inline]
fn power(x: f64, exponent: i32) -> f64 {
    let (mut square, mut power, mut left) = (x, 1.0, exponent.unsigned_abs());
    while left > 0 {
        if left % 2 == 1 {
            power *= square;
        }
        left /= 2;
        if left > 0 {
            square *= square;
        }
    }
    if exponent < 0 { 1.0 / power } else { power }
}
