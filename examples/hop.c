/* A controller that makes a leg with a spring hop to a height, by the force under its foot.

   `hopper_contacts` gives that force.  While it is zero the leg flies, and its motor rests.  At each
   top of the flight the thrust is corrected by what the height lacks; it acts while the foot presses
   and the leg grows longer.  hop.py compiles this with the C that is generated for the hopper. */
#include "hopper.h"
#include <stdio.h>

static const double TICK = 5e-4, HEIGHT = 0.55, GAIN = 150, LIMIT = 200; /* s, m, N/m, N */

typedef struct {
  double thrust; /* N */
  double rate;   /* the torso's before, m/s */
} controller;

/* The force of the leg's motor, that shortens it, at the measured state. */
static double force(controller *its, const double q[HOPPER_NQ], const double v[HOPPER_NV]) {
  double point[3], press[3], depth, share, normal[3];
  hopper_contacts(q, v, point, press, &depth, &share, normal);
  const int flies = press[2] <= 0, top = flies && its->rate > 0 && v[0] <= 0;
  if (top) its->thrust += GAIN * (HEIGHT - q[0]);
  if (its->thrust > LIMIT) its->thrust = LIMIT;
  if (its->thrust < -LIMIT) its->thrust = -LIMIT;
  its->rate = v[0];
  return flies || v[1] > 0 ? 0 : -its->thrust;
}

/* Prints t, the torso's height, the force under the foot, and that of the motor, tick by tick. */
int main(void) {
  double q[HOPPER_NQ] = HOPPER_NEUTRAL_Q, v[HOPPER_NV] = { 0 };
  controller its = { 40, 0 };
  q[0] = 0.45;
  for (int tick = 0; tick < 40000; tick++) {
    double point[3], press[3], depth, share, normal[3];
    const double tau[HOPPER_NV] = { 0, force(&its, q, v) };
    hopper_contacts(q, v, point, press, &depth, &share, normal);
    printf("%g %.9g %.9g %.9g\n", tick * TICK, q[0], press[2], tau[1]);
    hopper_step_leapfrog_tau(TICK, q, v, tau);
  }
  return 0;
}
