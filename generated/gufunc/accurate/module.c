/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* The extension module coscrew.accurate._gufunc: registers every gufunc. */
#include "_gufunc.h"

#define MOST_ARGUMENTS 9
#define GUFUNCS 265
#include "../runtime/ufuncs.h"

static const coscrew_gufunc *const baseline[] = {coscrew_elementary_gufuncs, coscrew_vec3_gufuncs,
    coscrew_vec4_gufuncs, coscrew_mat3x3_gufuncs, coscrew_SE3_gufuncs, coscrew_mat6x6_gufuncs,
    coscrew_matrix_gufuncs, coscrew_trig_gufuncs, coscrew_screw_gufuncs, coscrew_coscrew_gufuncs,
    coscrew_quaternion_gufuncs, coscrew_exponential_gufuncs, coscrew_symmetric_gufuncs,
    coscrew_inertia_gufuncs, coscrew_spatial_inertia_gufuncs};

#if COSCREW_HAS_AVX2
static const coscrew_gufunc *const avx2[] = {coscrew_elementary_gufuncs_avx2,
    coscrew_vec3_gufuncs_avx2, coscrew_vec4_gufuncs_avx2, coscrew_mat3x3_gufuncs_avx2,
    coscrew_SE3_gufuncs_avx2, coscrew_mat6x6_gufuncs_avx2, coscrew_matrix_gufuncs_avx2,
    coscrew_trig_gufuncs_avx2, coscrew_screw_gufuncs_avx2, coscrew_coscrew_gufuncs_avx2,
    coscrew_quaternion_gufuncs_avx2, coscrew_exponential_gufuncs_avx2,
    coscrew_symmetric_gufuncs_avx2, coscrew_inertia_gufuncs_avx2,
    coscrew_spatial_inertia_gufuncs_avx2};
#else
#define avx2 baseline
#endif

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_gufunc", "Generalized ufuncs of the spatial algebra.", -1,
    NULL, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__gufunc(void) {
  import_array();
  import_umath();
  const int best = takes_avx2();
  PyObject *module = PyModule_Create(&definition);
  if (module == NULL
      || add_gufuncs(module, best ? avx2 : baseline, sizeof baseline / sizeof baseline[0]) < 0
      || PyModule_AddStringConstant(module, "PROVENANCE", "c9f7668f92393c6b") < 0
      || PyModule_AddStringConstant(module, "LOOPS", best ? "AVX2 with FMA" : "baseline") < 0) {
    Py_XDECREF(module);
    return NULL;
  }
  return module;
}
