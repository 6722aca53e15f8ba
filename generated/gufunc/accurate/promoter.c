/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Chooses the loop for arguments of types that no loop has, or refuses them. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* Whether arguments of this type are accepted.  float64 would lose digits of wider types, float16 is
   not a precision of these kernels, and bool is not a number. */
static int is_taken(const PyArray_DTypeMeta *dtype) {
  return dtype == &PyArray_DoubleDType || dtype == &PyArray_FloatDType
      || dtype == &PyArray_PyLongDType || dtype == &PyArray_PyFloatDType
      || PyTypeNum_ISINTEGER(dtype->type_num);
}

/* float32, alone or with Python's int and float, stays float32; other mixtures, also with integer
   arrays, become float64; other types are refused unless the call gives dtype= or signature=. */
static int promote(PyObject *ufunc, PyArray_DTypeMeta *const given[],
    PyArray_DTypeMeta *const signature[], PyArray_DTypeMeta *chosen[]) {
  const int inputs = ((PyUFuncObject *)ufunc)->nin, arguments = ((PyUFuncObject *)ufunc)->nargs;
  int single = 0, other = 0, asked = 0;
  for (int k = 0; k < arguments; k++) {
    asked |= signature[k] != NULL;
  }
  for (int k = 0; k < inputs; k++) {
    if (!asked && !is_taken(given[k])) {
      PyErr_Format(PyExc_TypeError, "%s: argument %d has dtype %R; wanted float64, float32 or integers",
          ((PyUFuncObject *)ufunc)->name, k + 1, (PyObject *)given[k]);
      return -1;
    }
    const int python_number = given[k] == &PyArray_PyLongDType || given[k] == &PyArray_PyFloatDType;
    single += given[k] == &PyArray_FloatDType;
    other += given[k] != &PyArray_FloatDType && !python_number;
  }
  PyArray_DTypeMeta *common = single && !other ? &PyArray_FloatDType : &PyArray_DoubleDType;
  for (int k = 0; k < arguments; k++) {
    common = signature[k] != NULL ? signature[k] : common;
  }
  for (int k = 0; k < arguments; k++) {
    Py_INCREF(common);
    chosen[k] = common;
  }
  return 0;
}

/* Raises the error that the pure-NumPy function raises for these arguments, which names them; leaves
   the current error if it raises none. */
static void explain(const PyUFuncObject *ufunc, PyObject *const *given, size_t inputs) {
  PyObject *type, *value, *trace;
  PyErr_Fetch(&type, &value, &trace);
  PyObject *module = PyImport_ImportModule("coscrew.accurate._dispatch");
  PyObject *twin = module == NULL ? NULL : PyObject_GetAttrString(module, ufunc->name);
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

static vectorcallfunc call_of_numpy;

/* NumPy's call of a gufunc, with errors that name the argument.  Refuses masked arrays, whose masks
   NumPy would ignore, and pandas' objects, which would reorder the axes. */
static PyObject *call(PyObject *self, PyObject *const *given, size_t flags, PyObject *names) {
  const PyUFuncObject *ufunc = (const PyUFuncObject *)self;
  const size_t count = (size_t)PyVectorcall_NARGS(flags);
  const size_t inputs = count < (size_t)ufunc->nin ? count : (size_t)ufunc->nin;
  for (size_t k = 0; k < inputs; k++) {
    PyObject *x = given[k];
    if (!PyArray_CheckExact(x) && !PyFloat_CheckExact(x) && !PyLong_CheckExact(x)
        && !PyList_CheckExact(x)
        && PyObject_HasAttrString((PyObject *)Py_TYPE(x),
            PyArray_Check(x) ? "mask" : "__pandas_priority__")) {
      explain(ufunc, given, inputs);
      if (PyErr_Occurred()) {
        return NULL;
      }
    }
  }
  PyObject *result = call_of_numpy(self, given, flags, names);
  if (result == NULL && PyErr_ExceptionMatches(PyExc_Exception)) {
    explain(ufunc, given, inputs);
  }
  return result;
}

/* Registers the promoter, for all types, and the call above. */
int coscrew_add_promoter(PyObject *ufunc) {
  call_of_numpy = ((PyUFuncObject *)ufunc)->vectorcall;
  ((PyUFuncObject *)ufunc)->vectorcall = call;
  const int arguments = ((PyUFuncObject *)ufunc)->nargs;
  PyObject *dtypes = PyTuple_New(arguments);
  PyObject *capsule = PyCapsule_New((void *)&promote, "numpy._ufunc_promoter", NULL);
  int status = -1;
  if (dtypes != NULL && capsule != NULL) {
    for (Py_ssize_t k = 0; k < arguments; k++) {
      Py_INCREF(&PyArrayDescr_Type);
      PyTuple_SET_ITEM(dtypes, k, (PyObject *)&PyArrayDescr_Type);
    }
    status = PyUFunc_AddPromoter(ufunc, dtypes, capsule);
  }
  Py_XDECREF(dtypes);
  Py_XDECREF(capsule);
  return status;
}
