/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Chooses the loop for arguments of types that no loop has, or refuses them. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/ksl_accurate.h"

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


/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline double ksl_mat3x3_rotation_defect(const ksl_mat3x3_t *R) {
  const double n_0 = KSL_MUL(R->m11, R->m22) - KSL_MUL(R->m12, R->m21),
      n_1 = KSL_MUL(R->m02, R->m21) - KSL_MUL(R->m01, R->m22),
      n_2 = KSL_MUL(R->m01, R->m12) - KSL_MUL(R->m02, R->m11);
  const double det = KSL_MUL(R->m00, n_0) + KSL_MUL(R->m10, n_1) + KSL_MUL(R->m20, n_2);
  const double g_0 = KSL_MUL(R->m00, R->m00) + KSL_MUL(R->m10, R->m10) + KSL_MUL(R->m20, R->m20),
      g_1 = KSL_MUL(R->m00, R->m01) + KSL_MUL(R->m10, R->m11) + KSL_MUL(R->m20, R->m21),
      g_2 = KSL_MUL(R->m00, R->m02) + KSL_MUL(R->m10, R->m12) + KSL_MUL(R->m20, R->m22),
      g_3 = KSL_MUL(R->m01, R->m01) + KSL_MUL(R->m11, R->m11) + KSL_MUL(R->m21, R->m21),
      g_4 = KSL_MUL(R->m01, R->m02) + KSL_MUL(R->m11, R->m12) + KSL_MUL(R->m21, R->m22),
      g_5 = KSL_MUL(R->m02, R->m02) + KSL_MUL(R->m12, R->m12) + KSL_MUL(R->m22, R->m22);
  const double off_0 = det - 1.0, off_1 = g_0 - 1.0, off_4 = g_3 - 1.0, off_6 = g_5 - 1.0;
  const double defect_size_0 = fabs(off_0), defect_size_1 = fabs(off_1), defect_size_2 = fabs(g_1),
      defect_size_3 = fabs(g_2), defect_size_4 = fabs(off_4), defect_size_5 = fabs(g_4),
      defect_size_6 = fabs(off_6);
  const double defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const double defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const double defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const double defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const double defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const double defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* the largest of |det R - 1| and |R^T R - I|_ij: 0 for a rotation, 2 for a reflection, NaN if an
     entry is NaN.
   R: rotation or other 3×3 matrix.
   27 mul, 21 add, 7 abs, 6 less, 6 select.
   Error <= 6 u near a rotation; measured, not proved. */
static inline float ksl_mat3x3f_rotation_defect(const ksl_mat3x3f_t *R) {
  const float n_0 = KSL_MULF(R->m11, R->m22) - KSL_MULF(R->m12, R->m21),
      n_1 = KSL_MULF(R->m02, R->m21) - KSL_MULF(R->m01, R->m22),
      n_2 = KSL_MULF(R->m01, R->m12) - KSL_MULF(R->m02, R->m11);
  const float det = KSL_MULF(R->m00, n_0) + KSL_MULF(R->m10, n_1) + KSL_MULF(R->m20, n_2);
  const float g_0 = KSL_MULF(R->m00, R->m00) + KSL_MULF(R->m10, R->m10) + KSL_MULF(R->m20, R->m20),
      g_1 = KSL_MULF(R->m00, R->m01) + KSL_MULF(R->m10, R->m11) + KSL_MULF(R->m20, R->m21),
      g_2 = KSL_MULF(R->m00, R->m02) + KSL_MULF(R->m10, R->m12) + KSL_MULF(R->m20, R->m22),
      g_3 = KSL_MULF(R->m01, R->m01) + KSL_MULF(R->m11, R->m11) + KSL_MULF(R->m21, R->m21),
      g_4 = KSL_MULF(R->m01, R->m02) + KSL_MULF(R->m11, R->m12) + KSL_MULF(R->m21, R->m22),
      g_5 = KSL_MULF(R->m02, R->m02) + KSL_MULF(R->m12, R->m12) + KSL_MULF(R->m22, R->m22);
  const float off_0 = det - 1.0f, off_1 = g_0 - 1.0f, off_4 = g_3 - 1.0f, off_6 = g_5 - 1.0f;
  const float defect_size_0 = fabsf(off_0), defect_size_1 = fabsf(off_1),
      defect_size_2 = fabsf(g_1), defect_size_3 = fabsf(g_2), defect_size_4 = fabsf(off_4),
      defect_size_5 = fabsf(g_4), defect_size_6 = fabsf(off_6);
  const float defect_largest1 = defect_size_0 < defect_size_1 ? defect_size_1 : defect_size_0;
  const float defect_largest2 = defect_largest1 < defect_size_2 ? defect_size_2 : defect_largest1;
  const float defect_largest3 = defect_largest2 < defect_size_3 ? defect_size_3 : defect_largest2;
  const float defect_largest4 = defect_largest3 < defect_size_4 ? defect_size_4 : defect_largest3;
  const float defect_largest5 = defect_largest4 < defect_size_5 ? defect_size_5 : defect_largest4;
  const float defect_largest6 = defect_largest5 < defect_size_6 ? defect_size_6 : defect_largest5;
  return defect_largest6;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline double ksl_quaternion_unit_defect(const ksl_quaternion_t *q) {
  const double s_size_0 = fabs(q->x), s_size_1 = fabs(q->y), s_size_2 = fabs(q->z),
      s_size_3 = fabs(q->w);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const double s_b = 6.703903964971299e+153 < s_largest3 ? 3.7291703656001034e-155 : 1.0,
      s_d = s_largest3 < 256.0 ? 1.3093562431584567e+151 : s_b,
      s = s_largest3 < 1.955159272639747e-149 ? 1.0715086071862673e+301 : s_d;
  const double y_0 = KSL_MUL(q->x, s), y_1 = KSL_MUL(q->y, s), y_2 = KSL_MUL(q->z, s),
      y_3 = KSL_MUL(q->w, s);
  const double n = sqrt(KSL_MUL(y_0, y_0) + KSL_MUL(y_1, y_1) + KSL_MUL(y_2, y_2)
          + KSL_MUL(y_3, y_3));
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r_d = 1.0 < s ? 7.637340908749012e-152 : r_b,
      r = 1.3093562431584567e+151 < s ? 9.332636185032189e-302 : r_d;
  const double length = KSL_MUL(n, r);
  const double defect = length - 1.0;
  return defect;
}

/* |q| - 1: 0 for a unit quaternion, negative for a shorter one.
   q: quaternion (x, y, z, w), the scalar last.
   9 mul, 4 add, 1 sqrt, 4 abs, 9 less, 9 select. */
static inline float ksl_quaternionf_unit_defect(const ksl_quaternionf_t *q) {
  const float s_size_0 = fabsf(q->x), s_size_1 = fabsf(q->y), s_size_2 = fabsf(q->z),
      s_size_3 = fabsf(q->w);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_largest3 = s_largest2 < s_size_3 ? s_size_3 : s_largest2;
  const float s_b = 4.611686e+18f < s_largest3 ? 2.7105054e-20f : 1.0f,
      s_d = s_largest3 < 256.0f ? 1.8014399e+16f : s_b,
      s = s_largest3 < 1.4210855e-14f ? 3.2451855e+32f : s_d;
  const float y_0 = KSL_MULF(q->x, s), y_1 = KSL_MULF(q->y, s), y_2 = KSL_MULF(q->z, s),
      y_3 = KSL_MULF(q->w, s);
  const float n = sqrtf(KSL_MULF(y_0, y_0) + KSL_MULF(y_1, y_1) + KSL_MULF(y_2, y_2)
          + KSL_MULF(y_3, y_3));
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r_d = 1.0f < s ? 5.551115e-17f : r_b,
      r = 1.8014399e+16f < s ? 3.081488e-33f : r_d;
  const float length = KSL_MULF(n, r);
  const float defect = length - 1.0f;
  return defect;
}

/* Whether a component is NaN. */
INLINED int has_nan_double(const double *x, size_t size) {
  int found = 0;
  for (size_t k = 0; k < size; k++) {
    found |= x[k] != x[k];
  }
  return found;
}

INLINED int is_zero_double(const double *x, size_t size) {
  int found = 1;
  for (size_t k = 0; k < size; k++) {
    found &= x[k] == 0;
  }
  return found;
}

/* Whether ksl_mat3x3_rotation_defect says so: its size is above 0.001, or it is NaN though
   no component is, of which results are NaN. */
INLINED int is_off_R_double(const char *p, const npy_intp *core) {
  ksl_mat3x3_t x;
  load_mat3x3_double(&x, p, core);
  const double defect = ksl_mat3x3_rotation_defect(&x);
  return !(-0.001 <= defect && defect <= 0.001)
      && !has_nan_double((const double *)&x, sizeof x / sizeof defect);
}

/* Whether ksl_quaternion_unit_defect says so: its size is above 0.001, or it is NaN though
   no component is, of which results are NaN. */
INLINED int is_off_U_double(const char *p, const npy_intp *core) {
  ksl_quaternion_t x;
  load_quaternion_double(&x, p, core);
  const double defect = ksl_quaternion_unit_defect(&x);
  return !(-0.001 <= defect && defect <= 0.001)
      && !has_nan_double((const double *)&x, sizeof x / sizeof defect);
}

/* Whether one of n elements, `step` bytes apart, is not what the letter requires: R a rotation, U a
   quaternion of length 1, N and M a quaternion and a matrix that are not zero.  Of a matrix the
   first three columns are read. */
static int refuses_double(
    char letter, const char *p, npy_intp n, npy_intp step, const npy_intp *core) {
  int found = 0;
  if (letter == 'R') {
    for (npy_intp k = 0; k < n; k++, p += step) {
      found |= is_off_R_double(p, core);
    }
    return found;
  }
  if (letter == 'U') {
    for (npy_intp k = 0; k < n; k++, p += step) {
      found |= is_off_U_double(p, core);
    }
    return found;
  }
  for (npy_intp k = 0; k < n; k++, p += step) {
    ksl_mat3x3_t matrix;
    ksl_quaternion_t quaternion;
    if (letter == 'M') {
      load_mat3x3_double(&matrix, p, core);
      found |= is_zero_double((const double *)&matrix, 9);
    } else {
      load_quaternion_double(&quaternion, p, core);
      found |= is_zero_double((const double *)&quaternion, 4);
    }
  }
  return found;
}

/* Whether a component is NaN. */
INLINED int has_nan_single(const float *x, size_t size) {
  int found = 0;
  for (size_t k = 0; k < size; k++) {
    found |= x[k] != x[k];
  }
  return found;
}

INLINED int is_zero_single(const float *x, size_t size) {
  int found = 1;
  for (size_t k = 0; k < size; k++) {
    found &= x[k] == 0;
  }
  return found;
}

/* Whether ksl_mat3x3f_rotation_defect says so: its size is above 0.001f, or it is NaN though
   no component is, of which results are NaN. */
INLINED int is_off_R_single(const char *p, const npy_intp *core) {
  ksl_mat3x3f_t x;
  load_mat3x3_single(&x, p, core);
  const float defect = ksl_mat3x3f_rotation_defect(&x);
  return !(-0.001f <= defect && defect <= 0.001f)
      && !has_nan_single((const float *)&x, sizeof x / sizeof defect);
}

/* Whether ksl_quaternionf_unit_defect says so: its size is above 0.001f, or it is NaN though
   no component is, of which results are NaN. */
INLINED int is_off_U_single(const char *p, const npy_intp *core) {
  ksl_quaternionf_t x;
  load_quaternion_single(&x, p, core);
  const float defect = ksl_quaternionf_unit_defect(&x);
  return !(-0.001f <= defect && defect <= 0.001f)
      && !has_nan_single((const float *)&x, sizeof x / sizeof defect);
}

/* Whether one of n elements, `step` bytes apart, is not what the letter requires: R a rotation, U a
   quaternion of length 1, N and M a quaternion and a matrix that are not zero.  Of a matrix the
   first three columns are read. */
static int refuses_single(
    char letter, const char *p, npy_intp n, npy_intp step, const npy_intp *core) {
  int found = 0;
  if (letter == 'R') {
    for (npy_intp k = 0; k < n; k++, p += step) {
      found |= is_off_R_single(p, core);
    }
    return found;
  }
  if (letter == 'U') {
    for (npy_intp k = 0; k < n; k++, p += step) {
      found |= is_off_U_single(p, core);
    }
    return found;
  }
  for (npy_intp k = 0; k < n; k++, p += step) {
    ksl_mat3x3f_t matrix;
    ksl_quaternionf_t quaternion;
    if (letter == 'M') {
      load_mat3x3_single(&matrix, p, core);
      found |= is_zero_single((const float *)&matrix, 9);
    } else {
      load_quaternion_single(&quaternion, p, core);
      found |= is_zero_single((const float *)&quaternion, 4);
    }
  }
  return found;
}


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
  const int lead = PyArray_NDIM(array) - axes, last = lead - 1;
  const npy_intp *shape = PyArray_DIMS(array), *stride = PyArray_STRIDES(array);
  const npy_intp n = last < 0 || stride[last] == 0 ? 1 : shape[last];
  npy_intp index[NPY_MAXDIMS] = {0};
  const char *p = PyArray_BYTES(array);
  if (PyArray_SIZE(array) == 0) {
    return 0;
  }
  for (;;) {
    if ((PyArray_TYPE(array) == NPY_FLOAT ? refuses_single : refuses_double)(
            letter, p, n, last < 0 ? 0 : stride[last], stride + lead)) {
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

/* Whether the argument holds an element that the letter refuses.  What is no array of numbers is left
   to NumPy, and so is the argument of another library, whose parts come later. */
static int refuses(char letter, PyObject *given) {
  if (!PyArray_Check(given) && PyObject_HasAttrString(given, "__array_ufunc__")) {
    return 0;
  }
  PyArrayObject *array = (PyArrayObject *)PyArray_FROM_O(given);
  if (array == NULL) {
    PyErr_Clear();
    return 0;
  }
  const int type = PyArray_TYPE(array), axes = axes_of(letter, array);
  int found = 0;
  if (axes > 0 && (type == NPY_FLOAT || type == NPY_DOUBLE || PyTypeNum_ISINTEGER(type))) {
    PyArrayObject *numbers = (PyArrayObject *)PyArray_FROM_OTF((PyObject *)array,
        type == NPY_FLOAT ? NPY_FLOAT : NPY_DOUBLE,
        NPY_ARRAY_ALIGNED | NPY_ARRAY_NOTSWAPPED | NPY_ARRAY_FORCECAST);
    if (numbers == NULL) {
      PyErr_Clear();
    } else {
      Py_BEGIN_ALLOW_THREADS
      found = refuses_array(letter, numbers, axes);
      Py_END_ALLOW_THREADS
      Py_DECREF(numbers);
    }
  }
  Py_DECREF(array);
  return found;
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

/* The value of a keyword, which stand after `count` arguments; NULL if it is missing or None. */
static PyObject *keyword(
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

/* An argument with the axes of its elements last, as the gufunc takes them: `axes` has those of each
   argument, `axis` is the one of all.  NULL if they are no axes of it. */
static PyObject *with_axes_last(
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

/* NumPy's call of a gufunc, with errors that name the argument.  Refuses masked arrays, whose masks
   NumPy would ignore, pandas' objects, which would reorder the axes, and what is no rotation where one
   is required: `placed` are the arguments with the axes of their elements last. */
static PyObject *call_placed(PyObject *self, PyObject *const *given, PyObject *const *placed,
    size_t flags, PyObject *names) {
  const PyUFuncObject *ufunc = (const PyUFuncObject *)self;
  const size_t count = (size_t)PyVectorcall_NARGS(flags);
  const size_t inputs = count < (size_t)ufunc->nin ? count : (size_t)ufunc->nin;
  for (size_t k = 0; k < inputs; k++) {
    PyObject *x = given[k];
    if (!PyArray_CheckExact(x) && !PyFloat_CheckExact(x) && !PyLong_CheckExact(x)
        && !PyList_CheckExact(x)
        && PyObject_HasAttrString((PyObject *)Py_TYPE(x),
            PyArray_Check(x) ? "mask" : "__pandas_priority__")) {
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

/* The same, of arguments whose axes the keywords `axes` or `axis` may name.  Where these are no axes of
   an argument, NumPy says why. */
static PyObject *call(PyObject *self, PyObject *const *given, size_t flags, PyObject *names) {
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
