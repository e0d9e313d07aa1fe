//! Symmetric compositions of the two-level step, compared by work: the stages per second of motion with which each set
//! of coefficients reaches a position error, and the slope of the error there.
//!
//! `cargo run --release -p mbs-examples --example compositions [--csv book/src/results/readme]`

use mbs_examples::pages::record::{File, Recorder};
use mbs_examples::scenes::{bricard, chaplygin_sleigh, double_four_bar, pendulum, slider_crank};
use mbs_runtime::nalgebra::SVector;
use mbs_runtime::{Mechanism, Settings, Simulation, State, System, TwoLevelStepper};

/// Coefficients γ₁, γ₂, … without the middle one, which makes the sum 1.
struct Set {
    order: u8,
    name: &'static str,
    half: &'static [f64],
}

/// M. Suzuki, Phys. Lett. A 146 (1990) 319–323; R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168; H. Yoshida,
/// Phys. Lett. A 150 (1990) 262–268; W. Kahan, R.-C. Li, Math. Comp. 66 (1997) 1089–1099; M. Suzuki, K. Umeno, Springer
/// Proc. Phys. 76 (1993) 74–86; M. Sofroniou, G. Spaletta, Optim. Methods Softw. 20 (2005) 597–613.
const SETS: &[Set] = &[
    Set {
        order: 4,
        name: "triple jump, 3",
        half: &[1.351_207_191_959_657_8],
    },
    Set {
        order: 4,
        name: "Suzuki, 5",
        half: &[0.414_490_771_794_375_73, 0.414_490_771_794_375_73],
    },
    Set {
        order: 4,
        name: "McLachlan, 5",
        half: &[0.28, 0.625_466_428_467_670_045_01],
    },
    Set {
        order: 4,
        name: "Suzuki, 7",
        half: &[
            0.239_069_765_742_321_26,
            0.239_069_765_742_321_26,
            0.239_069_765_742_321_26,
        ],
    },
    Set {
        order: 4,
        name: "Suzuki, 9",
        half: &[1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0],
    },
    Set {
        order: 6,
        name: "Yoshida A, 7",
        half: &[
            0.784_513_610_477_557_263_82,
            0.235_573_213_359_358_133_68,
            -1.177_679_984_178_871_006_95,
        ],
    },
    Set {
        order: 6,
        name: "McLachlan, 9",
        half: &[
            0.1867,
            0.555_497_023_712_478_399_16,
            0.129_466_948_913_475_358_06,
            -0.843_265_623_387_734_608_55,
        ],
    },
    Set {
        order: 6,
        name: "Kahan–Li a, 9",
        half: &[
            0.392_161_444_007_314_139_28,
            0.332_599_136_789_359_438_60,
            -0.706_246_172_557_639_359_81,
            0.082_213_596_293_550_800_23,
        ],
    },
    Set {
        order: 6,
        name: "Sofroniou–Spaletta, 11",
        half: &[
            0.213_755_839_458_782_545_56,
            0.183_293_814_074_257_139_11,
            0.176_928_194_730_989_437_95,
            -0.443_290_826_811_702_158_50,
            0.117_285_604_328_659_353_85,
        ],
    },
    Set {
        order: 6,
        name: "Sofroniou–Spaletta, 13",
        half: &[
            0.138_619_308_540_516_952_46,
            0.133_465_628_510_747_604_07,
            0.130_705_310_114_492_251_91,
            0.129_618_937_569_070_347_73,
            -0.350_003_248_939_208_965_16,
            0.118_055_306_530_023_871_70,
        ],
    },
    Set {
        order: 8,
        name: "Suzuki–Umeno, 15",
        half: &[
            0.741_670_364_350_612_953_45,
            -0.409_100_825_800_031_593_99,
            0.190_754_710_296_238_379_95,
            -0.573_862_471_116_082_266_66,
            0.299_064_181_303_655_923_84,
            0.334_624_918_245_298_183_78,
            0.315_293_092_396_766_596_63,
        ],
    },
    Set {
        order: 8,
        name: "Kahan–Li a, 17",
        half: &[
            0.130_202_483_088_890_080_88,
            0.561_162_981_775_108_384_56,
            -0.389_474_962_644_847_286_41,
            0.158_841_906_555_155_600_90,
            -0.395_903_894_133_237_577_34,
            0.184_539_640_978_315_707_09,
            0.258_374_387_686_322_047_30,
            0.295_011_723_609_310_298_87,
        ],
    },
    Set {
        order: 8,
        name: "Sofroniou–Spaletta, 21",
        half: &[
            0.106_477_289_845_500_318_24,
            0.108_374_086_458_357_263_97,
            0.353_378_210_526_543_424_20,
            -0.233_414_140_231_650_821_99,
            -0.244_452_667_915_288_412_70,
            0.113_178_484_357_556_333_15,
            0.118_929_056_250_003_500_63,
            0.126_039_123_218_259_881_40,
            0.125_817_187_361_760_418_04,
            0.116_991_350_192_176_421_81,
        ],
    },
    Set {
        order: 10,
        name: "Sofroniou–Spaletta, 35",
        half: &[
            0.078_795_722_521_686_419_26,
            0.313_096_103_415_108_527_76,
            0.027_918_383_235_078_066_11,
            -0.229_592_841_593_907_094_15,
            0.130_962_061_077_164_863_17,
            -0.269_733_405_654_510_714_34,
            0.074_973_343_155_891_435_67,
            0.111_993_423_999_810_204_89,
            0.366_133_449_546_226_751_19,
            -0.399_105_630_136_035_897_88,
            0.103_087_398_527_471_077_32,
            0.411_430_873_955_890_237_82,
            -0.004_866_360_583_135_261_76,
            -0.392_033_353_708_639_906_45,
            0.051_942_502_962_449_647_04,
            0.050_665_090_759_924_496_34,
            0.049_674_370_639_729_879_06,
        ],
    },
];

