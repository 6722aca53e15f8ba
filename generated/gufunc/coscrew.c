/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Gufunc loops of the coscrew operations.  NumPy copies operands that overlap, except outputs
   identical to an input; so no element depends on another. */
#define NO_IMPORT_UFUNC
#define NO_IMPORT_ARRAY
#include "_gufunc.h"
#include "../c/include/ksl/coscrew.h"

/* (6)->(6) */
OVER(coscrew_copy_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD(coscrew_double, &ci, 0, 0);
    ksl_coscrew_copy(&ci, &co);
    STORE(coscrew_double, &co, 1, 1);
  }
}
STRIDED(coscrew_copy_double)
LOOP(coscrew_copy_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_copy_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD(coscrew_single, &ci, 0, 0);
    ksl_coscrewf_copy(&ci, &co);
    STORE(coscrew_single, &co, 1, 1);
  }
}
STRIDED(coscrew_copy_single)
LOOP(coscrew_copy_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_copy)

/* (6),()->(6) */
OVER(coscrew_scale_double) {
  POINTERS_3
  EACH {
    ksl_coscrew_t self;
    double a;
    LOAD(coscrew_double, &self, 0, 0);
    LOAD(scalar_double, &a, 1, 1);
    ksl_coscrew_scale(&self, a);
    STORE(coscrew_double, &self, 2, 1);
  }
}
STRIDED(coscrew_scale_double)
LOOP(coscrew_scale_double, 3, DENSE, 48, 8, 48, 8, 8)

OVER(coscrew_scale_single) {
  POINTERS_3
  EACH {
    ksl_coscrewf_t self;
    float a;
    LOAD(coscrew_single, &self, 0, 0);
    LOAD(scalar_single, &a, 1, 1);
    ksl_coscrewf_scale(&self, a);
    STORE(coscrew_single, &self, 2, 1);
  }
}
STRIDED(coscrew_scale_single)
LOOP(coscrew_scale_single, 3, DENSE, 24, 4, 24, 4, 4)
LOOPS(coscrew_scale)

/* (6)->(6) */
OVER(coscrew_inverted_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD(coscrew_double, &ci, 0, 0);
    ksl_coscrew_inverted(&ci, &co);
    STORE(coscrew_double, &co, 1, 1);
  }
}
STRIDED(coscrew_inverted_double)
LOOP(coscrew_inverted_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_inverted_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD(coscrew_single, &ci, 0, 0);
    ksl_coscrewf_inverted(&ci, &co);
    STORE(coscrew_single, &co, 1, 1);
  }
}
STRIDED(coscrew_inverted_single)
LOOP(coscrew_inverted_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_inverted)

/* (6)->(6) */
OVER(coscrew_invert_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t self;
    LOAD(coscrew_double, &self, 0, 0);
    ksl_coscrew_invert(&self);
    STORE(coscrew_double, &self, 1, 1);
  }
}
STRIDED(coscrew_invert_double)
LOOP(coscrew_invert_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_invert_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t self;
    LOAD(coscrew_single, &self, 0, 0);
    ksl_coscrewf_invert(&self);
    STORE(coscrew_single, &self, 1, 1);
  }
}
STRIDED(coscrew_invert_single)
LOOP(coscrew_invert_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_invert)

/* (),(6),(6)->(6) */
OVER(axpy_cc_double) {
  POINTERS_4
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t x;
    ksl_coscrew_t y;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &x, 1, 0);
    LOAD(coscrew_double, &y, 2, 1);
    ksl_axpy_cc(a, &x, &y);
    STORE(coscrew_double, &y, 3, 2);
  }
}
STRIDED(axpy_cc_double)
LOOP(axpy_cc_double, 4, DENSE_OR_ONE, 8, 48, 48, 48, 8, 8, 8)

OVER(axpy_cc_single) {
  POINTERS_4
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t x;
    ksl_coscrewf_t y;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &x, 1, 0);
    LOAD(coscrew_single, &y, 2, 1);
    ksl_axpy_ccf(a, &x, &y);
    STORE(coscrew_single, &y, 3, 2);
  }
}
STRIDED(axpy_cc_single)
LOOP(axpy_cc_single, 4, DENSE_OR_ONE, 4, 24, 24, 24, 4, 4, 4)
LOOPS(axpy_cc)

