//! The calls, for any mechanism. Structs of `double`s come as a pointer to the first and a size in bytes.

use super::status::{Failure, Status, status_of};
use crate::{AnySimulation, Mechanism, Quantity, Settings, Simulation, SimulationError, System};

/// What a program in C holds by a pointer.
pub struct Plant(Box<dyn AnySimulation>);

impl Plant {
    /// A simulation with steps of `step` seconds.
    ///
    /// # Errors
    /// As [`Simulation::with_settings`].
    pub fn new<M, S, const Q: usize, const N: usize, const R: usize>(
        mechanism: M,
        step: f64,
    ) -> Result<Self, SimulationError>
    where
        M: Mechanism<System = S>,
        S: System<Q, N, R>,
    {
        let settings = Settings {
            step,
            placement: false,
            ..Settings::default()
        };
        let simulation = Simulation::with_settings(mechanism, settings)?;
        Ok(Plant(Box::new(simulation)))
    }
}

/// How a mechanism becomes a [`Plant`].
pub type Make<M> = fn(M, f64) -> Result<Plant, SimulationError>;

/// Writes the default parameters.
///
/// # Safety
/// `parameters` is null or points to `size` bytes.
pub unsafe fn default_parameters<M: Mechanism>(parameters: *mut f64, size: usize) -> i32 {
    status_of(|| {
        let values = M::MODEL.parameters.iter().map(|quantity| quantity.default);
        // SAFETY: as for this function.
        unsafe { write(values, M::MODEL.parameters.len(), parameters, size) }
    })
}

/// Makes a simulation, and stores it at `plant`: null where it cannot be made.
///
/// # Safety
/// `parameters` is null or points to `size` bytes; `plant` is null or points to a pointer.
pub unsafe fn make<M: Mechanism>(
    make: Make<M>,
    (parameters, size): (*const f64, usize),
    step: f64,
    plant: *mut *mut Plant,
) -> i32 {
    status_of(|| {
        if plant.is_null() {
            return Err(null("the place for the simulation"));
        }
        if !plant.is_aligned() {
            let text = "the place for the simulation is not aligned; pass the address of a pointer";
            return Err(Failure::new(Status::Null, text));
        }
        // SAFETY: it is not null, and aligned.
        unsafe { plant.write(std::ptr::null_mut()) };
        // SAFETY: as for this function.
        let values = unsafe { read(M::MODEL.parameters, parameters, size) }?;
        let mut mechanism = M::default();
        for (quantity, &value) in M::MODEL.parameters.iter().zip(values) {
            let set = mechanism.set_parameter(quantity.name, value);
            set.map_err(SimulationError::from)?;
        }
        let made = make(mechanism, step).map_err(Failure::at_start)?;
        let made = Box::new(made);
        // SAFETY: it is not null, and aligned.
        unsafe { plant.write(Box::into_raw(made)) };
        Ok(())
    })
}

/// Frees a simulation; nothing for a null pointer.
///
/// # Safety
/// `plant` is null, or a simulation that was made here and not freed.
pub unsafe fn free(plant: *mut Plant) {
    if !plant.is_null() {
        // SAFETY: it came from `Box::into_raw`.
        let plant = unsafe { Box::from_raw(plant) };
        status_of(|| {
            drop(plant);
            Ok(())
        });
    }
}

/// One step.
///
/// # Safety
/// `plant` is null, or a simulation.
pub unsafe fn step(plant: *mut Plant) -> i32 {
    // SAFETY: as for this function.
    status_of(|| Ok(unsafe { get(plant) }?.0.step()?))
}

/// Runs to a time, s.
///
/// # Safety
/// `plant` is null, or a simulation.
pub unsafe fn run_until(plant: *mut Plant, time: f64) -> i32 {
    // SAFETY: as for this function.
    status_of(|| Ok(unsafe { get(plant) }?.0.run_until(time)?))
}

/// Writes the time, s.
///
/// # Safety
/// `plant` is null, or a simulation; `time` is null or points to a number.
pub unsafe fn time(plant: *const Plant, time: *mut f64) -> i32 {
    // SAFETY: as for this function.
    status_of(|| unsafe { write([look(plant)?.0.time()], 1, time, size_of::<f64>()) })
}

