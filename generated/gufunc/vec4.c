/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the vec4 operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/vec4.h"

/* (4)->(4) */
OVER(vec4_copy_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t vi;
    ksl_vec4_t vo;
    LOAD(vec4_double, &vi, 0, 0);
    ksl_vec4_copy(&vi, &vo);
    STORE(vec4_double, &vo, 1, 1);
  }
}
STRIDED(vec4_copy_double)
LOOP(vec4_copy_double, 2, DENSE, 32, 32, 8, 8)

OVER(vec4_copy_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t vi;
    ksl_vec4f_t vo;
    LOAD(vec4_single, &vi, 0, 0);
    ksl_vec4f_copy(&vi, &vo);
    STORE(vec4_single, &vo, 1, 1);
  }
}
STRIDED(vec4_copy_single)
LOOP(vec4_copy_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(vec4_copy)

/* (4),()->(4) */
OVER(vec4_scale_double) {
  POINTERS_3
  EACH {
    ksl_vec4_t self;
    double a;
    LOAD(vec4_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_vec4_scale(&self, a);
    STORE(vec4_double, &self, 2, 1);
  }
}
STRIDED(vec4_scale_double)
LOOP(vec4_scale_double, 3, DENSE, 32, 8, 32, 8, 8)

OVER(vec4_scale_single) {
  POINTERS_3
  EACH {
    ksl_vec4f_t self;
    float a;
    LOAD(vec4_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_vec4f_scale(&self, a);
    STORE(vec4_single, &self, 2, 1);
  }
}
STRIDED(vec4_scale_single)
LOOP(vec4_scale_single, 3, DENSE, 16, 4, 16, 4, 4)
LOOPS(vec4_scale)

/* (4)->(4) */
OVER(vec4_inverted_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t vi;
    ksl_vec4_t vo;
    LOAD(vec4_double, &vi, 0, 0);
    ksl_vec4_inverted(&vi, &vo);
    STORE(vec4_double, &vo, 1, 1);
  }
}
STRIDED(vec4_inverted_double)
LOOP(vec4_inverted_double, 2, DENSE, 32, 32, 8, 8)

OVER(vec4_inverted_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t vi;
    ksl_vec4f_t vo;
    LOAD(vec4_single, &vi, 0, 0);
    ksl_vec4f_inverted(&vi, &vo);
    STORE(vec4_single, &vo, 1, 1);
  }
}
STRIDED(vec4_inverted_single)
LOOP(vec4_inverted_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(vec4_inverted)

/* (4)->(4) */
OVER(vec4_invert_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t self;
    LOAD(vec4_double, &self, 0, 0);
    ksl_vec4_invert(&self);
    STORE(vec4_double, &self, 1, 1);
  }
}
STRIDED(vec4_invert_double)
LOOP(vec4_invert_double, 2, DENSE, 32, 32, 8, 8)

OVER(vec4_invert_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t self;
    LOAD(vec4_single, &self, 0, 0);
    ksl_vec4f_invert(&self);
    STORE(vec4_single, &self, 1, 1);
  }
}
STRIDED(vec4_invert_single)
LOOP(vec4_invert_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(vec4_invert)

/* (4),()->(4) */
OVER(vec4_scaled_double) {
  POINTERS_3
  LOAD_FIRST(vec4_double, ksl_vec4_t v, &v);
  EACH {
    double k;
    ksl_vec4_t vo;
    LOAD_OTHER(vec4_double, &v);
    LOAD(scalar_double, &k, 1, 1);
    ksl_vec4_scaled(&v, k, &vo);
    STORE(vec4_double, &vo, 2, 1);
  }
}
STRIDED(vec4_scaled_double)
LOOP(vec4_scaled_double, 3, DENSE_OR_ONE, 32, 8, 32, 8, 8)

OVER(vec4_scaled_single) {
  POINTERS_3
  LOAD_FIRST(vec4_single, ksl_vec4f_t v, &v);
  EACH {
    float k;
    ksl_vec4f_t vo;
    LOAD_OTHER(vec4_single, &v);
    LOAD(scalar_single, &k, 1, 1);
    ksl_vec4f_scaled(&v, k, &vo);
    STORE(vec4_single, &vo, 2, 1);
  }
}
STRIDED(vec4_scaled_single)
LOOP(vec4_scaled_single, 3, DENSE_OR_ONE, 16, 4, 16, 4, 4)
LOOPS(vec4_scaled)

/* (4),(4)->(4),(4) */
OVER(vec4_swap_double) {
  POINTERS_4
  EACH {
    ksl_vec4_t v1;
    ksl_vec4_t v2;
    LOAD(vec4_double, &v1, 0, 0);
    LOAD(vec4_double, &v2, 1, 1);
    ksl_vec4_swap(&v1, &v2);
    STORE(vec4_double, &v1, 2, 2);
    STORE(vec4_double, &v2, 3, 3);
  }
}
STRIDED(vec4_swap_double)
LOOP(vec4_swap_double, 4, DENSE, 32, 32, 32, 32, 8, 8, 8, 8)

OVER(vec4_swap_single) {
  POINTERS_4
  EACH {
    ksl_vec4f_t v1;
    ksl_vec4f_t v2;
    LOAD(vec4_single, &v1, 0, 0);
    LOAD(vec4_single, &v2, 1, 1);
    ksl_vec4f_swap(&v1, &v2);
    STORE(vec4_single, &v1, 2, 2);
    STORE(vec4_single, &v2, 3, 3);
  }
}
STRIDED(vec4_swap_single)
LOOP(vec4_swap_single, 4, DENSE, 16, 16, 16, 16, 4, 4, 4, 4)
LOOPS(vec4_swap)

/* (4)->() */
OVER(vec4_l2norm_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t v;
    double norm;
    LOAD(vec4_double, &v, 0, 0);
    norm = ksl_vec4_l2norm(&v);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED(vec4_l2norm_double)
LOOP(vec4_l2norm_double, 2, DENSE, 32, 8, 8)

OVER(vec4_l2norm_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t v;
    float norm;
    LOAD(vec4_single, &v, 0, 0);
    norm = ksl_vec4f_l2norm(&v);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(vec4_l2norm_single)
LOOP(vec4_l2norm_single, 2, DENSE, 16, 4, 4)
LOOPS(vec4_l2norm)

/* (4)->(4) */
OVER(vec4_normalize_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t self;
    LOAD(vec4_double, &self, 0, 0);
    ksl_vec4_normalize(&self);
    STORE(vec4_double, &self, 1, 1);
  }
}
STRIDED(vec4_normalize_double)
LOOP(vec4_normalize_double, 2, DENSE, 32, 32, 8, 8)

OVER(vec4_normalize_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t self;
    LOAD(vec4_single, &self, 0, 0);
    ksl_vec4f_normalize(&self);
    STORE(vec4_single, &self, 1, 1);
  }
}
STRIDED(vec4_normalize_single)
LOOP(vec4_normalize_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(vec4_normalize)

/* (4)->(4) */
OVER(vec4_normalized_double) {
  POINTERS_2
  EACH {
    ksl_vec4_t v;
    ksl_vec4_t vo;
    LOAD(vec4_double, &v, 0, 0);
    ksl_vec4_normalized(&v, &vo);
    STORE(vec4_double, &vo, 1, 1);
  }
}
STRIDED(vec4_normalized_double)
LOOP(vec4_normalized_double, 2, DENSE, 32, 32, 8, 8)

OVER(vec4_normalized_single) {
  POINTERS_2
  EACH {
    ksl_vec4f_t v;
    ksl_vec4f_t vo;
    LOAD(vec4_single, &v, 0, 0);
    ksl_vec4f_normalized(&v, &vo);
    STORE(vec4_single, &vo, 1, 1);
  }
}
STRIDED(vec4_normalized_single)
LOOP(vec4_normalized_single, 2, DENSE, 16, 16, 4, 4)
LOOPS(vec4_normalized)

const coscrew_gufunc TABLE(vec4)[] = {
  {"vec4_copy", "(4)->(4)",
    "vo = vi.\n"
    "\n"
    "(4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", vec4_copy_loops},
  {"vec4_scale", "(4),()->(4)",
    "self = a self.\n"
    "\n"
    "(4),()->(4).  self: vector (x, y, z) and a homogeneous coordinate w; a: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec4_scale_loops},
  {"vec4_inverted", "(4)->(4)",
    "vo = -vi.\n"
    "\n"
    "(4)->(4).  vi, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "4 neg.  Exact.\n",
   1, 1, "", vec4_inverted_loops},
  {"vec4_invert", "(4)->(4)",
    "self = -self.\n"
    "\n"
    "(4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.\n"
    "4 neg.  Exact.\n",
   1, 1, "", vec4_invert_loops},
  {"vec4_scaled", "(4),()->(4)",
    "vo = k v.\n"
    "\n"
    "(4),()->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w; k: number.\n"
    "4 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", vec4_scaled_loops},
  {"vec4_swap", "(4),(4)->(4),(4)",
    "v1, v2 = v2, v1.\n"
    "\n"
    "(4),(4)->(4),(4).  v1, v2: vector (x, y, z) and a homogeneous coordinate w.\n"
    "No arithmetic.  Exact.\n",
   2, 2, "", vec4_swap_loops},
  {"vec4_l2norm", "(4)->()",
    "|v| = sqrt(v·v), all four components.\n"
    "\n"
    "(4)->().  v: vector (x, y, z) and a homogeneous coordinate w; norm: number.\n"
    "9 mul, 3 add, 1 sqrt, 4 abs, 9 less, 9 select.\n",
   1, 1, "", vec4_l2norm_loops},
  {"vec4_normalize", "(4)->(4)",
    "self = self / |self|; the zero vector stays zero.\n"
    "\n"
    "(4)->(4).  self: vector (x, y, z) and a homogeneous coordinate w.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", vec4_normalize_loops},
  {"vec4_normalized", "(4)->(4)",
    "vo = v / |v|; the zero vector stays zero.\n"
    "\n"
    "(4)->(4).  v, vo: vector (x, y, z) and a homogeneous coordinate w.\n"
    "16 mul, 3 add, 4 div, 1 sqrt, 4 abs, 8 less, 1 equal, 9 select.\n",
   1, 1, "", vec4_normalized_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
