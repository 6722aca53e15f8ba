/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* What all sources of gufuncs share: NumPy's interface, and the entry of a gufunc. */
#ifndef COSCREW_NUMPY_H
#define COSCREW_NUMPY_H

#include <Python.h>

#define PY_ARRAY_UNIQUE_SYMBOL coscrew_array_api
#define PY_UFUNC_UNIQUE_SYMBOL coscrew_ufunc_api
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/dtype_api.h>
#include <numpy/ufuncobject.h>

#if defined(__GNUC__)
#define INLINED static inline __attribute__((always_inline))
#else
#define INLINED static inline
#endif

typedef struct {
  const char *name, *signature, *doc;
  int inputs, outputs;
  const char *required;  /* a letter for each input, or "" */
  PyUFuncGenericFunction *loops;
} coscrew_gufunc;

/* The types of numbers of the loops, and of the first and the last of them. */
#if defined(COSCREW_DOUBLE_ONLY)
#define LOOP_TYPES NPY_DOUBLE
#define WIDE(double, single) double
#define NARROW(double, single) double
#elif defined(COSCREW_SINGLE_ONLY)
#define LOOP_TYPES NPY_FLOAT
#define WIDE(double, single) single
#define NARROW(double, single) single
#else
#define LOOP_TYPES NPY_DOUBLE, NPY_FLOAT
#define WIDE(double, single) double
#define NARROW(double, single) single
#endif

/* Whether one of n elements, `step` bytes apart, is not what the letter requires: R a rotation, U a
   quaternion of length 1, N and M a quaternion and a matrix that are not zero. */
typedef int coscrew_refusal(
    char letter, const char *p, npy_intp n, npy_intp step, const npy_intp *core);
coscrew_refusal coscrew_refuses_double, coscrew_refuses_single;

/* Gives a ufunc the promoter, and the call that names arguments in errors. */
int coscrew_add_promoter(PyObject *ufunc);

#endif