/* (6),(6)->(6) */
OVER(xpy_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_xpy_cc(&x, &y);
    STORE(coscrew_double, &y, 2, 2);
  }
}
STRIDED(xpy_cc_double)
LOOP(xpy_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(xpy_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_xpy_ccf(&x, &y);
    STORE(coscrew_single, &y, 2, 2);
  }
}
STRIDED(xpy_cc_single)
LOOP(xpy_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(xpy_cc)

/* (6),(6)->(6) */
OVER(nxpy_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t x, &x);
  EACH {
    ksl_coscrew_t y;
    LOAD_OTHER(coscrew_double, &x);
    LOAD(coscrew_double, &y, 1, 1);
    ksl_nxpy_cc(&x, &y);
    STORE(coscrew_double, &y, 2, 2);
  }
}
STRIDED(nxpy_cc_double)
LOOP(nxpy_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(nxpy_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t x, &x);
  EACH {
    ksl_coscrewf_t y;
    LOAD_OTHER(coscrew_single, &x);
    LOAD(coscrew_single, &y, 1, 1);
    ksl_nxpy_ccf(&x, &y);
    STORE(coscrew_single, &y, 2, 2);
  }
}
STRIDED(nxpy_cc_single)
LOOP(nxpy_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(nxpy_cc)

/* (),(6)->(6) */
OVER(product_ac_double) {
  POINTERS_3
  LOAD_FIRST(scalar_double, double a, &a);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(scalar_double, &a);
    LOAD(coscrew_double, &ci, 1, 0);
    ksl_product_ac(a, &ci, &co);
    STORE(coscrew_double, &co, 2, 1);
  }
}
STRIDED(product_ac_double)
LOOP(product_ac_double, 3, DENSE_OR_ONE, 8, 48, 48, 8, 8)

OVER(product_ac_single) {
  POINTERS_3
  LOAD_FIRST(scalar_single, float a, &a);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(scalar_single, &a);
    LOAD(coscrew_single, &ci, 1, 0);
    ksl_product_acf(a, &ci, &co);
    STORE(coscrew_single, &co, 2, 1);
  }
}
STRIDED(product_ac_single)
LOOP(product_ac_single, 3, DENSE_OR_ONE, 4, 24, 24, 4, 4)
LOOPS(product_ac)

