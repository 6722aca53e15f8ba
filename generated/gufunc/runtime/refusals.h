/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Arguments that functions refuse: arrays with an element that is not what a letter requires. */
#ifndef COSCREW_REFUSALS_H
#define COSCREW_REFUSALS_H

#include "numpy.h"

/* The number of axes of what the letter stands for, if the array ends in such; else 0. */
static int axes_of(char letter, PyArrayObject *array) {
  const int count = PyArray_NDIM(array), is_matrix = letter == 'R' || letter == 'M';
  const npy_intp *ends = PyArray_DIMS(array) + count;
  if (is_matrix) {
    return count >= 2 && ends[-2] == 3 && (ends[-1] == 3 || ends[-1] == 4) ? 2 : 0;
  }
  return count >= 1 && ends[-1] == 4 ? 1 : 0;
}

/* Whether any element of the array is refused.  A stride of 0 repeats one element. */
static int refuses_array(char letter, PyArrayObject *array, int axes) {
  coscrew_refusal *const refuses = PyArray_TYPE(array) == NPY_FLOAT
      ? NARROW(coscrew_refuses_double, coscrew_refuses_single)
      : WIDE(coscrew_refuses_double, coscrew_refuses_single);
  const int lead = PyArray_NDIM(array) - axes, last = lead - 1;
  const npy_intp *shape = PyArray_DIMS(array), *stride = PyArray_STRIDES(array);
  const npy_intp n = last < 0 || stride[last] == 0 ? 1 : shape[last];
  npy_intp index[NPY_MAXDIMS] = {0};
  const char *p = PyArray_BYTES(array);
  if (PyArray_SIZE(array) == 0) {
    return 0;
  }
  for (;;) {
    if (refuses(letter, p, n, last < 0 ? 0 : stride[last], stride + lead)) {
      return 1;
    }
    int k = last - 1;
    while (k >= 0 && (stride[k] == 0 || index[k] + 1 == shape[k])) {
      p -= stride[k] * index[k];
      index[k--] = 0;
    }
    if (k < 0) {
      return 0;
    }
    index[k]++;
    p += stride[k];
  }
}

/* Whether an array of numbers, converted to a type of the loops, has a refused element. */
static int refuses_numbers(char letter, PyArrayObject *array, int axes) {
  int found = 0;
  const int wide = WIDE(NPY_DOUBLE, NPY_FLOAT), narrow = NARROW(NPY_DOUBLE, NPY_FLOAT);
  PyArrayObject *numbers = (PyArrayObject *)PyArray_FROM_OTF((PyObject *)array,
      PyArray_TYPE(array) == NPY_FLOAT ? narrow : wide,
      NPY_ARRAY_ALIGNED | NPY_ARRAY_NOTSWAPPED | NPY_ARRAY_FORCECAST);
  if (numbers == NULL) {
    PyErr_Clear();
    return 0;
  }
  Py_BEGIN_ALLOW_THREADS
  found = refuses_array(letter, numbers, axes);
  Py_END_ALLOW_THREADS
  Py_DECREF(numbers);
  return found;
}

/* Whether the argument holds an element that the letter refuses.  What is no array of numbers is
   left to NumPy, and so is the argument of another library, whose parts come later. */
static inline int refuses(char letter, PyObject *given) {
  if (!PyArray_Check(given) && PyObject_HasAttrString(given, "__array_ufunc__")) {
    return 0;
  }
  PyArrayObject *array = (PyArrayObject *)PyArray_FROM_O(given);
  if (array == NULL) {
    PyErr_Clear();
    return 0;
  }
  const int type = PyArray_TYPE(array), axes = axes_of(letter, array);
  const int is_number = type == NPY_FLOAT || type == NPY_DOUBLE || PyTypeNum_ISINTEGER(type);
  const int found = axes > 0 && is_number && refuses_numbers(letter, array, axes);
  Py_DECREF(array);
  return found;
}

#endif