/// Position errors to reach, in sizes or radians.
const ERRORS: [f64; 4] = [1e-3, 1e-5, 1e-7, 1e-9];
/// Stages per second of the first run, and the factor from each run to the next.
const FEWEST: f64 = 12.0;
const MORE: f64 = 1.189_207_115_002_721;
const RUNS: usize = 48;
/// Step of the fine run, from which errors are measured, as stages per second of the last order.
const FINE: f64 = 60_000.0;

impl Set {
    fn stages(&self) -> Vec<f64> {
        let rest = 1.0 - 2.0 * self.half.iter().sum::<f64>();
        let back = self.half.iter().rev();
        let all = self.half.iter().chain([&rest]).chain(back);
        all.copied().collect()
    }
}

fn main() -> Result<(), String> {
    const COLUMNS: [&str; 9] = [
        "scene",
        "order",
        "set",
        "time_s",
        "rate_1e-3",
        "rate_1e-5",
        "rate_1e-7",
        "rate_1e-9",
        "slope",
    ];
    let recorder = Recorder::new("cargo run --release -p mbs-examples --example compositions")?;
    recorder.check_names([])?;
    let mut file = recorder.file("compositions.csv", &COLUMNS, 3)?;
    println!(
        "stages a second for an error of position of {ERRORS:?}, and the slope at the last but one"
    );
    // Before the first singular poses: beside them the error depends on where stages end, not on the coefficients.
    compare("pendulum", &pendulum::Pendulum::default(), 3.0, &mut file)?;
    compare(
        "slider-crank",
        &slider_crank::SliderCrank::default(),
        0.35,
        &mut file,
    )?;
    compare(
        "double-four-bar",
        &double_four_bar::DoubleFourBar::default(),
        0.65,
        &mut file,
    )?;
    compare("bricard", &bricard::Bricard::default(), 3.0, &mut file)?;
    compare(
        "chaplygin-sleigh",
        &chaplygin_sleigh::ChaplyginSleigh::default(),
        4.0,
        &mut file,
    )
}

