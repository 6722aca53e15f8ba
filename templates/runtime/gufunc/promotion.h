/* The promoter: it chooses the loop for arguments of types that no loop has, or refuses them. */
#ifndef COSCREW_PROMOTION_H
#define COSCREW_PROMOTION_H

#include "calls.h"
#include "numpy.h"

/* Whether arguments of this type are accepted.  float64 would lose digits of wider types, float16
   is not a precision of these kernels, and bool is not a number. */
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
      PyErr_Format(PyExc_TypeError,
          "%s: argument %d has dtype %R; wanted float64, float32 or integers",
          ((PyUFuncObject *)ufunc)->name, k + 1, (PyObject *)given[k]);
      return -1;
    }
    const int python_number = given[k] == &PyArray_PyLongDType || given[k] == &PyArray_PyFloatDType;
    single += given[k] == &PyArray_FloatDType;
    other += given[k] != &PyArray_FloatDType && !python_number;
  }
  PyArray_DTypeMeta *common = single && !other
      ? NARROW(&PyArray_DoubleDType, &PyArray_FloatDType)
      : WIDE(&PyArray_DoubleDType, &PyArray_FloatDType);
  for (int k = 0; k < arguments; k++) {
    common = signature[k] != NULL ? signature[k] : common;
  }
  for (int k = 0; k < arguments; k++) {
    Py_INCREF(common);
    chosen[k] = common;
  }
  return 0;
}

/* Registers the promoter, for all types, and the call that names arguments in errors. */
int coscrew_add_promoter(PyObject *ufunc) {
  call_of_numpy = ((PyUFuncObject *)ufunc)->vectorcall;
  ((PyUFuncObject *)ufunc)->vectorcall = call;
  const int arguments = ((PyUFuncObject *)ufunc)->nargs;
  PyObject *dtypes = PyTuple_New(arguments);
  void *const function = (void *)(npy_uintp)&promote; /* through a number, as ISO C wants */
  PyObject *capsule = PyCapsule_New(function, "numpy._ufunc_promoter", NULL);
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

#endif
