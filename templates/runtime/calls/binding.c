/* Calls from Python in one precision: arrays to rows of numbers, rows to results.

   Compiled once per precision, for all scenes: function.h says what it knows of a scene. */
#include "arguments.h"
#include "function.h"
#include "threads.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

void IN(know)(size_t size) {
  head = size;
}

/* The numbers of one state: in place, or copied to `room` if they have the other precision or are
   not contiguous.  NULL if there are others, or a number overflows. */
static const REAL *IN(numbers)(const array *x, ptrdiff_t size, ptrdiff_t stride, REAL *room) {
  const char *from = x->data;
  if (holds(x, REAL_NUMBER)) {
    if (stride == (ptrdiff_t)sizeof *room && x->flags & ALIGNED)
      return (const REAL *)(const void *)from;
    for (ptrdiff_t k = 0; k < size; k++) memcpy(&room[k], from + k * stride, sizeof *room);
    return room;
  }
  if (!holds(x, OTHER_NUMBER)) return NULL;
  for (ptrdiff_t k = 0; k < size; k++) {
    OTHER_REAL number;
    memcpy(&number, from + k * stride, sizeof number);
    room[k] = (REAL)number;
    if (isinf(room[k]) && !isinf(number)) return NULL;
  }
  return room;
}

/* A number that is no array, in `room`; NULL if it is of another type, or overflows. */
static const REAL *IN(number)(void *self, void *object, REAL *room) {
  void *type = PyObject_Type(object);
  const int taken = PySet_Contains(PyTuple_GetItem(self, NUMBERS), type) == 1;
  Py_DecRef(type);
  const double number = taken ? PyFloat_AsDouble(object) : 0;
  *room = (REAL)number;
  return taken && !(isinf(*room) && !isinf(number)) && !PyErr_Occurred() ? room : NULL;
}

/* An input's numbers: of one state with a step of 0; or of the states along the axes of `lead` that
   come first, in place, and the step between rows.  NULL if it does not fit. */
static const REAL *IN(read)(void *self, void *object, const input *of, REAL *room,
    const array **lead, int *axes, ptrdiff_t *step) {
  const array *x = array_of(self, object);
  const ptrdiff_t size = of->size;
  if (!x) return of->axes ? NULL : IN(number)(self, object, room);
  if (of->axes > 1) { /* those of many states, too, are taken by Python */
    const int taken = holds(x, REAL_NUMBER) && whole(x, of);
    return taken ? (const REAL *)(const void *)x->data : NULL;
  }
  const int own = of->axes, before = x->axes - own;
  if (before < 0 || (own && x->shape[before] != size)) return NULL;
  const ptrdiff_t stride = own ? x->strides[before] : (ptrdiff_t)sizeof *room;
  if (!before) return IN(numbers)(x, size, stride, room);
  if (!holds(x, REAL_NUMBER) || !(x->flags & ALIGNED)) return NULL;
  if (size > 1 && stride != (ptrdiff_t)sizeof *room) return NULL;
  if (!*lead) {
    *lead = x;
    *axes = before;
  }
  if (before != *axes || !aligned(x, *lead, before)) return NULL;
  const ptrdiff_t apart = x->strides[before - 1], each = (ptrdiff_t)sizeof *room;
  *step = apart / each;
  return apart % each ? NULL : (const REAL *)(const void *)x->data;
}

/* Whether a result overlaps rows of an input. */
static int IN(meet)(const REAL *y, ptrdiff_t length, const REAL *x, ptrdiff_t n, ptrdiff_t step,
    ptrdiff_t size) {
  const uintptr_t first = (uintptr_t)x, last = (uintptr_t)(x + (n - 1) * step);
  const uintptr_t begin = first < last ? first : last;
  const uintptr_t end = (first < last ? last : first) + (uintptr_t)size * sizeof *x;
  return begin < (uintptr_t)(y + length) && (uintptr_t)y < end;
}

/* A call of n states. */
typedef struct {
  const IN(function) *f;
  const REAL *const *x;
  REAL *const *y;
  const ptrdiff_t *steps, *places;
} IN(call);

static void IN(compute)(const void *of, ptrdiff_t first, ptrdiff_t n) {
  const IN(call) *c = (const IN(call) *)of;
  const REAL *x[c->f->inputs + 1];
  REAL *y[c->f->outputs + 1];
  for (int k = 0; k < c->f->inputs; k++) x[k] = c->x[k] + first * c->steps[k];
  for (int k = 0; k < c->f->outputs; k++) y[k] = c->y[k] + first * c->places[k];
  c->f->states(n, x, c->steps, y, c->places);
}

