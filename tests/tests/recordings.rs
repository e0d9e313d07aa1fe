//! Recorded runs of a mechanism that is no scene: instants, files, and the model in words.

use crate::data::Pendulum;
use mbs_runtime::output::{Frame, SaveError, plot};
use mbs_runtime::{Mechanism, Settings, Simulation, SimulationError, mechanism};
use std::path::Path;
use std::process::Command;
use std::{env, fs, io};

#[test]
fn instants_are_multiples_of_the_interval() {
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let mut seen = Vec::new();
    let run = simulation.record(0.25).every(0.1);
    let run = run.progress(|progress| seen.push(progress.fraction()));
    let recording = run.run().unwrap();
    let times: Vec<f64> = recording.frames.iter().map(|frame| frame.time).collect();
    assert_eq!(times, [0.0, 0.1, 0.2, 0.25]);
    assert_eq!(seen, [0.4, 0.8, 1.0]);
    let last = &recording.frames[3];
    assert_eq!(last.outputs, simulation.output_values());
    assert!(last.reactions.iter().all(|value| value.is_finite()));
    // The next part begins where this one has ended.
    let next = simulation.record(0.3).run().unwrap();
    assert_eq!(next.frames[0].time, 0.25);
}

/// Without an interval; with a tolerance a step goes beyond an instant, and the run is the same as without instants.
#[test]
fn instants_of_a_tolerance_shorten_no_step() {
    let settings = Settings::for_tolerance(1e-4);
    let new = || Simulation::with_settings(Pendulum {}, settings).unwrap();
    let (mut recorded, mut plain) = (new(), new());
    let recording = recorded.record(2.0).run().unwrap();
    plain.run_until(2.0).unwrap();
    assert_eq!(recording.frames.len(), 501);
    assert_eq!(recorded.state(), plain.state());
}

#[test]
fn what_cannot_be_recorded_is_an_error() {
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let wrong = simulation.record(1.0).every(0.0).run().unwrap_err();
    assert!(wrong.to_string().contains("recording interval"), "{wrong}");
    simulation.run_until(0.5).unwrap();
    let late = simulation.record(0.1).run().unwrap_err();
    assert_eq!(late.recording.stopped, Some(late.error.clone()));
    assert_eq!(late.recording.frames.len(), 1);
}

#[test]
fn files_of_a_run() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("recording");
    let _ = fs::remove_dir_all(&folder);
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let mut recording = simulation.record(0.5).every(0.1).run().unwrap();
    recording.title = "Swing".to_owned();
    recording.save(&folder).unwrap();
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect(name);
    let table = read("trajectory.csv");
    assert_eq!(table.lines().count(), 7);
    assert!(table.starts_with("time_s,height_m,tip.x_m,tip.y_m,rate_rad_per_s,"));
    assert!(read("motion.html").contains("\"title\":\"Swing\""));
    // Metres and radians per second are in different diagrams.
    let outputs = read("outputs.svg");
    for text in ["height", "tip.x", "rate", "rad/s", ">m<"] {
        let text = text.trim_matches(['>', '<']);
        assert!(outputs.contains(text), "no {text}");
    }
    assert_eq!(outputs.matches("time, s").count(), 2);
    for name in ["energy.svg", "constraints.svg"] {
        assert!(read(name).ends_with("</svg>\n"), "{name}");
    }
    // A folder that is a file is named in the error.
    let error = recording.save(folder.join("outputs.svg")).unwrap_err();
    assert!(error.to_string().contains("outputs.svg"), "{error}");
}

/// Frames are public: such a frame was an index out of bounds, or a panic of the drawing library after files had been replaced.
#[test]
fn frames_of_another_model_are_refused() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign");
    let _ = fs::remove_dir_all(&folder);
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let recording = simulation.record(0.5).every(0.1).run().unwrap();
    let changed = |change: fn(&mut Frame)| {
        let mut recording = recording.clone();
        change(&mut recording.frames[3]);
        recording
    };
    let texts = [
        (|frame| frame.points.clear(), "0 points; the model has 2"),
        (
            |frame| frame.coordinates.push(0.0),
            "2 coordinates; the model has 1",
        ),
        (
            |frame| frame.velocities.clear(),
            "0 velocities; the model has 1",
        ),
        (
            |frame| {
                frame.outputs.pop();
            },
            "3 outputs; the model has 4",
        ),
        (
            |frame| {
                frame.reactions.pop();
            },
            "1 reactions; the model has 2",
        ),
        (
            |frame| frame.time = f64::NAN,
            "the time NaN s, which is not finite",
        ),
    ] as [(fn(&mut Frame), &str); 6];
    for (change, text) in texts {
        let recording = changed(change);
        let errors = [
            recording.save(&folder).unwrap_err(),
            recording.write_motion(io::sink()).unwrap_err(),
        ];
        for error in errors {
            assert_eq!(error.kind(), io::ErrorKind::InvalidData);
            assert_eq!(error.to_string(), format!("frame 3 has {text}"));
        }
    }
    assert!(!folder.exists());
    // Rows of a table have a value in each column. The header and the rows before were written, and an earlier file replaced.
    let short = changed(|frame| frame.velocities.clear());
    fs::create_dir_all(&folder).unwrap();
    let mut table = Vec::new();
    for error in [
        short.write_csv(&mut table).unwrap_err(),
        short.write_npz(folder.join("short.npz")).unwrap_err(),
    ] {
        assert_eq!(error.kind(), io::ErrorKind::InvalidData);
        assert_eq!(
            error.to_string(),
            "frame 3 has 0 velocities; the model has 1"
        );
    }
    assert_eq!(table, b"");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
    let timeless = changed(|frame| frame.time = f64::INFINITY);
    for picture in [
        plot::outputs(&timeless),
        plot::energy("", &timeless.frames),
        plot::constraints("", &timeless.frames),
    ] {
        let error = picture.unwrap_err();
        assert!(error.starts_with("frame 3 has the time inf s"), "{error}");
    }
}

