/* Made by `coscrew generate`; changes are overwritten. */
/* Gufunc loops of the mat6x6 operations. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* (6,6)->(6,6) */
INLINED void mat6x6_copy_double_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M; ksl_mat6x6_t Mo;
    load_mat6x6_double(&M, data[0] + i * step[0], core + 0);
    ksl_mat6x6_copy(&M, &Mo);
    store_mat6x6_double(&Mo, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_copy_double(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 48, 8, 48, 8 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_copy_double_over(data, n[0], step, dense);
    return;
  }
  mat6x6_copy_double_over(data, n[0], step, step + 2);
}

/* (6,6)->(6,6) */
INLINED void mat6x6_copy_single_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M; ksl_mat6x6f_t Mo;
    load_mat6x6_single(&M, data[0] + i * step[0], core + 0);
    ksl_mat6x6f_copy(&M, &Mo);
    store_mat6x6_single(&Mo, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_copy_single(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 24, 4, 24, 4 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_copy_single_over(data, n[0], step, dense);
    return;
  }
  mat6x6_copy_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat6x6_copy_loops[] = { mat6x6_copy_double, mat6x6_copy_single };

/* (6,6)->(6,6) */
INLINED void mat6x6_setIdentity_double_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t self;
    load_mat6x6_double(&self, data[0] + i * step[0], core + 0);
    ksl_mat6x6_setIdentity(&self);
    store_mat6x6_double(&self, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_setIdentity_double(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 48, 8, 48, 8 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_setIdentity_double_over(data, n[0], step, dense);
    return;
  }
  mat6x6_setIdentity_double_over(data, n[0], step, step + 2);
}

/* (6,6)->(6,6) */
INLINED void mat6x6_setIdentity_single_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t self;
    load_mat6x6_single(&self, data[0] + i * step[0], core + 0);
    ksl_mat6x6f_setIdentity(&self);
    store_mat6x6_single(&self, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_setIdentity_single(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 24, 4, 24, 4 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_setIdentity_single_over(data, n[0], step, dense);
    return;
  }
  mat6x6_setIdentity_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat6x6_setIdentity_loops[] = { mat6x6_setIdentity_double, mat6x6_setIdentity_single };

/* (6,6)->(6,6) */
INLINED void mat6x6_transposed_double_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6_t M; ksl_mat6x6_t Mo;
    load_mat6x6_double(&M, data[0] + i * step[0], core + 0);
    ksl_mat6x6_transposed(&M, &Mo);
    store_mat6x6_double(&Mo, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_transposed_double(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 48, 8, 48, 8 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_transposed_double_over(data, n[0], step, dense);
    return;
  }
  mat6x6_transposed_double_over(data, n[0], step, step + 2);
}

/* (6,6)->(6,6) */
INLINED void mat6x6_transposed_single_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    ksl_mat6x6f_t M; ksl_mat6x6f_t Mo;
    load_mat6x6_single(&M, data[0] + i * step[0], core + 0);
    ksl_mat6x6f_transposed(&M, &Mo);
    store_mat6x6_single(&Mo, data[1] + i * step[1], core + 2);
  }
}

static void mat6x6_transposed_single(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 24, 4, 24, 4 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    mat6x6_transposed_single_over(data, n[0], step, dense);
    return;
  }
  mat6x6_transposed_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction mat6x6_transposed_loops[] = { mat6x6_transposed_double, mat6x6_transposed_single };

const coscrew_gufunc coscrew_mat6x6_gufuncs[] = {
  {"mat6x6_copy", "(6,6)->(6,6)",
    "Mo = M.\n"
    "\n"
    "(6,6)->(6,6).  M, Mo: 6×6 operator.\n"
    "No arithmetic.\n",
   1, 1, mat6x6_copy_loops},
  {"mat6x6_setIdentity", "(6,6)->(6,6)",
    "self = I.\n"
    "\n"
    "(6,6)->(6,6).  self: 6×6 operator.\n"
    "No arithmetic.\n",
   1, 1, mat6x6_setIdentity_loops},
  {"mat6x6_transposed", "(6,6)->(6,6)",
    "Mo = M^T.\n"
    "\n"
    "(6,6)->(6,6).  M, Mo: 6×6 operator.\n"
    "No arithmetic.\n",
   1, 1, mat6x6_transposed_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};
