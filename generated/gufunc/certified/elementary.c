/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the elementary operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/elementary_certified.h"
#include <fenv.h>

/* ()->(),(),(),() */
OVER(sincos_double) {
  POINTERS_5
  EACH {
    double x;
    double s;
    double c;
    double s_bound;
    double c_bound;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sincos_certified(x, &c, &s_bound, &c_bound);
    STORE(scalar_double, &s, 1, 0);
    STORE(scalar_double, &c, 2, 0);
    STORE(scalar_double, &s_bound, 3, 0);
    STORE(scalar_double, &c_bound, 4, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(sincos_double)
LOOP(sincos_double, 5, ANY, 8, 8, 8, 8, 8)

OVER(sincos_single) {
  POINTERS_5
  EACH {
    float x;
    float s;
    float c;
    float s_bound;
    float c_bound;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sincosf_certified(x, &c, &s_bound, &c_bound);
    STORE(scalar_single, &s, 1, 0);
    STORE(scalar_single, &c, 2, 0);
    STORE(scalar_single, &s_bound, 3, 0);
    STORE(scalar_single, &c_bound, 4, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(sincos_single)
LOOP(sincos_single, 5, DENSE, 4, 4, 4, 4, 4)
LOOPS(sincos)

/* ()->(),() */
OVER(sin_double) {
  POINTERS_3
  EACH {
    double x;
    double s;
    double s_bound;
    LOAD(scalar_double, &x, 0, 0);
    s = ksl_sin_certified(x, &s_bound);
    STORE(scalar_double, &s, 1, 0);
    STORE(scalar_double, &s_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(sin_double)
LOOP(sin_double, 3, ANY, 8, 8, 8)

OVER(sin_single) {
  POINTERS_3
  EACH {
    float x;
    float s;
    float s_bound;
    LOAD(scalar_single, &x, 0, 0);
    s = ksl_sinf_certified(x, &s_bound);
    STORE(scalar_single, &s, 1, 0);
    STORE(scalar_single, &s_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(sin_single)
LOOP(sin_single, 3, DENSE, 4, 4, 4)
LOOPS(sin)

/* ()->(),() */
OVER(cos_double) {
  POINTERS_3
  EACH {
    double x;
    double c;
    double c_bound;
    LOAD(scalar_double, &x, 0, 0);
    c = ksl_cos_certified(x, &c_bound);
    STORE(scalar_double, &c, 1, 0);
    STORE(scalar_double, &c_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(cos_double)
LOOP(cos_double, 3, ANY, 8, 8, 8)

OVER(cos_single) {
  POINTERS_3
  EACH {
    float x;
    float c;
    float c_bound;
    LOAD(scalar_single, &x, 0, 0);
    c = ksl_cosf_certified(x, &c_bound);
    STORE(scalar_single, &c, 1, 0);
    STORE(scalar_single, &c_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(cos_single)
LOOP(cos_single, 3, DENSE, 4, 4, 4)
LOOPS(cos)

/* ()->(),() */
OVER(exp_double) {
  POINTERS_3
  EACH {
    double x;
    double y;
    double y_bound;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_exp_certified(x, &y_bound);
    STORE(scalar_double, &y, 1, 0);
    STORE(scalar_double, &y_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(exp_double)
LOOP(exp_double, 3, ANY, 8, 8, 8)

OVER(exp_single) {
  POINTERS_3
  EACH {
    float x;
    float y;
    float y_bound;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_expf_certified(x, &y_bound);
    STORE(scalar_single, &y, 1, 0);
    STORE(scalar_single, &y_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(exp_single)
LOOP(exp_single, 3, DENSE, 4, 4, 4)
LOOPS(exp)

/* ()->(),() */
OVER(tanh_double) {
  POINTERS_3
  EACH {
    double x;
    double y;
    double y_bound;
    LOAD(scalar_double, &x, 0, 0);
    y = ksl_tanh_certified(x, &y_bound);
    STORE(scalar_double, &y, 1, 0);
    STORE(scalar_double, &y_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(tanh_double)
LOOP(tanh_double, 3, ANY, 8, 8, 8)

OVER(tanh_single) {
  POINTERS_3
  EACH {
    float x;
    float y;
    float y_bound;
    LOAD(scalar_single, &x, 0, 0);
    y = ksl_tanhf_certified(x, &y_bound);
    STORE(scalar_single, &y, 1, 0);
    STORE(scalar_single, &y_bound, 2, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(tanh_single)
LOOP(tanh_single, 3, ANY, 4, 4, 4)
LOOPS(tanh)

/* (),()->(),() */
OVER(atan2_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double y, &y);
  EACH {
    double x;
    double angle;
    double angle_bound;
    LOAD_OTHER(scalar_double, &y);
    LOAD(scalar_double, &x, 1, 0);
    angle = ksl_atan2_certified(y, x, &angle_bound);
    STORE(scalar_double, &angle, 2, 0);
    STORE(scalar_double, &angle_bound, 3, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(atan2_double)
LOOP(atan2_double, 4, DENSE_OR_ONE, 8, 8, 8, 8)

OVER(atan2_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float y, &y);
  EACH {
    float x;
    float angle;
    float angle_bound;
    LOAD_OTHER(scalar_single, &y);
    LOAD(scalar_single, &x, 1, 0);
    angle = ksl_atan2f_certified(y, x, &angle_bound);
    STORE(scalar_single, &angle, 2, 0);
    STORE(scalar_single, &angle_bound, 3, 0);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(atan2_single)
LOOP(atan2_single, 4, DENSE_OR_ONE, 4, 4, 4, 4)
LOOPS(atan2)

const coscrew_gufunc TABLE(elementary)[] = {
  {"sincos", "()->(),(),(),()",
    "s = sin x, c = cos x, x in rad; |error of s| <= s_bound, |error of c| <= c_bound unless inf\n"
    "or NaN.\n"
    "\n"
    "()->(),(),(),().  x, s, c, s_bound, c_bound: number.\n"
    "83 mul, 129 add, 11 product error, 1 div, 5 abs, 1 less, 1 select.\n",
   1, 4, "", sincos_loops},
  {"sin", "()->(),()",
    "s = sin x, x in rad; |error of s| <= s_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, s, s_bound: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.\n",
   1, 2, "", sin_loops},
  {"cos", "()->(),()",
    "c = cos x, x in rad; |error of c| <= c_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, c, c_bound: number.\n"
    "83 mul, 128 add, 11 product error, 1 div, 4 abs, 1 less, 1 select.\n",
   1, 2, "", cos_loops},
  {"exp", "()->(),()",
    "y = e^x; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, y, y_bound: number.\n"
    "82 mul, 149 add, 14 product error, 5 power of two, 2 abs, 7 less, 1 equal, 9 select.\n",
   1, 2, "", exp_loops},
  {"tanh", "()->(),()",
    "y = tanh x; |error of y| <= y_bound unless inf or NaN.\n"
    "\n"
    "()->(),().  x, y, y_bound: number.\n"
    "92 mul, 175 add, 15 product error, 2 div, 2 power of two, 6 abs, 2 copysign, 5 less, 11\n"
    "select.\n",
   1, 2, "", tanh_loops},
  {"atan2", "(),()->(),()",
    "angle of the vector (x, y) to the x axis, in rad, from -π to π; |error of angle| <=\n"
    "angle_bound unless inf or NaN.\n"
    "\n"
    "(),()->(),().  y, x, angle, angle_bound: number.\n"
    "123 mul, 214 add, 21 product error, 2 div, 1 neg, 10 abs, 4 copysign, 13 less, 3 equal, 23\n"
    "select.\n",
   2, 2, "", atan2_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
