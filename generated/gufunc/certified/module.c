/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* The extension module coscrew.certified._gufunc: registers every gufunc. */
#include "_gufunc.h"

static const coscrew_gufunc *const baseline[] = {coscrew_elementary_gufuncs, coscrew_vec3_gufuncs,
    coscrew_vec4_gufuncs, coscrew_mat3x3_gufuncs, coscrew_SE3_gufuncs, coscrew_mat6x6_gufuncs,
    coscrew_matrix_gufuncs, coscrew_trig_gufuncs, coscrew_screw_gufuncs, coscrew_coscrew_gufuncs,
    coscrew_quaternion_gufuncs, coscrew_exponential_gufuncs, coscrew_inertia_gufuncs,
    coscrew_spatial_inertia_gufuncs};

#if COSCREW_HAS_AVX2
static const coscrew_gufunc *const avx2[] = {coscrew_elementary_gufuncs_avx2,
    coscrew_vec3_gufuncs_avx2, coscrew_vec4_gufuncs_avx2, coscrew_mat3x3_gufuncs_avx2,
    coscrew_SE3_gufuncs_avx2, coscrew_mat6x6_gufuncs_avx2, coscrew_matrix_gufuncs_avx2,
    coscrew_trig_gufuncs_avx2, coscrew_screw_gufuncs_avx2, coscrew_coscrew_gufuncs_avx2,
    coscrew_quaternion_gufuncs_avx2, coscrew_exponential_gufuncs_avx2, coscrew_inertia_gufuncs_avx2,
    coscrew_spatial_inertia_gufuncs_avx2};
#endif

/* The fastest loops for this processor, or the baseline if COSCREW_BASELINE is in the environment. */
static const coscrew_gufunc *const *best_families(void) {
#if COSCREW_HAS_AVX2
  __builtin_cpu_init();
  const int supported = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (supported && getenv("COSCREW_BASELINE") == NULL) {
    return avx2;
  }
#endif
  return baseline;
}

/* The type numbers of each loop: as many as the gufunc with the most arguments needs. */
enum { MOST_ARGUMENTS = 10, LOOPS = 2 };

/* Each ufunc's data: its entry of the table, for every loop. */
static void *data[222][LOOPS];

/* The entries of those that refuse arguments, for ufuncs that do not. */
static coscrew_gufunc taking_all[222];
static void *data_taking_all[222][LOOPS];

static char types[MOST_ARGUMENTS + 1][LOOPS * (MOST_ARGUMENTS + 1)];

static void fill_types(void) {
  static const char numbers[LOOPS] = { NPY_DOUBLE, NPY_FLOAT };
  for (int arguments = 0; arguments <= MOST_ARGUMENTS; arguments++) {
    for (int k = 0; k < LOOPS * arguments; k++) {
      types[arguments][k] = numbers[k / arguments];
    }
  }
}

static int add_gufunc(
    PyObject *module, const coscrew_gufunc *g, void **own_data, const char *prefix) {
  for (int k = 0; k < LOOPS; k++) {
    own_data[k] = (void *)g;
  }
  PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(
      g->loops, own_data, types[g->inputs + g->outputs], LOOPS, g->inputs, g->outputs,
      PyUFunc_None, g->name, g->doc, 0, g->signature);
  PyObject *name = PyUnicode_FromFormat("%s%s", prefix, g->name);
  const int failed = ufunc == NULL || name == NULL || coscrew_add_promoter(ufunc) < 0
      || PyObject_SetAttr(module, name, ufunc) < 0;
  Py_XDECREF(name);
  Py_XDECREF(ufunc);
  return failed ? -1 : 0;
}

/* Adds each gufunc, and one called unchecked_… for each that refuses arguments. */
static int add_gufuncs(PyObject *module, const coscrew_gufunc *g) {
  static size_t number = 0;
  for (; g->name != NULL; g++, number++) {
    if (add_gufunc(module, g, data[number], "") < 0) {
      return -1;
    }
    if (g->required[0] != 0) {
      taking_all[number] = *g;
      taking_all[number].required = "";
      if (add_gufunc(module, &taking_all[number], data_taking_all[number], "unchecked_") < 0) {
        return -1;
      }
    }
  }
  return 0;
}

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_gufunc", "Generalized ufuncs of the spatial algebra.", -1,
    NULL, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__gufunc(void) {
  import_array();
  import_umath();
  fill_types();
  PyObject *module = PyModule_Create(&definition);
  if (module == NULL) {
    return NULL;
  }
  const coscrew_gufunc *const *families = best_families();
  for (size_t k = 0; k < sizeof baseline / sizeof baseline[0]; k++) {
    if (add_gufuncs(module, families[k]) < 0) {
      Py_DECREF(module);
      return NULL;
    }
  }
  if (PyModule_AddStringConstant(module, "PROVENANCE", "09b4b4e9dfdbecbe") < 0
      || PyModule_AddStringConstant(
          module, "LOOPS", families == baseline ? "baseline" : "AVX2 with FMA") < 0) {
    Py_DECREF(module);
    return NULL;
  }
  return module;
}