/// Sets all inputs from now on, or none.
///
/// # Safety
/// `plant` is null, or a simulation; `inputs` is null or points to `size` bytes.
pub unsafe fn set_inputs(plant: *mut Plant, inputs: *const f64, size: usize) -> i32 {
    status_of(|| {
        // SAFETY: as for this function.
        let plant = unsafe { get(plant) }?;
        let quantities = plant.0.model().inputs;
        // SAFETY: as for this function.
        let values = unsafe { read(quantities, inputs, size) }?;
        Ok(plant.0.set_input_values(values)?)
    })
}

/// Writes the outputs.
///
/// # Safety
/// `plant` is null, or a simulation; `outputs` is null or points to `size` bytes.
pub unsafe fn outputs(plant: *const Plant, outputs: *mut f64, size: usize) -> i32 {
    status_of(|| {
        // SAFETY: as for this function.
        let values = unsafe { look(plant) }?.0.output_values();
        // SAFETY: as for this function.
        unsafe { write(values.iter().copied(), values.len(), outputs, size) }
    })
}

/// Writes q and v.
///
/// # Safety
/// `plant` is null, or a simulation; the two pointers are null or point to so many bytes.
pub unsafe fn state(
    plant: *const Plant,
    (positions, positions_size): (*mut f64, usize),
    (velocities, velocities_size): (*mut f64, usize),
) -> i32 {
    status_of(|| {
        // SAFETY: as for this function.
        let plant = unsafe { look(plant) }?;
        let (q, v) = (plant.0.coordinates(), plant.0.velocities());
        // SAFETY: as for this function.
        unsafe {
            write(q.iter().copied(), q.len(), positions, positions_size)?;
            write(v.iter().copied(), v.len(), velocities, velocities_size)
        }
    })
}

/// Writes T, V, the works of forces without potential and of rheonomic rows, and the error of the balance, J.
///
/// # Safety
/// `plant` is null, or a simulation; `energy` is null or points to `size` bytes.
pub unsafe fn energy(plant: *const Plant, energy: *mut f64, size: usize) -> i32 {
    status_of(|| {
        // SAFETY: as for this function.
        let of = unsafe { look(plant) }?.0.energy();
        let values = [
            of.kinetic,
            of.potential,
            of.nonconservative_work,
            of.drive_work,
            of.error,
        ];
        // SAFETY: as for this function.
        unsafe { write(values, values.len(), energy, size) }
    })
}

unsafe fn get<'a>(plant: *mut Plant) -> Result<&'a mut Plant, Failure> {
    // SAFETY: the caller's: null or a simulation.
    unsafe { plant.as_mut() }.ok_or_else(|| null("the simulation"))
}

unsafe fn look<'a>(plant: *const Plant) -> Result<&'a Plant, Failure> {
    // SAFETY: the caller's: null or a simulation.
    unsafe { plant.as_ref() }.ok_or_else(|| null("the simulation"))
}

/// The values of a struct; without fields a struct of C has one that nothing reads.
unsafe fn read<'a>(
    quantities: &[Quantity],
    from: *const f64,
    size: usize,
) -> Result<&'a [f64], Failure> {
    check(quantities.len(), from, size)?;
    // SAFETY: the size is that of the values; the caller's: so many bytes are there.
    Ok(unsafe { std::slice::from_raw_parts(from, quantities.len()) })
}

unsafe fn write(
    values: impl IntoIterator<Item = f64>,
    count: usize,
    to: *mut f64,
    size: usize,
) -> Result<(), Failure> {
    check(count, to, size)?;
    for (place, value) in values.into_iter().take(count).enumerate() {
        // SAFETY: the size is that of `count` values; the caller's: so many bytes are there.
        unsafe { to.add(place).write(value) };
    }
    Ok(())
}

/// The size of a struct without values is not compared: in C it has one that nothing reads.
fn check(count: usize, pointer: *const f64, size: usize) -> Result<(), Failure> {
    let needed = count * size_of::<f64>();
    if pointer.is_null() {
        return Err(null("a struct or an array"));
    }
    if !pointer.is_aligned() {
        return Err(Failure::new(
            Status::Null,
            "a pointer is not aligned to 8 bytes",
        ));
    }
    match size == needed || count == 0 {
        true => Ok(()),
        false => Err(Failure::new(
            Status::Size,
            format!(
                "a struct or an array has {size} bytes, and {needed} are needed; compile with the header of this library"
            ),
        )),
    }
}

fn null(what: &str) -> Failure {
    Failure::new(
        Status::Null,
        format!("the pointer to {what} is null; pass one that is not"),
    )
}
