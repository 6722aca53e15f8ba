/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/elementary_accurate.h"

/* ()->(),() */
OVER(sincos_double) {
  POINTERS_3
  EACH {
    double x;
    double s;
    double c;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sincos_accurate(x, &c);
    STORE(scalar_double, &s, 1, 0);
    STORE(scalar_double, &c, 2, 0);
  }
}
STRIDED_WITH_FMA(sincos_double)
LOOP(sincos_double, 3, ANY, 8, 8, 8)

OVER(sincos_single) {
  POINTERS_3
  EACH {
    float x;
    float s;
    float c;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sincosf_accurate(x, &c);
    STORE(scalar_single, &s, 1, 0);
    STORE(scalar_single, &c, 2, 0);
  }
}
STRIDED(sincos_single)
LOOP(sincos_single, 3, DENSE, 4, 4, 4)
LOOPS(sincos)

/* ()->() */
OVER(sin_double) {
  POINTERS_2
  EACH {
    double x;
    double s;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sin_accurate(x);
    STORE(scalar_double, &s, 1, 0);
  }
}
STRIDED_WITH_FMA(sin_double)
LOOP(sin_double, 2, ANY, 8, 8)

OVER(sin_single) {
  POINTERS_2
  EACH {
    float x;
    float s;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sinf_accurate(x);
    STORE(scalar_single, &s, 1, 0);
  }
}
STRIDED(sin_single)
LOOP(sin_single, 2, DENSE, 4, 4)
LOOPS(sin)

/* ()->() */
OVER(cos_double) {
  POINTERS_2
  EACH {
    double x;
    double c;
    LOAD(scalar_double, &x, 0, 0);
    c = ksl_cos_accurate(x);
    STORE(scalar_double, &c, 1, 0);
  }
}
STRIDED_WITH_FMA(cos_double)
LOOP(cos_double, 2, ANY, 8, 8)

OVER(cos_single) {
  POINTERS_2
  EACH {
    float x;
    float c;
    LOAD(scalar_single, &x, 0, 0);
    c = ksl_cosf_accurate(x);
    STORE(scalar_single, &c, 1, 0);
  }
}
STRIDED(cos_single)
LOOP(cos_single, 2, DENSE, 4, 4)
LOOPS(cos)

/* ()->() */
OVER(exp_double) {
  POINTERS_2
  EACH {
    double x;
    double y;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_exp_accurate(x);
    STORE(scalar_double, &y, 1, 0);
  }
}
STRIDED_WITH_FMA(exp_double)
LOOP(exp_double, 2, ANY, 8, 8)

OVER(exp_single) {
  POINTERS_2
  EACH {
    float x;
    float y;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_expf_accurate(x);
    STORE(scalar_single, &y, 1, 0);
  }
}
STRIDED(exp_single)
LOOP(exp_single, 2, DENSE, 4, 4)
LOOPS(exp)

/* ()->() */
OVER(tanh_double) {
  POINTERS_2
  EACH {
    double x;
    double y;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_tanh_accurate(x);
    STORE(scalar_double, &y, 1, 0);
  }
}
STRIDED_WITH_FMA(tanh_double)
LOOP(tanh_double, 2, ANY, 8, 8)

OVER(tanh_single) {
  POINTERS_2
  EACH {
    float x;
    float y;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_tanhf_accurate(x);
    STORE(scalar_single, &y, 1, 0);
  }
}
STRIDED(tanh_single)
LOOP(tanh_single, 2, DENSE, 4, 4)
LOOPS(tanh)

/* (),()->() */
OVER(atan2_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double y, &y);
  EACH {
    double x;
    double angle;
    LOAD_OTHER(scalar_double, &y);
    LOAD(scalar_double, &x, 1, 0);
    angle = ksl_atan2_accurate(y, x);
    STORE(scalar_double, &angle, 2, 0);
  }
}
STRIDED_WITH_FMA(atan2_double)
LOOP(atan2_double, 3, DENSE_OR_ONE, 8, 8, 8)

OVER(atan2_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float y, &y);
  EACH {
    float x;
    float angle;
    LOAD_OTHER(scalar_single, &y);
    LOAD(scalar_single, &x, 1, 0);
    angle = ksl_atan2f_accurate(y, x);
    STORE(scalar_single, &angle, 2, 0);
  }
}
STRIDED(atan2_single)
LOOP(atan2_single, 3, DENSE_OR_ONE, 4, 4, 4)
LOOPS(atan2)

const coscrew_gufunc TABLE(elementary)[] = {
  {"sincos", "()->(),()",
    "s = sin x, c = cos x, x in rad.\n"
    "\n"
    "()->(),().  x, s, c: number.\n"
    "83 mul, 129 add, 11 product error, 1 div, 3 abs, 1 less, 2 equal, 3 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 2, "", sincos_loops},
  {"sin", "()->()",
    "s = sin x, x in rad.\n"
    "\n"
    "()->().  x, s: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", sin_loops},
  {"cos", "()->()",
    "c = cos x, x in rad.\n"
    "\n"
    "()->().  x, c: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 3 abs, 1 less, 1 equal, 2 select.  Error <= 0.501\n"
    "ulp, unless a result is subnormal; proved.\n",
   1, 1, "", cos_loops},
  {"exp", "()->()",
    "y = e^x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "81 mul, 148 add, 14 product error, 5 power of two, 1 abs, 7 less, 2 equal, 10 select.  Error\n"
    "<= 0.501 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", exp_loops},
  {"tanh", "()->()",
    "y = tanh x.\n"
    "\n"
    "()->().  x, y: number.\n"
    "91 mul, 174 add, 15 product error, 2 div, 2 power of two, 4 abs, 2 copysign, 5 less, 1\n"
    "equal, 12 select.  Error <= 0.501 ulp, unless a result is subnormal; proved.\n",
   1, 1, "", tanh_loops},
  {"atan2", "(),()->()",
    "angle of the vector (x, y) to the x axis, in rad, from -π to π.\n"
    "\n"
    "(),()->().  y, x, angle: number.\n"
    "122 mul, 213 add, 21 product error, 2 div, 1 neg, 8 abs, 4 copysign, 13 less, 4 equal, 24\n"
    "select.  Error <= 0.501 ulp, unless a result is subnormal; proved.\n",
   2, 1, "", atan2_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
