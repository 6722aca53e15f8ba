/* The shape of gufunc loops: elements through strides. */
#ifndef COSCREW_LOOPS_H
#define COSCREW_LOOPS_H

#include "numpy.h"

#include <string.h>

#if defined(COSCREW_FOR_AVX2)
#define TABLE(family) coscrew_##family##_gufuncs_avx2
#else
#define TABLE(family) coscrew_##family##_gufuncs
#endif

#if defined(__clang__)
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define INDEPENDENT _Pragma("GCC ivdep")
#else
#define INDEPENDENT
#endif

/* A loop over n elements, which are independent of each other, with the arguments' strides and, in
   `core`, those of their components; p0, p1, … are the arguments' first elements. */
#define OVER(name) \
  INLINED void name##_over(char **data, npy_intp n, const npy_intp *step, const npy_intp *core)
#define EACH INDEPENDENT for (npy_intp i = 0; i < n; i++)

/* Element i of argument number k, whose first component's stride is core[first]. */
#define LOAD(quantity, x, k, first) load_##quantity(x, p##k + i * step[k], core + (first))
#define STORE(quantity, x, k, first) store_##quantity(x, p##k + i * step[k], core + (first))

/* The first argument, if it is read only: once, and again where it is not the same for all
   elements. */
#define LOAD_FIRST(quantity, declaration, x) \
  if (n <= 0) return; \
  declaration; \
  load_##quantity(x, p0, core)
#define LOAD_OTHER(quantity, x) if (step[0] != 0) load_##quantity(x, p0 + i * step[0], core)

/* The loop over elements with any strides.  It loads and stores numbers one by one, and takes as
   long with AVX2, unless its kernel takes FMA: so others are compiled without, and the loops for
   AVX2 call that one. */
#define ELEMENTS_OF(name) \
  name##_strided(char **data, npy_intp n, const npy_intp *step, const npy_intp *core)
#define STRIDED_HERE(name) \
  ELEMENTS_OF(name) { \
    name##_over(data, n, step, core); \
  }
#if defined(COSCREW_FOR_AVX2)
#define STRIDED(name) void ELEMENTS_OF(name);
#define STRIDED_WITH_FMA(name) static void STRIDED_HERE(name)
#else
#define STRIDED(name) void ELEMENTS_OF(name); void STRIDED_HERE(name)
#define STRIDED_WITH_FMA(name) static void STRIDED_HERE(name)
#endif

/* The inner loop of a gufunc.  Its loop over elements is compiled for any strides and, unless
   `dense` is ANY, for those of C-ordered arrays, if it is DENSE_OR_ONE also with a single first
   argument.  With known strides elements share vectors, and few operations take less time; many
   take as long. */
#define LOOP(name, arguments, dense, ...) \
  static void name(char **data, const npy_intp *n, const npy_intp *step, void *unused) { \
    (void)unused; \
    dense(name, arguments, __VA_ARGS__) \
    name##_strided(data, n[0], step, step + (arguments)); \
  }
#define ANY(name, arguments, ...)
#define DENSE(name, arguments, ...) DENSE_IN(each, name, arguments, __VA_ARGS__)
#define DENSE_OR_ONE(name, arguments, first, ...) \
  DENSE_IN(each, name, arguments, first, __VA_ARGS__) DENSE_IN(one, name, arguments, 0, __VA_ARGS__)
#define DENSE_IN(way, name, arguments, ...) \
  static const npy_intp way[] = {__VA_ARGS__}; \
  if (memcmp(step, way, sizeof way) == 0) { \
    name##_over(data, n[0], way, way + (arguments)); \
    return; \
  }

#endif
