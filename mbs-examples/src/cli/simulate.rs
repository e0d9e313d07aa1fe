//! `mbs simulate`: runs a scene.

use std::path::PathBuf;

use clap::Args;
use cpu_time::ProcessTime;
use mbs_examples::reference::{Deviation, ReferenceTable};
use mbs_examples::scene::Scene;
use mbs_runtime::output::Frame;
use mbs_runtime::{AnySimulation, SimulationError};

use super::failure::Failure;
use super::find;
use super::print::print;
use super::progress::Progress;
use super::request::Request;
use super::results::Results;
use super::summary;

/// The largest number of recorded instants, up to one.
const MOST_SAMPLES: f64 = 2000.0;
/// The least number of recorded instants, if they are between steps.
const LOOKS: f64 = 500.0;

/// Arguments of `mbs simulate`. Numbers are read as text, so that all of them are checked in one place.
#[derive(Args)]
pub struct Simulate {
    /// Name of the scene; `mbs list` shows them.
    pub scene: String,
    /// Simulated time, s [default: the scene's].
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub time: Option<String>,
    /// Step, s, of constant length; with --tolerance or --accuracy the first one [default: the scene's].
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub step: Option<String>,
    /// Chooses the steps, and the order too, by their errors relative to the size of the mechanism, for example 1e-6.
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    pub tolerance: Option<String>,
    /// Chooses method, order and steps: the largest error of a position over the run, relative to the size of the mechanism,
    /// for example 1e-9 [default: 1e-6, if there is no --step, --tolerance, --method and --order].
    #[arg(long, value_name = "X", allow_hyphen_values = true, conflicts_with_all = ["tolerance", "method", "order"])]
    pub accuracy: Option<String>,
    /// Integrator: two-level, alf3f-paper, m-alf, index3-projections, generalized-alpha, bdf, radau, rattle, baumgarte,
    /// projected or penalty [default: two-level with --step, --order or --tolerance, otherwise the one chosen for the accuracy].
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Order of the method: 2, 4, 6 or 8 [default: 2 with --step, otherwise the one that fits --tolerance or --accuracy].
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub order: Option<String>,
    /// Value of a parameter or an input; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Directory for the files [default: out/SCENE; none with --json].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print one JSON object instead of a summary.
    #[arg(long)]
    pub json: bool,
}

/// The results of a run, complete or not.
pub struct Run {
    /// The scene.
    pub scene: &'static Scene,
    /// The simulation at its last instant.
    pub simulation: Box<dyn AnySimulation>,
    /// The accuracy from which the method was chosen.
    pub accuracy: Option<f64>,
    /// The recorded instants.
    pub frames: Vec<Frame>,
    /// Processor time of the integration alone, s: no sampling, no files.
    pub cpu: f64,
    /// Stages of samples between steps.
    pub sampling: u64,
    /// Why it ended before its end.
    pub stopped: Option<SimulationError>,
    /// The deviation from the reference of the scene; `Err` is the reason if it was not compared.
    pub reference: Result<Vec<Deviation>, String>,
    /// Where the files are, if all could be written.
    pub files: Option<PathBuf>,
}

impl Simulate {
    /// Runs, writes and prints.
    pub fn run(&self) -> Result<(), Failure> {
        let scene = find::scene(&self.scene)?;
        let request = Request::new(self, scene)?;
        let simulation = request.build(scene)?;
        let files = match (&self.out, self.json) {
            (Some(directory), _) => Some(directory.clone()),
            (None, true) => None,
            (None, false) => Some(PathBuf::from("out").join(scene.name)),
        };
        // The trajectory is written during the run: an interrupted run leaves its part.
        let mut results = files
            .as_deref()
            .map(|d| Results::create(d, scene))
            .transpose()?;

        let table = reference(scene, &request);
        let interval = sample_interval(&request, scene.duration, table.as_ref().ok());
        let mut run = Run {
            scene,
            simulation,
            accuracy: request.settings.accuracy,
            frames: Vec::new(),
            cpu: 0.0,
            sampling: 0,
            stopped: None,
            reference: Ok(Vec::new()),
            files,
        };
        integrate(&mut run, request.duration, interval, results.as_mut())?;
        run.reference = table.map(|table| table.compare(&run.frames));
        // The summary is printed even where the files cannot be written.
        let saved = results.map_or(Ok(()), |results| results.finish(&run));
        if saved.is_err() {
            run.files = None;
        }
        let text = if self.json {
            summary::json(&run)
        } else {
            summary::text(&run)
        };
        print(&text)?;
        saved?;
        match &run.stopped {
            None => Ok(()),
            Some(error) => Err(Failure(format!("{error}"))),
        }
    }
}

