/* The keywords `axes` and `axis` of a call. */
#ifndef COSCREW_AXES_H
#define COSCREW_AXES_H

#include "numpy.h"

/* The value of a keyword, which stand after `count` arguments; NULL if it is missing or None. */
static inline PyObject *keyword(
    PyObject *const *given, size_t count, PyObject *names, const char *name) {
  const Py_ssize_t keywords = names == NULL ? 0 : PyTuple_GET_SIZE(names);
  PyObject *const *values = given + count;
  for (Py_ssize_t k = 0; k < keywords; k++) {
    if (PyUnicode_CompareWithASCIIString(PyTuple_GET_ITEM(names, k), name) == 0) {
      return values[k] == Py_None ? NULL : values[k];
    }
  }
  return NULL;
}

/* (-count, ..., -1): the last axes. */
static PyObject *last_axes(int count) {
  PyObject *last = PyTuple_New(count);
  for (int k = 0; last != NULL && k < count; k++) {
    PyObject *place = PyLong_FromLong(k - count);
    if (place == NULL) {
      Py_CLEAR(last);
    } else {
      PyTuple_SET_ITEM(last, k, place);
    }
  }
  return last;
}

/* An argument with the axes of its elements last, as the gufunc takes them: `axes` has those of
   each argument, `axis` is the one of all.  NULL if they are no axes of it. */
static inline PyObject *with_axes_last(
    PyObject *x, PyObject *axes, PyObject *axis, Py_ssize_t number, int count) {
  if ((axes == NULL && count != 1)
      || (!PyArray_Check(x) && PyObject_HasAttrString(x, "__array_ufunc__"))) {
    Py_INCREF(x);
    return x;
  }
  PyObject *moved = NULL, *last = last_axes(count), *numpy = PyImport_ImportModule("numpy");
  PyObject *own = axes != NULL ? PySequence_GetItem(axes, number) : axis;
  if (own != NULL && last != NULL && numpy != NULL) {
    moved = PyObject_CallMethod(numpy, "moveaxis", "OOO", x, own, last);
  }
  if (axes != NULL) {
    Py_XDECREF(own);
  }
  Py_XDECREF(last);
  Py_XDECREF(numpy);
  return moved;
}

#endif
