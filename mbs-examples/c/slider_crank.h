/* SliderCrank: written by mbs_runtime::c_interface::header. */
#ifndef SLIDER_CRANK_H
#define SLIDER_CRANK_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef MBS_STATUS
#define MBS_STATUS
/* What calls return; NAME_message has the text. */
enum {
    MBS_OK = 0, /* all is well */
    MBS_NULL = 1, /* a pointer is null or not aligned */
    MBS_SIZE = 2, /* a size is not that of the struct or array */
    MBS_VALUE = 3, /* a value that a parameter, setting or input cannot have */
    MBS_ASSEMBLY = 4, /* the mechanism cannot be assembled */
    MBS_STEP = 5, /* a step failed, and the state is that before it */
    MBS_INTERNAL = 6, /* an error in the library: free the simulation */
};

/* In J; works since the start. */
typedef struct {
    double kinetic;
    double potential;
    double nonconservative_work;
    double drive_work;
    double error; /* of the balance */
} mbs_energy;
#endif

/* A crank that a motor turns, and a rod that slides. */
typedef struct slider_crank slider_crank;

typedef struct {
    double crank_length; /* From the bearing to the pin. (in m; 0.15 by default) */
    double rod_length; /* From the pin to the slider. (in m; 0.4 by default) */
} slider_crank_parameters;

typedef struct {
    double motor_torque; /* On the crank. (in N m; 0 by default) */
} slider_crank_inputs;

typedef struct {
    double stroke; /* Of the slider. (in m) */
    double speed; /* Of the crank. (in rad/s) */
} slider_crank_outputs;

/* Numbers of coordinates and of velocities. */
enum { SLIDER_CRANK_COORDINATES = 3, SLIDER_CRANK_VELOCITIES = 3 };

/* Writes the default parameters. `size` is sizeof *parameters; so in all calls. */
int slider_crank_default_parameters(slider_crank_parameters *parameters, size_t size);

/* Makes a simulation with steps of `step` seconds, and stores it at `simulation`: NULL where it cannot be made. One thread at a time may use it. */
int slider_crank_new(const slider_crank_parameters *parameters, size_t size, double step, slider_crank **simulation);

/* Frees it; nothing for NULL. */
void slider_crank_free(slider_crank *simulation);

/* One step. */
int slider_crank_step(slider_crank *simulation);

/* Runs to a time in s, with a shorter step at the end. */
int slider_crank_run_until(slider_crank *simulation, double time);

/* The time in s. */
int slider_crank_time(const slider_crank *simulation, double *time);

/* Sets the inputs from now on: all, or none. */
int slider_crank_set_inputs(slider_crank *simulation, const slider_crank_inputs *inputs, size_t size);

/* The outputs now. */
int slider_crank_output(const slider_crank *simulation, slider_crank_outputs *outputs, size_t size);

/* Coordinates and velocities; sizes in bytes. */
int slider_crank_state(const slider_crank *simulation, double *positions, size_t positions_size, double *velocities, size_t velocities_size);

/* The energy balance. */
int slider_crank_energy(const slider_crank *simulation, mbs_energy *energy, size_t size);

/* The text of the last failure of this thread, cut where it does not fit; returns its length. */
size_t slider_crank_message(char *text, size_t size);

#ifdef __cplusplus
}
#endif

#endif
