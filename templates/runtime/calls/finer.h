/* Steps in finer parts, in one precision.

   Included once per precision, in place of function.h. */
#include "function.h"

/* Compute a function of h, p, q and v, or of h, q and v, at one state. */
static void IN(at_state)(const IN(function) *f, REAL h, const REAL *p, const REAL *q,
    const REAL *v, REAL *const *y) {
  const ptrdiff_t rows[4] = { 0 };
  const REAL *const with_p[] = { &h, p, q, v }, *const without[] = { &h, q, v };
  f->states(1, f->p < 0 ? without : with_p, rows, y, rows);
}

/* Take n steps of h from t on by `run`, each in as many parts as a step of finer*h would need:
   one if `test` says that this is not split, else the number that `parts` returns.  Without a
   test, which is NULL then, `parts` tells. */
static inline void IN(finer)(const IN(function) *test, const IN(function) *parts,
    void (*run)(ptrdiff_t n, double t, double h, const REAL *p, REAL *q, REAL *v), ptrdiff_t finer,
    ptrdiff_t n, double t, double h, const REAL *p, REAL *q, REAL *v) {
  const REAL longer = (REAL)((double)finer * h);
  for (ptrdiff_t k = 0; k < n; k++) {
    REAL closing = 1, number = 1, part;
    if (test) IN(at_state)(test, longer, p, q, v, (REAL *const[]){ &closing });
    if (closing > 0) IN(at_state)(parts, longer, p, q, v, (REAL *const[]){ &number, &part });
    run((ptrdiff_t)number, t + (double)k * h, h / (double)number, p, q, v);
  }
}
