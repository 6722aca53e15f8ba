/* KSL's functions of arrays and of angles that go on, for tests/peers/test_ksl_arrays.py: in each
   precision, behind names that a library exports. */
#include "ksl/SE3.h"
#include "ksl/array.h"
#include "ksl/trig.h"

#define EXPORTED(real, f)                                                                          \
  int close_##real(int n, const real *a, const real *b);                                           \
  int close_##real(int n, const real *a, const real *b) { return ksl_allclose##f(n, a, b); }       \
  void lerp_##real(int n, real p, const real *a, const real *b, real *o);                          \
  void lerp_##real(int n, real p, const real *a, const real *b, real *o) {                         \
    ksl_arraylerp##f(n, p, a, b, o);                                                               \
  }                                                                                                \
  int largest_##real(int n, const real *a);                                                        \
  int largest_##real(int n, const real *a) { return ksl_maxIndex##f(n, a); }                       \
  real whole_##real(real y, real x, real theta);                                                   \
  real whole_##real(real y, real x, real theta) { return catan2pi##f(y, x, theta); }               \
  real half_##real(real y, real x, real theta);                                                    \
  real half_##real(real y, real x, real theta) { return catan1pi##f(y, x, theta); }

EXPORTED(double, )
EXPORTED(float, f)

int equal_int(int n, const int *a, const int *b);
int equal_int(int n, const int *a, const int *b) { return ksl_allclosei(n, a, b); }

void to_single(const double *d, float *m);
void to_single(const double *d, float *m) {
  ksl_SE3_t from;
  ksl_mat4x4f_t to;
  memcpy(&from, d, sizeof from);
  ksl_SE3_toMat4x4f(&from, &to);
  memcpy(m, &to, sizeof to);
}