fn compare<M, S, const Q: usize, const N: usize, const R: usize>(
    name: &str,
    mechanism: &M,
    time: f64,
    file: &mut File,
) -> Result<(), String>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    println!(
        "\n| {name}, {time} s | 1e-3 | 1e-5 | 1e-7 | 1e-9 | slope |\n|---|---|---|---|---|---|"
    );
    let start = Simulation::new(mechanism.clone()).map_err(|error| error.to_string())?;
    let start = start.state().clone();
    let last = SETS.last().ok_or("there are no sets")?;
    let exact = run(mechanism, &start, &last.stages(), time, FINE);
    let exact = exact.ok_or("the fine run stopped")?;
    for set in SETS {
        let stages = set.stages();
        let errors: Vec<(f64, f64)> = (0..RUNS)
            .map(|run_index| {
                let rate = FEWEST * MORE.powi(run_index as i32);
                // A run that stops reaches no bound.
                let Some(end) = run(mechanism, &start, &stages, time, rate) else {
                    return (rate, f64::INFINITY);
                };
                let error = end.0.iter().zip(&exact.0).map(|(a, b)| (a - b).abs());
                (end.1, error.fold(0.0, f64::max))
            })
            .collect();
        let rates = ERRORS.map(|wanted| rate(&errors, wanted));
        let cells =
            rates.map(|found| found.map_or("–".to_owned(), |(rate, _)| format!("{rate:.0}")));
        let slope = rates[2].map_or(f64::NAN, |(_, slope)| slope);
        println!(
            "| {}: {} | {} | {slope:.1} |",
            set.order,
            set.name,
            cells.join(" | ")
        );
        let mut row = vec![name.to_owned(), set.order.to_string(), set.name.to_owned()];
        row.push(time.to_string());
        row.extend(cells);
        row.push(format!("{slope:.2}"));
        file.put(row)?;
    }
    Ok(())
}

/// q after `time` in whole steps, and the stages per second; `None` if a step fails.
fn run<M, S, const Q: usize, const N: usize, const R: usize>(
    mechanism: &M,
    start: &State<Q, N, R>,
    stages: &[f64],
    time: f64,
    rate: f64,
) -> Option<(SVector<f64, Q>, f64)>
where
    M: Mechanism<System = S>,
    S: System<Q, N, R>,
{
    let steps = (time * rate / stages.len() as f64).round().max(1.0);
    let h = time / steps;
    let settings = Settings {
        step: h,
        ..Settings::default()
    };
    let system = mechanism.prepare().ok()?;
    let mut stepper = TwoLevelStepper::new(system, start.clone(), &settings).ok()?;
    for _ in 0..steps as u64 {
        for fraction in stages {
            stepper.step(fraction * h).ok()?;
        }
    }
    let rate = stages.len() as f64 / h;
    Some((stepper.state().positions, rate))
}

/// The stages per second from which on errors are below `wanted`, and the slope there.
fn rate(errors: &[(f64, f64)], wanted: f64) -> Option<(f64, f64)> {
    let last = errors.iter().rposition(|(_, error)| !(*error < wanted))?;
    let (coarse, fine) = (errors.get(last)?, errors.get(last + 1)?);
    let slope = (coarse.1 / fine.1).ln() / (fine.0 / coarse.0).ln();
    let rate = match coarse.1.is_finite() {
        true => coarse.0 * (coarse.1 / wanted).powf(1.0 / slope),
        false => fine.0,
    };
    // Over a wider range, so that the noise of single runs has no effect.
    let wide = errors.get(last.checked_sub(3)?)?;
    let slope = (wide.1 / fine.1).ln() / (fine.0 / wide.0).ln();
    Some((rate, slope))
}
