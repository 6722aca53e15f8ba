/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.1.0.  Copyright (c) 2026 The coscrew authors. */
/* Which loop NumPy takes for arguments of other types than those the loops have. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"

/* float32 stays float32, also beside Python's int and float; other mixtures become float64. */
static int promote(PyObject *ufunc, PyArray_DTypeMeta *const given[],
    PyArray_DTypeMeta *const signature[], PyArray_DTypeMeta *chosen[]) {
  const int inputs = ((PyUFuncObject *)ufunc)->nin, arguments = ((PyUFuncObject *)ufunc)->nargs;
  int single = 0, other = 0;
  for (int k = 0; k < inputs; k++) {
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

int coscrew_add_promoter(PyObject *ufunc) {
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