void IN(many)(const IN(function) *f, ptrdiff_t n, const REAL *const *x,
    const ptrdiff_t *steps, REAL *const *y, const ptrdiff_t *places, ptrdiff_t threads) {
  const IN(call) call = { f, x, y, steps, places };
  share(IN(compute), &call, n, threads);
}

/* The inputs' numbers; how many states they are of, or -1 if they are not taken. */
static ptrdiff_t IN(inputs)(void *self, const IN(function) *f, void *const *given, REAL *room,
    const array **lead, int *axes, const REAL **x, ptrdiff_t *steps) {
  ptrdiff_t n = 1;
  for (int k = 0; k < f->inputs; k++) {
    x[k] = IN(read)(self, given[k], &f->takes[k], room, lead, axes, &steps[k]);
    if (!x[k]) return -1;
    room += f->takes[k].size;
  }
  for (int i = 0; i < *axes; i++) n *= (*lead)->shape[i];
  for (ptrdiff_t k = 0; f->refused && k < (steps[f->p] ? n : 1); k++)
    if (f->refused(x[f->p] + k * steps[f->p])) return -1;
  return *axes && !*f->lanes ? -1 : n;
}

/* Whether `out` can take the result, and overlaps no input. */
static int IN(taken)(const IN(function) *f, const array *out, const array *lead, int axes,
    ptrdiff_t n, const REAL *const *x, const ptrdiff_t *steps) {
  const REAL *y = out ? (const REAL *)(const void *)out->data : NULL;
  if (f->outputs != 1 || !out) return 0;
  if (!holds(out, REAL_NUMBER) || !fits(out, f->results, lead, axes)) return 0;
  for (int k = 0; n && k < f->inputs; k++) {
    if (IN(meet)(y, n * f->results->size, x[k], n, steps[k], f->takes[k].size)) return 0;
  }
  return 1;
}

/* Put the numbers with which a result of a step begins into its rows. */
static void IN(begin)(REAL *y, ptrdiff_t n, ptrdiff_t size, const REAL *x, ptrdiff_t step) {
  for (ptrdiff_t k = 0; k < n; k++) memcpy(y + k * size, x + k * step, (size_t)size * sizeof *y);
}

/* The results; NULL if the arguments are not taken, maybe with an error. */
static void *IN(results)(void *self, const IN(function) *f, void *const *given) {
  REAL room[f->numbers], *y[f->outputs + 1];
  const REAL *x[f->inputs + 1];
  ptrdiff_t steps[f->inputs + 1], places[f->outputs + 1];
  void *results[f->outputs + 1], *out = given[f->inputs];
  const array *lead = NULL;
  int axes = 0;
  memset(steps, 0, sizeof steps);
  const ptrdiff_t threads = threads_of(self, given[f->inputs + 1]);
  const ptrdiff_t n = threads ? IN(inputs)(self, f, given, room, &lead, &axes, x, steps) : -1;
  if (n < 0) return NULL;
  if (out && !IN(taken)(f, array_of(self, out), lead, axes, n, x, steps)) return NULL;
  for (int k = 0; k < f->outputs; k++) {
    const result *of = &f->results[k];
    if (out) Py_IncRef(out);
    results[k] = out ? out : made(self, k, of, lead, axes);
    if (!results[k]) {
      while (k--) Py_DecRef(results[k]);
      return NULL;
    }
    y[k] = (REAL *)(void *)((const array *)behind_head(results[k]))->data;
    places[k] = of->size;
    if (of->moved >= 0) IN(begin)(y[k], n, of->size, x[of->moved], steps[of->moved]);
  }
  void *state = axes ? PyEval_SaveThread() : NULL;
  if (axes) IN(many)(f, n, x, steps, y, places, threads);
  else f->states(1, x, steps, y, places);
  if (state) PyEval_RestoreThread(state);
  return returned(results, f->outputs, f->results, !axes && !out);
}

void *IN(called)(void *self, const IN(function) *f, void *const *arguments,
    ptrdiff_t n, void *names) {
  void *given[f->inputs + 2]; /* the inputs, out and threads */
  memset(given, 0, sizeof given);
  const int whole = matched(self, arguments, n, names, f->inputs, given);
  void *results = whole ? IN(results)(self, f, given) : NULL;
  if (results) return results;
  PyErr_Clear();
  return PyObject_Vectorcall(PyTuple_GetItem(self, CHECKED), arguments, (size_t)n, names);
}
