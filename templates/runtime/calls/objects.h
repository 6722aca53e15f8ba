/* Objects of Python and arrays of NumPy, without the headers of either.

   Python's functions are all of its stable application binary interface from 3.12 on and there in
   3.11; the fields of NumPy's arrays, behind `head` bytes that all objects begin with, are fixed by
   NumPy's binary interface. */
#ifndef COSCREW_OBJECTS_H
#define COSCREW_OBJECTS_H

#include <stddef.h>

extern void Py_IncRef(void *object);
extern void Py_DecRef(void *object);
extern void *PyObject_Type(void *object);
extern void *PyObject_GetItem(void *object, void *key);
extern void *PyObject_Call(void *callable, void *arguments, void *named);
extern void *PyObject_Vectorcall(void *callable, void *const *arguments, size_t n, void *names);
extern void *PyCFunction_NewEx(const void *method, void *self, void *module);
extern void *PyTuple_New(ptrdiff_t size);
extern void *PyTuple_Pack(ptrdiff_t size, ...);
extern ptrdiff_t PyTuple_Size(void *tuple);
extern void *PyTuple_GetItem(void *tuple, ptrdiff_t place);
extern int PyTuple_SetItem(void *tuple, ptrdiff_t place, void *item);
extern void *PyLong_FromSsize_t(ptrdiff_t value);
extern ptrdiff_t PyLong_AsSsize_t(void *object);
extern double PyFloat_AsDouble(void *object);
extern int PySet_Contains(void *set, void *object);
extern void *PyErr_Occurred(void);
extern void PyErr_Clear(void);
extern void *PyEval_SaveThread(void);
extern void PyEval_RestoreThread(void *state);
extern char _Py_NoneStruct;

typedef void (*anything)(void); /* a function of another type */
typedef void *called(void *self, void *const *arguments, ptrdiff_t n, void *names);
typedef struct {
  const char *name;
  called *function;
  int flags;
  const char *words;
} method;
typedef struct {
  void *scalar;
  char family, letter, order, former;
  int number;
} dtype;
typedef struct {
  char *data;
  int axes;
  ptrdiff_t *shape, *strides;
  void *base, *type;
  int flags;
} array;
enum { FAST = 0x80 | 0x02 };         /* flags of a method: it takes a vector of arguments, names */
enum { SINGLE = 11, DOUBLE = 12 };   /* numbers of dtypes */
enum { CONTIGUOUS = 1, ALIGNED = 0x100, WRITABLE = 0x400 }; /* flags of an array */

/* Items of a function's `self`: the function that checks its arguments; the types of arrays, of
   numbers and of `threads` that are taken; numpy.empty, and its arguments for each result; names.
   */
enum { CHECKED, ARRAY, NUMBERS, INTEGER, EMPTY, RESULTS, NAMES };

static size_t head;

static inline const void *behind_head(void *object) {
  return (const char *)object + head;
}

/* The array; NULL if it is none.  Subclasses may be more than numbers and are not taken. */
static inline const array *array_of(void *self, void *object) {
  void *type = PyObject_Type(object);
  Py_DecRef(type);
  return type == PyTuple_GetItem(self, ARRAY) ? (const array *)behind_head(object) : NULL;
}

/* Whether an array's numbers are of this dtype, in the byte order of the processor. */
static inline int holds(const array *x, int number) {
  const dtype *type = (const dtype *)behind_head(x->type);
  return type->number == number && type->order == '=';
}

#endif
