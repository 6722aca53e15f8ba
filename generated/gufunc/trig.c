/* Made by `coscrew generate`; changes are overwritten. */
/* Gufunc loops of the trig operations. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* ()->(2) */
INLINED void dc_double_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    double theta; double dc[2];
    load_scalar_double(&theta, data[0] + i * step[0], core + 0);
    ksl_dc(theta, dc);
    store_dc_double(dc, data[1] + i * step[1], core + 0);
  }
}

static void dc_double(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 8 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    dc_double_over(data, n[0], step, dense);
    return;
  }
  dc_double_over(data, n[0], step, step + 2);
}

/* ()->(2) */
INLINED void dc_single_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core) {
  for (npy_intp i = 0; i < n; i++) {
    float theta; float dc[2];
    load_scalar_single(&theta, data[0] + i * step[0], core + 0);
    ksl_dcf(theta, dc);
    store_dc_single(dc, data[1] + i * step[1], core + 0);
  }
}

static void dc_single(char **data, const npy_intp *n, const npy_intp *step, void *unused) {
  (void)unused;
  static const npy_intp dense[] = { 4 };
  if (memcmp(step + 2, dense, sizeof dense) == 0) {
    dc_single_over(data, n[0], step, dense);
    return;
  }
  dc_single_over(data, n[0], step, step + 2);
}

static PyUFuncGenericFunction dc_loops[] = { dc_double, dc_single };

const coscrew_gufunc coscrew_trig_gufuncs[] = {
  {"dc", "()->(2)",
    "dc = (sin θ, cos θ), θ in rad; accurate as the platform's sin and cos.\n"
    "\n"
    "()->(2).  theta: number; dc: (sin θ, cos θ).\n"
    "1 sin, 1 cos.\n",
   1, 1, dc_loops},
  {NULL, NULL, NULL, 0, 0, NULL},
};
