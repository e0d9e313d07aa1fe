//! Symmetric compositions of the two-level step: h c₁, h c₂, … h c_s with c_i = c_{s+1−i} and Σ c = 1.
//!
//! A symmetric step of second order has an error expansion in odd powers of h; Σ c³ = 0 raises the order to 4, further
//! conditions raise it to 6 and 8. Some stages run back in time, which is possible for conservative motion.
//!
//! | order | stages | source |
//! |---|---|---|
//! | 4 | 7 | M. Suzuki, Phys. Lett. A 146 (1990) 319–323, with three stages on either side: c = 1/(6 − 6^⅓) |
//! | 6 | 13 | M. Sofroniou, G. Spaletta, Optim. Methods Softw. 20 (2005) 597–613 |
//! | 8 | 17 | W. Kahan, R.-C. Li, Math. Comp. 66 (1997) 1089–1099 (s17odr8a) |
//!
//! They were chosen by the stages per second of motion for an error of 1e-9 on five scenes
//! (`cargo run --release -p mbs-examples --example compositions`; the table is in the book). More stages per step are
//! more efficient: at sixth order the set of thirteen needs 0.82 times (geometric mean) the stages of the set of nine
//! (Kahan, Li). At eighth order twenty-one (Sofroniou, Spaletta) need 0.93 times those of seventeen, but 1.2 times on
//! the slider-crank, and in their longer steps more stages end beside singular poses. So the set of seventeen is used.

const FOURTH: [f64; 7] = symmetric([
    0.239_069_765_742_321_26,
    0.239_069_765_742_321_26,
    0.239_069_765_742_321_26,
    0.0,
]);

const SIXTH: [f64; 13] = symmetric([
    0.138_619_308_540_516_952_458_08,
    0.133_465_628_510_747_604_070_47,
    0.130_705_310_114_492_251_905_43,
    0.129_618_937_569_070_347_725_05,
    -0.350_003_248_939_208_965_161_71,
    0.118_055_306_530_023_871_702_73,
    0.0,
]);

const EIGHTH: [f64; 17] = symmetric([
    0.130_202_483_088_890_080_88,
    0.561_162_981_775_108_384_56,
    -0.389_474_962_644_847_286_41,
    0.158_841_906_555_155_600_90,
    -0.395_903_894_133_237_577_34,
    0.184_539_640_978_315_707_09,
    0.258_374_387_686_322_047_30,
    0.295_011_723_609_310_298_87,
    0.0,
]);

/// The stages of a step of this order, as fractions of it; one of [`ORDERS`](crate::settings::ORDERS).
pub(crate) fn stages(order: u8) -> &'static [f64] {
    match order {
        4 => &FOURTH,
        6 => &SIXTH,
        8 => &EIGHTH,
        _ => &[1.0],
    }
}

/// All stages from the first half; the middle one, written as zero, makes the sum 1.
const fn symmetric<const HALF: usize, const ALL: usize>(half: [f64; HALF]) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    let mut rest = 1.0;
    let mut i = 0;
    while i + 1 < HALF {
        all[i] = half[i];
        all[ALL - 1 - i] = half[i];
        rest -= 2.0 * half[i];
        i += 1;
    }
    all[HALF - 1] = rest;
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::ORDERS;

    fn power_sum(order: u8, power: i32) -> f64 {
        stages(order).iter().map(|c| c.powi(power)).sum()
    }

    #[test]
    fn stages_add_up_and_are_symmetric() {
        for order in ORDERS {
            assert!((power_sum(order, 1) - 1.0).abs() < 1e-15);
            let (forward, backward) = (stages(order).iter(), stages(order).iter().rev());
            assert!(forward.eq(backward));
        }
    }

    #[test]
    fn power_sums_vanish_up_to_the_order() {
        for order in [4, 6, 8] {
            for power in (3..i32::from(order)).step_by(2) {
                let sum = power_sum(order, power);
                assert!(sum.abs() < 1e-14, "order {order}, power {power}: {sum:e}");
            }
        }
    }
}
