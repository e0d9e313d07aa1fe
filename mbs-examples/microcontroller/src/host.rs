//! The run of the microcontroller on the host: the same digits, if the elementary functions are the same.

fn main() -> Result<(), mbs_runtime::SimulationError> {
    print!("{}", mbs_microcontroller::run(|| 0)?);
    Ok(())
}
