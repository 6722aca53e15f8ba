/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Chooses the loop for arguments of types that no loop has, or refuses them; and refuses what is no
   rotation where one is required. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/ksl_accurate.h"

#include "../runtime/promotion.h"


/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline double ksl_mat3x3_rotation_defect(const ksl_mat3x3_t *R) {
  const double n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double det = KSL_MUL(R->m00, n_0) + KSL_MUL(R->m10, n_1) + KSL_MUL(R->m20, n_2);
  const double g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double off_0 = det - 1.0, off_1 = g_0 - 1.0, off_4 = g_3 - 1.0, off_6 = g_5 - 1.0;
  const double defect_size_0 = fabs(off_0), defect_size_1 = fabs(off_1), defect_size_2 = fabs(g_1),
      defect_size_3 = fabs(g_2), defect_size_4 = fabs(off_4), defect_size_5 = fabs(g_4),
      defect_size_6 = fabs(off_6);
  const double defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const double defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const double defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const double defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const double defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const double defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline float ksl_mat3x3f_rotation_defect(const ksl_mat3x3f_t *R) {
  const float n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float det = KSL_MULF(R->m00, n_0) + KSL_MULF(R->m10, n_1) + KSL_MULF(R->m20, n_2);
  const float g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10) + KSL_MULF(R->m20, R->m20),
      g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float off_0 = det - 1.0f, off_1 = g_0 - 1.0f, off_4 = g_3 - 1.0f, off_6 = g_5 - 1.0f;
  const float defect_size_0 = fabsf(off_0), defect_size_1 = fabsf(off_1),
      defect_size_2 = fabsf(g_1), defect_size_3 = fabsf(g_2), defect_size_4 = fabsf(off_4),
      defect_size_5 = fabsf(g_4), defect_size_6 = fabsf(off_6);
  const float defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const float defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const float defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const float defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const float defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const float defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_quaternion_unit_defect(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double length = KSL_MUL(n, r);
  const double defect = length - 1.0;
  return defect;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_quaternionf_unit_defect(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(q->x, s), y_1 = KSL_MULF(q->y, s), y_2 = KSL_MULF(q->z, s),
      y_3 = KSL_MULF(q->w, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float length = KSL_MULF(n, r);
  const float defect = length - 1.0f;
  return defect;
}

#undef SINGLE_PRECISION
#define SINGLE_PRECISION 0
#include "../runtime/elements.h"

/* Whether the size of ksl_mat3x3_rotation_defect is above 0.001. */
INLINED int is_off_R_double(const char *p, const npy_intp *core) {
  ksl_mat3x3_t x;
  load_mat3x3_double(&x, p, core);
  const double defect = ksl_mat3x3_rotation_defect(&x);
  const size_t size = sizeof x / sizeof defect;
  return is_off_double(defect, 0.001, (const double *)&x, size);
}

/* Whether the size of ksl_quaternion_unit_defect is above 0.001. */
INLINED int is_off_U_double(const char *p, const npy_intp *core) {
  ksl_quaternion_t x;
  load_quaternion_double(&x, p, core);
  const double defect = ksl_quaternion_unit_defect(&x);
  const size_t size = sizeof x / sizeof defect;
  return is_off_double(defect, 0.001, (const double *)&x, size);
}

/* Of a matrix the first three columns are read. */
INLINED int is_zero_matrix_double(const char *p, const npy_intp *core) {
  ksl_mat3x3_t x;
  load_mat3x3_double(&x, p, core);
  return is_zero_double((const double *)&x, 9);
}

INLINED int is_zero_quaternion_double(const char *p, const npy_intp *core) {
  ksl_quaternion_t x;
  load_quaternion_double(&x, p, core);
  return is_zero_double((const double *)&x, 4);
}

int coscrew_refuses_double(
    char letter, const char *p, npy_intp n, npy_intp step, const npy_intp *core) {
  switch (letter) {
  case 'R':
    return any_of_double(is_off_R_double, p, n, step, core);
  case 'U':
    return any_of_double(is_off_U_double, p, n, step, core);
  case 'M':
    return any_of_double(is_zero_matrix_double, p, n, step, core);
  default:
    return any_of_double(is_zero_quaternion_double, p, n, step, core);
  }
}

#undef SINGLE_PRECISION
#define SINGLE_PRECISION 1
#include "../runtime/elements.h"

/* Whether the size of ksl_mat3x3f_rotation_defect is above 0.001f. */
INLINED int is_off_R_single(const char *p, const npy_intp *core) {
  ksl_mat3x3f_t x;
  load_mat3x3_single(&x, p, core);
  const float defect = ksl_mat3x3f_rotation_defect(&x);
  const size_t size = sizeof x / sizeof defect;
  return is_off_single(defect, 0.001f, (const float *)&x, size);
}

/* Whether the size of ksl_quaternionf_unit_defect is above 0.001f. */
INLINED int is_off_U_single(const char *p, const npy_intp *core) {
  ksl_quaternionf_t x;
  load_quaternion_single(&x, p, core);
  const float defect = ksl_quaternionf_unit_defect(&x);
  const size_t size = sizeof x / sizeof defect;
  return is_off_single(defect, 0.001f, (const float *)&x, size);
}

/* Of a matrix the first three columns are read. */
INLINED int is_zero_matrix_single(const char *p, const npy_intp *core) {
  ksl_mat3x3f_t x;
  load_mat3x3_single(&x, p, core);
  return is_zero_single((const float *)&x, 9);
}

INLINED int is_zero_quaternion_single(const char *p, const npy_intp *core) {
  ksl_quaternionf_t x;
  load_quaternion_single(&x, p, core);
  return is_zero_single((const float *)&x, 4);
}

int coscrew_refuses_single(
    char letter, const char *p, npy_intp n, npy_intp step, const npy_intp *core) {
  switch (letter) {
  case 'R':
    return any_of_single(is_off_R_single, p, n, step, core);
  case 'U':
    return any_of_single(is_off_U_single, p, n, step, core);
  case 'M':
    return any_of_single(is_zero_matrix_single, p, n, step, core);
  default:
    return any_of_single(is_zero_quaternion_single, p, n, step, core);
  }
}
