//! Runs inputs in child processes, and makes those smaller that are not answered.

use super::mutate::{self, Random};
use super::tree::{self, Tree};
use std::fmt;
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// An answer takes milliseconds, on a busy machine seconds.
const PATIENCE: Duration = Duration::from_secs(30);
/// Trials of making an input smaller.
const TRIALS: usize = 400;
/// Memory of a child, KiB.
const MEMORY: usize = 4 << 20;

/// Set in the environment of a child.
pub const IS_CHILD: &str = "MBS_FUZZ_CHILD";

/// How a child is started.
pub struct Command {
    program: PathBuf,
    arguments: Vec<String>,
}

impl Command {
    pub fn new(program: PathBuf, arguments: Vec<String>) -> Self {
        Command { program, arguments }
    }
}

/// What is wrong with the answer to an input.
#[derive(Debug, Clone, PartialEq)]
pub enum Fault {
    /// A panic, a refusal without a reason.
    Answer(String),
    /// No answer in time.
    Hang,
    /// The process ended: its stack or memory was exhausted.
    End,
}

impl Fault {
    /// Faults of the same cause have the same signature.
    pub fn signature(&self) -> String {
        match self {
            Fault::Answer(text) if text.starts_with("panic") => {
                text.rsplit(" at ").next().unwrap_or_default().to_owned()
            }
            Fault::Answer(text) => text.chars().take(40).collect(),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Answer(text) => out.write_str(text),
            Fault::Hang => write!(out, "no answer in {PATIENCE:?}"),
            Fault::End => out.write_str("the process ended: its stack or its memory was exhausted"),
        }
    }
}

/// An answer that is of interest.
pub enum Event<'a> {
    #[allow(dead_code)] // The input is for the program.
    Accepted(&'a [Tree]),
    Found(&'a Found),
}

/// An input that was not answered.
pub struct Found {
    pub number: u64,
    pub input: Vec<Tree>,
    pub fault: Fault,
}

/// Numbers of a run.
#[derive(Debug, Default)]
pub struct Report {
    pub accepted: usize,
    pub refused: usize,
    pub faults: usize,
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Report {
            accepted,
            refused,
            faults,
        } = self;
        write!(
            out,
            "{accepted} accepted, {refused} refused, {faults} not answered"
        )
    }
}

/// Runs inputs 0 to `count` of a seed, and no longer than `limit`.
pub fn run(
    command: &Command,
    seeds: &[Vec<Tree>],
    seed: u64,
    count: u64,
    limit: Duration,
    mut each: impl FnMut(Event<'_>),
) -> Report {
    let start = Instant::now();
    let mut report = Report::default();
    let mut process = Process::default();
    for number in 0..count {
        if start.elapsed() > limit {
            break;
        }
        let input = mutate::mutant(seeds, &mut Random::new(seed, number));
        match process.answer(command, &tree::text(&input)) {
            Ok(true) => {
                report.accepted += 1;
                each(Event::Accepted(&input));
            }
            Ok(false) => report.refused += 1,
            Err(fault) => {
                report.faults += 1;
                each(Event::Found(&Found {
                    number,
                    input,
                    fault,
                }));
            }
        }
        if number % 10_000 == 9_999 {
            println!("{} inputs: {report}", number + 1);
        }
    }
    report
}

/// The declarations, with those that are accepted more often: a change of a wrong one is seldom more than wrong.
pub fn weighted(command: &Command, seeds: Vec<Vec<Tree>>) -> Vec<Vec<Tree>> {
    let mut process = Process::default();
    let mut weighted = Vec::new();
    for seed in seeds {
        let accepted = process.answer(command, &tree::text(&seed)) == Ok(true);
        let copies = if accepted { 12 } else { 1 };
        weighted.extend(std::iter::repeat_n(seed, copies));
    }
    weighted
}

/// The answer to one text.
#[allow(dead_code)] // For the test of the corpus.
pub fn check(command: &Command, text: &str) -> Result<bool, Fault> {
    Process::default().answer(command, text)
}

/// The text of an input without the tokens that its fault does not need.
#[allow(dead_code)] // For the program.
pub fn smaller(command: &Command, found: &Found) -> String {
    let mut process = Process::default();
    let mut best = found.input.clone();
    let signature = found.fault.signature();
    let mut number = tree::count(&best);
    // A hang takes too long to be tried often.
    let trials = if found.fault == Fault::Hang {
        10
    } else {
        TRIALS
    };
    for _ in 0..trials {
        let Some(next) = number.checked_sub(1) else {
            break;
        };
        number = next;
        let mut fewer = best.clone();
        tree::at(&mut fewer, &mut { number }, &mut |list, place| {
            list.remove(place);
        });
        let answer = process.answer(command, &tree::text(&fewer));
        if matches!(answer, Err(fault) if fault.signature() == signature) {
            best = fewer;
            number = number.min(tree::count(&best));
        }
    }
    tree::text(&best)
}

/// A child that is started when it is needed.
#[derive(Default)]
struct Process {
    running: Option<(Child, ChildStdin, Receiver<String>)>,
}

impl Process {
    fn answer(&mut self, command: &Command, text: &str) -> Result<bool, Fault> {
        let (_, input, answers) = self.running.get_or_insert_with(|| start(command));
        let sent = write!(input, "{}\n{text}", text.len()).and_then(|()| input.flush());
        let answer = match sent {
            Ok(()) => answers.recv_timeout(PATIENCE),
            Err(_) => Err(RecvTimeoutError::Disconnected),
        };
        match answer.as_deref() {
            Ok("accepted") => return Ok(true),
            Ok("refused") => return Ok(false),
            Ok(other) => return Err(Fault::Answer(other.to_owned())),
            Err(_) => {}
        }
        self.stop();
        Err(match answer {
            Err(RecvTimeoutError::Timeout) => Fault::Hang,
            _ => Fault::End,
        })
    }

    fn stop(&mut self) {
        if let Some((mut child, ..)) = self.running.take() {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.stop();
    }
}

fn start(command: &Command) -> (Child, ChildStdin, Receiver<String>) {
    let mut limited = match cfg!(target_os = "linux") {
        true => {
            let mut shell = std::process::Command::new("sh");
            let script = format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"");
            shell.arg("-c").arg(script).arg(&command.program);
            shell
        }
        false => std::process::Command::new(&command.program),
    };
    limited.args(&command.arguments).env(IS_CHILD, "1");
    limited.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = limited
        .stderr(Stdio::null())
        .spawn()
        .expect("the child starts");
    let input = child.stdin.take().expect("piped");
    let output = BufReader::new(child.stdout.take().expect("piped"));
    let (sender, answers) = channel();
    std::thread::spawn(move || {
        let lines = output.lines().map_while(Result::ok);
        // A test's own output stands between the answers.
        let answers = lines.filter(|line| {
            let first = line.split(':').next().unwrap_or_default();
            ["accepted", "refused", "panic", "silent", "odd", "unwritten"].contains(&first)
        });
        for answer in answers {
            if sender.send(answer).is_err() {
                break;
            }
        }
    });
    (child, input, answers)
}
