/* What KSL declares beside formulas, for tests/peers/test_ksl_functions.py: in each precision, behind
   names that a library exports.  Matrices lie column by column. */
#include "ksl/ksl.h"

#define EXPORTED(real, f)                                                                          \
  void set_##real(int axes, const real *angles, real *R);                                          \
  void set_##real(int axes, const real *angles, real *R) {                                         \
    ksl_vec3##f##_t given;                                                                         \
    ksl_mat3x3##f##_t r;                                                                           \
    memcpy(&given, angles, sizeof given);                                                          \
    ksl_mat3x3##f##_setFromEulerAngles(&r, (ksl_axis_enum_t)axes, &given);                         \
    memcpy(R, &r, sizeof r);                                                                       \
  }                                                                                                \
  void get_##real(int axes, const real *R, const real *reference, real *angles);                   \
  void get_##real(int axes, const real *R, const real *reference, real *angles) {                  \
    ksl_vec3##f##_t found, near;                                                                   \
    ksl_mat3x3##f##_t r;                                                                           \
    memcpy(&r, R, sizeof r);                                                                       \
    if (reference != NULL) {                                                                       \
      memcpy(&near, reference, sizeof near);                                                       \
      ksl_mat3x3##f##_getEulerAngles(&r, (ksl_axis_enum_t)axes, &found, &near);                    \
    } else {                                                                                       \
      ksl_mat3x3##f##_getEulerAngles(&r, (ksl_axis_enum_t)axes, &found);                           \
    }                                                                                              \
    memcpy(angles, &found, sizeof found);                                                          \
  }                                                                                                \
  void pca_##real(real *A, real *v);                                                               \
  void pca_##real(real *A, real *v) {                                                              \
    ksl_mat3x3##f##_t a, axes;                                                                     \
    memcpy(&a, A, sizeof a);                                                                       \
    ksl_mat3x3##f##_pca(&a, &axes);                                                                \
    memcpy(A, &a, sizeof a);                                                                       \
    memcpy(v, &axes, sizeof axes);                                                                 \
  }                                                                                                \
  int invert_##real(real *R);                                                                      \
  int invert_##real(real *R) {                                                                     \
    ksl_mat3x3##f##_t in_place, other;                                                             \
    int one, two;                                                                                  \
    memcpy(&in_place, R, sizeof in_place);                                                         \
    one = ksl_mat3x3##f##_inverted(&in_place, &other);                                             \
    two = ksl_mat3x3##f##_invert(&in_place);                                                       \
    memcpy(R, &in_place, sizeof in_place);                                                         \
    return memcmp(&in_place, &other, sizeof other) == 0 && one == two ? one : 1;                   \
  }                                                                                                \
  real degrees_##real(real angle);                                                                 \
  real degrees_##real(real angle) { return ksl_normalizeDegrees##f(angle); }                       \
  real radians_##real(real angle);                                                                 \
  real radians_##real(real angle) { return ksl_normalizeRadians##f(angle); }                       \
  void axpy_##real(int n, real a, const real *x, real *y);                                         \
  void axpy_##real(int n, real a, const real *x, real *y) { ksl_axpy##f(n, a, x, y); }             \
  void axis_angle_##real(const real *axis, real angle, real *R, real *found);                      \
  void axis_angle_##real(const real *axis, real angle, real *R, real *found) {                     \
    ksl_vec3##f##_t a;                                                                             \
    ksl_mat3x3##f##_t r;                                                                           \
    memcpy(&a, axis, sizeof a);                                                                    \
    ksl_mat3x3##f##_setFromAxisAngle(&r, &a, angle);                                               \
    memcpy(R, &r, sizeof r);                                                                       \
    ksl_mat3x3##f##_getAxisAngle(&r, &a, &found[3]);                                               \
    memcpy(found, &a, sizeof a);                                                                   \
  }                                                                                                \
  int factor_##real(real *J);                                                                      \
  int factor_##real(real *J) {                                                                     \
    ksl_inertia##f##_t j;                                                                          \
    int rank;                                                                                      \
    memcpy(&j, J, sizeof j);                                                                       \
    rank = ksl_inertia##f##_factor(&j);                                                            \
    memcpy(J, &j, sizeof j);                                                                       \
    return rank;                                                                                   \
  }                                                                                                \
  int moves_##real(void);                                                                          \
  int moves_##real(void) {                                                                         \
    const ksl_screw##f##_t s = ksl_screw##f(1, 2, 3, 4, 5, 6);                                     \
    real A[8 * 7] = {0}, one = 3, two = 4, x[4] = {1, 2, 3, 4}, y[6] = {5, 6, 7, 8, 9, 10};        \
    int wrong = 0;                                                                                 \
    ksl_screw##f##_copy_rmo(&s, A, 1, 2, 7); /* 8 rows of 7 */                                     \
    for (int i = 0; i < 8 * 7; i++) {                                                              \
      const int row = i / 7, column = i % 7;                                                       \
      wrong += A[i] != (real)(column == 2 && row > 0 && row < 7 ? row : 0);                        \
    }                                                                                              \
    ksl_screw##f##_ncopy_rmo(&s, A, 1, 2, 7);                                                      \
    wrong += A[1 * 7 + 2] != -1 || A[6 * 7 + 2] != -6;                                             \
    memset(A, 0, sizeof A);                                                                        \
    ksl_screw##f##_copy_cmo(&s, A, 1, 2, 8); /* 7 columns of 8 */                                  \
    for (int i = 0; i < 8 * 7; i++) {                                                              \
      const int row = i % 8, column = i / 8;                                                       \
      wrong += A[i] != (real)(column == 2 && row > 0 && row < 7 ? row : 0);                        \
    }                                                                                              \
    ksl_screw##f##_ncopy_cmo(&s, A, 1, 2, 8);                                                      \
    wrong += A[2 * 8 + 1] != -1 || A[2 * 8 + 6] != -6;                                             \
    ksl_swap##f(&one, &two);                                                                       \
    ksl_swapArray##f(2, x, 3, y, 2);                                                               \
    wrong += one != 4 || two != 3 || x[0] != 5 || x[3] != 7 || y[0] != 1 || y[2] != 4 || x[1] != 2; \
    return wrong;                                                                                  \
  }

