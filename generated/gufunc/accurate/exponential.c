/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the exponential operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../../c/include/ksl/exponential_accurate.h"

/* (3)->(3,3) */
OVER(SO3_exp_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_exp_accurate(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(SO3_exp_double)
LOOP(SO3_exp_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_exp_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_expf_accurate(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_exp_single)
LOOP(SO3_exp_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_exp)

/* (3,3)->(3) */
OVER(SO3_log_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_vec3_t vo;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_SO3_log_accurate(&R, &vo);
    STORE(vec3_double, &vo, 1, 2);
  }
}
STRIDED_WITH_FMA(SO3_log_double)
LOOP(SO3_log_double, 2, ANY, 72, 24, 24, 8, 8)

OVER(SO3_log_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_vec3f_t vo;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_SO3_logf_accurate(&R, &vo);
    STORE(vec3_single, &vo, 1, 2);
  }
}
STRIDED(SO3_log_single)
LOOP(SO3_log_single, 2, DENSE, 36, 12, 12, 4, 4)
LOOPS(SO3_log)

/* (3)->(3,3) */
OVER(SO3_leftJacobian_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobian_accurate(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(SO3_leftJacobian_double)
LOOP(SO3_leftJacobian_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_leftJacobian_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianf_accurate(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobian_single)
LOOP(SO3_leftJacobian_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_leftJacobian)

/* (3)->(3,3) */
OVER(SO3_rightJacobian_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobian_accurate(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(SO3_rightJacobian_double)
LOOP(SO3_rightJacobian_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_rightJacobian_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianf_accurate(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobian_single)
LOOP(SO3_rightJacobian_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_rightJacobian)

/* (3)->(3,3) */
OVER(SO3_leftJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_leftJacobianInverse_accurate(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(SO3_leftJacobianInverse_double)
LOOP(SO3_leftJacobianInverse_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_leftJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_leftJacobianInversef_accurate(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_leftJacobianInverse_single)
LOOP(SO3_leftJacobianInverse_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_leftJacobianInverse)

/* (3)->(3,3) */
OVER(SO3_rightJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_vec3_t v;
    ksl_mat3x3_t R;
    LOAD(vec3_double, &v, 0, 0);
    ksl_SO3_rightJacobianInverse_accurate(&v, &R);
    STORE(mat3x3_double, &R, 1, 1);
  }
}
STRIDED_WITH_FMA(SO3_rightJacobianInverse_double)
LOOP(SO3_rightJacobianInverse_double, 2, ANY, 24, 72, 8, 24, 8)

OVER(SO3_rightJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_vec3f_t v;
    ksl_mat3x3f_t R;
    LOAD(vec3_single, &v, 0, 0);
    ksl_SO3_rightJacobianInversef_accurate(&v, &R);
    STORE(mat3x3_single, &R, 1, 1);
  }
}
STRIDED(SO3_rightJacobianInverse_single)
LOOP(SO3_rightJacobianInverse_single, 2, DENSE, 12, 36, 4, 12, 4)
LOOPS(SO3_rightJacobianInverse)

/* (3,3)->(3,3) */
OVER(mat3x3_orthonormalize_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t self;
    LOAD(mat3x3_double, &self, 0, 0);
    ksl_mat3x3_orthonormalize_accurate(&self);
    STORE(mat3x3_double, &self, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_orthonormalize_double)
LOOP(mat3x3_orthonormalize_double, 2, ANY, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_orthonormalize_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t self;
    LOAD(mat3x3_single, &self, 0, 0);
    ksl_mat3x3f_orthonormalize_accurate(&self);
    STORE(mat3x3_single, &self, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalize_single)
LOOP(mat3x3_orthonormalize_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalize)

/* (3,3)->(3,3) */
OVER(mat3x3_orthonormalized_double) {
  POINTERS_2
  EACH {
    ksl_mat3x3_t R;
    ksl_mat3x3_t Ro;
    LOAD(mat3x3_double, &R, 0, 0);
    ksl_mat3x3_orthonormalized_accurate(&R, &Ro);
    STORE(mat3x3_double, &Ro, 1, 2);
  }
}
STRIDED_WITH_FMA(mat3x3_orthonormalized_double)
LOOP(mat3x3_orthonormalized_double, 2, ANY, 72, 72, 24, 8, 24, 8)

OVER(mat3x3_orthonormalized_single) {
  POINTERS_2
  EACH {
    ksl_mat3x3f_t R;
    ksl_mat3x3f_t Ro;
    LOAD(mat3x3_single, &R, 0, 0);
    ksl_mat3x3f_orthonormalized_accurate(&R, &Ro);
    STORE(mat3x3_single, &Ro, 1, 2);
  }
}
STRIDED(mat3x3_orthonormalized_single)
LOOP(mat3x3_orthonormalized_single, 2, DENSE, 36, 36, 12, 4, 12, 4)
LOOPS(mat3x3_orthonormalized)

/* (6)->(3,4) */
OVER(SE3_exp_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_SE3_t D;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_exp_accurate(&s, &D);
    STORE(SE3_double, &D, 1, 1);
  }
}
STRIDED_WITH_FMA(SE3_exp_double)
LOOP(SE3_exp_double, 2, ANY, 48, 96, 8, 32, 8)

OVER(SE3_exp_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_SE3f_t D;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_exp_accurate(&s, &D);
    STORE(SE3_single, &D, 1, 1);
  }
}
STRIDED(SE3_exp_single)
LOOP(SE3_exp_single, 2, DENSE, 24, 48, 4, 16, 4)
LOOPS(SE3_exp)

/* (3,4)->(6) */
OVER(SE3_log_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_screw_t so;
    LOAD(SE3_double, &D, 0, 0);
    ksl_SE3_log_accurate(&D, &so);
    STORE(screw_double, &so, 1, 2);
  }
}
STRIDED_WITH_FMA(SE3_log_double)
LOOP(SE3_log_double, 2, ANY, 96, 48, 32, 8, 8)

OVER(SE3_log_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_screwf_t so;
    LOAD(SE3_single, &D, 0, 0);
    ksl_SE3f_log_accurate(&D, &so);
    STORE(screw_single, &so, 1, 2);
  }
}
STRIDED(SE3_log_single)
LOOP(SE3_log_single, 2, ANY, 48, 24, 16, 4, 4)
LOOPS(SE3_log)

/* (6)->(6,6) */
OVER(SE3_leftJacobian_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_leftJacobian_accurate(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED_WITH_FMA(SE3_leftJacobian_double)
LOOP(SE3_leftJacobian_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_leftJacobian_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_leftJacobian_accurate(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobian_single)
LOOP(SE3_leftJacobian_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_leftJacobian)

/* (6)->(6,6) */
OVER(SE3_rightJacobian_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_rightJacobian_accurate(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED_WITH_FMA(SE3_rightJacobian_double)
LOOP(SE3_rightJacobian_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_rightJacobian_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_rightJacobian_accurate(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobian_single)
LOOP(SE3_rightJacobian_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_rightJacobian)

/* (6)->(6,6) */
OVER(SE3_leftJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_leftJacobianInverse_accurate(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED_WITH_FMA(SE3_leftJacobianInverse_double)
LOOP(SE3_leftJacobianInverse_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_leftJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_leftJacobianInverse_accurate(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_leftJacobianInverse_single)
LOOP(SE3_leftJacobianInverse_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_leftJacobianInverse)

/* (6)->(6,6) */
OVER(SE3_rightJacobianInverse_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_SE3_rightJacobianInverse_accurate(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED_WITH_FMA(SE3_rightJacobianInverse_double)
LOOP(SE3_rightJacobianInverse_double, 2, ANY, 48, 288, 8, 48, 8)

OVER(SE3_rightJacobianInverse_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_SE3f_rightJacobianInverse_accurate(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(SE3_rightJacobianInverse_single)
LOOP(SE3_rightJacobianInverse_single, 2, ANY, 24, 144, 4, 24, 4)
LOOPS(SE3_rightJacobianInverse)

/* (3,4),(3,4),()->(3,4) */
OVER(SE3_interpolated_double) {
  POINTERS_4
  LOAD_FIRST(SE3_double, ksl_SE3_t D1, &D1);
  EACH {
    ksl_SE3_t D2;
    double k;
    ksl_SE3_t Do;
    LOAD_OTHER(SE3_double, &D1);
    LOAD(SE3_double, &D2, 1, 2);
    LOAD(scalar_double, &k, 2, 4);
    ksl_SE3_interpolated_accurate(&D1, &D2, k, &Do);
    STORE(SE3_double, &Do, 3, 4);
  }
}
STRIDED_WITH_FMA(SE3_interpolated_double)
LOOP(SE3_interpolated_double, 4, ANY, 96, 96, 8, 96, 32, 8, 32, 8, 32, 8)

OVER(SE3_interpolated_single) {
  POINTERS_4
  LOAD_FIRST(SE3_single, ksl_SE3f_t D1, &D1);
  EACH {
    ksl_SE3f_t D2;
    float k;
    ksl_SE3f_t Do;
    LOAD_OTHER(SE3_single, &D1);
    LOAD(SE3_single, &D2, 1, 2);
    LOAD(scalar_single, &k, 2, 4);
    ksl_SE3f_interpolated_accurate(&D1, &D2, k, &Do);
    STORE(SE3_single, &Do, 3, 4);
  }
}
STRIDED(SE3_interpolated_single)
LOOP(SE3_interpolated_single, 4, DENSE_OR_ONE, 48, 48, 4, 48, 16, 4, 16, 4, 16, 4)
LOOPS(SE3_interpolated)

const coscrew_gufunc TABLE(exponential)[] = {
  {"SO3_exp", "(3)->(3,3)",
    "R = exp v~ = I + sin θ/θ v~ + (1 - cos θ)/θ^2 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "178 mul, 320 add, 17 product error, 22 product rest, 5 div, 1 sqrt, 7 abs, 6 less, 10 equal,\n"
    "19 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision\n"
    "1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "", SO3_exp_loops},
  {"SO3_log", "(3,3)->(3)",
    "vo with exp vo~ = R, |vo| <= π; if R is not quite a rotation, its defect carries over to vo.\n"
    "\n"
    "(3,3)->(3).  R: rotation or other 3×3 matrix; vo: vector.\n"
    "162 mul, 433 add, 26 product error, 3 product rest, 10 div, 1 sqrt, 13 neg, 13 abs, 4\n"
    "copysign, 29 less, 9 equal, 77 select.  Error <= vo: 1 u of its largest component for R a\n"
    "rotation; searched, not proved.  Each component is within 1 ulp as long as its condition is\n"
    "below 1e13; in single precision it is the nearest number, except near ties, as long as that\n"
    "is below 1e5; searched, not proved.\n",
   1, 1, "R", SO3_log_loops},
  {"SO3_leftJacobian", "(3)->(3,3)",
    "R = J_l(v) = I + (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 10 equal,\n"
    "25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single precision\n"
    "1e5; searched, not proved.  Each component is within 1 ulp as long as its condition is below\n"
    "1e13; in single precision it is the nearest number, except near ties, as long as that is\n"
    "below 1e5; searched, not proved.\n",
   1, 1, "", SO3_leftJacobian_loops},
  {"SO3_rightJacobian", "(3)->(3,3)",
    "R = J_r(v) = I - (1 - cos θ)/θ^2 v~ + (θ - sin θ)/θ^3 v~^2, θ = |v|.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 471 add, 21 product error, 43 product rest, 6 div, 1 sqrt, 9 neg, 4 abs, 6 less, 10\n"
    "equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= 1e13, in single\n"
    "precision 1e5; searched, not proved.  Each component is within 1 ulp as long as its\n"
    "condition is below 1e13; in single precision it is the nearest number, except near ties, as\n"
    "long as that is below 1e5; searched, not proved.\n",
   1, 1, "", SO3_rightJacobian_loops},
  {"SO3_leftJacobianInverse", "(3)->(3,3)",
    "R = J_l(v)^-1 = I - v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,\n"
    "10 equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not\n"
    "proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", SO3_leftJacobianInverse_loops},
  {"SO3_rightJacobianInverse", "(3)->(3,3)",
    "R = J_r(v)^-1 = I + v~/2 + (1 - θ/2 cot θ/2)/θ^2 v~^2, θ = |v|; singular at multiples of 2π\n"
    "except 0.\n"
    "\n"
    "(3)->(3,3).  v: vector; R: rotation or other 3×3 matrix.\n"
    "208 mul, 502 add, 23 product error, 34 product rest, 10 div, 1 sqrt, 4 abs, 6 less, 10\n"
    "equal, 25 select.  Error <= R: 1 u of its largest component for |v| <= π; searched, not\n"
    "proved.  Each component is within 1 ulp as long as its condition is below 1e13; in single\n"
    "precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.\n",
   1, 1, "", SO3_rightJacobianInverse_loops},
  {"mat3x3_orthonormalize", "(3,3)->(3,3)",
    "self = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  self: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalize_loops},
  {"mat3x3_orthonormalized", "(3,3)->(3,3)",
    "Ro = R + R (I - R^T R)/2, closer to a rotation: a defect d of R becomes 3/4 d^2.\n"
    "\n"
    "(3,3)->(3,3).  R, Ro: rotation or other 3×3 matrix.\n"
    "84 mul, 288 add, 45 product rest, 6 neg.  Error <= u |result| + 44 u^2 S, S the sum of the\n"
    "|terms| of the expanded formula; barring over- and underflow.\n",
   1, 1, "", mat3x3_orthonormalized_loops},
  {"SE3_exp", "(6)->(3,4)",
    "D = exp s = [exp ω~ | J_l(ω) v].\n"
    "\n"
    "(6)->(3,4).  s: screw (v in m/s; ω in rad/s); D: displacement [R | t], R rotation, t in m.\n"
    "246 mul, 553 add, 24 product error, 58 product rest, 6 div, 1 sqrt, 4 abs, 6 less, 13 equal,\n"
    "28 select.  Error <= R: 1 u, t: 1 u of its largest component, or of s.lin if that is larger,\n"
    "for |ω of s| <= 1e13, in single precision 1e5; searched, not proved.  Each component is\n"
    "within 1 ulp as long as its condition is below 1e13; in single precision it is the nearest\n"
    "number, except near ties, as long as that is below 1e5; searched, not proved.  Intermediate\n"
    "sums may overflow where |v|, or |ω| |v|, is above 2e306, in single precision 5e36.\n",
   1, 1, "", SE3_exp_loops},
  {"SE3_log", "(3,4)->(6)",
    "so with exp so = D, |ω| <= π: (J_l(ω)^-1 t; ω), ω = log R.\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).\n"
    "285 mul, 748 add, 36 product error, 36 product rest, 23 div, 2 sqrt, 12 neg, 14 abs, 4\n"
    "copysign, 32 less, 13 equal, 88 select.  Error <= lin: 1 u, ang: 1 u of its largest\n"
    "component for R of D a rotation; searched, not proved.  Each component is within 1 ulp as\n"
    "long as its condition is below 1e13; in single precision it is the nearest number, except\n"
    "near ties, as long as that is below 1e5; searched, not proved.  Intermediate sums may\n"
    "overflow where |t| is above 2e306, in single precision 5e36.\n",
   1, 1, "R", SE3_log_loops},
  {"SE3_leftJacobian", "(6)->(6,6)",
    "M = J_l(s) = Σ ([ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 3 neg, 4 abs, 6 less,\n"
    "19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_leftJacobian_loops},
  {"SE3_rightJacobian", "(6)->(6,6)",
    "M = J_r(s) = Σ (-[ad](s))^k / (k+1)!.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "321 mul, 819 add, 31 product error, 87 product rest, 10 div, 1 sqrt, 36 neg, 4 abs, 6 less,\n"
    "19 equal, 38 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_rightJacobian_loops},
  {"SE3_leftJacobianInverse", "(6)->(6,6)",
    "M = J_l(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 9 neg, 4 abs, 6 less,\n"
    "19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_leftJacobianInverse_loops},
  {"SE3_rightJacobianInverse", "(6)->(6,6)",
    "M = J_r(s)^-1; singular where |ω| is a multiple of 2π except 0.\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "283 mul, 721 add, 34 product error, 60 product rest, 14 div, 1 sqrt, 21 neg, 4 abs, 6 less,\n"
    "19 equal, 36 select.  Error <= M: 1 u of its largest component for |ω of s| <= π; searched,\n"
    "not proved.  Each component is within 1 ulp as long as its condition is below 1e13; in\n"
    "single precision it is the nearest number, except near ties, as long as that is below 1e5;\n"
    "searched, not proved.  Intermediate sums may overflow where |v| is above 2e306, in single\n"
    "precision 5e36.\n",
   1, 1, "", SE3_rightJacobianInverse_loops},
  {"SE3_interpolated", "(3,4),(3,4),()->(3,4)",
    "Do = D1 exp(k log(D1^-1 D2)), the screw motion from D1 at k = 0 to D2 at k = 1.\n"
    "\n"
    "(3,4),(3,4),()->(3,4).  D1, D2, Do: displacement [R | t], R rotation, t in m; k: number.\n"
    "717 mul, 1706 add, 66 product error, 166 product rest, 29 div, 3 sqrt, 13 neg, 18 abs, 4\n"
    "copysign, 38 less, 20 equal, 110 select.  Error <= R: 1 u, t: 1 u of its largest component,\n"
    "or of D1.t or D2.t if that is larger, for R of D1 a rotation and R of D2 a rotation and 0 <=\n"
    "k <= 1; searched, not proved.  Each component is within 1 ulp as long as its condition is\n"
    "below 1e13; in single precision it is the nearest number, except near ties, as long as that\n"
    "is below 1e5; searched, not proved.  Intermediate sums may overflow where |t| of D1 or D2 is\n"
    "above 2e306, in single precision 5e36.\n",
   3, 1, "RR.", SE3_interpolated_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
