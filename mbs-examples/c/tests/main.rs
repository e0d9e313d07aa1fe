//! The exported functions called as C does, with wrong pointers and sizes, and the header that is checked in.

use mbs_c::SliderCrank;
use mbs_runtime::c_interface::{Status, header};
use mbs_runtime::{Mechanism, mechanism};
use std::fs;
use std::path::Path;
use std::ptr::{null, null_mut};

/// What a program in C sees of a simulation.
type Plant = std::ffi::c_void;

unsafe extern "C" {
    fn slider_crank_default_parameters(parameters: *mut f64, size: usize) -> i32;
    fn slider_crank_new(
        parameters: *const f64,
        size: usize,
        step: f64,
        plant: *mut *mut Plant,
    ) -> i32;
    fn slider_crank_free(plant: *mut Plant);
    fn slider_crank_step(plant: *mut Plant) -> i32;
    fn slider_crank_run_until(plant: *mut Plant, time: f64) -> i32;
    fn slider_crank_time(plant: *const Plant, time: *mut f64) -> i32;
    fn slider_crank_set_inputs(plant: *mut Plant, inputs: *const f64, size: usize) -> i32;
    fn slider_crank_output(plant: *const Plant, outputs: *mut f64, size: usize) -> i32;
    fn slider_crank_state(
        plant: *const Plant,
        positions: *mut f64,
        positions_size: usize,
        velocities: *mut f64,
        velocities_size: usize,
    ) -> i32;
    fn slider_crank_energy(plant: *const Plant, energy: *mut f64, size: usize) -> i32;
    fn slider_crank_message(buffer: *mut u8, size: usize) -> usize;
}

const NULL: i32 = Status::Null as i32;
const SIZE: i32 = Status::Size as i32;
const VALUE: i32 = Status::Value as i32;

/// A simulation with these parameters.
fn made(parameters: [f64; 2], step: f64) -> Result<*mut Plant, i32> {
    let mut plant = null_mut();
    match unsafe { slider_crank_new(parameters.as_ptr(), 16, step, &raw mut plant) } {
        0 => Ok(plant),
        status => {
            assert!(plant.is_null());
            Err(status)
        }
    }
}

/// The text of the last failure.
fn message() -> String {
    let mut text = [0; 512];
    let length = unsafe { slider_crank_message(text.as_mut_ptr(), text.len()) };
    String::from_utf8(text[..length].to_vec()).expect("UTF-8")
}

#[test]
fn the_header_is_that_of_the_declaration() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("slider_crank.h");
    let written = header("slider_crank", SliderCrank::MODEL);
    if std::env::var_os("UPDATE_HEADER").is_some() {
        fs::write(&file, &written).expect("the file can be written");
    }
    let kept = fs::read_to_string(&file).expect("the header");
    assert_eq!(
        kept, written,
        "write it with UPDATE_HEADER=1 cargo test -p mbs-c"
    );
}

mechanism!(Named {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    double: Param(1.0_m),
    rod: Bar(mass = 1.0_kg, length = double, angle = 0.0_deg),
    pivot: Revolute(ground.origin, rod.a),
    tip: Output(rod.b),
    tip_x: Output(rod.b.x + 1.0_m),
});

#[test]
fn names_of_a_header_are_names_of_c_each_once() {
    let text = header("named", Named::MODEL);
    for field in [
        "double double_;",
        "double tip_x;",
        "double tip_y;",
        "double tip_x_;",
    ] {
        assert!(text.contains(field), "{field} in\n{text}");
    }
    assert!(text.contains("double none; /* there are no inputs */"));
}

/// A law with an error in it.
fn broken([length, rate]: [f64; 2]) -> (f64, [f64; 2]) {
    assert!(length < 1.01, "a law that panics, for the test");
    (rate, [0.0, 1.0])
}

