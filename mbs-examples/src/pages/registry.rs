//! Every text that `mbs pages` writes.

use super::data::Data;
use super::{
    accuracies, calls, candidates, charts, compile_times, compositions, damped, derivation,
    instructions, method_changes, model_size, orders, others, paper, phases, random_jumps,
    random_passages, rival, rows, scenes, springs, sweep, symbolic, tolerances, tuning, which,
};

/// From the data to Markdown; the error is a message about missing data.
pub type Render = fn(&Data) -> Result<String, String>;

/// The position of a text; paths are relative to the top of the repository.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place<'p> {
    /// Between the two comments of this name.
    Block {
        /// The page.
        page: &'p str,
        /// The name.
        name: &'p str,
    },
    /// The whole of a file, which a page includes.
    File(&'p str),
}

/// A text and where it is.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Where.
    pub place: Place<'static>,
    /// What.
    pub render: Render,
}

/// A block of a page.
pub const fn block(page: &'static str, name: &'static str, render: Render) -> Entry {
    let place = Place::Block { page, name };
    Entry { place, render }
}

/// A file that a page includes.
pub const fn file(path: &'static str, render: Render) -> Entry {
    let place = Place::File(path);
    Entry { place, render }
}

const README: &str = "README.md";
const INTRODUCTION: &str = "book/src/introduction.md";
const ACCURACY: &str = "book/src/accuracy.md";
const ACCURACY_COSTS: &str = "book/src/results/accuracy.md";
const CHOICE: &str = "book/src/theory/choice.md";
const COORDINATES: &str = "book/src/coordinates.md";
const COMMAND_LINE: &str = "book/src/command-line.md";
const TWO_LEVELS: &str = "book/src/theory/two-levels.md";
const COLLOCATION: &str = "book/src/theory/collocation.md";
const FIGURES: [&str; 7] = [
    "book/src/results/paper/figure-1.md",
    "book/src/results/paper/figure-2.md",
    "book/src/results/paper/figure-3.md",
    "book/src/results/paper/figure-4.md",
    "book/src/results/paper/figure-5.md",
    "book/src/results/paper/figure-6.md",
    "book/src/results/paper/figure-7.md",
];
const TUNING: &str = "book/src/results/tuning.md";
const WHICH: &str = "book/src/results/which-method.md";
const WORK_PRECISION: &str = "book/src/results/work-precision.md";
const STABILITY: &str = "book/src/results/stability.md";
const SWEEPS: &str = "book/src/results/sweeps.md";
const SYMBOLIC: &str = "book/src/results/symbolic.md";
const MODEL_SIZE: &str = "book/src/results/model-size.md";
const COMPILE_TIMES: &str = "book/src/results/compile-times.md";

/// All of them.
pub const ENTRIES: &[Entry] = &[
    block(README, "scenes", scenes::table),
    block(INTRODUCTION, "others", others::table),
    block(README, "rows", rows::measured),
    block(README, "orders", orders::table),
    block(README, "samples", orders::samples),
    block(README, "rival", rival::table),
    block(COLLOCATION, "damped", damped::table),
    block(README, "stiff springs", springs::sentence),
    block(README, "instructions", instructions::beside_hand),
    block(README, "derivation", derivation::sentence),
    block(ACCURACY, "samples", orders::samples),
    block(ACCURACY_COSTS, "accuracies", accuracies::table),
    block(ACCURACY, "largest error", accuracies::largest_error),
    block(ACCURACY_COSTS, "ratios", accuracies::ratios),
    block(CHOICE, "method changes", method_changes::table),
    block(ACCURACY, "looks", tolerances::looks),
    block(ACCURACY_COSTS, "tolerances", tolerances::table),
    block(ACCURACY_COSTS, "other orders", tolerances::others),
    block(ACCURACY_COSTS, "compositions", compositions::table),
    block(ACCURACY_COSTS, "phases", phases::table),
    block(ACCURACY_COSTS, "rival settings", rival::settings),
    block(ACCURACY_COSTS, "calls", calls::table),
    block(COMMAND_LINE, "samples", orders::samples),
    block(COORDINATES, "candidates", candidates::text),
    block(TWO_LEVELS, "rows", rows::measured),
    block(TWO_LEVELS, "corrections", rows::corrections),
    block(TWO_LEVELS, "redundant rows", instructions::redundant),
    block(SYMBOLIC, "any", symbolic::any),
    block(SYMBOLIC, "steady", symbolic::steady),
    block(SYMBOLIC, "settings", symbolic::settings),
    block(SYMBOLIC, "stabilised any", symbolic::stabilised_any),
    block(SYMBOLIC, "stabilised steady", symbolic::stabilised_steady),
    block(
        SYMBOLIC,
        "stabilised settings",
        symbolic::stabilised_settings,
    ),
    block(MODEL_SIZE, "models", model_size::table),
    block(COMPILE_TIMES, "compile times", compile_times::table),
    block(
        COMPILE_TIMES,
        "time of a statement",
        compile_times::of_statement,
    ),
    block(COMPILE_TIMES, "methods", compile_times::methods),
    block(COMPILE_TIMES, "origins", compile_times::origins),
    block(FIGURES[0], "runs", paper::runs_1),
    block(FIGURES[0], "deviations", paper::deviations),
    block(FIGURES[1], "runs", paper::runs_2),
    block(FIGURES[1], "ensemble", paper::ensembles_2),
    block(FIGURES[2], "runs", paper::runs_3),
    block(FIGURES[2], "ensemble", paper::ensembles_3),
    block(FIGURES[3], "runs", paper::runs_4),
    block(FIGURES[3], "ensemble", paper::ensembles_4),
    block(FIGURES[4], "runs", paper::runs_5),
    block(FIGURES[4], "peaks", paper::peaks),
    block(FIGURES[5], "runs", paper::runs_6),
    block(FIGURES[5], "ensemble", paper::ensembles_6),
    block(FIGURES[6], "runs", paper::runs_7),
    block(WHICH, "fastest", which::table),
    block(TUNING, "tuning", tuning::table),
    block(WORK_PRECISION, "source", charts::work_precision_source),
    block(STABILITY, "source", charts::stability_source),
    block(SWEEPS, "lost", sweep::sentence),
    block(SWEEPS, "by method", sweep::by_method),
    block(SWEEPS, "by scene", sweep::by_scene),
    block(SWEEPS, "random passages", random_passages::table),
    block(SWEEPS, "random jumps", random_jumps::table),
    file(
        "book/src/results/work-precision-tables.txt",
        charts::work_precision,
    ),
    file("book/src/results/stability-tables.txt", charts::stability),
];