/* (6),(6)->(6) */
OVER(add_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cc(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(add_cc_double)
LOOP(add_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_ccf(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(add_cc_single)
LOOP(add_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_cc)

/* (6),(6)->(6) */
OVER(subtract_cc_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_subtract_cc(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(subtract_cc_double)
LOOP(subtract_cc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(subtract_cc_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_subtract_ccf(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(subtract_cc_single)
LOOP(subtract_cc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(subtract_cc)

/* (6)->() */
OVER(coscrew_norm_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    double norm;
    LOAD(coscrew_double, &ci, 0, 0);
    norm = ksl_coscrew_norm(&ci);
    STORE(scalar_double, &norm, 1, 1);
  }
}
STRIDED(coscrew_norm_double)
LOOP(coscrew_norm_double, 2, DENSE, 48, 8, 8)

OVER(coscrew_norm_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    float norm;
    LOAD(coscrew_single, &ci, 0, 0);
    norm = ksl_coscrewf_norm(&ci);
    STORE(scalar_single, &norm, 1, 1);
  }
}
STRIDED(coscrew_norm_single)
LOOP(coscrew_norm_single, 2, DENSE, 24, 4, 4)
LOOPS(coscrew_norm)

/* (6)->(6) */
OVER(coscrew_normalize_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t self;
    LOAD(coscrew_double, &self, 0, 0);
    ksl_coscrew_normalize(&self);
    STORE(coscrew_double, &self, 1, 1);
  }
}
STRIDED(coscrew_normalize_double)
LOOP(coscrew_normalize_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_normalize_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t self;
    LOAD(coscrew_single, &self, 0, 0);
    ksl_coscrewf_normalize(&self);
    STORE(coscrew_single, &self, 1, 1);
  }
}
STRIDED(coscrew_normalize_single)
LOOP(coscrew_normalize_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_normalize)

/* (6)->(6) */
OVER(coscrew_normalized_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD(coscrew_double, &ci, 0, 0);
    ksl_coscrew_normalized(&ci, &co);
    STORE(coscrew_double, &co, 1, 1);
  }
}
STRIDED(coscrew_normalized_double)
LOOP(coscrew_normalized_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_normalized_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD(coscrew_single, &ci, 0, 0);
    ksl_coscrewf_normalized(&ci, &co);
    STORE(coscrew_single, &co, 1, 1);
  }
}
STRIDED(coscrew_normalized_single)
LOOP(coscrew_normalized_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_normalized)

/* (3),(3)->(6) */
OVER(coscrew_from_lin_ang_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t lin, &lin);
  EACH {
    ksl_vec3_t ang;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &lin);
    LOAD(vec3_double, &ang, 1, 1);
    ksl_coscrew_from_lin_ang(&lin, &ang, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(coscrew_from_lin_ang_double)
LOOP(coscrew_from_lin_ang_double, 3, DENSE_OR_ONE, 24, 24, 48, 8, 8, 8)

OVER(coscrew_from_lin_ang_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t lin, &lin);
  EACH {
    ksl_vec3f_t ang;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &lin);
    LOAD(vec3_single, &ang, 1, 1);
    ksl_coscrewf_from_lin_ang(&lin, &ang, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(coscrew_from_lin_ang_single)
LOOP(coscrew_from_lin_ang_single, 3, DENSE_OR_ONE, 12, 12, 24, 4, 4, 4)
LOOPS(coscrew_from_lin_ang)

/* (6)->(6) */
OVER(coscrew_to_angular_first_double) {
  POINTERS_2
  EACH {
    ksl_coscrew_t ci;
    double x[6];
    LOAD(coscrew_double, &ci, 0, 0);
    ksl_coscrew_to_angular_first(&ci, x);
    STORE(angular_first_double, x, 1, 1);
  }
}
STRIDED(coscrew_to_angular_first_double)
LOOP(coscrew_to_angular_first_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_to_angular_first_single) {
  POINTERS_2
  EACH {
    ksl_coscrewf_t ci;
    float x[6];
    LOAD(coscrew_single, &ci, 0, 0);
    ksl_coscrewf_to_angular_first(&ci, x);
    STORE(angular_first_single, x, 1, 1);
  }
}
STRIDED(coscrew_to_angular_first_single)
LOOP(coscrew_to_angular_first_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_to_angular_first)

/* (6)->(6) */
OVER(coscrew_from_angular_first_double) {
  POINTERS_2
  EACH {
    double x[6];
    ksl_coscrew_t co;
    LOAD(angular_first_double, x, 0, 0);
    ksl_coscrew_from_angular_first(x, &co);
    STORE(coscrew_double, &co, 1, 1);
  }
}
STRIDED(coscrew_from_angular_first_double)
LOOP(coscrew_from_angular_first_double, 2, DENSE, 48, 48, 8, 8)

OVER(coscrew_from_angular_first_single) {
  POINTERS_2
  EACH {
    float x[6];
    ksl_coscrewf_t co;
    LOAD(angular_first_single, x, 0, 0);
    ksl_coscrewf_from_angular_first(x, &co);
    STORE(coscrew_single, &co, 1, 1);
  }
}
STRIDED(coscrew_from_angular_first_single)
LOOP(coscrew_from_angular_first_single, 2, DENSE, 24, 24, 4, 4)
LOOPS(coscrew_from_angular_first)

/* (6),(6)->(6) */
OVER(add_cct_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c1, &c1);
  EACH {
    ksl_coscrew_t c2;
    ksl_coscrew_t co;
    LOAD_OTHER(coscrew_double, &c1);
    LOAD(coscrew_double, &c2, 1, 1);
    ksl_add_cct(&c1, &c2, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(add_cct_double)
LOOP(add_cct_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(add_cct_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c1, &c1);
  EACH {
    ksl_coscrewf_t c2;
    ksl_coscrewf_t co;
    LOAD_OTHER(coscrew_single, &c1);
    LOAD(coscrew_single, &c2, 1, 1);
    ksl_add_cctf(&c1, &c2, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(add_cct_single)
LOOP(add_cct_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(add_cct)

/* (3),(6)->(6) */
OVER(product_CoAdtc_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtc(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(product_CoAdtc_double)
LOOP(product_CoAdtc_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtc_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcf(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtc_single)
LOOP(product_CoAdtc_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtc)

/* (3),(6)->(6) */
OVER(product_CoAdtinvc_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtinvc(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(product_CoAdtinvc_double)
LOOP(product_CoAdtinvc_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtinvc_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtinvcf(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtinvc_single)
LOOP(product_CoAdtinvc_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtinvc)

/* (3),(6)->(6) */
OVER(product_CoAdtcinv_double) {
  POINTERS_3
  LOAD_FIRST(vec3_double, ksl_vec3_t t, &t);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(vec3_double, &t);
    LOAD(coscrew_double, &ci, 1, 1);
    ksl_product_CoAdtcinv(&t, &ci, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(product_CoAdtcinv_double)
LOOP(product_CoAdtcinv_double, 3, DENSE_OR_ONE, 24, 48, 48, 8, 8, 8)

OVER(product_CoAdtcinv_single) {
  POINTERS_3
  LOAD_FIRST(vec3_single, ksl_vec3f_t t, &t);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(vec3_single, &t);
    LOAD(coscrew_single, &ci, 1, 1);
    ksl_product_CoAdtcinvf(&t, &ci, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(product_CoAdtcinv_single)
LOOP(product_CoAdtcinv_single, 3, DENSE_OR_ONE, 12, 24, 24, 4, 4, 4)
LOOPS(product_CoAdtcinv)

/* (3,3),(6)->(6) */
OVER(product_CoAdrc_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrc(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdrc_double)
LOOP(product_CoAdrc_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrc_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcf(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrc_single)
LOOP(product_CoAdrc_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrc)

/* (3,3),(6)->(6) */
OVER(product_CoAdrinvc_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrinvc(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdrinvc_double)
LOOP(product_CoAdrinvc_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrinvc_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrinvcf(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrinvc_single)
LOOP(product_CoAdrinvc_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrinvc)

/* (3,3),(6)->(6) */
OVER(product_CoAdrcinv_double) {
  POINTERS_3
  LOAD_FIRST(mat3x3_double, ksl_mat3x3_t R, &R);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(mat3x3_double, &R);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdrcinv(&R, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdrcinv_double)
LOOP(product_CoAdrcinv_double, 3, DENSE_OR_ONE, 72, 48, 48, 24, 8, 8, 8)

OVER(product_CoAdrcinv_single) {
  POINTERS_3
  LOAD_FIRST(mat3x3_single, ksl_mat3x3f_t R, &R);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(mat3x3_single, &R);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdrcinvf(&R, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdrcinv_single)
LOOP(product_CoAdrcinv_single, 3, DENSE_OR_ONE, 36, 24, 24, 12, 4, 4, 4)
LOOPS(product_CoAdrcinv)

/* (3,4),(6)->(6) */
OVER(product_CoAdc_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdc(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdc_double)
LOOP(product_CoAdc_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdc_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcf(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdc_single)
LOOP(product_CoAdc_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdc)

/* (3,4),(6)->(6) */
OVER(product_CoAdinvc_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdinvc(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdinvc_double)
LOOP(product_CoAdinvc_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdinvc_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdinvcf(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdinvc_single)
LOOP(product_CoAdinvc_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdinvc)

/* (3,4),(6)->(6) */
OVER(product_CoAdcinv_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t ci;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &ci, 1, 2);
    ksl_product_CoAdcinv(&D, &ci, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(product_CoAdcinv_double)
LOOP(product_CoAdcinv_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(product_CoAdcinv_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t ci;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &ci, 1, 2);
    ksl_product_CoAdcinvf(&D, &ci, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(product_CoAdcinv_single)
LOOP(product_CoAdcinv_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(product_CoAdcinv)

/* (3,4)->(6) */
OVER(hctx_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctx(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hctx_double)
LOOP(hctx_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctx_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctx_single)
LOOP(hctx_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctx)

/* (3,4)->(6) */
OVER(hcty_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcty(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcty_double)
LOOP(hcty_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcty_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcty_single)
LOOP(hcty_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcty)

/* (3,4)->(6) */
OVER(hctz_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctz(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hctz_double)
LOOP(hctz_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctz_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctz_single)
LOOP(hctz_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctz)

/* (3,4)->(6) */
OVER(hcrx_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcrx(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcrx_double)
LOOP(hcrx_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcrx_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcrxf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcrx_single)
LOOP(hcrx_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcrx)

/* (3,4)->(6) */
OVER(hcry_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcry(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcry_double)
LOOP(hcry_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcry_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcryf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcry_single)
LOOP(hcry_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcry)

/* (3,4)->(6) */
OVER(hcrz_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcrz(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcrz_double)
LOOP(hcrz_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcrz_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcrzf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcrz_single)
LOOP(hcrz_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcrz)

/* (3,4)->(6) */
OVER(hctxinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctxinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hctxinv_double)
LOOP(hctxinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctxinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctxinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctxinv_single)
LOOP(hctxinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctxinv)

/* (3,4)->(6) */
OVER(hctyinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctyinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hctyinv_double)
LOOP(hctyinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctyinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctyinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctyinv_single)
LOOP(hctyinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctyinv)

/* (3,4)->(6) */
OVER(hctzinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hctzinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hctzinv_double)
LOOP(hctzinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hctzinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hctzinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hctzinv_single)
LOOP(hctzinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hctzinv)

/* (3,4)->(6) */
OVER(hcrxinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcrxinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcrxinv_double)
LOOP(hcrxinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcrxinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcrxinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcrxinv_single)
LOOP(hcrxinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcrxinv)

/* (3,4)->(6) */
OVER(hcryinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcryinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcryinv_double)
LOOP(hcryinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcryinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcryinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcryinv_single)
LOOP(hcryinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcryinv)

/* (3,4)->(6) */
OVER(hcrzinv_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_coscrew_t co;
    LOAD(SE3_double, &D, 0, 0);
    ksl_hcrzinv(&D, &co);
    STORE(coscrew_double, &co, 1, 2);
  }
}
STRIDED(hcrzinv_double)
LOOP(hcrzinv_double, 2, DENSE, 96, 48, 32, 8, 8)

OVER(hcrzinv_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_coscrewf_t co;
    LOAD(SE3_single, &D, 0, 0);
    ksl_hcrzinvf(&D, &co);
    STORE(coscrew_single, &co, 1, 2);
  }
}
STRIDED(hcrzinv_single)
LOOP(hcrzinv_single, 2, DENSE, 48, 24, 16, 4, 4)
LOOPS(hcrzinv)

/* (3,4)->(6,6) */
OVER(CoAd_double) {
  POINTERS_2
  EACH {
    ksl_SE3_t D;
    ksl_mat6x6_t M;
    LOAD(SE3_double, &D, 0, 0);
    ksl_CoAd(&D, &M);
    STORE(mat6x6_double, &M, 1, 2);
  }
}
STRIDED(CoAd_double)
LOOP(CoAd_double, 2, DENSE, 96, 288, 32, 8, 48, 8)

OVER(CoAd_single) {
  POINTERS_2
  EACH {
    ksl_SE3f_t D;
    ksl_mat6x6f_t M;
    LOAD(SE3_single, &D, 0, 0);
    ksl_CoAdf(&D, &M);
    STORE(mat6x6_single, &M, 1, 2);
  }
}
STRIDED(CoAd_single)
LOOP(CoAd_single, 2, DENSE, 48, 144, 16, 4, 24, 4)
LOOPS(CoAd)

/* (6),(6)->() */
OVER(reciprocal_product_double) {
  POINTERS_3
  LOAD_FIRST(coscrew_double, ksl_coscrew_t c, &c);
  EACH {
    double x[6];
    double power;
    LOAD_OTHER(coscrew_double, &c);
    LOAD(angular_first_double, x, 1, 1);
    power = ksl_reciprocal_product(&c, x);
    STORE(scalar_double, &power, 2, 2);
  }
}
STRIDED(reciprocal_product_double)
LOOP(reciprocal_product_double, 3, DENSE_OR_ONE, 48, 48, 8, 8, 8)

OVER(reciprocal_product_single) {
  POINTERS_3
  LOAD_FIRST(coscrew_single, ksl_coscrewf_t c, &c);
  EACH {
    float x[6];
    float power;
    LOAD_OTHER(coscrew_single, &c);
    LOAD(angular_first_single, x, 1, 1);
    power = ksl_reciprocal_productf(&c, x);
    STORE(scalar_single, &power, 2, 2);
  }
}
STRIDED(reciprocal_product_single)
LOOP(reciprocal_product_single, 3, DENSE_OR_ONE, 24, 24, 4, 4, 4)
LOOPS(reciprocal_product)

/* (6),(6)->(6) */
OVER(cross_sc_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sc(&s, &c, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(cross_sc_double)
LOOP(cross_sc_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_sc_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scf(&s, &c, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(cross_sc_single)
LOOP(cross_sc_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_sc)

/* (6),(6)->(6) */
OVER(cross_sca_double) {
  POINTERS_3
  LOAD_FIRST(screw_double, ksl_screw_t s, &s);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(screw_double, &s);
    LOAD(coscrew_double, &c, 1, 1);
    ksl_cross_sca(&s, &c, &co);
    STORE(coscrew_double, &co, 2, 2);
  }
}
STRIDED(cross_sca_double)
LOOP(cross_sca_double, 3, DENSE_OR_ONE, 48, 48, 48, 8, 8, 8)

OVER(cross_sca_single) {
  POINTERS_3
  LOAD_FIRST(screw_single, ksl_screwf_t s, &s);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(screw_single, &s);
    LOAD(coscrew_single, &c, 1, 1);
    ksl_cross_scaf(&s, &c, &co);
    STORE(coscrew_single, &co, 2, 2);
  }
}
STRIDED(cross_sca_single)
LOOP(cross_sca_single, 3, DENSE_OR_ONE, 24, 24, 24, 4, 4, 4)
LOOPS(cross_sca)

/* (3,4),(6)->(6) */
OVER(constraint_ctx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctx(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_ctx_double)
LOOP(constraint_ctx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_ctx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctxf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_ctx_single)
LOOP(constraint_ctx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_ctx)

/* (3,4),(6)->(6) */
OVER(constraint_cty_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cty(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_cty_double)
LOOP(constraint_cty_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_cty_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctyf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_cty_single)
LOOP(constraint_cty_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_cty)

/* (3,4),(6)->(6) */
OVER(constraint_ctz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_ctz(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_ctz_double)
LOOP(constraint_ctz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_ctz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_ctzf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_ctz_single)
LOOP(constraint_ctz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_ctz)

/* (3,4),(6)->(6) */
OVER(constraint_crx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crx(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_crx_double)
LOOP(constraint_crx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_crx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crxf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_crx_single)
LOOP(constraint_crx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_crx)

/* (3,4),(6)->(6) */
OVER(constraint_cry_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_cry(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_cry_double)
LOOP(constraint_cry_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_cry_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_cryf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_cry_single)
LOOP(constraint_cry_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_cry)

/* (3,4),(6)->(6) */
OVER(constraint_crz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_constraint_crz(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(constraint_crz_double)
LOOP(constraint_crz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(constraint_crz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_constraint_crzf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(constraint_crz_single)
LOOP(constraint_crz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(constraint_crz)

/* (3,4),(6)->(6) */
OVER(working_ctx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctx(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_ctx_double)
LOOP(working_ctx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_ctx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctxf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_ctx_single)
LOOP(working_ctx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_ctx)

/* (3,4),(6)->(6) */
OVER(working_cty_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cty(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_cty_double)
LOOP(working_cty_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_cty_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctyf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_cty_single)
LOOP(working_cty_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_cty)

/* (3,4),(6)->(6) */
OVER(working_ctz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_ctz(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_ctz_double)
LOOP(working_ctz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_ctz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_ctzf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_ctz_single)
LOOP(working_ctz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_ctz)

/* (3,4),(6)->(6) */
OVER(working_crx_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crx(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_crx_double)
LOOP(working_crx_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_crx_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crxf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_crx_single)
LOOP(working_crx_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_crx)

/* (3,4),(6)->(6) */
OVER(working_cry_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_cry(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_cry_double)
LOOP(working_cry_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_cry_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_cryf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_cry_single)
LOOP(working_cry_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_cry)

/* (3,4),(6)->(6) */
OVER(working_crz_double) {
  POINTERS_3
  LOAD_FIRST(SE3_double, ksl_SE3_t D, &D);
  EACH {
    ksl_coscrew_t c;
    ksl_coscrew_t co;
    LOAD_OTHER(SE3_double, &D);
    LOAD(coscrew_double, &c, 1, 2);
    ksl_working_crz(&D, &c, &co);
    STORE(coscrew_double, &co, 2, 3);
  }
}
STRIDED(working_crz_double)
LOOP(working_crz_double, 3, DENSE_OR_ONE, 96, 48, 48, 32, 8, 8, 8)

OVER(working_crz_single) {
  POINTERS_3
  LOAD_FIRST(SE3_single, ksl_SE3f_t D, &D);
  EACH {
    ksl_coscrewf_t c;
    ksl_coscrewf_t co;
    LOAD_OTHER(SE3_single, &D);
    LOAD(coscrew_single, &c, 1, 2);
    ksl_working_crzf(&D, &c, &co);
    STORE(coscrew_single, &co, 2, 3);
  }
}
STRIDED(working_crz_single)
LOOP(working_crz_single, 3, DENSE_OR_ONE, 48, 24, 24, 16, 4, 4, 4)
LOOPS(working_crz)

/* (6)->(6,6) */
OVER(coad_double) {
  POINTERS_2
  EACH {
    ksl_screw_t s;
    ksl_mat6x6_t M;
    LOAD(screw_double, &s, 0, 0);
    ksl_coad(&s, &M);
    STORE(mat6x6_double, &M, 1, 1);
  }
}
STRIDED(coad_double)
LOOP(coad_double, 2, DENSE, 48, 288, 8, 48, 8)

OVER(coad_single) {
  POINTERS_2
  EACH {
    ksl_screwf_t s;
    ksl_mat6x6f_t M;
    LOAD(screw_single, &s, 0, 0);
    ksl_coadf(&s, &M);
    STORE(mat6x6_single, &M, 1, 1);
  }
}
STRIDED(coad_single)
LOOP(coad_single, 2, DENSE, 24, 144, 4, 24, 4)
LOOPS(coad)

const coscrew_gufunc TABLE(coscrew)[] = {
  {"coscrew_copy", "(6)->(6)",
    "co = ci.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_copy_loops},
  {"coscrew_scale", "(6),()->(6)",
    "self = a self.\n"
    "\n"
    "(6),()->(6).  self: coscrew (f in N; τ in N m); a: number.\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", coscrew_scale_loops},
  {"coscrew_inverted", "(6)->(6)",
    "co = -ci.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "6 neg.  Exact.\n",
   1, 1, "", coscrew_inverted_loops},
  {"coscrew_invert", "(6)->(6)",
    "self = -self.\n"
    "\n"
    "(6)->(6).  self: coscrew (f in N; τ in N m).\n"
    "6 neg.  Exact.\n",
   1, 1, "", coscrew_invert_loops},
  {"axpy_cc", "(),(6),(6)->(6)",
    "y = a x + y.\n"
    "\n"
    "(),(6),(6)->(6).  a: number; x, y: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   3, 1, "", axpy_cc_loops},
  {"xpy_cc", "(6),(6)->(6)",
    "y = x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", xpy_cc_loops},
  {"nxpy_cc", "(6),(6)->(6)",
    "y = -x + y.\n"
    "\n"
    "(6),(6)->(6).  x, y: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", nxpy_cc_loops},
  {"product_ac", "(),(6)->(6)",
    "co = a ci.\n"
    "\n"
    "(),(6)->(6).  a: number; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", product_ac_loops},
  {"add_cc", "(6),(6)->(6)",
    "co = c1 + c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cc_loops},
  {"subtract_cc", "(6),(6)->(6)",
    "co = c1 - c2.\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "6 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", subtract_cc_loops},
  {"coscrew_norm", "(6)->()",
    "|ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).\n"
    "\n"
    "(6)->().  ci: coscrew (f in N; τ in N m); norm: number.\n"
    "7 mul, 2 add, 1 sqrt, 6 abs, 11 less, 1 equal, 14 select.\n",
   1, 1, "", coscrew_norm_loops},
  {"coscrew_normalize", "(6)->(6)",
    "self = self / |self|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  self: coscrew (f in N; τ in N m).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", coscrew_normalize_loops},
  {"coscrew_normalized", "(6)->(6)",
    "co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.\n"
    "\n"
    "(6)->(6).  ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 2 add, 6 div, 1 sqrt, 9 abs, 16 less, 2 equal, 26 select.\n",
   1, 1, "", coscrew_normalized_loops},
  {"coscrew_from_lin_ang", "(3),(3)->(6)",
    "co = (lin; ang).\n"
    "\n"
    "(3),(3)->(6).  lin, ang: vector; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   2, 1, "", coscrew_from_lin_ang_loops},
  {"coscrew_to_angular_first", "(6)->(6)",
    "x = (ang; lin) of ci.\n"
    "\n"
    "(6)->(6).  ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_to_angular_first_loops},
  {"coscrew_from_angular_first", "(6)->(6)",
    "co = (lin; ang) of x = (ang; lin).\n"
    "\n"
    "(6)->(6).  x: six components with the angular part on top; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", coscrew_from_angular_first_loops},
  {"add_cct", "(6),(6)->(6)",
    "co = (c1.lin + c2.lin ; c1.ang).\n"
    "\n"
    "(6),(6)->(6).  c1, c2, co: coscrew (f in N; τ in N m).\n"
    "3 add.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "", add_cct_loops},
  {"product_CoAdtc", "(3),(6)->(6)",
    "co = [Ad]*(t) ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtc_loops},
  {"product_CoAdtinvc", "(3),(6)->(6)",
    "co = [Ad]*(t)^-1 ci.\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtinvc_loops},
  {"product_CoAdtcinv", "(3),(6)->(6)",
    "co = [Ad]*(t) (-ci).\n"
    "\n"
    "(3),(6)->(6).  t: vector; ci, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 6 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "", product_CoAdtcinv_loops},
  {"product_CoAdrc", "(3,3),(6)->(6)",
    "co = [Ad]*(R) ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrc_loops},
  {"product_CoAdrinvc", "(3,3),(6)->(6)",
    "co = [Ad]*(R)^-1 ci.\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrinvc_loops},
  {"product_CoAdrcinv", "(3,3),(6)->(6)",
    "co = [Ad]*(R) (-ci).\n"
    "\n"
    "(3,3),(6)->(6).  R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add, 6 neg.  Error <= u |result| + 2 u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdrcinv_loops},
  {"product_CoAdc", "(3,4),(6)->(6)",
    "co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdc_loops},
  {"product_CoAdinvc", "(3,4),(6)->(6)",
    "co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdinvc_loops},
  {"product_CoAdcinv", "(3,4),(6)->(6)",
    "co = [Ad]*(D) (-ci).\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in\n"
    "N m).\n"
    "24 mul, 18 add, 6 neg.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   2, 1, "R.", product_CoAdcinv_loops},
  {"hctx", "(3,4)->(6)",
    "co = h_tx: column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctx_loops},
  {"hcty", "(3,4)->(6)",
    "co = h_ty: column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hcty_loops},
  {"hctz", "(3,4)->(6)",
    "co = h_tz: column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctz_loops},
  {"hcrx", "(3,4)->(6)",
    "co = h_rx: column 3 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcrx_loops},
  {"hcry", "(3,4)->(6)",
    "co = h_ry: column 4 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcry_loops},
  {"hcrz", "(3,4)->(6)",
    "co = h_rz: column 5 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "No arithmetic.  Exact.\n",
   1, 1, "", hcrz_loops},
  {"hctxinv", "(3,4)->(6)",
    "co = -h_tx: -column 0 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctxinv_loops},
  {"hctyinv", "(3,4)->(6)",
    "co = -h_ty: -column 1 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctyinv_loops},
  {"hctzinv", "(3,4)->(6)",
    "co = -h_tz: -column 2 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add, 3 neg.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms|\n"
    "of the expanded formula; barring over- and underflow.\n",
   1, 1, "R", hctzinv_loops},
  {"hcrxinv", "(3,4)->(6)",
    "co = -h_rx: -column 3 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcrxinv_loops},
  {"hcryinv", "(3,4)->(6)",
    "co = -h_ry: -column 4 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcryinv_loops},
  {"hcrzinv", "(3,4)->(6)",
    "co = -h_rz: -column 5 of [Ad]*(D).\n"
    "\n"
    "(3,4)->(6).  D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).\n"
    "3 neg.  Exact.\n",
   1, 1, "R", hcrzinv_loops},
  {"CoAd", "(3,4)->(6,6)",
    "M = [Ad]*(D).\n"
    "\n"
    "(3,4)->(6,6).  D: displacement [R | t], R rotation, t in m; M: 6×6 operator.\n"
    "18 mul, 9 add.  Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   1, 1, "R", CoAd_loops},
  {"reciprocal_product", "(6),(6)->()",
    "power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).\n"
    "\n"
    "(6),(6)->().  c: coscrew (f in N; τ in N m); x: six components with the angular part on top;\n"
    "power: number.\n"
    "6 mul, 5 add.  Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded\n"
    "formula; barring over- and underflow.\n",
   2, 1, "", reciprocal_product_loops},
  {"cross_sc", "(6),(6)->(6)",
    "co = [ad]*(s) c = (ω×f ; v×f + ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "18 mul, 12 add.  Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sc_loops},
  {"cross_sca", "(6),(6)->(6)",
    "co = (0 ; ω×τ).\n"
    "\n"
    "(6),(6)->(6).  s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).\n"
    "6 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "", cross_sca_loops},
  {"constraint_ctx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctx_loops},
  {"constraint_cty", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cty_loops},
  {"constraint_ctz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_ctz_loops},
  {"constraint_crx", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crx_loops},
  {"constraint_cry", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_cry_loops},
  {"constraint_crz", "(3,4),(6)->(6)",
    "co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "21 mul, 15 add.  Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", constraint_crz_loops},
  {"working_ctx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctx_loops},
  {"working_cty", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_cty_loops},
  {"working_ctz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "9 mul, 3 add.  Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the\n"
    "expanded formula; barring over- and underflow.\n",
   2, 1, "R.", working_ctz_loops},
  {"working_crx", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crx_loops},
  {"working_cry", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_cry_loops},
  {"working_crz", "(3,4),(6)->(6)",
    "co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.\n"
    "\n"
    "(3,4),(6)->(6).  D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N\n"
    "m).\n"
    "3 mul.  Error <= u |result|, barring over- and underflow.\n",
   2, 1, "R.", working_crz_loops},
  {"coad", "(6)->(6,6)",
    "M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].\n"
    "\n"
    "(6)->(6,6).  s: screw (v in m/s; ω in rad/s); M: 6×6 operator.\n"
    "6 neg.  Exact.\n",
   1, 1, "", coad_loops},
  {NULL, NULL, NULL, 0, 0, NULL, NULL},
};

#if defined(COSCREW_FOR_AVX2) && defined(__clang__)
#pragma clang attribute pop
#endif