mechanism!(Broken {
    world: Planar(gravity = [0.0, -9.81_m_per_s2]),
    bob: Particle(mass = 1.0_kg, at = [0.0, -1.0]),
    strut: SpringDamper(ground.origin, bob.origin, law = broken),
});
mbs_runtime::c_library!(broken: Broken);

unsafe extern "C" {
    fn broken_new(parameters: *const f64, size: usize, step: f64, plant: *mut *mut Plant) -> i32;
    fn broken_run_until(plant: *mut Plant, time: f64) -> i32;
    fn broken_free(plant: *mut Plant);
}

#[test]
fn no_panic_leaves_the_library() {
    let mut plant = null_mut();
    unsafe {
        let none = 0.0;
        assert_eq!(broken_new(&raw const none, 8, 1e-3, &raw mut plant), 0);
        let status = broken_run_until(plant, 1.0);
        assert_eq!(status, Status::Internal as i32);
        broken_free(plant);
    }
}

#[test]
fn null_pointers_and_wrong_sizes_are_refused() {
    let mut numbers = [0.15, 0.4, 0.0, 0.0, 0.0, 0.0];
    let (to, from) = (numbers.as_mut_ptr(), numbers.as_ptr());
    let plant = made([0.15, 0.4], 1e-3).expect("it assembles");
    unsafe {
        assert_eq!(slider_crank_default_parameters(null_mut(), 16), NULL);
        assert_eq!(slider_crank_default_parameters(to, 24), SIZE);
        assert_eq!(slider_crank_new(null(), 16, 1e-3, &mut null_mut()), NULL);
        assert_eq!(slider_crank_new(from, 8, 1e-3, &mut null_mut()), SIZE);
        assert_eq!(slider_crank_new(from, 16, 1e-3, null_mut()), NULL);
        slider_crank_free(null_mut());
        assert_eq!(slider_crank_step(null_mut()), NULL);
        assert!(message().contains("the simulation is null"));
        assert_eq!(slider_crank_run_until(null_mut(), 1.0), NULL);
        assert_eq!(slider_crank_time(null(), to), NULL);
        assert_eq!(slider_crank_time(plant, null_mut()), NULL);
        assert_eq!(slider_crank_set_inputs(null_mut(), from, 8), NULL);
        assert_eq!(slider_crank_set_inputs(plant, null(), 8), NULL);
        assert_eq!(slider_crank_set_inputs(plant, from, 16), SIZE);
        assert!(message().contains("16 bytes, and 8 are needed"));
        assert_eq!(slider_crank_output(plant, to, 8), SIZE);
        assert_eq!(slider_crank_state(plant, to, 24, to, 16), SIZE);
        assert_eq!(slider_crank_energy(plant, to, 32), SIZE);
        let odd = to.cast::<u8>().wrapping_add(1).cast::<f64>();
        assert_eq!(slider_crank_output(plant, odd, 16), NULL);
        slider_crank_free(plant);
    }
}

#[test]
fn values_that_cannot_be_are_refused() {
    assert_eq!(made([f64::NAN, 0.4], 1e-3), Err(VALUE));
    assert!(message().contains("`crank_length` is NaN"), "{}", message());
    assert_eq!(made([0.15, 0.4], -1.0), Err(VALUE));
    let plant = made([0.15, 0.4], 1e-3).expect("it assembles");
    unsafe {
        let torque = f64::INFINITY;
        assert_eq!(slider_crank_set_inputs(plant, &raw const torque, 8), VALUE);
        assert_eq!(slider_crank_run_until(plant, f64::NAN), VALUE);
        let mut time = 1.0;
        assert_eq!(slider_crank_time(plant, &raw mut time), 0);
        assert_eq!(time, 0.0);
        slider_crank_free(plant);
        // Cut, with a zero at its end.
        let mut text = [1; 5];
        assert!(slider_crank_message(text.as_mut_ptr(), 5) > 5);
        assert_eq!(text[4], 0);
        assert!(slider_crank_message(null_mut(), 0) > 5);
    }
}
