/* The shape of gufunc loops whose kernels are on vectors, too: several elements at a time, a
   component of each in a vector.

   Kernels on vectors evaluate what is not chosen, too, which may raise floating-point flags, of
   which NumPy would warn.  Where they raise any, the elements are computed again one by one: these
   flags are the true ones. */
#ifndef COSCREW_VECTORS_H
#define COSCREW_VECTORS_H

#include "numpy.h"

#include <fenv.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

enum { SEVERAL = 8 }; /* of fewer elements, calls take no longer one by one, or hardly */
enum { FLAGS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW };

/* Not inlined: calls with fewer elements need no room for vectors. */
#define APART __attribute__((noinline))

/* Keeps compilers from computing this array later. */
#define COMPUTED(array) __asm__ volatile("" : : "r"(array) : "memory")

INLINED int flags(void) {
#if defined(__x86_64__)
  return (int)_mm_getcsr() & FLAGS; /* without the flags of long double, which take as long again */
#else
  return fetestexcept(FLAGS);
#endif
}

/* The flags that are raised in addition to these; lowers them. */
INLINED int lowered(int raised) {
  const int added = flags() & ~raised;
  if (added) {
    feclearexcept(added);
  }
  return added;
}

/* So many of the next n elements are computed on vectors.  One or two that are left take no longer
   one by one. */
INLINED npy_intp for_vectors(npy_intp n, npy_intp lanes, npy_intp most) {
  const npy_intp left = n % lanes;
  return n > most ? most : left > 2 ? n : n - left;
}

/* A loop over n elements, one by one. */
typedef void elements_over(
    char **data, npy_intp n, const npy_intp *step, const npy_intp *core);

/* The same of m elements, from the one numbered i, on vectors; returns 0, and writes nothing, if
   that raises flags that are not yet raised. */
typedef int elements_on_vectors(
    char **data, npy_intp i, npy_intp m, const npy_intp *step, const npy_intp *core, int raised);

/* A loop, and the most elements that it computes on vectors before any is written. */
typedef struct {
  elements_over *over;
  elements_on_vectors *on_vectors;
  int arguments;
  npy_intp lanes, most;
} vector_loop;

/* m elements one by one, from the one numbered i. */
INLINED void elements_from(const vector_loop *loop, char **data, npy_intp i, npy_intp m,
    const npy_intp *step, const npy_intp *core) {
  char *from[NPY_MAXARGS];
  for (int k = 0; k < loop->arguments; k++) {
    from[k] = data[k] + i * step[k];
  }
  loop->over(from, m, step, core);
}

/* n elements. */
INLINED void many_elements(const vector_loop *loop, char **data, npy_intp n, const npy_intp *step,
    const npy_intp *core) {
  int raised = flags();
  npy_intp i = 0, m;
  for (; (m = for_vectors(n - i, loop->lanes, loop->most)) > 0; i += m) {
    if (!loop->on_vectors(data, i, m, step, core, raised)) {
      elements_from(loop, data, i, m, step, core);
      raised = flags();
    }
  }
  elements_from(loop, data, i, n - i, step, core);
}

/* The inner loop of a gufunc whose kernel is on vectors, too. */
#define LOOP_ON_VECTORS(name, arguments, dense, ...) \
  static void name(char **data, const npy_intp *n, const npy_intp *step, void *unused) { \
    (void)unused; \
    if (n[0] >= SEVERAL) { \
      name##_many(data, n[0], step, step + (arguments)); \
      return; \
    } \
    dense(name, arguments, __VA_ARGS__) \
    name##_strided(data, n[0], step, step + (arguments)); \
  }

#endif
