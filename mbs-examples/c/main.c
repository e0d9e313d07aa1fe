/* Steps the slider-crank with a speed controller and prints the bits of all numbers. */

#include "slider_crank.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void require(int status) {
    if (status != MBS_OK) {
        char text[256];
        slider_crank_message(text, sizeof text);
        fprintf(stderr, "status %d: %s\n", status, text);
        exit(1);
    }
}

static void show(const char *name, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%s %016" PRIx64 " %.6f\n", name, bits, value);
}

/* ANCHOR: main */
int main(void) {
    slider_crank_parameters parameters;
    require(slider_crank_default_parameters(&parameters, sizeof parameters));
    parameters.rod_length = 0.45;

    slider_crank *plant = NULL;
    require(slider_crank_new(&parameters, sizeof parameters, 1e-3, &plant));

    slider_crank_outputs outputs;
    for (int step = 0; step < 1000; step++) {
        require(slider_crank_output(plant, &outputs, sizeof outputs));
        slider_crank_inputs inputs = {.motor_torque = 0.8 * (12.0 - outputs.speed)};
        require(slider_crank_set_inputs(plant, &inputs, sizeof inputs));
        require(slider_crank_step(plant));
    }

    double time, positions[SLIDER_CRANK_COORDINATES], velocities[SLIDER_CRANK_VELOCITIES];
    mbs_energy energy;
    require(slider_crank_time(plant, &time));
    require(slider_crank_output(plant, &outputs, sizeof outputs));
    require(slider_crank_energy(plant, &energy, sizeof energy));
    require(slider_crank_state(plant, positions, sizeof positions, velocities, sizeof velocities));
    show("time", time);
    show("stroke", outputs.stroke);
    show("speed", outputs.speed);
    show("work", energy.nonconservative_work);
    show("error", energy.error);
    for (int i = 0; i < SLIDER_CRANK_COORDINATES; i++) {
        char name[16];
        snprintf(name, sizeof name, "q%d", i);
        show(name, positions[i]);
    }
    slider_crank_free(plant);
    return 0;
}
/* ANCHOR_END: main */
