/* Arguments and results of a call from Python, whatever the precision. */
#ifndef COSCREW_ARGUMENTS_H
#define COSCREW_ARGUMENTS_H

#include "objects.h"
#include "shapes.h"

/* The arguments in the order of inputs; then `out` and `threads`, NULL if not given.  Whether there
   is each input once. */
static inline int matched(void *self, void *const *arguments, ptrdiff_t n, void *names, int inputs,
    void **given) {
  const ptrdiff_t named = names ? PyTuple_Size(names) : 0;
  if (n > inputs) return 0;
  for (ptrdiff_t k = 0; k < n; k++) given[k] = arguments[k];
  for (ptrdiff_t k = 0; k < named; k++) {
    void *known = PyTuple_GetItem(self, NAMES), *name = PyTuple_GetItem(names, k);
    int place = 0;
    while (place < inputs + 2 && PyTuple_GetItem(known, place) != name) place++;
    if (place == inputs + 2 || given[place]) return 0;
    given[place] = arguments[n + k];
  }
  for (int k = 0; k < inputs; k++)
    if (!given[k]) return 0;
  if (given[inputs] == &_Py_NoneStruct) given[inputs] = NULL;
  return 1;
}

/* The number of threads, 0 if it is none that is taken, maybe with an error. */
static inline ptrdiff_t threads_of(void *self, void *object) {
  if (!object) return 1;
  void *type = PyObject_Type(object);
  Py_DecRef(type);
  const ptrdiff_t count = type == PyTuple_GetItem(self, INTEGER) ? PyLong_AsSsize_t(object) : 0;
  return count > 0 ? count : 0;
}

/* An array for result k: of one state, or with the first `axes` axes of `lead`.  NULL on an error.
   */
static inline void *made(void *self, int k, const result *of, const array *lead, int axes) {
  void *empty = PyTuple_GetItem(self, EMPTY);
  void *one = PyTuple_GetItem(PyTuple_GetItem(self, RESULTS), k);
  if (!axes) return PyObject_Call(empty, one, NULL);
  void *shape = PyTuple_New(axes + of->axes), *arguments = NULL, *found = NULL;
  int filled = shape != NULL;
  for (int i = 0; filled && i < axes + of->axes; i++) {
    void *length = PyLong_FromSsize_t(i < axes ? lead->shape[i] : of->shape[i - axes]);
    filled = length && !PyTuple_SetItem(shape, i, length);
  }
  if (filled) arguments = PyTuple_Pack(2, shape, PyTuple_GetItem(one, 1));
  if (arguments) found = PyObject_Call(empty, arguments, NULL);
  Py_DecRef(arguments);
  Py_DecRef(shape);
  return found;
}

/* Whether x is the input of one state, as C stores it. */
static inline int whole(const array *x, const input *of) {
  const int wanted = CONTIGUOUS | ALIGNED;
  if ((x->flags & wanted) != wanted || x->axes != of->axes) return 0;
  for (int i = 0; i < x->axes; i++)
    if (x->shape[i] != of->shape[i]) return 0;
  return 1;
}

/* Whether the axes of x before its own are those of `lead`, and its rows stand in one line. */
static inline int aligned(const array *x, const array *lead, int axes) {
  for (int i = 0; i < axes; i++) {
    if (x->shape[i] != lead->shape[i]) return 0;
    if (i && x->strides[i - 1] != x->shape[i] * x->strides[i]) return 0;
  }
  return 1;
}

/* Whether `out` can take the result. */
static inline int fits(const array *out, const result *of, const array *lead, int axes) {
  const int wanted = CONTIGUOUS | ALIGNED | WRITABLE;
  if ((out->flags & wanted) != wanted || out->axes != axes + of->axes) return 0;
  for (int i = 0; i < out->axes; i++)
    if (out->shape[i] != (i < axes ? lead->shape[i] : of->shape[i - axes])) return 0;
  return 1;
}

/* The results as Python returns them: numbers of one state as NumPy's, several as a tuple.  Takes
   over the references. */
static inline void *returned(void **results, int count, const result *of, int numbers) {
  int whole = 1;
  for (int k = 0; numbers && k < count; k++)
    if (!of[k].axes) {
      void *place = PyTuple_New(0), *number = place ? PyObject_GetItem(results[k], place) : NULL;
      Py_DecRef(place);
      Py_DecRef(results[k]);
      results[k] = number;
      whole = whole && number;
    }
  if (whole && count == 1) return results[0];
  void *all = whole ? PyTuple_New(count) : NULL;
  for (int k = 0; k < count; k++)
    if (all) PyTuple_SetItem(all, k, results[k]);
    else Py_DecRef(results[k]);
  return all;
}

#endif
