/* Elements of arguments that functions refuse.  Included once per precision. */
#include "numpy.h"

#undef REAL
#undef IN
#if defined(SINGLE_PRECISION) && SINGLE_PRECISION
#define REAL float
#define IN(name) name##_single
#else
#define REAL double
#define IN(name) name##_double
#endif

/* Whether a component is NaN. */
INLINED int IN(has_nan)(const REAL *x, size_t size) {
  int found = 0;
  for (size_t k = 0; k < size; k++) {
    found |= x[k] != x[k];
  }
  return found;
}

/* Whether all components are zero. */
INLINED int IN(is_zero)(const REAL *x, size_t size) {
  int found = 1;
  for (size_t k = 0; k < size; k++) {
    found &= x[k] == 0;
  }
  return found;
}

/* Whether a defect is above its tolerance, or NaN though no component is, of which results are
   NaN. */
INLINED int IN(is_off)(REAL defect, REAL tolerance, const REAL *x, size_t size) {
  return !(-tolerance <= defect && defect <= tolerance) && !IN(has_nan)(x, size);
}

/* Whether one of n elements, `step` bytes apart, is refused. */
INLINED int IN(any_of)(int (*refused)(const char *p, const npy_intp *core), const char *p,
    npy_intp n, npy_intp step, const npy_intp *core) {
  int found = 0;
  for (npy_intp k = 0; k < n; k++, p += step) {
    found |= refused(p, core);
  }
  return found;
}
