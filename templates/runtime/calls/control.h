/* Steps of many states in one precision, with calls of a controller in between.

   Included once per precision.  A file that includes it says how many numbers a state has; the
   sizes below are for editors and checkers, which read it alone. */
#include "objects.h"

#include <math.h>
#include <string.h>

#ifndef STATE_Q
#define STATE_Q 1 /* coordinates q */
#define STATE_V 1 /* velocities v */
#define STATE_P 1 /* parameters p */
#endif

#include "real.h"

/* A controller: the values u that it overwrites are the numbers of p at `places`.  It is called
   before a step and holds for `every` steps. */
typedef struct {
  void (*law)(double t, const REAL *q, const REAL *v, REAL *u, void *context);
  void *context;
  ptrdiff_t every, count;
  const ptrdiff_t *places;
} IN(controller);

/* The first value of a state that is not finite: its number among u, or -1; the time. */
typedef struct {
  ptrdiff_t number;
  double t, value;
} IN(refused);

/* n steps of h from t on, of one state. */
typedef void IN(steps)(ptrdiff_t n, double t, double h, const REAL *p, REAL *q, REAL *v);

/* The same of many states, by a function in lanes, whose type depends on the scene. */
typedef void IN(steps_in_lanes)(anything lanes, ptrdiff_t states, ptrdiff_t n, double t, double h,
    const REAL *p, REAL *q, REAL *v);

/* The ways to take steps of h: one state after the other, or in lanes unless `lanes` is NULL; and
   the time of step k of a run that begins at t. */
typedef struct {
  IN(steps) *steps;
  anything lanes;
  IN(steps_in_lanes) *in_lanes;
  double (*begun)(double t, double h, double k);
  double h;
} IN(stepper);

/* Call it for one state after the other; it gets copies. */
static void IN(control)(const IN(controller) *c, ptrdiff_t states, double t, REAL *p,
    const REAL *q, const REAL *v, IN(refused) *refused) {
  REAL u[STATE_P], its_q[STATE_Q], its_v[STATE_V];
  for (ptrdiff_t k = 0; k < states; k++, p += STATE_P) {
    memcpy(its_q, q + k * STATE_Q, sizeof its_q);
    memcpy(its_v, v + k * STATE_V, sizeof its_v);
    for (ptrdiff_t n = 0; n < c->count; n++) u[n] = p[c->places[n]];
    c->law(t, its_q, its_v, u, c->context);
    for (ptrdiff_t n = 0; n < c->count; n++) {
      p[c->places[n]] = u[n];
      if (!isfinite(u[n]) && refused[k].number < 0)
        refused[k] = (IN(refused)){ n, t, (double)u[n] };
    }
  }
}

/* n steps of all states from t on. */
static void IN(advance)(const IN(stepper) *s, ptrdiff_t states, ptrdiff_t n, double t,
    const REAL *p, REAL *q, REAL *v) {
  if (s->lanes)
    s->in_lanes(s->lanes, states, n, t, s->h, p, q, v);
  else
    for (ptrdiff_t k = 0; k < states; k++)
      s->steps(n, t, s->h, p + k * STATE_P, q + k * STATE_Q, v + k * STATE_V);
}

/* n steps from t on, the first call of the controller after `wait` of them. */
static inline void IN(controlled)(const IN(controller) *c, const IN(stepper) *s, ptrdiff_t states,
    ptrdiff_t n, ptrdiff_t wait, double t, REAL *p, REAL *q, REAL *v, IN(refused) *refused) {
  for (ptrdiff_t k = 0; k < n;) {
    const ptrdiff_t held = k < wait ? wait : c->every, more = held < n - k ? held : n - k;
    const double now = s->begun(t, s->h, (double)k);
    if (k >= wait) IN(control)(c, states, now, p, q, v, refused);
    IN(advance)(s, states, more, now, p, q, v);
    k += more;
  }
}
