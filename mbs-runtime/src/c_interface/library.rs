//! The exported functions of a mechanism.

/// Exports the functions of a mechanism for programs in C: `c_library!(slider_crank: SliderCrank)` makes
/// `slider_crank_new`, `slider_crank_step` and so on, which the [header](crate::c_interface::header) declares.
#[macro_export]
macro_rules! c_library {
    ($name:ident: $mechanism:ty) => {
        const _: () = {
            use $crate::c_interface as c;

            #[unsafe(export_name = concat!(stringify!($name), "_default_parameters"))]
            unsafe extern "C" fn default_parameters(parameters: *mut f64, size: usize) -> i32 {
                unsafe { c::default_parameters::<$mechanism>(parameters, size) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_new"))]
            unsafe extern "C" fn new(
                parameters: *const f64,
                size: usize,
                step: f64,
                plant: *mut *mut c::Plant,
            ) -> i32 {
                let make: c::Make<$mechanism> = c::Plant::new;
                unsafe { c::make(make, (parameters, size), step, plant) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_free"))]
            unsafe extern "C" fn free(plant: *mut c::Plant) {
                unsafe { c::free(plant) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_step"))]
            unsafe extern "C" fn step(plant: *mut c::Plant) -> i32 {
                unsafe { c::step(plant) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_run_until"))]
            unsafe extern "C" fn run_until(plant: *mut c::Plant, time: f64) -> i32 {
                unsafe { c::run_until(plant, time) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_time"))]
            unsafe extern "C" fn time(plant: *const c::Plant, time: *mut f64) -> i32 {
                unsafe { c::time(plant, time) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_set_inputs"))]
            unsafe extern "C" fn set_inputs(
                plant: *mut c::Plant,
                inputs: *const f64,
                size: usize,
            ) -> i32 {
                unsafe { c::set_inputs(plant, inputs, size) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_output"))]
            unsafe extern "C" fn outputs(
                plant: *const c::Plant,
                outputs: *mut f64,
                size: usize,
            ) -> i32 {
                unsafe { c::outputs(plant, outputs, size) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_state"))]
            unsafe extern "C" fn state(
                plant: *const c::Plant,
                positions: *mut f64,
                positions_size: usize,
                velocities: *mut f64,
                velocities_size: usize,
            ) -> i32 {
                unsafe {
                    c::state(
                        plant,
                        (positions, positions_size),
                        (velocities, velocities_size),
                    )
                }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_energy"))]
            unsafe extern "C" fn energy(
                plant: *const c::Plant,
                energy: *mut f64,
                size: usize,
            ) -> i32 {
                unsafe { c::energy(plant, energy, size) }
            }

            #[unsafe(export_name = concat!(stringify!($name), "_message"))]
            unsafe extern "C" fn message(buffer: *mut u8, size: usize) -> usize {
                unsafe { c::message(buffer, size) }
            }
        };
    };
}
