/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another.  An inf or NaN bound is an answer, "no
   statement", and what is not chosen may divide by 0: NumPy finds no floating-point flags and warns
   of nothing.  C callers of the kernels find the flags of all that is computed. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/exponential_certified.h"
#include <fenv.h>

/* (3)->(3,3),(3,3) */
OVER(SO3_exp_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_exp_certified(&v, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_exp_double)
LOOP(SO3_exp_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(SO3_exp_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_expf_certified(&v, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_exp_single)
LOOP(SO3_exp_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(SO3_exp)

/* (3,3)->(3),(3) */
OVER(SO3_log_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t vo;
    ksl_vec3_t vo_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_SO3_log_certified(&R, &vo, &vo_bound);
    STORE(vec3_double, &vo, 1, 2);
    STORE(vec3_double, &vo_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_log_double)
LOOP(SO3_log_double, 3, ANY, 72, 24, 24, 24, 8, 8, 8)

OVER(SO3_log_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t vo;
    ksl_vec3f_t vo_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_SO3_logf_certified(&R, &vo, &vo_bound);
    STORE(vec3_single, &vo, 1, 2);
    STORE(vec3_single, &vo_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_log_single)
LOOP(SO3_log_single, 3, ANY, 36, 12, 12, 12, 4, 4, 4)
LOOPS(SO3_log)

/* (3)->(3,3),(3,3) */
OVER(SO3_leftJacobian_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobian_certified(&v, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_leftJacobian_double)
LOOP(SO3_leftJacobian_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(SO3_leftJacobian_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianf_certified(&v, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_leftJacobian_single)
LOOP(SO3_leftJacobian_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(SO3_leftJacobian)

/* (3)->(3,3),(3,3) */
OVER(SO3_rightJacobian_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobian_certified(&v, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_rightJacobian_double)
LOOP(SO3_rightJacobian_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(SO3_rightJacobian_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianf_certified(&v, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_rightJacobian_single)
LOOP(SO3_rightJacobian_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(SO3_rightJacobian)

/* (3)->(3,3),(3,3) */
OVER(SO3_leftJacobianInverse_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobianInverse_certified(&v, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_leftJacobianInverse_double)
LOOP(SO3_leftJacobianInverse_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(SO3_leftJacobianInverse_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianInversef_certified(&v, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_leftJacobianInverse_single)
LOOP(SO3_leftJacobianInverse_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(SO3_leftJacobianInverse)

/* (3)->(3,3),(3,3) */
OVER(SO3_rightJacobianInverse_double) {
  POINTERS_3
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    ksl_mat3x3_t R_bound;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobianInverse_certified(&v, &R, &R_bound);
    STORE(mat3x3_double, &R, 1, 1);
    STORE(mat3x3_double, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_rightJacobianInverse_double)
LOOP(SO3_rightJacobianInverse_double, 3, ANY, 24, 72, 72, 8, 24, 8, 24, 8)

OVER(SO3_rightJacobianInverse_single) {
  POINTERS_3
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t R_bound;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianInversef_certified(&v, &R, &R_bound);
    STORE(mat3x3_single, &R, 1, 1);
    STORE(mat3x3_single, &R_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SO3_rightJacobianInverse_single)
LOOP(SO3_rightJacobianInverse_single, 3, ANY, 12, 36, 36, 4, 12, 4, 12, 4)
LOOPS(SO3_rightJacobianInverse)

/* (3,3)->(3,3),(3,3) */
OVER(mat3x3_orthonormalize_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t self;
    ksl_mat3x3_t self_bound;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_orthonormalize_certified(&self, &self_bound);
    STORE(mat3x3_double, &self, 1, 2);
    STORE(mat3x3_double, &self_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_orthonormalize_double)
LOOP(mat3x3_orthonormalize_double, 3, ANY, 72, 72, 72, 24, 8, 24, 8, 24, 8)

OVER(mat3x3_orthonormalize_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t self;
    ksl_mat3x3f_t self_bound;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_orthonormalize_certified(&self, &self_bound);
    STORE(mat3x3_single, &self, 1, 2);
    STORE(mat3x3_single, &self_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_orthonormalize_single)
LOOP(mat3x3_orthonormalize_single, 3, ANY, 36, 36, 36, 12, 4, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalize)

/* (3,3)->(3,3),(3,3) */
OVER(mat3x3_orthonormalized_double) {
  POINTERS_3
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    ksl_mat3x3_t Ro_bound;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_orthonormalized_certified(&R, &Ro, &Ro_bound);
    STORE(mat3x3_double, &Ro, 1, 2);
    STORE(mat3x3_double, &Ro_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_orthonormalized_double)
LOOP(mat3x3_orthonormalized_double, 3, ANY, 72, 72, 72, 24, 8, 24, 8, 24, 8)

OVER(mat3x3_orthonormalized_single) {
  POINTERS_3
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    ksl_mat3x3f_t Ro_bound;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_orthonormalized_certified(&R, &Ro, &Ro_bound);
    STORE(mat3x3_single, &Ro, 1, 2);
    STORE(mat3x3_single, &Ro_bound, 2, 4);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED(mat3x3_orthonormalized_single)
LOOP(mat3x3_orthonormalized_single, 3, ANY, 36, 36, 36, 12, 4, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalized)

/* (6)->(3,4),(3,4) */
OVER(SE3_exp_double) {
  POINTERS_3
  EACH {
    ksl_screw_t s;
    ksl_SE3_t D;
    ksl_SE3_t D_bound;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_exp_certified(&s, &D, &D_bound);
    STORE(SE3_double, &D, 1, 1);
    STORE(SE3_double, &D_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SE3_exp_double)
LOOP(SE3_exp_double, 3, ANY, 48, 96, 96, 8, 32, 8, 32, 8)

OVER(SE3_exp_single) {
  POINTERS_3
  EACH {
    ksl_screwf_t s;
    ksl_SE3f_t D;
    ksl_SE3f_t D_bound;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_exp_certified(&s, &D, &D_bound);
    STORE(SE3_single, &D, 1, 1);
    STORE(SE3_single, &D_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SE3_exp_single)
LOOP(SE3_exp_single, 3, ANY, 24, 48, 48, 4, 16, 4, 16, 4)
LOOPS(SE3_exp)

/* (3,4)->(6),(6) */
OVER(SE3_log_double) {
  POINTERS_3
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    ksl_screw_t so_bound;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_log_certified(&D, &so, &so_bound);
    STORE(screw_double, &so, 1, 2);
    STORE(screw_double, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SE3_log_double)
LOOP(SE3_log_double, 3, ANY, 96, 48, 48, 32, 8, 8, 8)

OVER(SE3_log_single) {
  POINTERS_3
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    ksl_screwf_t so_bound;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_log_certified(&D, &so, &so_bound);
    STORE(screw_single, &so, 1, 2);
    STORE(screw_single, &so_bound, 2, 3);
  }
  feclearexcept(FE_ALL_EXCEPT);
}
STRIDED_WITH_FMA(SE3_log_single)
LOOP(SE3_log_single, 3, ANY, 48, 24, 24, 16, 4, 4, 4)
LOOPS(SE3_log)

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_exp", "(3)->(3,3),(3,3)",
    "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|; |error of R| <= R_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "336 mul, 494 add, 17 product error, 22 product rest, 12 div, 3 sqrt, 51 abs, 14 less, 1\n"
    "equal, 29 select.\n",
   1, 2, "", SO3_exp_loops},
  {"SO3_log", "(3,3)->(3),(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo;\n"
    "|error of vo| <= vo_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3),(3).  R: rotation or other 3×3 matrix; vo, vo_bound: vector.\n"
    "244 mul, 466 add, 26 product error, 3 product rest, 16 div, 2 sqrt, 10 neg, 72 abs, 4\n"
    "copysign, 41 less, 7 equal, 107 select.\n",
   1, 2, "R", SO3_log_loops},
  {"SO3_leftJacobian", "(3)->(3,3),(3,3)",
    "R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 90 abs, 20 less, 1\n"
    "equal, 45 select.\n",
   1, 2, "", SO3_leftJacobian_loops},
  {"SO3_rightJacobian", "(3)->(3,3),(3,3)",
    "R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|; |error of R| <= R_bound\n"
    "unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "433 mul, 747 add, 21 product error, 43 product rest, 16 div, 3 sqrt, 12 neg, 90 abs, 20\n"
    "less, 1 equal, 45 select.\n",
   1, 2, "", SO3_rightJacobian_loops},
  {"SO3_leftJacobianInverse", "(3)->(3,3),(3,3)",
    "R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 6 neg, 93 abs, 23 less,\n"
    "1 equal, 47 select.\n",
   1, 2, "", SO3_leftJacobianInverse_loops},
  {"SO3_rightJacobianInverse", "(3)->(3,3),(3,3)",
    "R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0; |error of R| <= R_bound unless inf or NaN.\n"
    "\n"
    "(3)->(3,3),(3,3).  v: vector; R, R_bound: rotation or other 3×3 matrix.\n"
    "420 mul, 746 add, 23 product error, 34 product rest, 23 div, 3 sqrt, 93 abs, 23 less, 1\n"
    "equal, 47 select.\n",
   1, 2, "", SO3_rightJacobianInverse_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3),(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "self| <= self_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  self, self_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, "", mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3),(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2; |error of\n"
    "Ro| <= Ro_bound unless inf or NaN.\n"
    "\n"
    "(3,3)->(3,3),(3,3).  R, Ro, Ro_bound: rotation or other 3×3 matrix.\n"
    "93 mul, 105 add, 3 neg, 27 abs.\n",
   1, 2, "", mat3x3_orthonormalized_loops},
  {"SE3_exp", "(6)->(3,4),(3,4)",
    "D = exp s = [exp ω~ | J_l(ω) v]; |error of D| <= D_bound unless inf or NaN.\n"
    "\n"
    "(6)->(3,4),(3,4).  s: screw (v in m/s; ω in rad/s); D, D_bound: displacement [R | t], R\n"
    "rotation, t in m.\n"
    "524 mul, 876 add, 24 product error, 58 product rest, 16 div, 3 sqrt, 102 abs, 20 less, 1\n"
    "equal, 46 select.\n",
   1, 2, "", SE3_exp_loops},
  {"SE3_log", "(3,4)->(6),(6)",
    "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R; |error of so| <= so_bound unless\n"
    "inf or NaN.\n"
    "\n"
    "(3,4)->(6),(6).  D: displacement [R | t], R rotation, t in m; so, so_bound: screw (v in m/s;\n"
    "ω in rad/s).\n"
    "599 mul, 986 add, 36 product error, 36 product rest, 47 div, 5 sqrt, 15 neg, 155 abs, 6\n"
    "copysign, 72 less, 10 equal, 171 select.\n",
   1, 2, "R", SE3_log_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