/// A table that cannot grow, as on a full disk, is named. (A process of its own has a limit for the length of files.)
#[cfg(unix)]
#[test]
fn a_table_that_cannot_grow_is_named() {
    const LIMITED: &str = "MBS_LIMITED_FILES";
    if env::var_os(LIMITED).is_none() {
        let limited = Command::new("sh")
            .args(["-c", r#"trap "" XFSZ; ulimit -f 64; exec "$0" "$@""#])
            .arg(env::current_exe().unwrap())
            .args(["--exact", "recordings::a_table_that_cannot_grow_is_named"])
            .env(LIMITED, "")
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&limited.stdout);
        assert!(limited.status.success(), "{text}");
        assert!(text.contains("1 passed"), "{text}");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("limited");
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let run = simulation.record(5.0).every(1e-3);
    let error = run.save(&folder).unwrap_err();
    assert!(matches!(&error, SaveError::File(_)), "{error}");
    let table = folder.join("trajectory.csv").display().to_string();
    assert!(error.to_string().starts_with(&table), "{error}");
}

#[test]
fn an_own_mechanism_explains_itself() {
    let text = Pendulum::MODEL.explain().to_string();
    for line in [
        "Coordinates considered, with the estimated operations of a step",
        "rod",
        "mass matrix  constant",
        "Reactions on the second partner",
    ] {
        assert!(text.contains(line), "no {line} in\n{text}");
    }
    let equations = Pendulum::MODEL.latex().unwrap();
    assert!(equations.contains("M_{1,1} &= "), "{equations}");
    // The text of a declaration has no assemblies.
    let refused = crate::home::Pendulum::MODEL.latex().unwrap_err();
    assert!(refused.contains("has no assemblies"), "{refused}");
}

/// The files of a run that is written while it lasts are those of a recorded run.
#[test]
fn a_run_is_written_while_it_lasts() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stream");
    let _ = fs::remove_dir_all(&folder);
    let new = || Simulation::new(Pendulum {}).unwrap();
    let (mut streamed, mut recorded) = (new(), new());
    let saved = (streamed.record(0.5).every(0.1).title("Swing").npz())
        .save(folder.join("streamed"))
        .unwrap();
    assert_eq!((saved.instants, saved.shown), (6, 6));
    let mut recording = recorded.record(0.5).every(0.1).run().unwrap();
    recording.title = "Swing".to_owned();
    recording.save(folder.join("recorded")).unwrap();
    recording
        .write_npz(folder.join("recorded/trajectory.npz"))
        .unwrap();
    let names = ["trajectory.csv", "trajectory.npz", "motion.html"];
    for name in names.into_iter().chain(["outputs.svg", "energy.svg"]) {
        let [a, b] = ["streamed", "recorded"].map(|run| fs::read(folder.join(run).join(name)));
        assert!(a.unwrap() == b.unwrap(), "{name}");
    }
    assert!(!folder.join("streamed/trajectory.npz.part").exists());
}

/// Of a long run the table has all instants, the animation as many as it can show, and says so.
#[test]
fn animations_of_long_runs_are_thinned() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("long");
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    let saved = simulation.record(6.0).every(1e-3).save(&folder).unwrap();
    assert_eq!(saved.instants, 6001);
    assert!((1000..=2001).contains(&saved.shown), "{saved}");
    let words = format!("6001 instants; motion.html shows {} of them", saved.shown);
    assert_eq!(saved.to_string(), words);
    let table = fs::read_to_string(folder.join("trajectory.csv")).unwrap();
    assert_eq!(table.lines().count(), 6002);
    let page = fs::read_to_string(folder.join("motion.html")).unwrap();
    assert!(page.contains("\"recorded\":6001,"));
}

