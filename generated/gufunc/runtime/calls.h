/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Calls of gufuncs whose errors name the argument. */
#ifndef COSCREW_CALLS_H
#define COSCREW_CALLS_H

#include "axes.h"
#include "numpy.h"
#include "refusals.h"

#ifndef COSCREW_PACKAGE
#define COSCREW_PACKAGE "coscrew" /* of the functions in pure NumPy */
#endif

/* Raises the error that the pure-NumPy function raises for these arguments, which names them;
   leaves the current error if it raises none. */
static void explain(const PyUFuncObject *ufunc, PyObject *const *given, size_t inputs) {
  PyObject *type, *value, *trace;
  PyErr_Fetch(&type, &value, &trace);
  PyObject *module = PyImport_ImportModule(COSCREW_PACKAGE "._dispatch");
  PyObject *twin = module == NULL ? NULL : PyObject_GetAttrString(module, ufunc->name);
  const int takes_all = ((const coscrew_gufunc *)ufunc->data[0])->required[0] == 0;
  if (twin != NULL && takes_all) {
    PyObject *unchecked = PyObject_GetAttrString(twin, "unchecked");
    Py_DECREF(twin);
    twin = unchecked;
  }
  PyObject *check = twin == NULL ? NULL : PyObject_GetAttrString(twin, "check");
  PyObject *passed = check == NULL ? NULL : PyObject_Vectorcall(check, given, inputs, NULL);
  if (passed != NULL) {
    PyErr_Restore(type, value, trace);
  } else {
    Py_XDECREF(type);
    Py_XDECREF(value);
    Py_XDECREF(trace);
  }
  Py_XDECREF(passed);
  Py_XDECREF(check);
  Py_XDECREF(twin);
  Py_XDECREF(module);
}

/* Whether any argument is refused. */
static int refuses_any(const PyUFuncObject *ufunc, PyObject *const *given, size_t inputs) {
  const char *required = ((const coscrew_gufunc *)ufunc->data[0])->required;
  for (size_t k = 0; k < inputs && required[k] != 0; k++) {
    if (required[k] != '.' && refuses(required[k], given[k])) {
      return 1;
    }
  }
  return 0;
}

static vectorcallfunc call_of_numpy;

/* Whether the argument is masked, and NumPy would ignore the mask, or pandas', and would reorder
   the axes. */
static int is_masked_or_labelled(PyObject *x) {
  return !PyArray_CheckExact(x) && !PyFloat_CheckExact(x) && !PyLong_CheckExact(x)
      && !PyList_CheckExact(x)
      && PyObject_HasAttrString(
          (PyObject *)Py_TYPE(x), PyArray_Check(x) ? "mask" : "__pandas_priority__");
}

/* NumPy's call of a gufunc, with errors that name the argument.  Refuses masked arrays and pandas'
   objects, and what is no rotation where one is required: `placed` are the arguments with the axes
   of their elements last. */
static PyObject *call_placed(PyObject *self, PyObject *const *given, PyObject *const *placed,
    size_t flags, PyObject *names) {
  const PyUFuncObject *ufunc = (const PyUFuncObject *)self;
  const size_t count = (size_t)PyVectorcall_NARGS(flags);
  const size_t inputs = count < (size_t)ufunc->nin ? count : (size_t)ufunc->nin;
  for (size_t k = 0; k < inputs; k++) {
    if (is_masked_or_labelled(given[k])) {
      explain(ufunc, placed, inputs);
      if (PyErr_Occurred()) {
        return NULL;
      }
    }
  }
  if (refuses_any(ufunc, placed, inputs)) {
    explain(ufunc, placed, inputs);
    if (PyErr_Occurred()) {
      return NULL;
    }
  }
  PyObject *result = call_of_numpy(self, given, flags, names);
  if (result == NULL && PyErr_ExceptionMatches(PyExc_Exception)) {
    explain(ufunc, placed, inputs);
  }
  return result;
}

/* The same, of arguments whose axes the keywords `axes` or `axis` may name.  Where these are no
   axes of an argument, NumPy says why. */
static inline PyObject *call(
    PyObject *self, PyObject *const *given, size_t flags, PyObject *names) {
  const PyUFuncObject *ufunc = (const PyUFuncObject *)self;
  const size_t count = (size_t)PyVectorcall_NARGS(flags);
  const size_t inputs = count < (size_t)ufunc->nin ? count : (size_t)ufunc->nin;
  PyObject *axes = keyword(given, count, names, "axes");
  PyObject *axis = keyword(given, count, names, "axis");
  if (axes == NULL && axis == NULL) {
    return call_placed(self, given, given, flags, names);
  }
  PyObject *placed[NPY_MAXARGS];
  size_t done = 0;
  while (done < inputs && (placed[done] = with_axes_last(
          given[done], axes, axis, (Py_ssize_t)done, ufunc->core_num_dims[done])) != NULL) {
    done++;
  }
  PyErr_Clear();
  PyObject *result = done < inputs ? call_of_numpy(self, given, flags, names)
                                   : call_placed(self, given, placed, flags, names);
  while (done > 0) {
    Py_DECREF(placed[--done]);
  }
  return result;
}

#endif