/// Advances to `end`, recording every `interval`.
fn integrate(
    run: &mut Run,
    end: f64,
    interval: f64,
    mut results: Option<&mut Results>,
) -> Result<(), Failure> {
    let progress = Progress::new(run.scene.name, end);
    let mut record = |frames: &mut Vec<Frame>, simulation: &dyn AnySimulation| {
        let frame = Frame::record(simulation);
        if let Some(results) = results.as_deref_mut() {
            results.record(&frame)?;
        }
        frames.push(frame);
        Ok::<(), Failure>(())
    };
    record(&mut run.frames, run.simulation.as_ref())?;
    // With a tolerance steps go beyond a sample, whose state is computed afterwards.
    let between = run.simulation.settings().tolerance.is_some();
    let samples = (end / interval - 1e-6).ceil().max(1.0) as u64;
    for sample in 1..=samples {
        let until = if sample == samples {
            end
        } else {
            sample as f64 * interval
        };
        let started = ProcessTime::now();
        let advanced = match between && sample < samples {
            true => run.simulation.run_past(until, end),
            false => run.simulation.run_until(until),
        };
        run.cpu += started.elapsed().as_secs_f64();
        if let Err(error) = advanced {
            run.stopped = Some(error);
            // The state after the last successful step shows the reason.
            if run
                .frames
                .last()
                .is_some_and(|frame| frame.time < run.simulation.time())
            {
                record(&mut run.frames, run.simulation.as_ref())?;
            }
            break;
        }
        let mut recorded = Ok(());
        let frames = &mut run.frames;
        let before = run.simulation.report().stages;
        let looked = run.simulation.look_at(until, &mut |simulation| {
            recorded = record(frames, simulation);
        });
        recorded?;
        run.sampling += run.simulation.report().stages - before;
        if let Err(error) = looked {
            run.stopped = Some(error);
            break;
        }
        progress.at(until);
    }
    progress.finish();
    Ok(())
}

/// The interval of the samples of a scene with this usual duration. With a tolerance it is a fraction of the interval of the reference,
/// or in a long run a multiple of it. Otherwise it is a
/// whole number of steps, so that samples shorten no step, and if possible one whose samples include the instants of
/// the reference.
fn sample_interval(request: &Request, usual: f64, reference: Option<&ReferenceTable>) -> f64 {
    let wanted = reference.and_then(ReferenceTable::interval);
    if request.settings.tolerance.is_some() || request.settings.accuracy.is_some() {
        let interval = wanted.unwrap_or(request.duration).min(request.duration);
        let parts = (interval / request.duration * LOOKS).ceil();
        let interval = interval / parts.max(1.0);
        // A run that is longer than the reference does not have more of them than fit into a diagram.
        let most = MOST_SAMPLES.max((usual / interval).ceil());
        return interval * (request.duration / interval / most).ceil().max(1.0);
    }
    let step = request.settings.step;
    let fewest = (request.duration / step / MOST_SAMPLES).ceil().max(1.0);
    let whole = |ratio: f64| ratio > 0.5 && (ratio - ratio.round()).abs() < 1e-6 * ratio;
    let meets = |steps: &f64| {
        wanted.is_some_and(|wanted| whole(wanted / (steps * step)) || whole(steps * step / wanted))
    };
    let mut candidates = (0..=fewest as u64).map(|more| fewest + more as f64);
    let steps = candidates.find(meets).unwrap_or(fewest);
    steps * step
}

/// The reference of the scene, or the reason why there is no comparison.
fn reference(scene: &Scene, request: &Request) -> Result<ReferenceTable, String> {
    let Some(reference) = &scene.reference else {
        return Err("the scene has none".to_owned());
    };
    if !request.is_unchanged() {
        return Err(format!(
            "not compared with {}: values were changed with --set",
            reference.file
        ));
    }
    ReferenceTable::find(reference, scene.model)?
        .ok_or_else(|| format!("{} was not found", reference.file))
}