EXPORTED(double, )
EXPORTED(float, f)

int axes_of(int sequence, int axis);
int axes_of(int sequence, int axis) {
  return ksl_axis_getVector((ksl_axis_enum_t)sequence).at[axis];
}

int sequence_of(int i, int j, int k);
int sequence_of(int i, int j, int k) { return (int)ksl_axis_getEulerAngles(ksl_vec3i(i, j, k)); }

int integers(void);
int integers(void) {
  const ksl_vec3i_t a = ksl_vec3i(1, 2, 3), b = ksl_vec3i(1, 2, 4);
  const ksl_vec4i_t c = ksl_vec4i(5, 6, 7, 8);
  ksl_vec3i_t *zeros = ksl_vec3i_alloc(2);
  ksl_vec4i_t *more = ksl_vec4i_alloc(2);
  const ksl_SE3f_t D = ksl_SE3f(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
  ksl_screwf_t one, other;
  int wrong = zeros == NULL || more == NULL, first = 1, second = 2;
  if (!wrong) { wrong += zeros[1].z != 0 || more[1].w != 0; }
  free(zeros);
  free(more);
  ksl_swapi(&first, &second);
  ksl_hrxinvf(&D, &one);
  ksl_hsrxinvf(&D, &other);
  wrong += first != 2 || second != 1 || memcmp(&one, &other, sizeof one) != 0;
  wrong += !ksl_vec3i_isEqual(&a, &a) || ksl_vec3i_isEqual(&a, &b) || a.at[2] != 3;
  return wrong + (c.x != 5 || c.r.y != 6 || c.at[2] != 7 || c.w != 8);
}