// Its force is no number after a quarter of a second.
mechanism!(Fading {
    world: Planar(),
    bead: Particle(mass = 1.0_kg),
    track: PointOnLine(bead, ground.origin),
    push: Force(
        bead.origin,
        value = [1.0_N * sqrt(1.0 - 4.0_per_s * t), 0.0_N]
    ),
    x: Output(bead.origin.x),
});

#[test]
fn a_run_that_stops_leaves_its_files() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("stopped");
    let _ = fs::remove_dir_all(&folder);
    let mut simulation = Simulation::new(Fading {}).unwrap();
    let error = (simulation.record(0.5).every(0.1).npz())
        .save(&folder)
        .unwrap_err();
    assert!(matches!(&error, SaveError::Simulation(_)), "{error}");
    let read = || fs::read_to_string(folder.join("trajectory.csv")).unwrap();
    let table = read();
    // Its head, three instants and that of the end.
    assert_eq!(table.lines().count(), 6, "{table}");
    let last = table.lines().last().unwrap();
    assert!(last.starts_with("# stopped at t = 0.2"), "{last}");
    assert!(folder.join("motion.html").exists() && folder.join("trajectory.npz").exists());
    // What cannot be run leaves them as they are.
    let error = simulation.record(0.1).save(&folder).unwrap_err();
    assert!(
        matches!(&error, SaveError::Simulation(SimulationError::Time { .. })),
        "{error}"
    );
    assert_eq!(read(), table);
    // A folder that is a file is named in the error.
    let file = folder.join("motion.html");
    let error = simulation.record(0.6).save(&file).unwrap_err();
    assert!(error.to_string().contains("motion.html"), "{error}");
}

/// Read by the specification of ZIP and NPY, not by the writer's code.
#[test]
fn binary_columns_have_the_bits_of_the_table() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("binary");
    let mut simulation = Simulation::new(Pendulum {}).unwrap();
    simulation
        .record(0.5)
        .every(0.02)
        .npz()
        .save(&folder)
        .unwrap();
    let columns = unpack(&fs::read(folder.join("trajectory.npz")).unwrap());
    let table = fs::read_to_string(folder.join("trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|x| x.parse().unwrap()).collect())
        .collect();
    assert_eq!((columns.len(), rows.len()), (names.len(), 26));
    for (index, (name, values)) in columns.iter().enumerate() {
        assert_eq!(*name, format!("{}.npy", names[index]));
        let expected: Vec<u64> = rows.iter().map(|row| row[index].to_bits()).collect();
        let values: Vec<u64> = values.iter().map(|value| value.to_bits()).collect();
        assert_eq!(values, expected, "{name}");
    }
}

/// Names and values of the arrays of an archive, by its list of files.
fn unpack(archive: &[u8]) -> Vec<(String, Vec<f64>)> {
    let number = |at: usize, bytes: usize| {
        let bytes = archive[at..at + bytes].iter().rev();
        bytes.fold(0, |number, &byte| number << 8 | usize::from(byte))
    };
    let end = archive.len() - 22;
    assert_eq!(&archive[end..end + 4], b"PK\x05\x06");
    let (count, mut at) = (number(end + 10, 2), number(end + 16, 4));
    let arrays = (0..count).map(|_| {
        assert_eq!(&archive[at..at + 4], b"PK\x01\x02");
        let (crc, size, length) = (number(at + 16, 4), number(at + 24, 4), number(at + 28, 2));
        let name = String::from_utf8(archive[at + 46..at + 46 + length].to_vec()).unwrap();
        let start = number(at + 42, 4);
        assert_eq!(&archive[start..start + 4], b"PK\x03\x04");
        let file = start + 30 + number(start + 26, 2) + number(start + 28, 2);
        let file = &archive[file..file + size];
        assert_eq!(checksum(file), crc as u32, "{name}");
        assert_eq!(number(start + 14, 4), crc, "{name}");
        assert_eq!(&file[..8], b"\x93NUMPY\x01\x00");
        let header = 10 + usize::from(file[8]) + 256 * usize::from(file[9]);
        assert!(header.is_multiple_of(64) && file[header - 1] == b'\n');
        let values: Vec<f64> = file[header..]
            .chunks_exact(8)
            .map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()))
            .collect();
        let text = String::from_utf8(file[10..header].to_vec()).unwrap();
        let shape = format!(
            "{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}",
            values.len()
        );
        assert_eq!(text.trim_end(), shape);
        at += 46 + length;
        (name, values)
    });
    arrays.collect()
}

/// CRC-32, bit by bit.
fn checksum(bytes: &[u8]) -> u32 {
    let bits = bytes
        .iter()
        .flat_map(|&byte| (0..8).map(move |bit| u32::from(byte >> bit & 1)));
    !bits.fold(u32::MAX, |crc, bit| match (crc ^ bit) & 1 {
        1 => crc >> 1 ^ 0xedb8_8320,
        _ => crc >> 1,
    })
}
