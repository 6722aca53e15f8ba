/* Registers gufuncs in an extension module. */
#ifndef COSCREW_UFUNCS_H
#define COSCREW_UFUNCS_H

#include "numpy.h"
#include "processors.h"

#ifndef MOST_ARGUMENTS
#define MOST_ARGUMENTS 1 /* of a gufunc */
#define GUFUNCS 1        /* how many there are */
#endif

static const char loop_types[] = { LOOP_TYPES };
enum { LOOPS = sizeof loop_types };

/* Each ufunc's data: its entry of the table, for every loop. */
static void *data[GUFUNCS][LOOPS];

/* The entries of those that refuse arguments, for ufuncs that do not. */
static coscrew_gufunc taking_all[GUFUNCS];
static void *data_taking_all[GUFUNCS][LOOPS];

/* The type numbers of each loop, by the number of arguments. */
static char types[MOST_ARGUMENTS + 1][LOOPS * (MOST_ARGUMENTS + 1)];

static void fill_types(void) {
  for (int arguments = 0; arguments <= MOST_ARGUMENTS; arguments++) {
    for (int k = 0; k < LOOPS * arguments; k++) {
      types[arguments][k] = loop_types[k / arguments];
    }
  }
}

static int add_gufunc(
    PyObject *module, const coscrew_gufunc *g, void **own_data, const char *prefix) {
  for (int k = 0; k < LOOPS; k++) {
    own_data[k] = (void *)g;
  }
  PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(
      g->loops, own_data, types[g->inputs + g->outputs], LOOPS, g->inputs, g->outputs,
      PyUFunc_None, g->name, g->doc, 0, g->signature);
  PyObject *name = PyUnicode_FromFormat("%s%s", prefix, g->name);
  const int failed = ufunc == NULL || name == NULL || coscrew_add_promoter(ufunc) < 0
      || PyObject_SetAttr(module, name, ufunc) < 0;
  Py_XDECREF(name);
  Py_XDECREF(ufunc);
  return failed ? -1 : 0;
}

/* Adds each gufunc of a table, and one called unchecked_… for each that refuses arguments. */
static int add_table(PyObject *module, const coscrew_gufunc *g) {
  static size_t number = 0;
  for (; g->name != NULL; g++, number++) {
    if (add_gufunc(module, g, data[number], "") < 0) {
      return -1;
    }
    if (g->required[0] != 0) {
      taking_all[number] = *g;
      taking_all[number].required = "";
      if (add_gufunc(module, &taking_all[number], data_taking_all[number], "unchecked_") < 0) {
        return -1;
      }
    }
  }
  return 0;
}

/* Adds the gufuncs of these tables. */
static inline int add_gufuncs(
    PyObject *module, const coscrew_gufunc *const *tables, size_t count) {
  fill_types();
  for (size_t k = 0; k < count; k++) {
    if (add_table(module, tables[k]) < 0) {
      return -1;
    }
  }
  return 0;
}

/* Whether this processor runs the loops for AVX2, and COSCREW_BASELINE is not in the environment.
   */
static inline int takes_avx2(void) {
#if COSCREW_HAS_AVX2
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && (!COSCREW_WITH_FMA || __builtin_cpu_supports("fma"))
      && getenv("COSCREW_BASELINE") == NULL;
#else
  return 0;
#endif
}

#endif
