/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Chooses the loop for arguments of types that no loop has, or refuses them; and refuses what is no
   rotation where one is required. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/ksl.h"

#include "runtime/promotion.h"


#undef SINGLE_PRECISION
#define SINGLE_PRECISION 0
#include "runtime/elements.h"

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
#include "runtime/elements.h"

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
