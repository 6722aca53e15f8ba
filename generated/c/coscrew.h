/* Made by `coscrew generate`; changes are overwritten. */
/* All headers of plain kernels in one file, for vendoring; it may be included together with
   them. */

/* Types of the spatial algebra, in double and single precision.

   Every quantity is a union, so that it can be reached several ways.  Matrices are stored column by
   column.  Screws s = (v; ω) and coscrews c = (f; τ) have the linear part on top, so that power is
   their dot product.

   All functions: pointers must point to valid objects; an output may be the same object as an
   input; nothing else is read or written.  Every operation is rounded once, in the order written, so
   that results are the same bits everywhere: compile with -ffp-contract=off (and, where the target
   has fused multiply-adds, with gcc's -fno-tree-vectorize: gcc 12 fuses in spite of the former).

   Error bounds are derived from that order, to first order in u: u = 2^-53 in double and 2^-24 in
   single precision. */
#ifndef KSL_TYPES_H
#define KSL_TYPES_H

#include <math.h>
#include <string.h>

#if (defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)) && !defined(KSL_ALLOW_FAST_MATH)
#error "-ffast-math breaks the bits promised here; define KSL_ALLOW_FAST_MATH to accept that"
#endif

#if defined(__GNUC__)
#define KSL_VIEW __extension__ struct
#else
#define KSL_VIEW struct
#endif

/* vector (x, y, z); double precision. */
typedef union ksl_vec3_t {
  KSL_VIEW { double at[3]; };
  KSL_VIEW { double x, y, z; };
} ksl_vec3_t;

/* vector (x, y, z); single precision. */
typedef union ksl_vec3f_t {
  KSL_VIEW { float at[3]; };
  KSL_VIEW { float x, y, z; };
} ksl_vec3f_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; double precision. */
typedef union ksl_mat3x3_t {
  KSL_VIEW { double as_array[9]; };
  KSL_VIEW { double at[3][3]; };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3_t v[3]; };
} ksl_mat3x3_t;

/* 3×3 matrix, stored column by column: m21 is row 2, column 1, also at[1][2]; single precision. */
typedef union ksl_mat3x3f_t {
  KSL_VIEW { float as_array[9]; };
  KSL_VIEW { float at[3][3]; };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2; };
  KSL_VIEW { ksl_vec3f_t v[3]; };
} ksl_mat3x3f_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; double precision. */
typedef union ksl_SE3_t {
  KSL_VIEW { double as_array[12]; };
  KSL_VIEW { double at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3_t R;
    ksl_vec3_t t;
  };
  KSL_VIEW {
    double m00, m10, m20;
    double m01, m11, m21;
    double m02, m12, m22;
    double m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3_t v[4]; };
} ksl_SE3_t;

/* displacement [R | t], stored column by column: m13 is t.y, also at[3][1]; single precision. */
typedef union ksl_SE3f_t {
  KSL_VIEW { float as_array[12]; };
  KSL_VIEW { float at[4][3]; };
  KSL_VIEW {
    ksl_mat3x3f_t R;
    ksl_vec3f_t t;
  };
  KSL_VIEW {
    float m00, m10, m20;
    float m01, m11, m21;
    float m02, m12, m22;
    float m03, m13, m23;
  };
  KSL_VIEW { ksl_vec3f_t v0, v1, v2, v3; };
  KSL_VIEW { ksl_vec3f_t v[4]; };
} ksl_SE3f_t;

/* screw (lin; ang) = (v; ω); double precision. */
typedef union ksl_screw_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_screw_t;

/* screw (lin; ang) = (v; ω); single precision. */
typedef union ksl_screwf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_screwf_t;

/* coscrew (lin; ang) = (f; τ); double precision. */
typedef union ksl_coscrew_t {
  KSL_VIEW { double at[6]; };
  KSL_VIEW { ksl_vec3_t lin, ang; };
  KSL_VIEW { double m0, m1, m2, m3, m4, m5; };
} ksl_coscrew_t;

/* coscrew (lin; ang) = (f; τ); single precision. */
typedef union ksl_coscrewf_t {
  KSL_VIEW { float at[6]; };
  KSL_VIEW { ksl_vec3f_t lin, ang; };
  KSL_VIEW { float m0, m1, m2, m3, m4, m5; };
} ksl_coscrewf_t;

/* 6×6 operator, stored column by column: at[column][row]; double precision. */
typedef union ksl_mat6x6_t {
  KSL_VIEW { double as_array[36]; };
  KSL_VIEW { double at[6][6]; };
} ksl_mat6x6_t;

/* 6×6 operator, stored column by column: at[column][row]; single precision. */
typedef union ksl_mat6x6f_t {
  KSL_VIEW { float as_array[36]; };
  KSL_VIEW { float at[6][6]; };
} ksl_mat6x6f_t;

/* quaternion (w; x, y, z), the scalar first; for rotations, of norm 1; double precision. */
typedef union ksl_quaternion_t {
  KSL_VIEW { double at[4]; };
  KSL_VIEW { double w, x, y, z; };
} ksl_quaternion_t;

/* quaternion (w; x, y, z), the scalar first; for rotations, of norm 1; single precision. */
typedef union ksl_quaternionf_t {
  KSL_VIEW { float at[4]; };
  KSL_VIEW { float w, x, y, z; };
} ksl_quaternionf_t;

/* spatial inertia: mass m, first moment h = m c, second moments about the origin; double precision. */
typedef union ksl_inertia_t {
  KSL_VIEW { double at[10]; };
  KSL_VIEW {
    double m;
    ksl_vec3_t h;
    double xx, yy, zz, xy, xz, yz;
  };
} ksl_inertia_t;

/* spatial inertia: mass m, first moment h = m c, second moments about the origin; single precision. */
typedef union ksl_inertiaf_t {
  KSL_VIEW { float at[10]; };
  KSL_VIEW {
    float m;
    ksl_vec3f_t h;
    float xx, yy, zz, xy, xz, yz;
  };
} ksl_inertiaf_t;

#endif

/* Vectors of three components. */
#ifndef KSL_VEC3_H
#define KSL_VEC3_H


/* The vec3 of these entries, in order. */
static inline ksl_vec3_t ksl_vec3(const double x, const double y, const double z) {
  ksl_vec3_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_copy(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vi_x = vi->x;
  const double vi_y = vi->y;
  const double vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scale(ksl_vec3_t *self, const double a) {
  const double self_0_new = self->x * a;
  const double self_1_new = self->y * a;
  const double self_2_new = self->z * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_inverted(const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = -vi->x;
  const double vo_1 = -vi->y;
  const double vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3_invert(ksl_vec3_t *self) {
  const double self_0_new = -self->x;
  const double self_1_new = -self->y;
  const double self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vv(const double a, const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new_a = a * x->x, y_0_new = y_0_new_a + y->x;
  const double y_1_new_a = a * x->y, y_1_new = y_1_new_a + y->y;
  const double y_2_new_a = a * x->z, y_2_new = y_2_new_a + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = x->x + y->x;
  const double y_1_new = x->y + y->y;
  const double y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vv(const ksl_vec3_t *x, ksl_vec3_t *y) {
  const double y_0_new = y->x - x->x;
  const double y_1_new = y->y - x->y;
  const double y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_av(const double a, const ksl_vec3_t *vi, ksl_vec3_t *vo) {
  const double vo_0 = a * vi->x;
  const double vo_1 = a * vi->y;
  const double vo_2 = a * vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x + v2->x;
  const double vo_1 = v1->y + v2->y;
  const double vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0 = v1->x - v2->x;
  const double vo_1 = v1->y - v2->y;
  const double vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3_scaled(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x * k;
  const double vo_1 = v->y * k;
  const double vo_2 = v->z * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3_swap(ksl_vec3_t *v1, ksl_vec3_t *v2) {
  const double v2_x = v2->x;
  const double v2_y = v2->y;
  const double v2_z = v2->z;
  const double v1_x = v1->x;
  const double v1_y = v1->y;
  const double v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 6 less, 6 select. */
static inline double ksl_vec3_l2norm(const ksl_vec3_t *v) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3_normalize(ksl_vec3_t *self) {
  const double s_size_0 = fabs(self->x);
  const double s_size_1 = fabs(self->y);
  const double s_size_2 = fabs(self->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = self->x * s;
  const double y_1 = self->y * s;
  const double y_2 = self->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = self->x * up;
  const double z_1 = self->y * up;
  const double z_2 = self->z * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double self_0_new = q_0 * down;
  const double self_1_new = q_1 * down;
  const double self_2_new = q_2 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3_normalized(const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double s_size_0 = fabs(v->x);
  const double s_size_1 = fabs(v->y);
  const double s_size_2 = fabs(v->z);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = v->x * s;
  const double y_1 = v->y * s;
  const double y_2 = v->z * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = v->x * up;
  const double z_1 = v->y * up;
  const double z_2 = v->z * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double vo_0 = q_0 * down;
  const double vo_1 = q_1 * down;
  const double vo_2 = q_2 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2) {
  const double dot_a = v1->x * v2->x, dot_b = v1->y * v2->y, dot_c = dot_a + dot_b,
      dot_d = v1->z * v2->z, dot = dot_c + dot_d;
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = k * v->x, vo_0 = -vo_0a;
  const double vo_1a = k * v->y, vo_1 = -vo_1a;
  const double vo_2a = k * v->z, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvv(const double k, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0 = v->x / k;
  const double vo_1 = v->y / k;
  const double vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0a = v1->y * v2->z, vo_0b = v1->z * v2->y, vo_0 = vo_0a - vo_0b;
  const double vo_1a = v1->z * v2->x, vo_1b = v1->x * v2->z, vo_1 = vo_1a - vo_1b;
  const double vo_2a = v1->x * v2->y, vo_2b = v1->y * v2->x, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinv(const ksl_vec3_t *v1, const ksl_vec3_t *v2, ksl_vec3_t *vo) {
  const double vo_0a = v1->z * v2->y, vo_0b = v1->y * v2->z, vo_0 = vo_0a - vo_0b;
  const double vo_1a = v1->x * v2->z, vo_1b = v1->z * v2->x, vo_1 = vo_1a - vo_1b;
  const double vo_2a = v1->y * v2->x, vo_2b = v1->x * v2->y, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvx(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x + k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_0 = v->x - k;
  const double v_y = v->y;
  const double v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvy(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y + k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_1 = v->y - k;
  const double v_x = v->x;
  const double v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvz(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z + k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinv(const ksl_vec3_t *v, const double k, ksl_vec3_t *vo) {
  const double vo_2 = v->z - k;
  const double v_x = v->x;
  const double v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* The vec3 of these entries, in order. */
static inline ksl_vec3f_t ksl_vec3f(const float x, const float y, const float z) {
  ksl_vec3f_t value;
  value.x = x;
  value.y = y;
  value.z = z;
  return value;
}

/* vo = vi.
   vi, vo: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_copy(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vi_x = vi->x;
  const float vi_y = vi->y;
  const float vi_z = vi->z;
  vo->x = vi_x;
  vo->y = vi_y;
  vo->z = vi_z;
}

/* self = a self.
   self: vector; a: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scale(ksl_vec3f_t *self, const float a) {
  const float self_0_new = self->x * a;
  const float self_1_new = self->y * a;
  const float self_2_new = self->z * a;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = -vi.
   vi, vo: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_inverted(const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = -vi->x;
  const float vo_1 = -vi->y;
  const float vo_2 = -vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* self = -self.
   self: vector.
   3 neg.
   Exact. */
static inline void ksl_vec3f_invert(ksl_vec3f_t *self) {
  const float self_0_new = -self->x;
  const float self_1_new = -self->y;
  const float self_2_new = -self->z;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* y = a x + y.
   a: number; x, y: vector.
   3 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_vvf(const float a, const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new_a = a * x->x, y_0_new = y_0_new_a + y->x;
  const float y_1_new_a = a * x->y, y_1_new = y_1_new_a + y->y;
  const float y_2_new_a = a * x->z, y_2_new = y_2_new_a + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = x->x + y->x;
  const float y_1_new = x->y + y->y;
  const float y_2_new = x->z + y->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* y = -x + y.
   x, y: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_vvf(const ksl_vec3f_t *x, ksl_vec3f_t *y) {
  const float y_0_new = y->x - x->x;
  const float y_1_new = y->y - x->y;
  const float y_2_new = y->z - x->z;
  y->x = y_0_new;
  y->y = y_1_new;
  y->z = y_2_new;
}

/* vo = a vi.
   a: number; vi, vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avf(const float a, const ksl_vec3f_t *vi, ksl_vec3f_t *vo) {
  const float vo_0 = a * vi->x;
  const float vo_1 = a * vi->y;
  const float vo_2 = a * vi->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 + v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = v1->x + v2->x;
  const float vo_1 = v1->y + v2->y;
  const float vo_2 = v1->z + v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 - v2.
   v1, v2, vo: vector.
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0 = v1->x - v2->x;
  const float vo_1 = v1->y - v2->y;
  const float vo_2 = v1->z - v2->z;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = k v.
   v, vo: vector; k: number.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_vec3f_scaled(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x * k;
  const float vo_1 = v->y * k;
  const float vo_2 = v->z * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1, v2 = v2, v1.
   v1, v2: vector.
   No arithmetic.
   Exact. */
static inline void ksl_vec3f_swap(ksl_vec3f_t *v1, ksl_vec3f_t *v2) {
  const float v2_x = v2->x;
  const float v2_y = v2->y;
  const float v2_z = v2->z;
  const float v1_x = v1->x;
  const float v1_y = v1->y;
  const float v1_z = v1->z;
  v1->x = v2_x;
  v1->y = v2_y;
  v1->z = v2_z;
  v2->x = v1_x;
  v2->y = v1_y;
  v2->z = v1_z;
}

/* |v| = sqrt(v·v).
   v: vector.
   7 mul, 2 add, 1 sqrt, 3 abs, 6 less, 6 select. */
static inline float ksl_vec3f_l2norm(const ksl_vec3f_t *v) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r = 1.0f < s ? 7.888609e-31f : r_b;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|; the zero vector stays zero.
   self: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3f_normalize(ksl_vec3f_t *self) {
  const float s_size_0 = fabsf(self->x);
  const float s_size_1 = fabsf(self->y);
  const float s_size_2 = fabsf(self->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = self->x * s;
  const float y_1 = self->y * s;
  const float y_2 = self->z * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = self->x * up;
  const float z_1 = self->y * up;
  const float z_2 = self->z * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float self_0_new = q_0 * down;
  const float self_1_new = q_1 * down;
  const float self_2_new = q_2 * down;
  self->x = self_0_new;
  self->y = self_1_new;
  self->z = self_2_new;
}

/* vo = v / |v|; the zero vector stays zero.
   v, vo: vector.
   12 mul, 2 add, 3 div, 1 sqrt, 3 abs, 6 less, 1 equal, 7 select. */
static inline void ksl_vec3f_normalized(const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float s_size_0 = fabsf(v->x);
  const float s_size_1 = fabsf(v->y);
  const float s_size_2 = fabsf(v->z);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = v->x * s;
  const float y_1 = v->y * s;
  const float y_2 = v->z * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = v->x * up;
  const float z_1 = v->y * up;
  const float z_2 = v->z * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float vo_0 = q_0 * down;
  const float vo_1 = q_1 * down;
  const float vo_2 = q_2 * down;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* v1·v2.
   v1, v2: vector.
   3 mul, 2 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2) {
  const float dot_a = v1->x * v2->x, dot_b = v1->y * v2->y, dot_c = dot_a + dot_b,
      dot_d = v1->z * v2->z, dot = dot_c + dot_d;
  return dot;
}

/* vo = k (-v).
   k: number; v, vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_avinvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = k * v->x, vo_0 = -vo_0a;
  const float vo_1a = k * v->y, vo_1 = -vo_1a;
  const float vo_2a = k * v->z, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v / k.
   k: number; v, vo: vector.
   3 div. */
static inline void ksl_product_ainvvf(const float k, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0 = v->x / k;
  const float vo_1 = v->y / k;
  const float vo_2 = v->z / k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × v2.  Exactly zero for v1 = v2, unless products overflow.
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0a = v1->y * v2->z, vo_0b = v1->z * v2->y, vo_0 = vo_0a - vo_0b;
  const float vo_1a = v1->z * v2->x, vo_1b = v1->x * v2->z, vo_1 = vo_1a - vo_1b;
  const float vo_2a = v1->x * v2->y, vo_2b = v1->y * v2->x, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v1 × (-v2).
   v1, v2, vo: vector.
   6 mul, 3 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_cross_vvinvf(const ksl_vec3f_t *v1, const ksl_vec3f_t *v2, ksl_vec3f_t *vo) {
  const float vo_0a = v1->z * v2->y, vo_0b = v1->y * v2->z, vo_0 = vo_0a - vo_0b;
  const float vo_1a = v1->x * v2->z, vo_1b = v1->z * v2->x, vo_1 = vo_1a - vo_1b;
  const float vo_2a = v1->y * v2->x, vo_2b = v1->x * v2->y, vo_2 = vo_2a - vo_2b;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = v + k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x + k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v - k e_x.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvxinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = v->x - k;
  const float v_y = v->y;
  const float v_z = v->z;
  vo->x = vo_0;
  vo->y = v_y;
  vo->z = v_z;
}

/* vo = v + k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y + k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v - k e_y.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvyinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_1 = v->y - k;
  const float v_x = v->x;
  const float v_z = v->z;
  vo->x = v_x;
  vo->y = vo_1;
  vo->z = v_z;
}

/* vo = v + k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z + k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

/* vo = v - k e_z.
   v, vo: vector; k: number.
   1 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_vvzinvf(const ksl_vec3f_t *v, const float k, ksl_vec3f_t *vo) {
  const float vo_2 = v->z - k;
  const float v_x = v->x;
  const float v_y = v->y;
  vo->x = v_x;
  vo->y = v_y;
  vo->z = vo_2;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_vec3_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3_t *ksl_vec3_alloc(int n) {
  return n > 0 ? (ksl_vec3_t *)calloc((size_t)n, sizeof(ksl_vec3_t)) : NULL;
}

/* n zeroed ksl_vec3f_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_vec3f_t *ksl_vec3f_alloc(int n) {
  return n > 0 ? (ksl_vec3f_t *)calloc((size_t)n, sizeof(ksl_vec3f_t)) : NULL;
}

#endif

#endif

/* 3×3 matrices: rotations, and matrices in general. */
#ifndef KSL_MAT3X3_H
#define KSL_MAT3X3_H


/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3_t ksl_mat3x3(const double m00, const double m01, const double m02,
    const double m10, const double m11, const double m12, const double m20,
    const double m21, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3_t ksl_mat3x3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22) {
  ksl_mat3x3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline double ksl_mat3x3_get(const ksl_mat3x3_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (double)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3_set(ksl_mat3x3_t *R, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_copy(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m01 = R->m01;
  const double R_m02 = R->m02;
  const double R_m10 = R->m10;
  const double R_m11 = R->m11;
  const double R_m12 = R->m12;
  const double R_m20 = R->m20;
  const double R_m21 = R->m21;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setIdentity(ksl_mat3x3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_setFromVectors(ksl_mat3x3_t *R, const ksl_vec3_t *x,
    const ksl_vec3_t *y, const ksl_vec3_t *z) {
  const double x_x = x->x;
  const double y_x = y->x;
  const double z_x = z->x;
  const double x_y = x->y;
  const double y_y = y->y;
  const double z_y = z->y;
  const double x_z = x->z;
  const double y_z = y->z;
  const double z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skew(const ksl_vec3_t *v, ksl_mat3x3_t *Ro) {
  const double Ro_01 = -v->z;
  const double Ro_12 = -v->x;
  const double Ro_20 = -v->y;
  const double v_y = v->y;
  const double v_z = v->z;
  const double v_x = v->x;
  Ro->m00 = 0.0;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transpose(ksl_mat3x3_t *self) {
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3_transposed(const ksl_mat3x3_t *R, ksl_mat3x3_t *Ro) {
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_mat3x3_determinant(const ksl_mat3x3_t *R) {
  const double n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const double n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const double n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const double det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

/* The mat3x3 of these entries, row by row. */
static inline ksl_mat3x3f_t ksl_mat3x3f(const float m00, const float m01, const float m02,
    const float m10, const float m11, const float m12, const float m20,
    const float m21, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  return value;
}

/* The mat3x3 of these entries, column by column. */
static inline ksl_mat3x3f_t ksl_mat3x3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22) {
  ksl_mat3x3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  return value;
}

/* The entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; NaN outside. */
static inline float ksl_mat3x3f_get(const ksl_mat3x3f_t *R, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 3 ? R->at[column][row] : (float)NAN;
}

/* Sets the entry of R at (row, column), for 0 <= row < 3 and 0 <= column < 3; does nothing
     outside. */
static inline void ksl_mat3x3f_set(ksl_mat3x3f_t *R, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 3) {
    R->at[column][row] = value;
  }
}

/* Ro = R.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_copy(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m01 = R->m01;
  const float R_m02 = R->m02;
  const float R_m10 = R->m10;
  const float R_m11 = R->m11;
  const float R_m12 = R->m12;
  const float R_m20 = R->m20;
  const float R_m21 = R->m21;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m01;
  Ro->m02 = R_m02;
  Ro->m10 = R_m10;
  Ro->m11 = R_m11;
  Ro->m12 = R_m12;
  Ro->m20 = R_m20;
  Ro->m21 = R_m21;
  Ro->m22 = R_m22;
}

/* self = I.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setIdentity(ksl_mat3x3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
}

/* R = [x y z], the columns.
   R: rotation or other 3×3 matrix; x, y, z: vector.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_setFromVectors(ksl_mat3x3f_t *R, const ksl_vec3f_t *x,
    const ksl_vec3f_t *y, const ksl_vec3f_t *z) {
  const float x_x = x->x;
  const float y_x = y->x;
  const float z_x = z->x;
  const float x_y = x->y;
  const float y_y = y->y;
  const float z_y = z->y;
  const float x_z = x->z;
  const float y_z = y->z;
  const float z_z = z->z;
  R->m00 = x_x;
  R->m01 = y_x;
  R->m02 = z_x;
  R->m10 = x_y;
  R->m11 = y_y;
  R->m12 = z_y;
  R->m20 = x_z;
  R->m21 = y_z;
  R->m22 = z_z;
}

/* Ro = v~, the matrix with v~ y = v × y.
   v: vector; Ro: rotation or other 3×3 matrix.
   3 neg.
   Exact. */
static inline void ksl_skewf(const ksl_vec3f_t *v, ksl_mat3x3f_t *Ro) {
  const float Ro_01 = -v->z;
  const float Ro_12 = -v->x;
  const float Ro_20 = -v->y;
  const float v_y = v->y;
  const float v_z = v->z;
  const float v_x = v->x;
  Ro->m00 = 0.0f;
  Ro->m01 = Ro_01;
  Ro->m02 = v_y;
  Ro->m10 = v_z;
  Ro->m11 = 0.0f;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = v_x;
  Ro->m22 = 0.0f;
}

/* self = self^T, the inverse of a rotation.
   self: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transpose(ksl_mat3x3f_t *self) {
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m20 = self_m02;
  self->m21 = self_m12;
}

/* Ro = R^T, the inverse of a rotation.
   R, Ro: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_mat3x3f_transposed(const ksl_mat3x3f_t *R, ksl_mat3x3f_t *Ro) {
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = R_m00;
  Ro->m01 = R_m10;
  Ro->m02 = R_m20;
  Ro->m10 = R_m01;
  Ro->m11 = R_m11;
  Ro->m12 = R_m21;
  Ro->m20 = R_m02;
  Ro->m21 = R_m12;
  Ro->m22 = R_m22;
}

/* det R.
   R: rotation or other 3×3 matrix.
   9 mul, 5 add.
   Error <= u |result| + 4 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_mat3x3f_determinant(const ksl_mat3x3f_t *R) {
  const float n_0a = R->m11 * R->m22, n_0b = R->m12 * R->m21, n_0 = n_0a - n_0b;
  const float n_1a = R->m02 * R->m21, n_1b = R->m01 * R->m22, n_1 = n_1a - n_1b;
  const float n_2a = R->m01 * R->m12, n_2b = R->m02 * R->m11, n_2 = n_2a - n_2b;
  const float det_a = R->m00 * n_0, det_b = R->m10 * n_1, det_c = det_a + det_b,
      det_d = R->m20 * n_2, det = det_c + det_d;
  return det;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_mat3x3_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_mat3x3_t *ksl_mat3x3_alloc(int n) {
  return n > 0 ? (ksl_mat3x3_t *)calloc((size_t)n, sizeof(ksl_mat3x3_t)) : NULL;
}

/* n zeroed ksl_mat3x3f_t on the heap, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_mat3x3f_t *ksl_mat3x3f_alloc(int n) {
  return n > 0 ? (ksl_mat3x3f_t *)calloc((size_t)n, sizeof(ksl_mat3x3f_t)) : NULL;
}

#endif

#endif

/* Displacements D = [R | t]. */
#ifndef KSL_SE3_H
#define KSL_SE3_H


/* The SE3 of these entries, row by row. */
static inline ksl_SE3_t ksl_SE3(const double m00, const double m01, const double m02,
    const double m03, const double m10, const double m11, const double m12,
    const double m13, const double m20, const double m21, const double m22,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3_t ksl_SE3_cmo(const double m00, const double m10, const double m20,
    const double m01, const double m11, const double m21, const double m02,
    const double m12, const double m22, const double m03, const double m13,
    const double m23) {
  ksl_SE3_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3_t ksl_SE3_identity(void) {
  return ksl_SE3(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline double ksl_SE3_get(const ksl_SE3_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (double)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3_set(ksl_SE3_t *D, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3_t ksl_SE3_fromRt(const ksl_mat3x3_t R, const ksl_vec3_t t) {
  ksl_SE3_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_copy(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_setIdentity(ksl_SE3_t *self) {
  self->m00 = 1.0;
  self->m01 = 0.0;
  self->m02 = 0.0;
  self->m03 = 0.0;
  self->m10 = 0.0;
  self->m11 = 1.0;
  self->m12 = 0.0;
  self->m13 = 0.0;
  self->m20 = 0.0;
  self->m21 = 0.0;
  self->m22 = 1.0;
  self->m23 = 0.0;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getTranslation(const ksl_SE3_t *D, ksl_vec3_t *t) {
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3_getRotation(const ksl_SE3_t *D, ksl_mat3x3_t *R) {
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_invert(ksl_SE3_t *self) {
  const double self_03_new_a = self->m00 * self->m03, self_03_new_b = self->m10 * self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b, self_03_new_d = self->m20 * self->m23,
      self_03_new_e = self_03_new_c + self_03_new_d, self_03_new = -self_03_new_e;
  const double self_13_new_a = self->m01 * self->m03, self_13_new_b = self->m11 * self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b, self_13_new_d = self->m21 * self->m23,
      self_13_new_e = self_13_new_c + self_13_new_d, self_13_new = -self_13_new_e;
  const double self_23_new_a = self->m02 * self->m03, self_23_new_b = self->m12 * self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b, self_23_new_d = self->m22 * self->m23,
      self_23_new_e = self_23_new_c + self_23_new_d, self_23_new = -self_23_new_e;
  const double self_m10 = self->m10;
  const double self_m20 = self->m20;
  const double self_m01 = self->m01;
  const double self_m21 = self->m21;
  const double self_m02 = self->m02;
  const double self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3_inverted(const ksl_SE3_t *D, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * D->m03, Do_03b = D->m10 * D->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * D->m23, Do_03e = Do_03c + Do_03d, Do_03 = -Do_03e;
  const double Do_13a = D->m01 * D->m03, Do_13b = D->m11 * D->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * D->m23, Do_13e = Do_13c + Do_13d, Do_13 = -Do_13e;
  const double Do_23a = D->m02 * D->m03, Do_23b = D->m12 * D->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * D->m23, Do_23e = Do_23c + Do_23d, Do_23 = -Do_23e;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* The SE3 of these entries, row by row. */
static inline ksl_SE3f_t ksl_SE3f(const float m00, const float m01, const float m02,
    const float m03, const float m10, const float m11, const float m12,
    const float m13, const float m20, const float m21, const float m22,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m01 = m01;
  value.m02 = m02;
  value.m03 = m03;
  value.m10 = m10;
  value.m11 = m11;
  value.m12 = m12;
  value.m13 = m13;
  value.m20 = m20;
  value.m21 = m21;
  value.m22 = m22;
  value.m23 = m23;
  return value;
}

/* The SE3 of these entries, column by column. */
static inline ksl_SE3f_t ksl_SE3f_cmo(const float m00, const float m10, const float m20,
    const float m01, const float m11, const float m21, const float m02,
    const float m12, const float m22, const float m03, const float m13,
    const float m23) {
  ksl_SE3f_t value;
  value.m00 = m00;
  value.m10 = m10;
  value.m20 = m20;
  value.m01 = m01;
  value.m11 = m11;
  value.m21 = m21;
  value.m02 = m02;
  value.m12 = m12;
  value.m22 = m22;
  value.m03 = m03;
  value.m13 = m13;
  value.m23 = m23;
  return value;
}

/* The displacement [I | 0]. */
static inline ksl_SE3f_t ksl_SE3f_identity(void) {
  return ksl_SE3f(1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
}

/* The entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; NaN outside. */
static inline float ksl_SE3f_get(const ksl_SE3f_t *D, const int row, const int column) {
  return row >= 0 && row < 3 && column >= 0 && column < 4 ? D->at[column][row] : (float)NAN;
}

/* Sets the entry of D at (row, column), for 0 <= row < 3 and 0 <= column < 4; does nothing
     outside. */
static inline void ksl_SE3f_set(ksl_SE3f_t *D, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 3 && column >= 0 && column < 4) {
    D->at[column][row] = value;
  }
}

/* D = [R | t].
   R: rotation or other 3×3 matrix; t: vector.
   No arithmetic.
   Exact. */
static inline ksl_SE3f_t ksl_SE3f_fromRt(const ksl_mat3x3f_t R, const ksl_vec3f_t t) {
  ksl_SE3f_t D;
  D.m00 = R.m00;
  D.m01 = R.m01;
  D.m02 = R.m02;
  D.m03 = t.x;
  D.m10 = R.m10;
  D.m11 = R.m11;
  D.m12 = R.m12;
  D.m13 = t.y;
  D.m20 = R.m20;
  D.m21 = R.m21;
  D.m22 = R.m22;
  D.m23 = t.z;
  return D;
}

/* Do = D.
   D, Do: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_copy(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* self = [I | 0].
   self: displacement [R | t], R rotation, t in m.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_setIdentity(ksl_SE3f_t *self) {
  self->m00 = 1.0f;
  self->m01 = 0.0f;
  self->m02 = 0.0f;
  self->m03 = 0.0f;
  self->m10 = 0.0f;
  self->m11 = 1.0f;
  self->m12 = 0.0f;
  self->m13 = 0.0f;
  self->m20 = 0.0f;
  self->m21 = 0.0f;
  self->m22 = 1.0f;
  self->m23 = 0.0f;
}

/* t of D = [R | t].
   D: displacement [R | t], R rotation, t in m; t: vector.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getTranslation(const ksl_SE3f_t *D, ksl_vec3f_t *t) {
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  t->x = D_m03;
  t->y = D_m13;
  t->z = D_m23;
}

/* R of D = [R | t].
   D: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   No arithmetic.
   Exact. */
static inline void ksl_SE3f_getRotation(const ksl_SE3f_t *D, ksl_mat3x3f_t *R) {
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  R->m00 = D_m00;
  R->m01 = D_m01;
  R->m02 = D_m02;
  R->m10 = D_m10;
  R->m11 = D_m11;
  R->m12 = D_m12;
  R->m20 = D_m20;
  R->m21 = D_m21;
  R->m22 = D_m22;
}

/* self = self^-1 = [R^T | -R^T t].
   self: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_invert(ksl_SE3f_t *self) {
  const float self_03_new_a = self->m00 * self->m03, self_03_new_b = self->m10 * self->m13,
      self_03_new_c = self_03_new_a + self_03_new_b, self_03_new_d = self->m20 * self->m23,
      self_03_new_e = self_03_new_c + self_03_new_d, self_03_new = -self_03_new_e;
  const float self_13_new_a = self->m01 * self->m03, self_13_new_b = self->m11 * self->m13,
      self_13_new_c = self_13_new_a + self_13_new_b, self_13_new_d = self->m21 * self->m23,
      self_13_new_e = self_13_new_c + self_13_new_d, self_13_new = -self_13_new_e;
  const float self_23_new_a = self->m02 * self->m03, self_23_new_b = self->m12 * self->m13,
      self_23_new_c = self_23_new_a + self_23_new_b, self_23_new_d = self->m22 * self->m23,
      self_23_new_e = self_23_new_c + self_23_new_d, self_23_new = -self_23_new_e;
  const float self_m10 = self->m10;
  const float self_m20 = self->m20;
  const float self_m01 = self->m01;
  const float self_m21 = self->m21;
  const float self_m02 = self->m02;
  const float self_m12 = self->m12;
  self->m01 = self_m10;
  self->m02 = self_m20;
  self->m03 = self_03_new;
  self->m10 = self_m01;
  self->m12 = self_m21;
  self->m13 = self_13_new;
  self->m20 = self_m02;
  self->m21 = self_m12;
  self->m23 = self_23_new;
}

/* Do = D^-1 = [R^T | -R^T t].
   D, Do: displacement [R | t], R rotation, t in m.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + (R: 0, t: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_SE3f_inverted(const ksl_SE3f_t *D, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * D->m03, Do_03b = D->m10 * D->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * D->m23, Do_03e = Do_03c + Do_03d, Do_03 = -Do_03e;
  const float Do_13a = D->m01 * D->m03, Do_13b = D->m11 * D->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * D->m23, Do_13e = Do_13c + Do_13d, Do_13 = -Do_13e;
  const float Do_23a = D->m02 * D->m03, Do_23b = D->m12 * D->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * D->m23, Do_23e = Do_23c + Do_23d, Do_23 = -Do_23e;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_SE3_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is no
     memory. */
static inline ksl_SE3_t *ksl_SE3_alloc(int n) {
  return n > 0 ? (ksl_SE3_t *)calloc((size_t)n, sizeof(ksl_SE3_t)) : NULL;
}

/* n zeroed ksl_SE3f_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_SE3f_t *ksl_SE3f_alloc(int n) {
  return n > 0 ? (ksl_SE3f_t *)calloc((size_t)n, sizeof(ksl_SE3f_t)) : NULL;
}

#endif

#endif

/* 6×6 operators on screws and coscrews, as [Ad], [Ad]*, [ad] and [ad]* return them. */
#ifndef KSL_MAT6X6_H
#define KSL_MAT6X6_H


/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline double ksl_mat6x6_get(const ksl_mat6x6_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (double)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6_set(ksl_mat6x6_t *M, const int row, const int column,
    const double value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_copy(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_10 = M->at[1][0];
  const double M_at_20 = M->at[2][0];
  const double M_at_30 = M->at[3][0];
  const double M_at_40 = M->at[4][0];
  const double M_at_50 = M->at[5][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_11 = M->at[1][1];
  const double M_at_21 = M->at[2][1];
  const double M_at_31 = M->at[3][1];
  const double M_at_41 = M->at[4][1];
  const double M_at_51 = M->at[5][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_12 = M->at[1][2];
  const double M_at_22 = M->at[2][2];
  const double M_at_32 = M->at[3][2];
  const double M_at_42 = M->at[4][2];
  const double M_at_52 = M->at[5][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_13 = M->at[1][3];
  const double M_at_23 = M->at[2][3];
  const double M_at_33 = M->at[3][3];
  const double M_at_43 = M->at[4][3];
  const double M_at_53 = M->at[5][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_14 = M->at[1][4];
  const double M_at_24 = M->at[2][4];
  const double M_at_34 = M->at[3][4];
  const double M_at_44 = M->at[4][4];
  const double M_at_54 = M->at[5][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_15 = M->at[1][5];
  const double M_at_25 = M->at[2][5];
  const double M_at_35 = M->at[3][5];
  const double M_at_45 = M->at[4][5];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_setIdentity(ksl_mat6x6_t *self) {
  self->at[0][0] = 1.0;
  self->at[1][0] = 0.0;
  self->at[2][0] = 0.0;
  self->at[3][0] = 0.0;
  self->at[4][0] = 0.0;
  self->at[5][0] = 0.0;
  self->at[0][1] = 0.0;
  self->at[1][1] = 1.0;
  self->at[2][1] = 0.0;
  self->at[3][1] = 0.0;
  self->at[4][1] = 0.0;
  self->at[5][1] = 0.0;
  self->at[0][2] = 0.0;
  self->at[1][2] = 0.0;
  self->at[2][2] = 1.0;
  self->at[3][2] = 0.0;
  self->at[4][2] = 0.0;
  self->at[5][2] = 0.0;
  self->at[0][3] = 0.0;
  self->at[1][3] = 0.0;
  self->at[2][3] = 0.0;
  self->at[3][3] = 1.0;
  self->at[4][3] = 0.0;
  self->at[5][3] = 0.0;
  self->at[0][4] = 0.0;
  self->at[1][4] = 0.0;
  self->at[2][4] = 0.0;
  self->at[3][4] = 0.0;
  self->at[4][4] = 1.0;
  self->at[5][4] = 0.0;
  self->at[0][5] = 0.0;
  self->at[1][5] = 0.0;
  self->at[2][5] = 0.0;
  self->at[3][5] = 0.0;
  self->at[4][5] = 0.0;
  self->at[5][5] = 1.0;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6_transposed(const ksl_mat6x6_t *M, ksl_mat6x6_t *Mo) {
  const double M_at_00 = M->at[0][0];
  const double M_at_01 = M->at[0][1];
  const double M_at_02 = M->at[0][2];
  const double M_at_03 = M->at[0][3];
  const double M_at_04 = M->at[0][4];
  const double M_at_05 = M->at[0][5];
  const double M_at_10 = M->at[1][0];
  const double M_at_11 = M->at[1][1];
  const double M_at_12 = M->at[1][2];
  const double M_at_13 = M->at[1][3];
  const double M_at_14 = M->at[1][4];
  const double M_at_15 = M->at[1][5];
  const double M_at_20 = M->at[2][0];
  const double M_at_21 = M->at[2][1];
  const double M_at_22 = M->at[2][2];
  const double M_at_23 = M->at[2][3];
  const double M_at_24 = M->at[2][4];
  const double M_at_25 = M->at[2][5];
  const double M_at_30 = M->at[3][0];
  const double M_at_31 = M->at[3][1];
  const double M_at_32 = M->at[3][2];
  const double M_at_33 = M->at[3][3];
  const double M_at_34 = M->at[3][4];
  const double M_at_35 = M->at[3][5];
  const double M_at_40 = M->at[4][0];
  const double M_at_41 = M->at[4][1];
  const double M_at_42 = M->at[4][2];
  const double M_at_43 = M->at[4][3];
  const double M_at_44 = M->at[4][4];
  const double M_at_45 = M->at[4][5];
  const double M_at_50 = M->at[5][0];
  const double M_at_51 = M->at[5][1];
  const double M_at_52 = M->at[5][2];
  const double M_at_53 = M->at[5][3];
  const double M_at_54 = M->at[5][4];
  const double M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

/* The entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; NaN outside. */
static inline float ksl_mat6x6f_get(const ksl_mat6x6f_t *M, const int row, const int column) {
  return row >= 0 && row < 6 && column >= 0 && column < 6 ? M->at[column][row] : (float)NAN;
}

/* Sets the entry of M at (row, column), for 0 <= row < 6 and 0 <= column < 6; does nothing
     outside. */
static inline void ksl_mat6x6f_set(ksl_mat6x6f_t *M, const int row, const int column,
    const float value) {
  if (row >= 0 && row < 6 && column >= 0 && column < 6) {
    M->at[column][row] = value;
  }
}

/* Mo = M.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_copy(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_10 = M->at[1][0];
  const float M_at_20 = M->at[2][0];
  const float M_at_30 = M->at[3][0];
  const float M_at_40 = M->at[4][0];
  const float M_at_50 = M->at[5][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_11 = M->at[1][1];
  const float M_at_21 = M->at[2][1];
  const float M_at_31 = M->at[3][1];
  const float M_at_41 = M->at[4][1];
  const float M_at_51 = M->at[5][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_12 = M->at[1][2];
  const float M_at_22 = M->at[2][2];
  const float M_at_32 = M->at[3][2];
  const float M_at_42 = M->at[4][2];
  const float M_at_52 = M->at[5][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_13 = M->at[1][3];
  const float M_at_23 = M->at[2][3];
  const float M_at_33 = M->at[3][3];
  const float M_at_43 = M->at[4][3];
  const float M_at_53 = M->at[5][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_14 = M->at[1][4];
  const float M_at_24 = M->at[2][4];
  const float M_at_34 = M->at[3][4];
  const float M_at_44 = M->at[4][4];
  const float M_at_54 = M->at[5][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_15 = M->at[1][5];
  const float M_at_25 = M->at[2][5];
  const float M_at_35 = M->at[3][5];
  const float M_at_45 = M->at[4][5];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_10;
  Mo->at[2][0] = M_at_20;
  Mo->at[3][0] = M_at_30;
  Mo->at[4][0] = M_at_40;
  Mo->at[5][0] = M_at_50;
  Mo->at[0][1] = M_at_01;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_21;
  Mo->at[3][1] = M_at_31;
  Mo->at[4][1] = M_at_41;
  Mo->at[5][1] = M_at_51;
  Mo->at[0][2] = M_at_02;
  Mo->at[1][2] = M_at_12;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_32;
  Mo->at[4][2] = M_at_42;
  Mo->at[5][2] = M_at_52;
  Mo->at[0][3] = M_at_03;
  Mo->at[1][3] = M_at_13;
  Mo->at[2][3] = M_at_23;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_43;
  Mo->at[5][3] = M_at_53;
  Mo->at[0][4] = M_at_04;
  Mo->at[1][4] = M_at_14;
  Mo->at[2][4] = M_at_24;
  Mo->at[3][4] = M_at_34;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_54;
  Mo->at[0][5] = M_at_05;
  Mo->at[1][5] = M_at_15;
  Mo->at[2][5] = M_at_25;
  Mo->at[3][5] = M_at_35;
  Mo->at[4][5] = M_at_45;
  Mo->at[5][5] = M_at_55;
}

/* self = I.
   self: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_setIdentity(ksl_mat6x6f_t *self) {
  self->at[0][0] = 1.0f;
  self->at[1][0] = 0.0f;
  self->at[2][0] = 0.0f;
  self->at[3][0] = 0.0f;
  self->at[4][0] = 0.0f;
  self->at[5][0] = 0.0f;
  self->at[0][1] = 0.0f;
  self->at[1][1] = 1.0f;
  self->at[2][1] = 0.0f;
  self->at[3][1] = 0.0f;
  self->at[4][1] = 0.0f;
  self->at[5][1] = 0.0f;
  self->at[0][2] = 0.0f;
  self->at[1][2] = 0.0f;
  self->at[2][2] = 1.0f;
  self->at[3][2] = 0.0f;
  self->at[4][2] = 0.0f;
  self->at[5][2] = 0.0f;
  self->at[0][3] = 0.0f;
  self->at[1][3] = 0.0f;
  self->at[2][3] = 0.0f;
  self->at[3][3] = 1.0f;
  self->at[4][3] = 0.0f;
  self->at[5][3] = 0.0f;
  self->at[0][4] = 0.0f;
  self->at[1][4] = 0.0f;
  self->at[2][4] = 0.0f;
  self->at[3][4] = 0.0f;
  self->at[4][4] = 1.0f;
  self->at[5][4] = 0.0f;
  self->at[0][5] = 0.0f;
  self->at[1][5] = 0.0f;
  self->at[2][5] = 0.0f;
  self->at[3][5] = 0.0f;
  self->at[4][5] = 0.0f;
  self->at[5][5] = 1.0f;
}

/* Mo = M^T.
   M, Mo: 6×6 operator.
   No arithmetic.
   Exact. */
static inline void ksl_mat6x6f_transposed(const ksl_mat6x6f_t *M, ksl_mat6x6f_t *Mo) {
  const float M_at_00 = M->at[0][0];
  const float M_at_01 = M->at[0][1];
  const float M_at_02 = M->at[0][2];
  const float M_at_03 = M->at[0][3];
  const float M_at_04 = M->at[0][4];
  const float M_at_05 = M->at[0][5];
  const float M_at_10 = M->at[1][0];
  const float M_at_11 = M->at[1][1];
  const float M_at_12 = M->at[1][2];
  const float M_at_13 = M->at[1][3];
  const float M_at_14 = M->at[1][4];
  const float M_at_15 = M->at[1][5];
  const float M_at_20 = M->at[2][0];
  const float M_at_21 = M->at[2][1];
  const float M_at_22 = M->at[2][2];
  const float M_at_23 = M->at[2][3];
  const float M_at_24 = M->at[2][4];
  const float M_at_25 = M->at[2][5];
  const float M_at_30 = M->at[3][0];
  const float M_at_31 = M->at[3][1];
  const float M_at_32 = M->at[3][2];
  const float M_at_33 = M->at[3][3];
  const float M_at_34 = M->at[3][4];
  const float M_at_35 = M->at[3][5];
  const float M_at_40 = M->at[4][0];
  const float M_at_41 = M->at[4][1];
  const float M_at_42 = M->at[4][2];
  const float M_at_43 = M->at[4][3];
  const float M_at_44 = M->at[4][4];
  const float M_at_45 = M->at[4][5];
  const float M_at_50 = M->at[5][0];
  const float M_at_51 = M->at[5][1];
  const float M_at_52 = M->at[5][2];
  const float M_at_53 = M->at[5][3];
  const float M_at_54 = M->at[5][4];
  const float M_at_55 = M->at[5][5];
  Mo->at[0][0] = M_at_00;
  Mo->at[1][0] = M_at_01;
  Mo->at[2][0] = M_at_02;
  Mo->at[3][0] = M_at_03;
  Mo->at[4][0] = M_at_04;
  Mo->at[5][0] = M_at_05;
  Mo->at[0][1] = M_at_10;
  Mo->at[1][1] = M_at_11;
  Mo->at[2][1] = M_at_12;
  Mo->at[3][1] = M_at_13;
  Mo->at[4][1] = M_at_14;
  Mo->at[5][1] = M_at_15;
  Mo->at[0][2] = M_at_20;
  Mo->at[1][2] = M_at_21;
  Mo->at[2][2] = M_at_22;
  Mo->at[3][2] = M_at_23;
  Mo->at[4][2] = M_at_24;
  Mo->at[5][2] = M_at_25;
  Mo->at[0][3] = M_at_30;
  Mo->at[1][3] = M_at_31;
  Mo->at[2][3] = M_at_32;
  Mo->at[3][3] = M_at_33;
  Mo->at[4][3] = M_at_34;
  Mo->at[5][3] = M_at_35;
  Mo->at[0][4] = M_at_40;
  Mo->at[1][4] = M_at_41;
  Mo->at[2][4] = M_at_42;
  Mo->at[3][4] = M_at_43;
  Mo->at[4][4] = M_at_44;
  Mo->at[5][4] = M_at_45;
  Mo->at[0][5] = M_at_50;
  Mo->at[1][5] = M_at_51;
  Mo->at[2][5] = M_at_52;
  Mo->at[3][5] = M_at_53;
  Mo->at[4][5] = M_at_54;
  Mo->at[5][5] = M_at_55;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_mat6x6_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_mat6x6_t *ksl_mat6x6_alloc(int n) {
  return n > 0 ? (ksl_mat6x6_t *)calloc((size_t)n, sizeof(ksl_mat6x6_t)) : NULL;
}

/* n zeroed ksl_mat6x6f_t on the heap, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_mat6x6f_t *ksl_mat6x6f_alloc(int n) {
  return n > 0 ? (ksl_mat6x6f_t *)calloc((size_t)n, sizeof(ksl_mat6x6f_t)) : NULL;
}

#endif

#endif

/* Products between rotations, displacements and vectors. */
#ifndef KSL_MATRIX_H
#define KSL_MATRIX_H


/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvv(const ksl_mat3x3_t *R, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0 = vo_0c + vo_0d;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1 = vo_1c + vo_1d;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinv(const ksl_mat3x3_t *R, const ksl_vec3_t *v,
    ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const double vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const double vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double vo_0a = D->m00 * v->x, vo_0b = D->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const double vo_1a = D->m10 * v->x, vo_1b = D->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const double vo_2a = D->m20 * v->x, vo_2b = D->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvv(const ksl_SE3_t *D, const ksl_vec3_t *v, ksl_vec3_t *vo) {
  const double p_0 = v->x - D->m03;
  const double p_1 = v->y - D->m13;
  const double p_2 = v->z - D->m23;
  const double vo_0a = D->m00 * p_0, vo_0b = D->m10 * p_1, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m20 * p_2, vo_0 = vo_0c + vo_0d;
  const double vo_1a = D->m01 * p_0, vo_1b = D->m11 * p_1, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m21 * p_2, vo_1 = vo_1c + vo_1d;
  const double vo_2a = D->m02 * p_0, vo_2b = D->m12 * p_1, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * p_2, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m01 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m10 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m10 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m20 * R2->m01, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m20 * R2->m02, Ro_22b = R1->m21 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinv(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m02, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m10, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m12, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m20, Ro_02b = R1->m01 * R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m02, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m10 * R2->m10, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m12, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m10 * R2->m20, Ro_12b = R1->m11 * R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m02, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m20 * R2->m10, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m12, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m20 * R2->m20, Ro_22b = R1->m21 * R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdr(const ksl_mat3x3_t *R1, const ksl_mat3x3_t *R2,
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m10 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m20 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const double Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m10 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m20 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const double Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m10 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m20 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const double Ro_10a = R1->m01 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m21 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const double Ro_11a = R1->m01 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m21 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const double Ro_12a = R1->m01 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m21 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const double Ro_20a = R1->m02 * R2->m00, Ro_20b = R1->m12 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const double Ro_21a = R1->m02 * R2->m01, Ro_21b = R1->m12 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const double Ro_22a = R1->m02 * R2->m02, Ro_22b = R1->m12 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m01 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m02 * D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m01 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m02 * D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m01 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = D1->m00 * D2->m03, Do_03b = D1->m01 * D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * D2->m23, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const double Do_10a = D1->m10 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m12 * D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D1->m10 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m12 * D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D1->m10 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = D1->m10 * D2->m03, Do_13b = D1->m11 * D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * D2->m23, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const double Do_20a = D1->m20 * D2->m00, Do_20b = D1->m21 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D1->m20 * D2->m01, Do_21b = D1->m21 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D1->m20 * D2->m02, Do_22b = D1->m21 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = D1->m20 * D2->m03, Do_23b = D1->m21 * D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * D2->m23, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinv(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double R_0a = D1->m00 * D2->m00, R_0b = D1->m01 * D2->m01, R_0c = R_0a + R_0b,
      R_0d = D1->m02 * D2->m02, R_0 = R_0c + R_0d;
  const double R_1a = D1->m00 * D2->m10, R_1b = D1->m01 * D2->m11, R_1c = R_1a + R_1b,
      R_1d = D1->m02 * D2->m12, R_1 = R_1c + R_1d;
  const double R_2a = D1->m00 * D2->m20, R_2b = D1->m01 * D2->m21, R_2c = R_2a + R_2b,
      R_2d = D1->m02 * D2->m22, R_2 = R_2c + R_2d;
  const double R_3a = D1->m10 * D2->m00, R_3b = D1->m11 * D2->m01, R_3c = R_3a + R_3b,
      R_3d = D1->m12 * D2->m02, R_3 = R_3c + R_3d;
  const double R_4a = D1->m10 * D2->m10, R_4b = D1->m11 * D2->m11, R_4c = R_4a + R_4b,
      R_4d = D1->m12 * D2->m12, R_4 = R_4c + R_4d;
  const double R_5a = D1->m10 * D2->m20, R_5b = D1->m11 * D2->m21, R_5c = R_5a + R_5b,
      R_5d = D1->m12 * D2->m22, R_5 = R_5c + R_5d;
  const double R_6a = D1->m20 * D2->m00, R_6b = D1->m21 * D2->m01, R_6c = R_6a + R_6b,
      R_6d = D1->m22 * D2->m02, R_6 = R_6c + R_6d;
  const double R_7a = D1->m20 * D2->m10, R_7b = D1->m21 * D2->m11, R_7c = R_7a + R_7b,
      R_7d = D1->m22 * D2->m12, R_7 = R_7c + R_7d;
  const double R_8a = D1->m20 * D2->m20, R_8b = D1->m21 * D2->m21, R_8c = R_8a + R_8b,
      R_8d = D1->m22 * D2->m22, R_8 = R_8c + R_8d;
  const double Do_03a = D2->m03 * R_0, Do_03b = D2->m13 * R_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D2->m23 * R_2, Do_03e = Do_03c + Do_03d, Do_03 = D1->m03 - Do_03e;
  const double Do_13a = D2->m03 * R_3, Do_13b = D2->m13 * R_4, Do_13c = Do_13a + Do_13b,
      Do_13d = D2->m23 * R_5, Do_13e = Do_13c + Do_13d, Do_13 = D1->m13 - Do_13e;
  const double Do_23a = D2->m03 * R_6, Do_23b = D2->m13 * R_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D2->m23 * R_8, Do_23e = Do_23c + Do_23d, Do_23 = D1->m23 - Do_23e;
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvd(const ksl_SE3_t *D1, const ksl_SE3_t *D2, ksl_SE3_t *Do) {
  const double p_0 = D2->m03 - D1->m03;
  const double p_1 = D2->m13 - D1->m13;
  const double p_2 = D2->m23 - D1->m23;
  const double Do_00a = D1->m00 * D2->m00, Do_00b = D1->m10 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m20 * D2->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D1->m00 * D2->m01, Do_01b = D1->m10 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m20 * D2->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D1->m00 * D2->m02, Do_02b = D1->m10 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m20 * D2->m22, Do_02 = Do_02c + Do_02d;
  const double Do_03a = D1->m00 * p_0, Do_03b = D1->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_10a = D1->m01 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m21 * D2->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D1->m01 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m21 * D2->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D1->m01 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m21 * D2->m22, Do_12 = Do_12c + Do_12d;
  const double Do_13a = D1->m01 * p_0, Do_13b = D1->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_20a = D1->m02 * D2->m00, Do_20b = D1->m12 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D1->m02 * D2->m01, Do_21b = D1->m12 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D1->m02 * D2->m02, Do_22b = D1->m12 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const double Do_23a = D1->m02 * p_0, Do_23b = D1->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * p_2, Do_23 = Do_23c + Do_23d;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddr(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m20, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D->m00 * R->m01, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m21, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D->m00 * R->m02, Do_02b = D->m01 * R->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m20, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D->m10 * R->m01, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m21, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D->m10 * R->m02, Do_12b = D->m11 * R->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m20, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D->m20 * R->m01, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m21, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D->m20 * R->m02, Do_22b = D->m21 * R->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinv(const ksl_SE3_t *D, const ksl_mat3x3_t *R, ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m01, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m02, Do_00 = Do_00c + Do_00d;
  const double Do_01a = D->m00 * R->m10, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m12, Do_01 = Do_01c + Do_01d;
  const double Do_02a = D->m00 * R->m20, Do_02b = D->m01 * R->m21, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const double Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m01, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m02, Do_10 = Do_10c + Do_10d;
  const double Do_11a = D->m10 * R->m10, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m12, Do_11 = Do_11c + Do_11d;
  const double Do_12a = D->m10 * R->m20, Do_12b = D->m11 * R->m21, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const double Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m01, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m02, Do_20 = Do_20c + Do_20d;
  const double Do_21a = D->m20 * R->m10, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m12, Do_21 = Do_21c + Do_21d;
  const double Do_22a = D->m20 * R->m20, Do_22b = D->m21 * R->m21, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const double D_m03 = D->m03;
  const double D_m13 = D->m13;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D->m03;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D->m13;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D->m23;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinv(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = D->m03 - Do_03e;
  const double Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = D->m13 - Do_13e;
  const double Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = D->m23 - Do_23e;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdt(const ksl_SE3_t *D, const ksl_vec3_t *t, ksl_SE3_t *Do) {
  const double p_0 = t->x - D->m03;
  const double p_1 = t->y - D->m13;
  const double p_2 = t->z - D->m23;
  const double Do_03a = D->m00 * p_0, Do_03b = D->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const double Do_13a = D->m01 * p_0, Do_13b = D->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const double Do_23a = D->m02 * p_0, Do_23b = D->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * p_2, Do_23 = Do_23c + Do_23d;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtx(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m00 * k;
  const double vo_1 = R->m10 * k;
  const double vo_2 = R->m20 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrx(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a + Ro_01b;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m01 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a + Ro_11b;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m11 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a + Ro_21b;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m21 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrx(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a + Do_01b;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m01 * dc[0], Do_02 = Do_02a - Do_02b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a + Do_11b;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m11 * dc[0], Do_12 = Do_12a - Do_12b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a + Do_21b;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m21 * dc[0], Do_22 = Do_22a - Do_22b;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtx(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m10 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m20 * k, Do_23 = Do_23a + D->m23;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m00 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m10 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m20 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const double Ro_02a = R->m01 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const double Ro_12a = R->m11 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const double Ro_22a = R->m21 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const double R_m00 = R->m00;
  const double R_m10 = R->m10;
  const double R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a - Do_01b;
  const double Do_02a = D->m01 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a - Do_11b;
  const double Do_12a = D->m11 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a - Do_21b;
  const double Do_22a = D->m21 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const double D_m00 = D->m00;
  const double D_m03 = D->m03;
  const double D_m10 = D->m10;
  const double D_m13 = D->m13;
  const double D_m20 = D->m20;
  const double D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m00 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m10 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m20 * k, Do_23 = D->m23 - Do_23a;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvty(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m01 * k;
  const double vo_1 = R->m11 * k;
  const double vo_2 = R->m21 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdry(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const double Ro_02a = R->m00 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const double Ro_12a = R->m10 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const double Ro_22a = R->m20 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddry(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a - Do_00b;
  const double Do_02a = D->m00 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a - Do_10b;
  const double Do_12a = D->m10 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a - Do_20b;
  const double Do_22a = D->m20 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddty(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m11 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m21 * k, Do_23 = Do_23a + D->m23;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m01 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m11 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m21 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const double Ro_02a = R->m02 * dc[1], Ro_02b = R->m00 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const double Ro_12a = R->m12 * dc[1], Ro_12b = R->m10 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const double Ro_22a = R->m22 * dc[1], Ro_22b = R->m20 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const double R_m01 = R->m01;
  const double R_m11 = R->m11;
  const double R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a + Do_00b;
  const double Do_02a = D->m02 * dc[1], Do_02b = D->m00 * dc[0], Do_02 = Do_02a - Do_02b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a + Do_10b;
  const double Do_12a = D->m12 * dc[1], Do_12b = D->m10 * dc[0], Do_12 = Do_12a - Do_12b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a + Do_20b;
  const double Do_22a = D->m22 * dc[1], Do_22b = D->m20 * dc[0], Do_22 = Do_22a - Do_22b;
  const double D_m01 = D->m01;
  const double D_m03 = D->m03;
  const double D_m11 = D->m11;
  const double D_m13 = D->m13;
  const double D_m21 = D->m21;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m01 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m11 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m21 * k, Do_23 = D->m23 - Do_23a;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtz(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0 = R->m02 * k;
  const double vo_1 = R->m12 * k;
  const double vo_2 = R->m22 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrz(const ksl_mat3x3_t *R, const double dc[2], ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const double Ro_01a = R->m01 * dc[1], Ro_01b = R->m00 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const double Ro_11a = R->m11 * dc[1], Ro_11b = R->m10 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const double Ro_21a = R->m21 * dc[1], Ro_21b = R->m20 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrz(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a + Do_00b;
  const double Do_01a = D->m01 * dc[1], Do_01b = D->m00 * dc[0], Do_01 = Do_01a - Do_01b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a + Do_10b;
  const double Do_11a = D->m11 * dc[1], Do_11b = D->m10 * dc[0], Do_11 = Do_11a - Do_11b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a + Do_20b;
  const double Do_21a = D->m21 * dc[1], Do_21b = D->m20 * dc[0], Do_21 = Do_21a - Do_21b;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtz(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = Do_03a + D->m03;
  const double Do_13a = D->m12 * k, Do_13 = Do_13a + D->m13;
  const double Do_23a = D->m22 * k, Do_23 = Do_23a + D->m23;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinv(const ksl_mat3x3_t *R, const double k, ksl_vec3_t *vo) {
  const double vo_0a = R->m02 * k, vo_0 = -vo_0a;
  const double vo_1a = R->m12 * k, vo_1 = -vo_1a;
  const double vo_2a = R->m22 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinv(const ksl_mat3x3_t *R, const double dc[2],
    ksl_mat3x3_t *Ro) {
  const double Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const double Ro_01a = R->m00 * dc[0], Ro_01b = R->m01 * dc[1], Ro_01 = Ro_01a + Ro_01b;
  const double Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const double Ro_11a = R->m10 * dc[0], Ro_11b = R->m11 * dc[1], Ro_11 = Ro_11a + Ro_11b;
  const double Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const double Ro_21a = R->m20 * dc[0], Ro_21b = R->m21 * dc[1], Ro_21 = Ro_21a + Ro_21b;
  const double R_m02 = R->m02;
  const double R_m12 = R->m12;
  const double R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinv(const ksl_SE3_t *D, const double dc[2], ksl_SE3_t *Do) {
  const double Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a - Do_00b;
  const double Do_01a = D->m00 * dc[0], Do_01b = D->m01 * dc[1], Do_01 = Do_01a + Do_01b;
  const double Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a - Do_10b;
  const double Do_11a = D->m10 * dc[0], Do_11b = D->m11 * dc[1], Do_11 = Do_11a + Do_11b;
  const double Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a - Do_20b;
  const double Do_21a = D->m20 * dc[0], Do_21b = D->m21 * dc[1], Do_21 = Do_21a + Do_21b;
  const double D_m02 = D->m02;
  const double D_m03 = D->m03;
  const double D_m12 = D->m12;
  const double D_m13 = D->m13;
  const double D_m22 = D->m22;
  const double D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinv(const ksl_SE3_t *D, const double k, ksl_SE3_t *Do) {
  const double Do_03a = D->m02 * k, Do_03 = D->m03 - Do_03a;
  const double Do_13a = D->m12 * k, Do_13 = D->m13 - Do_13a;
  const double Do_23a = D->m22 * k, Do_23 = D->m23 - Do_23a;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0 = vo_0c + vo_0d;
  const float vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1 = vo_1c + vo_1d;
  const float vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = R->m10 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = R->m20 * v->x, vo_2b = R->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T v.
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0 = vo_0c + vo_0d;
  const float vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1 = vo_1c + vo_1d;
  const float vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (-v).
   R: rotation or other 3×3 matrix; v, vo: vector.
   9 mul, 6 add, 3 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvvinvf(const ksl_mat3x3f_t *R, const ksl_vec3f_t *v,
    ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * v->x, vo_0b = R->m10 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = R->m20 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = -vo_0e;
  const float vo_1a = R->m01 * v->x, vo_1b = R->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = R->m21 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = -vo_1e;
  const float vo_2a = R->m02 * v->x, vo_2b = R->m12 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = R->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = -vo_2e;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R v + t.
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float vo_0a = D->m00 * v->x, vo_0b = D->m01 * v->y, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m02 * v->z, vo_0e = vo_0c + vo_0d, vo_0 = vo_0e + D->m03;
  const float vo_1a = D->m10 * v->x, vo_1b = D->m11 * v->y, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m12 * v->z, vo_1e = vo_1c + vo_1d, vo_1 = vo_1e + D->m13;
  const float vo_2a = D->m20 * v->x, vo_2b = D->m21 * v->y, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * v->z, vo_2e = vo_2c + vo_2d, vo_2 = vo_2e + D->m23;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* vo = R^T (v - t).
   D: displacement [R | t], R rotation, t in m; v, vo: vector.
   9 mul, 9 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_dinvvf(const ksl_SE3f_t *D, const ksl_vec3f_t *v, ksl_vec3f_t *vo) {
  const float p_0 = v->x - D->m03;
  const float p_1 = v->y - D->m13;
  const float p_2 = v->z - D->m23;
  const float vo_0a = D->m00 * p_0, vo_0b = D->m10 * p_1, vo_0c = vo_0a + vo_0b,
      vo_0d = D->m20 * p_2, vo_0 = vo_0c + vo_0d;
  const float vo_1a = D->m01 * p_0, vo_1b = D->m11 * p_1, vo_1c = vo_1a + vo_1b,
      vo_1d = D->m21 * p_2, vo_1 = vo_1c + vo_1d;
  const float vo_2a = D->m02 * p_0, vo_2b = D->m12 * p_1, vo_2c = vo_2a + vo_2b,
      vo_2d = D->m22 * p_2, vo_2 = vo_2c + vo_2d;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R1 R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m01 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m10 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m10 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m20 * R2->m01, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m20 * R2->m02, Ro_22b = R1->m21 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1 R2^T.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrinvf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m01 * R2->m01, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m02 * R2->m02, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m10, Ro_01b = R1->m01 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m02 * R2->m12, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m20, Ro_02b = R1->m01 * R2->m21, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m02 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m10 * R2->m00, Ro_10b = R1->m11 * R2->m01, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m12 * R2->m02, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m10 * R2->m10, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m12 * R2->m12, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m10 * R2->m20, Ro_12b = R1->m11 * R2->m21, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m12 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m20 * R2->m00, Ro_20b = R1->m21 * R2->m01, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m02, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m20 * R2->m10, Ro_21b = R1->m21 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m12, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m20 * R2->m20, Ro_22b = R1->m21 * R2->m21, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Ro = R1^T R2.
   R1, R2, Ro: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drinvdrf(const ksl_mat3x3f_t *R1, const ksl_mat3x3f_t *R2,
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R1->m00 * R2->m00, Ro_00b = R1->m10 * R2->m10, Ro_00c = Ro_00a + Ro_00b,
      Ro_00d = R1->m20 * R2->m20, Ro_00 = Ro_00c + Ro_00d;
  const float Ro_01a = R1->m00 * R2->m01, Ro_01b = R1->m10 * R2->m11, Ro_01c = Ro_01a + Ro_01b,
      Ro_01d = R1->m20 * R2->m21, Ro_01 = Ro_01c + Ro_01d;
  const float Ro_02a = R1->m00 * R2->m02, Ro_02b = R1->m10 * R2->m12, Ro_02c = Ro_02a + Ro_02b,
      Ro_02d = R1->m20 * R2->m22, Ro_02 = Ro_02c + Ro_02d;
  const float Ro_10a = R1->m01 * R2->m00, Ro_10b = R1->m11 * R2->m10, Ro_10c = Ro_10a + Ro_10b,
      Ro_10d = R1->m21 * R2->m20, Ro_10 = Ro_10c + Ro_10d;
  const float Ro_11a = R1->m01 * R2->m01, Ro_11b = R1->m11 * R2->m11, Ro_11c = Ro_11a + Ro_11b,
      Ro_11d = R1->m21 * R2->m21, Ro_11 = Ro_11c + Ro_11d;
  const float Ro_12a = R1->m01 * R2->m02, Ro_12b = R1->m11 * R2->m12, Ro_12c = Ro_12a + Ro_12b,
      Ro_12d = R1->m21 * R2->m22, Ro_12 = Ro_12c + Ro_12d;
  const float Ro_20a = R1->m02 * R2->m00, Ro_20b = R1->m12 * R2->m10, Ro_20c = Ro_20a + Ro_20b,
      Ro_20d = R1->m22 * R2->m20, Ro_20 = Ro_20c + Ro_20d;
  const float Ro_21a = R1->m02 * R2->m01, Ro_21b = R1->m12 * R2->m11, Ro_21c = Ro_21a + Ro_21b,
      Ro_21d = R1->m22 * R2->m21, Ro_21 = Ro_21c + Ro_21d;
  const float Ro_22a = R1->m02 * R2->m02, Ro_22b = R1->m12 * R2->m12, Ro_22c = Ro_22a + Ro_22b,
      Ro_22d = R1->m22 * R2->m22, Ro_22 = Ro_22c + Ro_22d;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D1 D2 = [R1 R2 | R1 t2 + t1].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float Do_00a = D1->m00 * D2->m00, Do_00b = D1->m01 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m02 * D2->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D1->m00 * D2->m01, Do_01b = D1->m01 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m02 * D2->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D1->m00 * D2->m02, Do_02b = D1->m01 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m02 * D2->m22, Do_02 = Do_02c + Do_02d;
  const float Do_03a = D1->m00 * D2->m03, Do_03b = D1->m01 * D2->m13, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m02 * D2->m23, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D1->m03;
  const float Do_10a = D1->m10 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m12 * D2->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D1->m10 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m12 * D2->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D1->m10 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m12 * D2->m22, Do_12 = Do_12c + Do_12d;
  const float Do_13a = D1->m10 * D2->m03, Do_13b = D1->m11 * D2->m13, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m12 * D2->m23, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D1->m13;
  const float Do_20a = D1->m20 * D2->m00, Do_20b = D1->m21 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D1->m20 * D2->m01, Do_21b = D1->m21 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D1->m20 * D2->m02, Do_22b = D1->m21 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const float Do_23a = D1->m20 * D2->m03, Do_23b = D1->m21 * D2->m13, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * D2->m23, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D1->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D1 D2^-1 = [R | t1 - R t2], R = R1 R2^T.
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 6) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddinvf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float R_0a = D1->m00 * D2->m00, R_0b = D1->m01 * D2->m01, R_0c = R_0a + R_0b,
      R_0d = D1->m02 * D2->m02, R_0 = R_0c + R_0d;
  const float R_1a = D1->m00 * D2->m10, R_1b = D1->m01 * D2->m11, R_1c = R_1a + R_1b,
      R_1d = D1->m02 * D2->m12, R_1 = R_1c + R_1d;
  const float R_2a = D1->m00 * D2->m20, R_2b = D1->m01 * D2->m21, R_2c = R_2a + R_2b,
      R_2d = D1->m02 * D2->m22, R_2 = R_2c + R_2d;
  const float R_3a = D1->m10 * D2->m00, R_3b = D1->m11 * D2->m01, R_3c = R_3a + R_3b,
      R_3d = D1->m12 * D2->m02, R_3 = R_3c + R_3d;
  const float R_4a = D1->m10 * D2->m10, R_4b = D1->m11 * D2->m11, R_4c = R_4a + R_4b,
      R_4d = D1->m12 * D2->m12, R_4 = R_4c + R_4d;
  const float R_5a = D1->m10 * D2->m20, R_5b = D1->m11 * D2->m21, R_5c = R_5a + R_5b,
      R_5d = D1->m12 * D2->m22, R_5 = R_5c + R_5d;
  const float R_6a = D1->m20 * D2->m00, R_6b = D1->m21 * D2->m01, R_6c = R_6a + R_6b,
      R_6d = D1->m22 * D2->m02, R_6 = R_6c + R_6d;
  const float R_7a = D1->m20 * D2->m10, R_7b = D1->m21 * D2->m11, R_7c = R_7a + R_7b,
      R_7d = D1->m22 * D2->m12, R_7 = R_7c + R_7d;
  const float R_8a = D1->m20 * D2->m20, R_8b = D1->m21 * D2->m21, R_8c = R_8a + R_8b,
      R_8d = D1->m22 * D2->m22, R_8 = R_8c + R_8d;
  const float Do_03a = D2->m03 * R_0, Do_03b = D2->m13 * R_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D2->m23 * R_2, Do_03e = Do_03c + Do_03d, Do_03 = D1->m03 - Do_03e;
  const float Do_13a = D2->m03 * R_3, Do_13b = D2->m13 * R_4, Do_13c = Do_13a + Do_13b,
      Do_13d = D2->m23 * R_5, Do_13e = Do_13c + Do_13d, Do_13 = D1->m13 - Do_13e;
  const float Do_23a = D2->m03 * R_6, Do_23b = D2->m13 * R_7, Do_23c = Do_23a + Do_23b,
      Do_23d = D2->m23 * R_8, Do_23e = Do_23c + Do_23d, Do_23 = D1->m23 - Do_23e;
  Do->m00 = R_0;
  Do->m01 = R_1;
  Do->m02 = R_2;
  Do->m03 = Do_03;
  Do->m10 = R_3;
  Do->m11 = R_4;
  Do->m12 = R_5;
  Do->m13 = Do_13;
  Do->m20 = R_6;
  Do->m21 = R_7;
  Do->m22 = R_8;
  Do->m23 = Do_23;
}

/* Do = D1^-1 D2 = [R1^T R2 | R1^T (t2 - t1)].
   D1, D2, Do: displacement [R | t], R rotation, t in m.
   36 mul, 27 add.
   Error <= u |result| + (R: 2, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdf(const ksl_SE3f_t *D1, const ksl_SE3f_t *D2, ksl_SE3f_t *Do) {
  const float p_0 = D2->m03 - D1->m03;
  const float p_1 = D2->m13 - D1->m13;
  const float p_2 = D2->m23 - D1->m23;
  const float Do_00a = D1->m00 * D2->m00, Do_00b = D1->m10 * D2->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D1->m20 * D2->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D1->m00 * D2->m01, Do_01b = D1->m10 * D2->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D1->m20 * D2->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D1->m00 * D2->m02, Do_02b = D1->m10 * D2->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D1->m20 * D2->m22, Do_02 = Do_02c + Do_02d;
  const float Do_03a = D1->m00 * p_0, Do_03b = D1->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D1->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const float Do_10a = D1->m01 * D2->m00, Do_10b = D1->m11 * D2->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D1->m21 * D2->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D1->m01 * D2->m01, Do_11b = D1->m11 * D2->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D1->m21 * D2->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D1->m01 * D2->m02, Do_12b = D1->m11 * D2->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D1->m21 * D2->m22, Do_12 = Do_12c + Do_12d;
  const float Do_13a = D1->m01 * p_0, Do_13b = D1->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D1->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const float Do_20a = D1->m02 * D2->m00, Do_20b = D1->m12 * D2->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D1->m22 * D2->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D1->m02 * D2->m01, Do_21b = D1->m12 * D2->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D1->m22 * D2->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D1->m02 * D2->m02, Do_22b = D1->m12 * D2->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D1->m22 * D2->m22, Do_22 = Do_22c + Do_22d;
  const float Do_23a = D1->m02 * p_0, Do_23b = D1->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D1->m22 * p_2, Do_23 = Do_23c + Do_23d;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = Do_03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = Do_13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = Do_23;
}

/* Do = D [R | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R, ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m10, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m20, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D->m00 * R->m01, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m21, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D->m00 * R->m02, Do_02b = D->m01 * R->m12, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const float Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m10, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m20, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D->m10 * R->m01, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m21, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D->m10 * R->m02, Do_12b = D->m11 * R->m12, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const float Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m10, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m20, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D->m20 * R->m01, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m21, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D->m20 * R->m02, Do_22b = D->m21 * R->m12, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [R^T | 0].
   D, Do: displacement [R | t], R rotation, t in m; R: rotation or other 3×3 matrix.
   27 mul, 18 add.
   Error <= u |result| + (R: 2, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrinvf(const ksl_SE3f_t *D, const ksl_mat3x3f_t *R,
    ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * R->m00, Do_00b = D->m01 * R->m01, Do_00c = Do_00a + Do_00b,
      Do_00d = D->m02 * R->m02, Do_00 = Do_00c + Do_00d;
  const float Do_01a = D->m00 * R->m10, Do_01b = D->m01 * R->m11, Do_01c = Do_01a + Do_01b,
      Do_01d = D->m02 * R->m12, Do_01 = Do_01c + Do_01d;
  const float Do_02a = D->m00 * R->m20, Do_02b = D->m01 * R->m21, Do_02c = Do_02a + Do_02b,
      Do_02d = D->m02 * R->m22, Do_02 = Do_02c + Do_02d;
  const float Do_10a = D->m10 * R->m00, Do_10b = D->m11 * R->m01, Do_10c = Do_10a + Do_10b,
      Do_10d = D->m12 * R->m02, Do_10 = Do_10c + Do_10d;
  const float Do_11a = D->m10 * R->m10, Do_11b = D->m11 * R->m11, Do_11c = Do_11a + Do_11b,
      Do_11d = D->m12 * R->m12, Do_11 = Do_11c + Do_11d;
  const float Do_12a = D->m10 * R->m20, Do_12b = D->m11 * R->m21, Do_12c = Do_12a + Do_12b,
      Do_12d = D->m12 * R->m22, Do_12 = Do_12c + Do_12d;
  const float Do_20a = D->m20 * R->m00, Do_20b = D->m21 * R->m01, Do_20c = Do_20a + Do_20b,
      Do_20d = D->m22 * R->m02, Do_20 = Do_20c + Do_20d;
  const float Do_21a = D->m20 * R->m10, Do_21b = D->m21 * R->m11, Do_21c = Do_21a + Do_21b,
      Do_21d = D->m22 * R->m12, Do_21 = Do_21c + Do_21d;
  const float Do_22a = D->m20 * R->m20, Do_22b = D->m21 * R->m21, Do_22c = Do_22a + Do_22b,
      Do_22d = D->m22 * R->m22, Do_22 = Do_22c + Do_22d;
  const float D_m03 = D->m03;
  const float D_m13 = D->m13;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = Do_03e + D->m03;
  const float Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = Do_13e + D->m13;
  const float Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = Do_23e + D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D [I | -t].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtinvf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * t->x, Do_03b = D->m01 * t->y, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m02 * t->z, Do_03e = Do_03c + Do_03d, Do_03 = D->m03 - Do_03e;
  const float Do_13a = D->m10 * t->x, Do_13b = D->m11 * t->y, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m12 * t->z, Do_13e = Do_13c + Do_13d, Do_13 = D->m13 - Do_13e;
  const float Do_23a = D->m20 * t->x, Do_23b = D->m21 * t->y, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * t->z, Do_23e = Do_23c + Do_23d, Do_23 = D->m23 - Do_23e;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* Do = D^-1 [I | t] = [R^T | R^T (t - t_D)].
   D, Do: displacement [R | t], R rotation, t in m; t: vector.
   9 mul, 9 add.
   Error <= u |result| + (R: 0, t: 3) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_dinvdtf(const ksl_SE3f_t *D, const ksl_vec3f_t *t, ksl_SE3f_t *Do) {
  const float p_0 = t->x - D->m03;
  const float p_1 = t->y - D->m13;
  const float p_2 = t->z - D->m23;
  const float Do_03a = D->m00 * p_0, Do_03b = D->m10 * p_1, Do_03c = Do_03a + Do_03b,
      Do_03d = D->m20 * p_2, Do_03 = Do_03c + Do_03d;
  const float Do_13a = D->m01 * p_0, Do_13b = D->m11 * p_1, Do_13c = Do_13a + Do_13b,
      Do_13d = D->m21 * p_2, Do_13 = Do_13c + Do_13d;
  const float Do_23a = D->m02 * p_0, Do_23b = D->m12 * p_1, Do_23c = Do_23a + Do_23b,
      Do_23d = D->m22 * p_2, Do_23 = Do_23c + Do_23d;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m10;
  Do->m02 = D_m20;
  Do->m03 = Do_03;
  Do->m10 = D_m01;
  Do->m11 = D_m11;
  Do->m12 = D_m21;
  Do->m13 = Do_13;
  Do->m20 = D_m02;
  Do->m21 = D_m12;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m00 * k;
  const float vo_1 = R->m10 * k;
  const float vo_2 = R->m20 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a + Ro_01b;
  const float Ro_02a = R->m02 * dc[1], Ro_02b = R->m01 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a + Ro_11b;
  const float Ro_12a = R->m12 * dc[1], Ro_12b = R->m11 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a + Ro_21b;
  const float Ro_22a = R->m22 * dc[1], Ro_22b = R->m21 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a + Do_01b;
  const float Do_02a = D->m02 * dc[1], Do_02b = D->m01 * dc[0], Do_02 = Do_02a - Do_02b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a + Do_11b;
  const float Do_12a = D->m12 * dc[1], Do_12b = D->m11 * dc[0], Do_12 = Do_12a - Do_12b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a + Do_21b;
  const float Do_22a = D->m22 * dc[1], Do_22b = D->m21 * dc[0], Do_22 = Do_22a - Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m10 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m20 * k, Do_23 = Do_23a + D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_x).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtxinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m00 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m10 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m20 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_x(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrxinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m02 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const float Ro_02a = R->m01 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m12 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const float Ro_12a = R->m11 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m22 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const float Ro_22a = R->m21 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const float R_m00 = R->m00;
  const float R_m10 = R->m10;
  const float R_m20 = R->m20;
  Ro->m00 = R_m00;
  Ro->m01 = Ro_01;
  Ro->m02 = Ro_02;
  Ro->m10 = R_m10;
  Ro->m11 = Ro_11;
  Ro->m12 = Ro_12;
  Ro->m20 = R_m20;
  Ro->m21 = Ro_21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_x(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrxinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m02 * dc[0], Do_01 = Do_01a - Do_01b;
  const float Do_02a = D->m01 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m12 * dc[0], Do_11 = Do_11a - Do_11b;
  const float Do_12a = D->m11 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m22 * dc[0], Do_21 = Do_21a - Do_21b;
  const float Do_22a = D->m21 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const float D_m00 = D->m00;
  const float D_m03 = D->m03;
  const float D_m10 = D->m10;
  const float D_m13 = D->m13;
  const float D_m20 = D->m20;
  const float D_m23 = D->m23;
  Do->m00 = D_m00;
  Do->m01 = Do_01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = D_m10;
  Do->m11 = Do_11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = D_m20;
  Do->m21 = Do_21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_x].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtxinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m00 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m10 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m20 * k, Do_23 = D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m01 * k;
  const float vo_1 = R->m11 * k;
  const float vo_2 = R->m21 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const float Ro_02a = R->m00 * dc[0], Ro_02b = R->m02 * dc[1], Ro_02 = Ro_02a + Ro_02b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const float Ro_12a = R->m10 * dc[0], Ro_12b = R->m12 * dc[1], Ro_12 = Ro_12a + Ro_12b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const float Ro_22a = R->m20 * dc[0], Ro_22b = R->m22 * dc[1], Ro_22 = Ro_22a + Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a - Do_00b;
  const float Do_02a = D->m00 * dc[0], Do_02b = D->m02 * dc[1], Do_02 = Do_02a + Do_02b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a - Do_10b;
  const float Do_12a = D->m10 * dc[0], Do_12b = D->m12 * dc[1], Do_12 = Do_12a + Do_12b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a - Do_20b;
  const float Do_22a = D->m20 * dc[0], Do_22b = D->m22 * dc[1], Do_22 = Do_22a + Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m01 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m11 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m21 * k, Do_23 = Do_23a + D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_y).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtyinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m01 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m11 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m21 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_y(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdryinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m02 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const float Ro_02a = R->m02 * dc[1], Ro_02b = R->m00 * dc[0], Ro_02 = Ro_02a - Ro_02b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m12 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const float Ro_12a = R->m12 * dc[1], Ro_12b = R->m10 * dc[0], Ro_12 = Ro_12a - Ro_12b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m22 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const float Ro_22a = R->m22 * dc[1], Ro_22b = R->m20 * dc[0], Ro_22 = Ro_22a - Ro_22b;
  const float R_m01 = R->m01;
  const float R_m11 = R->m11;
  const float R_m21 = R->m21;
  Ro->m00 = Ro_00;
  Ro->m01 = R_m01;
  Ro->m02 = Ro_02;
  Ro->m10 = Ro_10;
  Ro->m11 = R_m11;
  Ro->m12 = Ro_12;
  Ro->m20 = Ro_20;
  Ro->m21 = R_m21;
  Ro->m22 = Ro_22;
}

/* Do = D [R_y(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddryinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m02 * dc[0], Do_00 = Do_00a + Do_00b;
  const float Do_02a = D->m02 * dc[1], Do_02b = D->m00 * dc[0], Do_02 = Do_02a - Do_02b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m12 * dc[0], Do_10 = Do_10a + Do_10b;
  const float Do_12a = D->m12 * dc[1], Do_12b = D->m10 * dc[0], Do_12 = Do_12a - Do_12b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m22 * dc[0], Do_20 = Do_20a + Do_20b;
  const float Do_22a = D->m22 * dc[1], Do_22b = D->m20 * dc[0], Do_22 = Do_22a - Do_22b;
  const float D_m01 = D->m01;
  const float D_m03 = D->m03;
  const float D_m11 = D->m11;
  const float D_m13 = D->m13;
  const float D_m21 = D->m21;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = D_m01;
  Do->m02 = Do_02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = D_m11;
  Do->m12 = Do_12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = D_m21;
  Do->m22 = Do_22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_y].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtyinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m01 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m11 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m21 * k, Do_23 = D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0 = R->m02 * k;
  const float vo_1 = R->m12 * k;
  const float vo_2 = R->m22 * k;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a + Ro_00b;
  const float Ro_01a = R->m01 * dc[1], Ro_01b = R->m00 * dc[0], Ro_01 = Ro_01a - Ro_01b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a + Ro_10b;
  const float Ro_11a = R->m11 * dc[1], Ro_11b = R->m10 * dc[0], Ro_11 = Ro_11a - Ro_11b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a + Ro_20b;
  const float Ro_21a = R->m21 * dc[1], Ro_21b = R->m20 * dc[0], Ro_21 = Ro_21a - Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a + Do_00b;
  const float Do_01a = D->m01 * dc[1], Do_01b = D->m00 * dc[0], Do_01 = Do_01a - Do_01b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a + Do_10b;
  const float Do_11a = D->m11 * dc[1], Do_11b = D->m10 * dc[0], Do_11 = Do_11a - Do_11b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a + Do_20b;
  const float Do_21a = D->m21 * dc[1], Do_21b = D->m20 * dc[0], Do_21 = Do_21a - Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m02 * k, Do_03 = Do_03a + D->m03;
  const float Do_13a = D->m12 * k, Do_13 = Do_13a + D->m13;
  const float Do_23a = D->m22 * k, Do_23 = Do_23a + D->m23;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

/* vo = R (-k e_z).
   R: rotation or other 3×3 matrix; k: number; vo: vector.
   3 mul, 3 neg.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_drvtzinvf(const ksl_mat3x3f_t *R, const float k, ksl_vec3f_t *vo) {
  const float vo_0a = R->m02 * k, vo_0 = -vo_0a;
  const float vo_1a = R->m12 * k, vo_1 = -vo_1a;
  const float vo_2a = R->m22 * k, vo_2 = -vo_2a;
  vo->x = vo_0;
  vo->y = vo_1;
  vo->z = vo_2;
}

/* Ro = R R_z(-θ), dc = (sin θ, cos θ).
   R, Ro: rotation or other 3×3 matrix; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_drdrzinvf(const ksl_mat3x3f_t *R, const float dc[2],
    ksl_mat3x3f_t *Ro) {
  const float Ro_00a = R->m00 * dc[1], Ro_00b = R->m01 * dc[0], Ro_00 = Ro_00a - Ro_00b;
  const float Ro_01a = R->m00 * dc[0], Ro_01b = R->m01 * dc[1], Ro_01 = Ro_01a + Ro_01b;
  const float Ro_10a = R->m10 * dc[1], Ro_10b = R->m11 * dc[0], Ro_10 = Ro_10a - Ro_10b;
  const float Ro_11a = R->m10 * dc[0], Ro_11b = R->m11 * dc[1], Ro_11 = Ro_11a + Ro_11b;
  const float Ro_20a = R->m20 * dc[1], Ro_20b = R->m21 * dc[0], Ro_20 = Ro_20a - Ro_20b;
  const float Ro_21a = R->m20 * dc[0], Ro_21b = R->m21 * dc[1], Ro_21 = Ro_21a + Ro_21b;
  const float R_m02 = R->m02;
  const float R_m12 = R->m12;
  const float R_m22 = R->m22;
  Ro->m00 = Ro_00;
  Ro->m01 = Ro_01;
  Ro->m02 = R_m02;
  Ro->m10 = Ro_10;
  Ro->m11 = Ro_11;
  Ro->m12 = R_m12;
  Ro->m20 = Ro_20;
  Ro->m21 = Ro_21;
  Ro->m22 = R_m22;
}

/* Do = D [R_z(-θ) | 0], dc = (sin θ, cos θ).
   D, Do: displacement [R | t], R rotation, t in m; dc: (sin θ, cos θ).
   12 mul, 6 add.
   Error <= u |result| + (R: 1, t: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddrzinvf(const ksl_SE3f_t *D, const float dc[2], ksl_SE3f_t *Do) {
  const float Do_00a = D->m00 * dc[1], Do_00b = D->m01 * dc[0], Do_00 = Do_00a - Do_00b;
  const float Do_01a = D->m00 * dc[0], Do_01b = D->m01 * dc[1], Do_01 = Do_01a + Do_01b;
  const float Do_10a = D->m10 * dc[1], Do_10b = D->m11 * dc[0], Do_10 = Do_10a - Do_10b;
  const float Do_11a = D->m10 * dc[0], Do_11b = D->m11 * dc[1], Do_11 = Do_11a + Do_11b;
  const float Do_20a = D->m20 * dc[1], Do_20b = D->m21 * dc[0], Do_20 = Do_20a - Do_20b;
  const float Do_21a = D->m20 * dc[0], Do_21b = D->m21 * dc[1], Do_21 = Do_21a + Do_21b;
  const float D_m02 = D->m02;
  const float D_m03 = D->m03;
  const float D_m12 = D->m12;
  const float D_m13 = D->m13;
  const float D_m22 = D->m22;
  const float D_m23 = D->m23;
  Do->m00 = Do_00;
  Do->m01 = Do_01;
  Do->m02 = D_m02;
  Do->m03 = D_m03;
  Do->m10 = Do_10;
  Do->m11 = Do_11;
  Do->m12 = D_m12;
  Do->m13 = D_m13;
  Do->m20 = Do_20;
  Do->m21 = Do_21;
  Do->m22 = D_m22;
  Do->m23 = D_m23;
}

/* Do = D [I | -k e_z].
   D, Do: displacement [R | t], R rotation, t in m; k: number.
   3 mul, 3 add.
   Error <= u |result| + (R: 0, t: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_ddtzinvf(const ksl_SE3f_t *D, const float k, ksl_SE3f_t *Do) {
  const float Do_03a = D->m02 * k, Do_03 = D->m03 - Do_03a;
  const float Do_13a = D->m12 * k, Do_13 = D->m13 - Do_13a;
  const float Do_23a = D->m22 * k, Do_23 = D->m23 - Do_23a;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  Do->m00 = D_m00;
  Do->m01 = D_m01;
  Do->m02 = D_m02;
  Do->m03 = Do_03;
  Do->m10 = D_m10;
  Do->m11 = D_m11;
  Do->m12 = D_m12;
  Do->m13 = Do_13;
  Do->m20 = D_m20;
  Do->m21 = D_m21;
  Do->m22 = D_m22;
  Do->m23 = Do_23;
}

#endif

/* Sine and cosine of a joint angle. */
#ifndef KSL_TRIG_H
#define KSL_TRIG_H


/* dc = (sin θ, cos θ), θ in rad; accurate as the platform's sin and cos.
   theta: number; dc: (sin θ, cos θ).
   1 sin, 1 cos. */
static inline void ksl_dc(const double theta, double dc[2]) {
  const double dc_0 = sin(theta);
  const double dc_1 = cos(theta);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

/* dc = (sin θ, cos θ), θ in rad; accurate as the platform's sin and cos.
   theta: number; dc: (sin θ, cos θ).
   1 sin, 1 cos. */
static inline void ksl_dcf(const float theta, float dc[2]) {
  const float dc_0 = sinf(theta);
  const float dc_1 = cosf(theta);
  dc[0] = dc_0;
  dc[1] = dc_1;
}

#endif

/* Screws: twists, spatial velocities and accelerations, s = (v; ω). */
#ifndef KSL_SCREW_H
#define KSL_SCREW_H


/* The screw of these entries, in order. */
static inline ksl_screw_t ksl_screw(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_screw_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_copy(const ksl_screw_t *si, ksl_screw_t *so) {
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screw_scale(ksl_screw_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_inverted(const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = -si->m0;
  const double so_1 = -si->m1;
  const double so_2 = -si->m2;
  const double so_3 = -si->m3;
  const double so_4 = -si->m4;
  const double so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screw_invert(ksl_screw_t *self) {
  const double self_0_new = -self->m0;
  const double self_1_new = -self->m1;
  const double self_2_new = -self->m2;
  const double self_3_new = -self->m3;
  const double self_4_new = -self->m4;
  const double self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ss(const double a, const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = x->m0 + y->m0;
  const double y_1_new = x->m1 + y->m1;
  const double y_2_new = x->m2 + y->m2;
  const double y_3_new = x->m3 + y->m3;
  const double y_4_new = x->m4 + y->m4;
  const double y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ss(const ksl_screw_t *x, ksl_screw_t *y) {
  const double y_0_new = y->m0 - x->m0;
  const double y_1_new = y->m1 - x->m1;
  const double y_2_new = y->m2 - x->m2;
  const double y_3_new = y->m3 - x->m3;
  const double y_4_new = y->m4 - x->m4;
  const double y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_as(const double a, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0 = a * si->m0;
  const double so_1 = a * si->m1;
  const double so_2 = a * si->m2;
  const double so_3 = a * si->m3;
  const double so_4 = a * si->m4;
  const double so_5 = a * si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double so_3 = s1->m3 + s2->m3;
  const double so_4 = s1->m4 + s2->m4;
  const double so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 - s2->m0;
  const double so_1 = s1->m1 - s2->m1;
  const double so_2 = s1->m2 - s2->m2;
  const double so_3 = s1->m3 - s2->m3;
  const double so_4 = s1->m4 - s2->m4;
  const double so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline double ksl_screw_norm(const ksl_screw_t *si) {
  const double small_a = fabs(si->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(si->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(si->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3;
  const double p_1 = small == 1.0 ? si->m1 : si->m4;
  const double p_2 = small == 1.0 ? si->m2 : si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screw_normalize(ksl_screw_t *self) {
  const double small_a = fabs(self->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m0 : self->m3;
  const double p_1 = small == 1.0 ? self->m1 : self->m4;
  const double p_2 = small == 1.0 ? self->m2 : self->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = self->m0 * up;
  const double z_1 = self->m1 * up;
  const double z_2 = self->m2 * up;
  const double z_3 = self->m3 * up;
  const double z_4 = self->m4 * up;
  const double z_5 = self->m5 * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double q_3 = z_3 / d;
  const double q_4 = z_4 / d;
  const double q_5 = z_5 / d;
  const double self_0_new = q_0 * down;
  const double self_1_new = q_1 * down;
  const double self_2_new = q_2 * down;
  const double self_3_new = q_3 * down;
  const double self_4_new = q_4 * down;
  const double self_5_new = q_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screw_normalized(const ksl_screw_t *si, ksl_screw_t *so) {
  const double small_a = fabs(si->m5), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(si->m4), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(si->m3),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? si->m0 : si->m3;
  const double p_1 = small == 1.0 ? si->m1 : si->m4;
  const double p_2 = small == 1.0 ? si->m2 : si->m5;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = si->m0 * up;
  const double z_1 = si->m1 * up;
  const double z_2 = si->m2 * up;
  const double z_3 = si->m3 * up;
  const double z_4 = si->m4 * up;
  const double z_5 = si->m5 * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double q_3 = z_3 / d;
  const double q_4 = z_4 / d;
  const double q_5 = z_5 / d;
  const double so_0 = q_0 * down;
  const double so_1 = q_1 * down;
  const double so_2 = q_2 * down;
  const double so_3 = q_3 * down;
  const double so_4 = q_4 * down;
  const double so_5 = q_5 * down;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_screw_t *so) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screw_to_angular_first(const ksl_screw_t *si, double x[6]) {
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  const double si_m0 = si->m0;
  const double si_m1 = si->m1;
  const double si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screw_from_angular_first(const double x[6], ksl_screw_t *so) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0 = s1->m0 + s2->m0;
  const double so_1 = s1->m1 + s2->m1;
  const double so_2 = s1->m2 + s2->m2;
  const double s1_m3 = s1->m3;
  const double s1_m4 = s1->m4;
  const double s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adts(const ksl_vec3_t *t, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0a = t->y * si->m5, so_0b = t->z * si->m4, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = t->z * si->m3, so_1b = t->x * si->m5, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = t->x * si->m4, so_2b = t->y * si->m3, so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvs(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const double si_m3 = si->m3;
  const double si_m4 = si->m4;
  const double si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinv(const ksl_vec3_t *t, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const double so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const double so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2 = so_2c - si->m2;
  const double so_3 = -si->m3;
  const double so_4 = -si->m4;
  const double so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrs(const ksl_mat3x3_t *R, const ksl_screw_t *si, ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0 = so_0c + so_0d;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1 = so_1c + so_1d;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvs(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m10 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m20 * si->m2, so_0 = so_0c + so_0d;
  const double so_1a = R->m01 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m21 * si->m2, so_1 = so_1c + so_1d;
  const double so_2a = R->m02 * si->m0, so_2b = R->m12 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const double so_3a = R->m00 * si->m3, so_3b = R->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m20 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = R->m01 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m21 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = R->m02 * si->m3, so_5b = R->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinv(const ksl_mat3x3_t *R, const ksl_screw_t *si,
    ksl_screw_t *so) {
  const double so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const double so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const double so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2e = so_2c + so_2d, so_2 = -so_2e;
  const double so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3e = so_3c + so_3d, so_3 = -so_3e;
  const double so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4e = so_4c + so_4d, so_4 = -so_4e;
  const double so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5e = so_5c + so_5d, so_5 = -so_5e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Ads(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5 = w_5c + w_5d;
  const double so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvs(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m23 * si->m4, w_0b = D->m13 * si->m5, w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const double w_1a = D->m03 * si->m5, w_1b = D->m23 * si->m3, w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const double w_2a = D->m13 * si->m3, w_2b = D->m03 * si->m4, w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const double so_0a = D->m00 * w_0, so_0b = D->m10 * w_1, so_0c = so_0a + so_0b,
      so_0d = D->m20 * w_2, so_0 = so_0c + so_0d;
  const double so_1a = D->m01 * w_0, so_1b = D->m11 * w_1, so_1c = so_1a + so_1b,
      so_1d = D->m21 * w_2, so_1 = so_1c + so_1d;
  const double so_2a = D->m02 * w_0, so_2b = D->m12 * w_1, so_2c = so_2a + so_2b,
      so_2d = D->m22 * w_2, so_2 = so_2c + so_2d;
  const double so_3a = D->m00 * si->m3, so_3b = D->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = D->m20 * si->m5, so_3 = so_3c + so_3d;
  const double so_4a = D->m01 * si->m3, so_4b = D->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = D->m21 * si->m5, so_4 = so_4c + so_4d;
  const double so_5a = D->m02 * si->m3, so_5b = D->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = D->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinv(const ksl_SE3_t *D, const ksl_screw_t *si, ksl_screw_t *so) {
  const double w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b,
      so_0 = so_0c + w_0;
  const double so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b,
      so_1 = so_1c + w_1;
  const double so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b,
      so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hsty(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrx(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m20 * D->m13, so_0b = D->m10 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m00 * D->m23, so_1b = D->m20 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m10 * D->m03, so_2b = D->m00 * D->m13, so_2 = so_2a - so_2b;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsry(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m21 * D->m13, so_0b = D->m11 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m01 * D->m23, so_1b = D->m21 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m11 * D->m03, so_2b = D->m01 * D->m13, so_2 = so_2a - so_2b;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrz(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m22 * D->m13, so_0b = D->m12 * D->m23, so_0 = so_0a - so_0b;
  const double so_1a = D->m02 * D->m23, so_1b = D->m22 * D->m03, so_1 = so_1a - so_1b;
  const double so_2a = D->m12 * D->m03, so_2b = D->m02 * D->m13, so_2 = so_2a - so_2b;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m00;
  const double so_1 = -D->m10;
  const double so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m01;
  const double so_1 = -D->m11;
  const double so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0 = -D->m02;
  const double so_1 = -D->m12;
  const double so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m10 * D->m23, so_0b = D->m20 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m20 * D->m03, so_1b = D->m00 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m00 * D->m13, so_2b = D->m10 * D->m03, so_2 = so_2a - so_2b;
  const double so_3 = -D->m00;
  const double so_4 = -D->m10;
  const double so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m11 * D->m23, so_0b = D->m21 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m21 * D->m03, so_1b = D->m01 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m01 * D->m13, so_2b = D->m11 * D->m03, so_2 = so_2a - so_2b;
  const double so_3 = -D->m01;
  const double so_4 = -D->m11;
  const double so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinv(const ksl_SE3_t *D, ksl_screw_t *so) {
  const double so_0a = D->m12 * D->m23, so_0b = D->m22 * D->m13, so_0 = so_0a - so_0b;
  const double so_1a = D->m22 * D->m03, so_1b = D->m02 * D->m23, so_1 = so_1a - so_1b;
  const double so_2a = D->m02 * D->m13, so_2b = D->m12 * D->m03, so_2 = so_2a - so_2b;
  const double so_3 = -D->m02;
  const double so_4 = -D->m12;
  const double so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Ad(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_03a = D->m20 * D->m13, M_03b = D->m10 * D->m23, M_03 = M_03a - M_03b;
  const double M_04a = D->m21 * D->m13, M_04b = D->m11 * D->m23, M_04 = M_04a - M_04b;
  const double M_05a = D->m22 * D->m13, M_05b = D->m12 * D->m23, M_05 = M_05a - M_05b;
  const double M_13a = D->m00 * D->m23, M_13b = D->m20 * D->m03, M_13 = M_13a - M_13b;
  const double M_14a = D->m01 * D->m23, M_14b = D->m21 * D->m03, M_14 = M_14a - M_14b;
  const double M_15a = D->m02 * D->m23, M_15b = D->m22 * D->m03, M_15 = M_15a - M_15b;
  const double M_23a = D->m10 * D->m03, M_23b = D->m00 * D->m13, M_23 = M_23a - M_23b;
  const double M_24a = D->m11 * D->m03, M_24b = D->m01 * D->m13, M_24 = M_24a - M_24b;
  const double M_25a = D->m12 * D->m03, M_25b = D->m02 * D->m13, M_25 = M_25a - M_25b;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_dot_cs(const ksl_coscrew_t *c, const ksl_screw_t *s) {
  const double power_a = c->m0 * s->m0, power_b = c->m1 * s->m1, power_c = power_a + power_b,
      power_d = c->m2 * s->m2, power_e = power_c + power_d, power_f = c->m3 * s->m3,
      power_g = c->m4 * s->m4, power_h = power_f + power_g, power_i = c->m5 * s->m5,
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ss(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0a = s1->m1 * s2->m5, so_0b = s1->m5 * s2->m1, so_0c = so_0a - so_0b,
      so_0d = s1->m4 * s2->m2, so_0e = s1->m2 * s2->m4, so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m0 * s2->m5, so_1c = so_1a - so_1b,
      so_1d = s1->m2 * s2->m3, so_1e = s1->m3 * s2->m2, so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const double so_2a = s1->m0 * s2->m4, so_2b = s1->m4 * s2->m0, so_2c = so_2a - so_2b,
      so_2d = s1->m3 * s2->m1, so_2e = s1->m1 * s2->m3, so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const double so_3a = s1->m4 * s2->m5, so_3b = s1->m5 * s2->m4, so_3 = so_3a - so_3b;
  const double so_4a = s1->m5 * s2->m3, so_4b = s1->m3 * s2->m5, so_4 = so_4a - so_4b;
  const double so_5a = s1->m3 * s2->m4, so_5b = s1->m4 * s2->m3, so_5 = so_5a - so_5b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sst(const ksl_screw_t *s1, const ksl_screw_t *s2, ksl_screw_t *so) {
  const double so_0a = s1->m4 * s2->m2, so_0b = s1->m5 * s2->m1, so_0 = so_0a - so_0b;
  const double so_1a = s1->m5 * s2->m0, so_1b = s1->m3 * s2->m2, so_1 = so_1a - so_1b;
  const double so_2a = s1->m3 * s2->m1, so_2b = s1->m4 * s2->m0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsra(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const double a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const double a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const double so_0a = D->m13 * a_2, so_0b = D->m23 * a_1, so_0 = so_0a - so_0b;
  const double so_1a = D->m23 * a_0, so_1b = D->m03 * a_2, so_1 = so_1a - so_1b;
  const double so_2a = D->m03 * a_1, so_2b = D->m13 * a_0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsta(const ksl_SE3_t *D, const ksl_vec3_t *axis, ksl_screw_t *so) {
  const double so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0 = so_0c + so_0d;
  const double so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1 = so_1c + so_1d;
  const double so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2 = so_2c + so_2d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0;
  so->m4 = 0.0;
  so->m5 = 0.0;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_ad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5;
  const double M_04 = -s->m2;
  const double M_12 = -s->m3;
  const double M_15 = -s->m0;
  const double M_20 = -s->m4;
  const double M_23 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m1 = s->m1;
  const double s_m5 = s->m5;
  const double s_m2 = s->m2;
  const double s_m3 = s->m3;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = 0.0;
  M->at[2][3] = 0.0;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0;
  M->at[1][4] = 0.0;
  M->at[2][4] = 0.0;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0;
  M->at[1][5] = 0.0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The screw of these entries, in order. */
static inline ksl_screwf_t ksl_screwf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_screwf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* so = si.
   si, so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_copy(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = si_m0;
  so->m1 = si_m1;
  so->m2 = si_m2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* self = a self.
   self: screw (v in m/s; ω in rad/s); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_screwf_scale(ksl_screwf_t *self, const float a) {
  const float self_0_new = self->m0 * a;
  const float self_1_new = self->m1 * a;
  const float self_2_new = self->m2 * a;
  const float self_3_new = self->m3 * a;
  const float self_4_new = self->m4 * a;
  const float self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = -si.
   si, so: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_inverted(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = -si->m0;
  const float so_1 = -si->m1;
  const float so_2 = -si->m2;
  const float so_3 = -si->m3;
  const float so_4 = -si->m4;
  const float so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* self = -self.
   self: screw (v in m/s; ω in rad/s).
   6 neg.
   Exact. */
static inline void ksl_screwf_invert(ksl_screwf_t *self) {
  const float self_0_new = -self->m0;
  const float self_1_new = -self->m1;
  const float self_2_new = -self->m2;
  const float self_3_new = -self->m3;
  const float self_4_new = -self->m4;
  const float self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ssf(const float a, const ksl_screwf_t *x, ksl_screwf_t *y) {
  const float y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const float y_0_new = x->m0 + y->m0;
  const float y_1_new = x->m1 + y->m1;
  const float y_2_new = x->m2 + y->m2;
  const float y_3_new = x->m3 + y->m3;
  const float y_4_new = x->m4 + y->m4;
  const float y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ssf(const ksl_screwf_t *x, ksl_screwf_t *y) {
  const float y_0_new = y->m0 - x->m0;
  const float y_1_new = y->m1 - x->m1;
  const float y_2_new = y->m2 - x->m2;
  const float y_3_new = y->m3 - x->m3;
  const float y_4_new = y->m4 - x->m4;
  const float y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* so = a si.
   a: number; si, so: screw (v in m/s; ω in rad/s).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_asf(const float a, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float so_0 = a * si->m0;
  const float so_1 = a * si->m1;
  const float so_2 = a * si->m2;
  const float so_3 = a * si->m3;
  const float so_4 = a * si->m4;
  const float so_5 = a * si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 + s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float so_3 = s1->m3 + s2->m3;
  const float so_4 = s1->m4 + s2->m4;
  const float so_5 = s1->m5 + s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = s1 - s2.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0 = s1->m0 - s2->m0;
  const float so_1 = s1->m1 - s2->m1;
  const float so_2 = s1->m2 - s2->m2;
  const float so_3 = s1->m3 - s2->m3;
  const float so_4 = s1->m4 - s2->m4;
  const float so_5 = s1->m5 - s2->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* |si|: |ω|, or |v| where every |ω_i| is below 1e-9 (single: 1e-6).
   si: screw (v in m/s; ω in rad/s).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline float ksl_screwf_norm(const ksl_screwf_t *si) {
  const float small_a = fabsf(si->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(si->m4), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(si->m3),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3;
  const float p_1 = small == 1.0f ? si->m1 : si->m4;
  const float p_2 = small == 1.0f ? si->m2 : si->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r = 1.0f < s ? 7.888609e-31f : r_b;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|, with screw_norm; the zero screw stays zero.
   self: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screwf_normalize(ksl_screwf_t *self) {
  const float small_a = fabsf(self->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m4), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m3), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m0 : self->m3;
  const float p_1 = small == 1.0f ? self->m1 : self->m4;
  const float p_2 = small == 1.0f ? self->m2 : self->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = self->m0 * up;
  const float z_1 = self->m1 * up;
  const float z_2 = self->m2 * up;
  const float z_3 = self->m3 * up;
  const float z_4 = self->m4 * up;
  const float z_5 = self->m5 * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float q_3 = z_3 / d;
  const float q_4 = z_4 / d;
  const float q_5 = z_5 / d;
  const float self_0_new = q_0 * down;
  const float self_1_new = q_1 * down;
  const float self_2_new = q_2 * down;
  const float self_3_new = q_3 * down;
  const float self_4_new = q_4 * down;
  const float self_5_new = q_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* so = si / |si|, with screw_norm; the zero screw stays zero.
   si, so: screw (v in m/s; ω in rad/s).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_screwf_normalized(const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float small_a = fabsf(si->m5), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(si->m4), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(si->m3),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? si->m0 : si->m3;
  const float p_1 = small == 1.0f ? si->m1 : si->m4;
  const float p_2 = small == 1.0f ? si->m2 : si->m5;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = si->m0 * up;
  const float z_1 = si->m1 * up;
  const float z_2 = si->m2 * up;
  const float z_3 = si->m3 * up;
  const float z_4 = si->m4 * up;
  const float z_5 = si->m5 * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float q_3 = z_3 / d;
  const float q_4 = z_4 / d;
  const float q_5 = z_5 / d;
  const float so_0 = q_0 * down;
  const float so_1 = q_1 * down;
  const float so_2 = q_2 * down;
  const float so_3 = q_3 * down;
  const float so_4 = q_4 * down;
  const float so_5 = q_5 * down;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (lin; ang).
   lin, ang: vector; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_screwf_t *so) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  so->m0 = lin_x;
  so->m1 = lin_y;
  so->m2 = lin_z;
  so->m3 = ang_x;
  so->m4 = ang_y;
  so->m5 = ang_z;
}

/* x = (ang; lin) of si.
   si: screw (v in m/s; ω in rad/s); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_screwf_to_angular_first(const ksl_screwf_t *si, float x[6]) {
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  const float si_m0 = si->m0;
  const float si_m1 = si->m1;
  const float si_m2 = si->m2;
  x[0] = si_m3;
  x[1] = si_m4;
  x[2] = si_m5;
  x[3] = si_m0;
  x[4] = si_m1;
  x[5] = si_m2;
}

/* so = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_screwf_from_angular_first(const float x[6], ksl_screwf_t *so) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  so->m0 = x_3;
  so->m1 = x_4;
  so->m2 = x_5;
  so->m3 = x_0;
  so->m4 = x_1;
  so->m5 = x_2;
}

/* so = (s1.lin + s2.lin ; s1.ang).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0 = s1->m0 + s2->m0;
  const float so_1 = s1->m1 + s2->m1;
  const float so_2 = s1->m2 + s2->m2;
  const float s1_m3 = s1->m3;
  const float s1_m4 = s1->m4;
  const float s1_m5 = s1->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = s1_m3;
  so->m4 = s1_m4;
  so->m5 = s1_m5;
}

/* so = [Ad](t) si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->y * si->m5, so_0b = t->z * si->m4, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = t->z * si->m3, so_1b = t->x * si->m5, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = t->x * si->m4, so_2b = t->y * si->m3, so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t)^-1 si.
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtinvsf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c + si->m0;
  const float so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c + si->m1;
  const float so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2 = so_2c + si->m2;
  const float si_m3 = si->m3;
  const float si_m4 = si->m4;
  const float si_m5 = si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = si_m3;
  so->m4 = si_m4;
  so->m5 = si_m5;
}

/* so = [Ad](t) (-si).
   t: vector; si, so: screw (v in m/s; ω in rad/s).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adtsinvf(const ksl_vec3f_t *t, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = t->z * si->m4, so_0b = t->y * si->m5, so_0c = so_0a - so_0b,
      so_0 = so_0c - si->m0;
  const float so_1a = t->x * si->m5, so_1b = t->z * si->m3, so_1c = so_1a - so_1b,
      so_1 = so_1c - si->m1;
  const float so_2a = t->y * si->m3, so_2b = t->x * si->m4, so_2c = so_2a - so_2b,
      so_2 = so_2c - si->m2;
  const float so_3 = -si->m3;
  const float so_4 = -si->m4;
  const float so_5 = -si->m5;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0 = so_0c + so_0d;
  const float so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1 = so_1c + so_1d;
  const float so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const float so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R)^-1 si.
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrinvsf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m10 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m20 * si->m2, so_0 = so_0c + so_0d;
  const float so_1a = R->m01 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m21 * si->m2, so_1 = so_1c + so_1d;
  const float so_2a = R->m02 * si->m0, so_2b = R->m12 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2 = so_2c + so_2d;
  const float so_3a = R->m00 * si->m3, so_3b = R->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m20 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = R->m01 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m21 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = R->m02 * si->m3, so_5b = R->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](R) (-si).
   R: rotation or other 3×3 matrix; si, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_Adrsinvf(const ksl_mat3x3f_t *R, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float so_0a = R->m00 * si->m0, so_0b = R->m01 * si->m1, so_0c = so_0a + so_0b,
      so_0d = R->m02 * si->m2, so_0e = so_0c + so_0d, so_0 = -so_0e;
  const float so_1a = R->m10 * si->m0, so_1b = R->m11 * si->m1, so_1c = so_1a + so_1b,
      so_1d = R->m12 * si->m2, so_1e = so_1c + so_1d, so_1 = -so_1e;
  const float so_2a = R->m20 * si->m0, so_2b = R->m21 * si->m1, so_2c = so_2a + so_2b,
      so_2d = R->m22 * si->m2, so_2e = so_2c + so_2d, so_2 = -so_2e;
  const float so_3a = R->m00 * si->m3, so_3b = R->m01 * si->m4, so_3c = so_3a + so_3b,
      so_3d = R->m02 * si->m5, so_3e = so_3c + so_3d, so_3 = -so_3e;
  const float so_4a = R->m10 * si->m3, so_4b = R->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = R->m12 * si->m5, so_4e = so_4c + so_4d, so_4 = -so_4e;
  const float so_5a = R->m20 * si->m3, so_5b = R->m21 * si->m4, so_5c = so_5a + so_5b,
      so_5d = R->m22 * si->m5, so_5e = so_5c + so_5d, so_5 = -so_5e;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) si = [Ad](t) [Ad](R) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsf(const ksl_SE3f_t *D, const ksl_screwf_t *si, ksl_screwf_t *so) {
  const float w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5 = w_5c + w_5d;
  const float so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b, so_0 = so_0c + w_0;
  const float so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b, so_1 = so_1c + w_1;
  const float so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b, so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = [Ad](D)^-1 si = [Ad](R^T) [Ad](-t) si.
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adinvsf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = D->m23 * si->m4, w_0b = D->m13 * si->m5, w_0c = w_0a - w_0b,
      w_0 = w_0c + si->m0;
  const float w_1a = D->m03 * si->m5, w_1b = D->m23 * si->m3, w_1c = w_1a - w_1b,
      w_1 = w_1c + si->m1;
  const float w_2a = D->m13 * si->m3, w_2b = D->m03 * si->m4, w_2c = w_2a - w_2b,
      w_2 = w_2c + si->m2;
  const float so_0a = D->m00 * w_0, so_0b = D->m10 * w_1, so_0c = so_0a + so_0b,
      so_0d = D->m20 * w_2, so_0 = so_0c + so_0d;
  const float so_1a = D->m01 * w_0, so_1b = D->m11 * w_1, so_1c = so_1a + so_1b,
      so_1d = D->m21 * w_2, so_1 = so_1c + so_1d;
  const float so_2a = D->m02 * w_0, so_2b = D->m12 * w_1, so_2c = so_2a + so_2b,
      so_2d = D->m22 * w_2, so_2 = so_2c + so_2d;
  const float so_3a = D->m00 * si->m3, so_3b = D->m10 * si->m4, so_3c = so_3a + so_3b,
      so_3d = D->m20 * si->m5, so_3 = so_3c + so_3d;
  const float so_4a = D->m01 * si->m3, so_4b = D->m11 * si->m4, so_4c = so_4a + so_4b,
      so_4d = D->m21 * si->m5, so_4 = so_4c + so_4d;
  const float so_5a = D->m02 * si->m3, so_5b = D->m12 * si->m4, so_5c = so_5a + so_5b,
      so_5d = D->m22 * si->m5, so_5 = so_5c + so_5d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = [Ad](D) (-si).
   D: displacement [R | t], R rotation, t in m; si, so: screw (v in m/s; ω in rad/s).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 5, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_Adsinvf(const ksl_SE3f_t *D, const ksl_screwf_t *si,
    ksl_screwf_t *so) {
  const float w_0a = D->m00 * si->m0, w_0b = D->m01 * si->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * si->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = D->m10 * si->m0, w_1b = D->m11 * si->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * si->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = D->m20 * si->m0, w_2b = D->m21 * si->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * si->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = D->m00 * si->m3, w_3b = D->m01 * si->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * si->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = D->m10 * si->m3, w_4b = D->m11 * si->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * si->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = D->m20 * si->m3, w_5b = D->m21 * si->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * si->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float so_0a = D->m13 * w_5, so_0b = D->m23 * w_4, so_0c = so_0a - so_0b, so_0 = so_0c + w_0;
  const float so_1a = D->m23 * w_3, so_1b = D->m03 * w_5, so_1c = so_1a - so_1b, so_1 = so_1c + w_1;
  const float so_2a = D->m03 * w_4, so_2b = D->m13 * w_3, so_2c = so_2a - so_2b, so_2 = so_2c + w_2;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = w_3;
  so->m4 = w_4;
  so->m5 = w_5;
}

/* so = h_tx: column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = D_m00;
  so->m1 = D_m10;
  so->m2 = D_m20;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_ty: column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstyf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = D_m01;
  so->m1 = D_m11;
  so->m2 = D_m21;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_tz: column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   No arithmetic.
   Exact. */
static inline void ksl_hstzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = D_m02;
  so->m1 = D_m12;
  so->m2 = D_m22;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = h_rx: column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m20 * D->m13, so_0b = D->m10 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m00 * D->m23, so_1b = D->m20 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m10 * D->m03, so_2b = D->m00 * D->m13, so_2 = so_2a - so_2b;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m00;
  so->m4 = D_m10;
  so->m5 = D_m20;
}

/* so = h_ry: column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m21 * D->m13, so_0b = D->m11 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m01 * D->m23, so_1b = D->m21 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m11 * D->m03, so_2b = D->m01 * D->m13, so_2 = so_2a - so_2b;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m01;
  so->m4 = D_m11;
  so->m5 = D_m21;
}

/* so = h_rz: column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m22 * D->m13, so_0b = D->m12 * D->m23, so_0 = so_0a - so_0b;
  const float so_1a = D->m02 * D->m23, so_1b = D->m22 * D->m03, so_1 = so_1a - so_1b;
  const float so_2a = D->m12 * D->m03, so_2b = D->m02 * D->m13, so_2 = so_2a - so_2b;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = D_m02;
  so->m4 = D_m12;
  so->m5 = D_m22;
}

/* so = -h_tx: -column 0 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m00;
  const float so_1 = -D->m10;
  const float so_2 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_ty: -column 1 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstyinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m01;
  const float so_1 = -D->m11;
  const float so_2 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_tz: -column 2 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   3 neg.
   Exact. */
static inline void ksl_hstzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0 = -D->m02;
  const float so_1 = -D->m12;
  const float so_2 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = -h_rx: -column 3 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrxinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m10 * D->m23, so_0b = D->m20 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m20 * D->m03, so_1b = D->m00 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m00 * D->m13, so_2b = D->m10 * D->m03, so_2 = so_2a - so_2b;
  const float so_3 = -D->m00;
  const float so_4 = -D->m10;
  const float so_5 = -D->m20;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_ry: -column 4 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsryinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m11 * D->m23, so_0b = D->m21 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m21 * D->m03, so_1b = D->m01 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m01 * D->m13, so_2b = D->m11 * D->m03, so_2 = so_2a - so_2b;
  const float so_3 = -D->m01;
  const float so_4 = -D->m11;
  const float so_5 = -D->m21;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = -h_rz: -column 5 of [Ad](D).
   D: displacement [R | t], R rotation, t in m; so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsrzinvf(const ksl_SE3f_t *D, ksl_screwf_t *so) {
  const float so_0a = D->m12 * D->m23, so_0b = D->m22 * D->m13, so_0 = so_0a - so_0b;
  const float so_1a = D->m22 * D->m03, so_1b = D->m02 * D->m23, so_1 = so_1a - so_1b;
  const float so_2a = D->m02 * D->m13, so_2b = D->m12 * D->m03, so_2 = so_2a - so_2b;
  const float so_3 = -D->m02;
  const float so_4 = -D->m12;
  const float so_5 = -D->m22;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* M = [Ad](D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_Adf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_03a = D->m20 * D->m13, M_03b = D->m10 * D->m23, M_03 = M_03a - M_03b;
  const float M_04a = D->m21 * D->m13, M_04b = D->m11 * D->m23, M_04 = M_04a - M_04b;
  const float M_05a = D->m22 * D->m13, M_05b = D->m12 * D->m23, M_05 = M_05a - M_05b;
  const float M_13a = D->m00 * D->m23, M_13b = D->m20 * D->m03, M_13 = M_13a - M_13b;
  const float M_14a = D->m01 * D->m23, M_14b = D->m21 * D->m03, M_14 = M_14a - M_14b;
  const float M_15a = D->m02 * D->m23, M_15b = D->m22 * D->m03, M_15 = M_15a - M_15b;
  const float M_23a = D->m10 * D->m03, M_23b = D->m00 * D->m13, M_23 = M_23a - M_23b;
  const float M_24a = D->m11 * D->m03, M_24b = D->m01 * D->m13, M_24 = M_24a - M_24b;
  const float M_25a = D->m12 * D->m03, M_25b = D->m02 * D->m13, M_25 = M_25a - M_25b;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = M_03;
  M->at[4][0] = M_04;
  M->at[5][0] = M_05;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = M_13;
  M->at[4][1] = M_14;
  M->at[5][1] = M_15;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = M_23;
  M->at[4][2] = M_24;
  M->at[5][2] = M_25;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = f·v + τ·ω, in W.
   c: coscrew (f in N; τ in N m); s: screw (v in m/s; ω in rad/s).
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_dot_csf(const ksl_coscrewf_t *c, const ksl_screwf_t *s) {
  const float power_a = c->m0 * s->m0, power_b = c->m1 * s->m1, power_c = power_a + power_b,
      power_d = c->m2 * s->m2, power_e = power_c + power_d, power_f = c->m3 * s->m3,
      power_g = c->m4 * s->m4, power_h = power_f + power_g, power_i = c->m5 * s->m5,
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* so = [ad](s1) s2 = (ω1×v2 + v1×ω2 ; ω1×ω2).  Exactly zero for s1 = s2, unless products
     overflow.
   s1, s2, so: screw (v in m/s; ω in rad/s).
   18 mul, 12 add.
   Error <= u |result| + (lin: 2, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_ssf(const ksl_screwf_t *s1, const ksl_screwf_t *s2, ksl_screwf_t *so) {
  const float so_0a = s1->m1 * s2->m5, so_0b = s1->m5 * s2->m1, so_0c = so_0a - so_0b,
      so_0d = s1->m4 * s2->m2, so_0e = s1->m2 * s2->m4, so_0f = so_0d - so_0e, so_0 = so_0c + so_0f;
  const float so_1a = s1->m5 * s2->m0, so_1b = s1->m0 * s2->m5, so_1c = so_1a - so_1b,
      so_1d = s1->m2 * s2->m3, so_1e = s1->m3 * s2->m2, so_1f = so_1d - so_1e, so_1 = so_1c + so_1f;
  const float so_2a = s1->m0 * s2->m4, so_2b = s1->m4 * s2->m0, so_2c = so_2a - so_2b,
      so_2d = s1->m3 * s2->m1, so_2e = s1->m1 * s2->m3, so_2f = so_2d - so_2e, so_2 = so_2c + so_2f;
  const float so_3a = s1->m4 * s2->m5, so_3b = s1->m5 * s2->m4, so_3 = so_3a - so_3b;
  const float so_4a = s1->m5 * s2->m3, so_4b = s1->m3 * s2->m5, so_4 = so_4a - so_4b;
  const float so_5a = s1->m3 * s2->m4, so_5b = s1->m4 * s2->m3, so_5 = so_5a - so_5b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = so_3;
  so->m4 = so_4;
  so->m5 = so_5;
}

/* so = (ω1×v2 ; 0).
   s1, s2, so: screw (v in m/s; ω in rad/s).
   6 mul, 3 add.
   Error <= u |result| + (lin: 1, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sstf(const ksl_screwf_t *s1, const ksl_screwf_t *s2,
    ksl_screwf_t *so) {
  const float so_0a = s1->m4 * s2->m2, so_0b = s1->m5 * s2->m1, so_0 = so_0a - so_0b;
  const float so_1a = s1->m5 * s2->m0, so_1b = s1->m3 * s2->m2, so_1 = so_1a - so_1b;
  const float so_2a = s1->m3 * s2->m1, so_2b = s1->m4 * s2->m0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* so = (t×R a ; R a), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   15 mul, 9 add.
   Error <= u |result| + (lin: 4, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hsraf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float a_0a = D->m00 * axis->x, a_0b = D->m01 * axis->y, a_0c = a_0a + a_0b,
      a_0d = D->m02 * axis->z, a_0 = a_0c + a_0d;
  const float a_1a = D->m10 * axis->x, a_1b = D->m11 * axis->y, a_1c = a_1a + a_1b,
      a_1d = D->m12 * axis->z, a_1 = a_1c + a_1d;
  const float a_2a = D->m20 * axis->x, a_2b = D->m21 * axis->y, a_2c = a_2a + a_2b,
      a_2d = D->m22 * axis->z, a_2 = a_2c + a_2d;
  const float so_0a = D->m13 * a_2, so_0b = D->m23 * a_1, so_0 = so_0a - so_0b;
  const float so_1a = D->m23 * a_0, so_1b = D->m03 * a_2, so_1 = so_1a - so_1b;
  const float so_2a = D->m03 * a_1, so_2b = D->m13 * a_0, so_2 = so_2a - so_2b;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = a_0;
  so->m4 = a_1;
  so->m5 = a_2;
}

/* so = (R a ; 0), a = axis in the body's frame.
   D: displacement [R | t], R rotation, t in m; axis: vector; so: screw (v in m/s; ω in rad/s).
   9 mul, 6 add.
   Error <= u |result| + (lin: 2, ang: 0) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hstaf(const ksl_SE3f_t *D, const ksl_vec3f_t *axis, ksl_screwf_t *so) {
  const float so_0a = D->m00 * axis->x, so_0b = D->m01 * axis->y, so_0c = so_0a + so_0b,
      so_0d = D->m02 * axis->z, so_0 = so_0c + so_0d;
  const float so_1a = D->m10 * axis->x, so_1b = D->m11 * axis->y, so_1c = so_1a + so_1b,
      so_1d = D->m12 * axis->z, so_1 = so_1c + so_1d;
  const float so_2a = D->m20 * axis->x, so_2b = D->m21 * axis->y, so_2c = so_2a + so_2b,
      so_2d = D->m22 * axis->z, so_2 = so_2c + so_2d;
  so->m0 = so_0;
  so->m1 = so_1;
  so->m2 = so_2;
  so->m3 = 0.0f;
  so->m4 = 0.0f;
  so->m5 = 0.0f;
}

/* M = [ad](s) = [Ad]' [Ad]^-1 = [[ω~, v~], [0, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_adf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5;
  const float M_04 = -s->m2;
  const float M_12 = -s->m3;
  const float M_15 = -s->m0;
  const float M_20 = -s->m4;
  const float M_23 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m1 = s->m1;
  const float s_m5 = s->m5;
  const float s_m2 = s->m2;
  const float s_m3 = s->m3;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = M_04;
  M->at[5][0] = s_m1;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = s_m2;
  M->at[4][1] = 0.0f;
  M->at[5][1] = M_15;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = M_23;
  M->at[4][2] = s_m0;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = 0.0f;
  M->at[2][3] = 0.0f;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = 0.0f;
  M->at[1][4] = 0.0f;
  M->at[2][4] = 0.0f;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = 0.0f;
  M->at[1][5] = 0.0f;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_screw_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screw_t *ksl_screw_alloc(int n) {
  return n > 0 ? (ksl_screw_t *)calloc((size_t)n, sizeof(ksl_screw_t)) : NULL;
}

/* n zeroed ksl_screwf_t on the heap, to be freed by the caller; NULL for n <= 0 or when there is
     no memory. */
static inline ksl_screwf_t *ksl_screwf_alloc(int n) {
  return n > 0 ? (ksl_screwf_t *)calloc((size_t)n, sizeof(ksl_screwf_t)) : NULL;
}

#endif

#endif

/* Coscrews: wrenches and momenta, c = (f; τ). */
#ifndef KSL_COSCREW_H
#define KSL_COSCREW_H


/* The coscrew of these entries, in order. */
static inline ksl_coscrew_t ksl_coscrew(const double m0, const double m1, const double m2,
    const double m3, const double m4, const double m5) {
  ksl_coscrew_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_copy(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrew_scale(ksl_coscrew_t *self, const double a) {
  const double self_0_new = self->m0 * a;
  const double self_1_new = self->m1 * a;
  const double self_2_new = self->m2 * a;
  const double self_3_new = self->m3 * a;
  const double self_4_new = self->m4 * a;
  const double self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_inverted(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3 = -ci->m3;
  const double co_4 = -ci->m4;
  const double co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrew_invert(ksl_coscrew_t *self) {
  const double self_0_new = -self->m0;
  const double self_1_new = -self->m1;
  const double self_2_new = -self->m2;
  const double self_3_new = -self->m3;
  const double self_4_new = -self->m4;
  const double self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_cc(const double a, const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const double y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const double y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const double y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const double y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const double y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = x->m0 + y->m0;
  const double y_1_new = x->m1 + y->m1;
  const double y_2_new = x->m2 + y->m2;
  const double y_3_new = x->m3 + y->m3;
  const double y_4_new = x->m4 + y->m4;
  const double y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_cc(const ksl_coscrew_t *x, ksl_coscrew_t *y) {
  const double y_0_new = y->m0 - x->m0;
  const double y_1_new = y->m1 - x->m1;
  const double y_2_new = y->m2 - x->m2;
  const double y_3_new = y->m3 - x->m3;
  const double y_4_new = y->m4 - x->m4;
  const double y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_ac(const double a, const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double co_0 = a * ci->m0;
  const double co_1 = a * ci->m1;
  const double co_2 = a * ci->m2;
  const double co_3 = a * ci->m3;
  const double co_4 = a * ci->m4;
  const double co_5 = a * ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2, ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double co_3 = c1->m3 + c2->m3;
  const double co_4 = c1->m4 + c2->m4;
  const double co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_cc(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 - c2->m0;
  const double co_1 = c1->m1 - c2->m1;
  const double co_2 = c1->m2 - c2->m2;
  const double co_3 = c1->m3 - c2->m3;
  const double co_4 = c1->m4 - c2->m4;
  const double co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline double ksl_coscrew_norm(const ksl_coscrew_t *ci) {
  const double small_a = fabs(ci->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(ci->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(ci->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0;
  const double p_1 = small == 1.0 ? ci->m4 : ci->m1;
  const double p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double r_b = s < 1.0 ? 2.6815615859885194e+154 : 1.0,
      r = 1.0 < s ? 2.409919865102884e-181 : r_b;
  const double norm = n * r;
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrew_normalize(ksl_coscrew_t *self) {
  const double small_a = fabs(self->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(self->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(self->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? self->m3 : self->m0;
  const double p_1 = small == 1.0 ? self->m4 : self->m1;
  const double p_2 = small == 1.0 ? self->m5 : self->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = self->m0 * up;
  const double z_1 = self->m1 * up;
  const double z_2 = self->m2 * up;
  const double z_3 = self->m3 * up;
  const double z_4 = self->m4 * up;
  const double z_5 = self->m5 * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double q_3 = z_3 / d;
  const double q_4 = z_4 / d;
  const double q_5 = z_5 / d;
  const double self_0_new = q_0 * down;
  const double self_1_new = q_1 * down;
  const double self_2_new = q_2 * down;
  const double self_3_new = q_3 * down;
  const double self_4_new = q_4 * down;
  const double self_5_new = q_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrew_normalized(const ksl_coscrew_t *ci, ksl_coscrew_t *co) {
  const double small_a = fabs(ci->m2), small_c = small_a < 1e-09 ? 1.0 : 0.0,
      small_d = fabs(ci->m1), small_f = small_d < 1e-09 ? small_c : 0.0, small_g = fabs(ci->m0),
      small = small_g < 1e-09 ? small_f : 0.0;
  const double p_0 = small == 1.0 ? ci->m3 : ci->m0;
  const double p_1 = small == 1.0 ? ci->m4 : ci->m1;
  const double p_2 = small == 1.0 ? ci->m5 : ci->m2;
  const double s_size_0 = fabs(p_0);
  const double s_size_1 = fabs(p_1);
  const double s_size_2 = fabs(p_2);
  const double s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const double s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const double s_b = 6.703903964971299e+153 < s_largest2 ? 3.7291703656001034e-155 : 1.0,
      s = s_largest2 < 3.4395525670743494e-136 ? 4.149515568880993e+180 : s_b;
  const double y_0 = p_0 * s;
  const double y_1 = p_1 * s;
  const double y_2 = p_2 * s;
  const double n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrt(n_e);
  const double d = n == 0.0 ? 1.0 : n;
  const double up = 1.0 < s ? s : 1.0;
  const double down = s < 1.0 ? s : 1.0;
  const double z_0 = ci->m0 * up;
  const double z_1 = ci->m1 * up;
  const double z_2 = ci->m2 * up;
  const double z_3 = ci->m3 * up;
  const double z_4 = ci->m4 * up;
  const double z_5 = ci->m5 * up;
  const double q_0 = z_0 / d;
  const double q_1 = z_1 / d;
  const double q_2 = z_2 / d;
  const double q_3 = z_3 / d;
  const double q_4 = z_4 / d;
  const double q_5 = z_5 / d;
  const double co_0 = q_0 * down;
  const double co_1 = q_1 * down;
  const double co_2 = q_2 * down;
  const double co_3 = q_3 * down;
  const double co_4 = q_4 * down;
  const double co_5 = q_5 * down;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_lin_ang(const ksl_vec3_t *lin, const ksl_vec3_t *ang,
    ksl_coscrew_t *co) {
  const double lin_x = lin->x;
  const double lin_y = lin->y;
  const double lin_z = lin->z;
  const double ang_x = ang->x;
  const double ang_y = ang->y;
  const double ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_to_angular_first(const ksl_coscrew_t *ci, double x[6]) {
  const double ci_m3 = ci->m3;
  const double ci_m4 = ci->m4;
  const double ci_m5 = ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrew_from_angular_first(const double x[6], ksl_coscrew_t *co) {
  const double x_3 = x[3];
  const double x_4 = x[4];
  const double x_5 = x[5];
  const double x_0 = x[0];
  const double x_1 = x[1];
  const double x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cct(const ksl_coscrew_t *c1, const ksl_coscrew_t *c2,
    ksl_coscrew_t *co) {
  const double co_0 = c1->m0 + c2->m0;
  const double co_1 = c1->m1 + c2->m1;
  const double co_2 = c1->m2 + c2->m2;
  const double c1_m3 = c1->m3;
  const double c1_m4 = c1->m4;
  const double c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->y * ci->m2, co_3b = t->z * ci->m1, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = t->z * ci->m0, co_4b = t->x * ci->m2, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = t->x * ci->m1, co_5b = t->y * ci->m0, co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvc(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const double ci_m0 = ci->m0;
  const double ci_m1 = ci->m1;
  const double ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinv(const ksl_vec3_t *t, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0 = -ci->m0;
  const double co_1 = -ci->m1;
  const double co_2 = -ci->m2;
  const double co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const double co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const double co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5 = co_5c - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvc(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m20 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = R->m01 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m21 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = R->m02 * ci->m0, co_2b = R->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m10 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m20 * ci->m5, co_3 = co_3c + co_3d;
  const double co_4a = R->m01 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m21 * ci->m5, co_4 = co_4c + co_4d;
  const double co_5a = R->m02 * ci->m3, co_5b = R->m12 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinv(const ksl_mat3x3_t *R, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0e = co_0c + co_0d, co_0 = -co_0e;
  const double co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1e = co_1c + co_1d, co_1 = -co_1e;
  const double co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2e = co_2c + co_2d, co_2 = -co_2e;
  const double co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3e = co_3c + co_3d, co_3 = -co_3e;
  const double co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4e = co_4c + co_4d, co_4 = -co_4e;
  const double co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5e = co_5c + co_5d, co_5 = -co_5e;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvc(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_3a = D->m23 * ci->m1, w_3b = D->m13 * ci->m2, w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const double w_4a = D->m03 * ci->m2, w_4b = D->m23 * ci->m0, w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const double w_5a = D->m13 * ci->m0, w_5b = D->m03 * ci->m1, w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const double co_0a = D->m00 * ci->m0, co_0b = D->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = D->m20 * ci->m2, co_0 = co_0c + co_0d;
  const double co_1a = D->m01 * ci->m0, co_1b = D->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = D->m21 * ci->m2, co_1 = co_1c + co_1d;
  const double co_2a = D->m02 * ci->m0, co_2b = D->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = D->m22 * ci->m2, co_2 = co_2c + co_2d;
  const double co_3a = D->m00 * w_3, co_3b = D->m10 * w_4, co_3c = co_3a + co_3b,
      co_3d = D->m20 * w_5, co_3 = co_3c + co_3d;
  const double co_4a = D->m01 * w_3, co_4b = D->m11 * w_4, co_4c = co_4a + co_4b,
      co_4d = D->m21 * w_5, co_4 = co_4c + co_4d;
  const double co_5a = D->m02 * w_3, co_5b = D->m12 * w_4, co_5c = co_5a + co_5b,
      co_5d = D->m22 * w_5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinv(const ksl_SE3_t *D, const ksl_coscrew_t *ci,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const double w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const double w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const double w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const double w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const double w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m20 * D->m13, co_3b = D->m10 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m00 * D->m23, co_4b = D->m20 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m10 * D->m03, co_5b = D->m00 * D->m13, co_5 = co_5a - co_5b;
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hcty(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m21 * D->m13, co_3b = D->m11 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m01 * D->m23, co_4b = D->m21 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m11 * D->m03, co_5b = D->m01 * D->m13, co_5 = co_5a - co_5b;
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3a = D->m22 * D->m13, co_3b = D->m12 * D->m23, co_3 = co_3a - co_3b;
  const double co_4a = D->m02 * D->m23, co_4b = D->m22 * D->m03, co_4 = co_4a - co_4b;
  const double co_5a = D->m12 * D->m03, co_5b = D->m02 * D->m13, co_5 = co_5a - co_5b;
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrx(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m00 = D->m00;
  const double D_m10 = D->m10;
  const double D_m20 = D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcry(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m01 = D->m01;
  const double D_m11 = D->m11;
  const double D_m21 = D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrz(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double D_m02 = D->m02;
  const double D_m12 = D->m12;
  const double D_m22 = D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m00;
  const double co_1 = -D->m10;
  const double co_2 = -D->m20;
  const double co_3a = D->m10 * D->m23, co_3b = D->m20 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m20 * D->m03, co_4b = D->m00 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m00 * D->m13, co_5b = D->m10 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m01;
  const double co_1 = -D->m11;
  const double co_2 = -D->m21;
  const double co_3a = D->m11 * D->m23, co_3b = D->m21 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m21 * D->m03, co_4b = D->m01 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m01 * D->m13, co_5b = D->m11 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_0 = -D->m02;
  const double co_1 = -D->m12;
  const double co_2 = -D->m22;
  const double co_3a = D->m12 * D->m23, co_3b = D->m22 * D->m13, co_3 = co_3a - co_3b;
  const double co_4a = D->m22 * D->m03, co_4b = D->m02 * D->m23, co_4 = co_4a - co_4b;
  const double co_5a = D->m02 * D->m13, co_5b = D->m12 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m00;
  const double co_4 = -D->m10;
  const double co_5 = -D->m20;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m01;
  const double co_4 = -D->m11;
  const double co_5 = -D->m21;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinv(const ksl_SE3_t *D, ksl_coscrew_t *co) {
  const double co_3 = -D->m02;
  const double co_4 = -D->m12;
  const double co_5 = -D->m22;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAd(const ksl_SE3_t *D, ksl_mat6x6_t *M) {
  const double M_30a = D->m20 * D->m13, M_30b = D->m10 * D->m23, M_30 = M_30a - M_30b;
  const double M_31a = D->m21 * D->m13, M_31b = D->m11 * D->m23, M_31 = M_31a - M_31b;
  const double M_32a = D->m22 * D->m13, M_32b = D->m12 * D->m23, M_32 = M_32a - M_32b;
  const double M_40a = D->m00 * D->m23, M_40b = D->m20 * D->m03, M_40 = M_40a - M_40b;
  const double M_41a = D->m01 * D->m23, M_41b = D->m21 * D->m03, M_41 = M_41a - M_41b;
  const double M_42a = D->m02 * D->m23, M_42b = D->m22 * D->m03, M_42 = M_42a - M_42b;
  const double M_50a = D->m10 * D->m03, M_50b = D->m00 * D->m13, M_50 = M_50a - M_50b;
  const double M_51a = D->m11 * D->m03, M_51b = D->m01 * D->m13, M_51 = M_51a - M_51b;
  const double M_52a = D->m12 * D->m03, M_52b = D->m02 * D->m13, M_52 = M_52a - M_52b;
  const double D_m00 = D->m00;
  const double D_m01 = D->m01;
  const double D_m02 = D->m02;
  const double D_m10 = D->m10;
  const double D_m11 = D->m11;
  const double D_m12 = D->m12;
  const double D_m20 = D->m20;
  const double D_m21 = D->m21;
  const double D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline double ksl_reciprocal_product(const ksl_coscrew_t *c, const double x[6]) {
  const double power_a = c->m0 * x[3], power_b = c->m1 * x[4], power_c = power_a + power_b,
      power_d = c->m2 * x[5], power_e = power_c + power_d, power_f = c->m3 * x[0],
      power_g = c->m4 * x[1], power_h = power_f + power_g, power_i = c->m5 * x[2],
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sc(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_0a = s->m4 * c->m2, co_0b = s->m5 * c->m1, co_0 = co_0a - co_0b;
  const double co_1a = s->m5 * c->m0, co_1b = s->m3 * c->m2, co_1 = co_1a - co_1b;
  const double co_2a = s->m3 * c->m1, co_2b = s->m4 * c->m0, co_2 = co_2a - co_2b;
  const double co_3a = s->m1 * c->m2, co_3b = s->m2 * c->m1, co_3c = co_3a - co_3b,
      co_3d = s->m4 * c->m5, co_3e = s->m5 * c->m4, co_3f = co_3d - co_3e, co_3 = co_3c + co_3f;
  const double co_4a = s->m2 * c->m0, co_4b = s->m0 * c->m2, co_4c = co_4a - co_4b,
      co_4d = s->m5 * c->m3, co_4e = s->m3 * c->m5, co_4f = co_4d - co_4e, co_4 = co_4c + co_4f;
  const double co_5a = s->m0 * c->m1, co_5b = s->m1 * c->m0, co_5c = co_5a - co_5b,
      co_5d = s->m3 * c->m4, co_5e = s->m4 * c->m3, co_5f = co_5d - co_5e, co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_sca(const ksl_screw_t *s, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double co_3a = s->m4 * c->m5, co_3b = s->m5 * c->m4, co_3 = co_3a - co_3b;
  const double co_4a = s->m5 * c->m3, co_4b = s->m3 * c->m5, co_4 = co_4a - co_4b;
  const double co_5a = s->m3 * c->m4, co_5b = s->m4 * c->m3, co_5 = co_5a - co_5b;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m01 * c->m1, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const double w_1a = D->m11 * c->m1, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const double w_2a = D->m21 * c->m1, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const double w_1a = D->m10 * c->m0, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const double w_2a = D->m20 * c->m0, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0 = w_0a + w_0b;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1 = w_1a + w_1b;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2 = w_2a + w_2b;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m01 * c->m4, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const double w_4a = D->m11 * c->m4, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const double w_5a = D->m21 * c->m4, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * c->m3, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const double w_4a = D->m10 * c->m3, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const double w_5a = D->m20 * c->m3, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c,
    ksl_coscrew_t *co) {
  const double w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const double w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const double w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const double w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3 = w_3a + w_3b;
  const double w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4 = w_4a + w_4b;
  const double w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5 = w_5a + w_5b;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b,
      co_3 = co_3c + w_3;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b,
      co_4 = co_4c + w_4;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b,
      co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m00 * c->m0;
  const double w_1 = D->m10 * c->m0;
  const double w_2 = D->m20 * c->m0;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_cty(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m01 * c->m1;
  const double w_1 = D->m11 * c->m1;
  const double w_2 = D->m21 * c->m1;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_0 = D->m02 * c->m2;
  const double w_1 = D->m12 * c->m2;
  const double w_2 = D->m22 * c->m2;
  const double co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const double co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const double co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crx(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m00 * c->m3;
  const double w_4 = D->m10 * c->m3;
  const double w_5 = D->m20 * c->m3;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cry(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m01 * c->m4;
  const double w_4 = D->m11 * c->m4;
  const double w_5 = D->m21 * c->m4;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crz(const ksl_SE3_t *D, const ksl_coscrew_t *c, ksl_coscrew_t *co) {
  const double w_3 = D->m02 * c->m5;
  const double w_4 = D->m12 * c->m5;
  const double w_5 = D->m22 * c->m5;
  co->m0 = 0.0;
  co->m1 = 0.0;
  co->m2 = 0.0;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coad(const ksl_screw_t *s, ksl_mat6x6_t *M) {
  const double M_01 = -s->m5;
  const double M_12 = -s->m3;
  const double M_20 = -s->m4;
  const double M_31 = -s->m2;
  const double M_42 = -s->m0;
  const double M_50 = -s->m1;
  const double s_m4 = s->m4;
  const double s_m5 = s->m5;
  const double s_m3 = s->m3;
  const double s_m1 = s->m1;
  const double s_m2 = s->m2;
  const double s_m0 = s->m0;
  M->at[0][0] = 0.0;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0;
  M->at[4][0] = 0.0;
  M->at[5][0] = 0.0;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0;
  M->at[4][1] = 0.0;
  M->at[5][1] = 0.0;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0;
  M->at[3][2] = 0.0;
  M->at[4][2] = 0.0;
  M->at[5][2] = 0.0;
  M->at[0][3] = 0.0;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0;
}

/* The coscrew of these entries, in order. */
static inline ksl_coscrewf_t ksl_coscrewf(const float m0, const float m1, const float m2,
    const float m3, const float m4, const float m5) {
  ksl_coscrewf_t value;
  value.m0 = m0;
  value.m1 = m1;
  value.m2 = m2;
  value.m3 = m3;
  value.m4 = m4;
  value.m5 = m5;
  return value;
}

/* co = ci.
   ci, co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_copy(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = ci_m3;
  co->m4 = ci_m4;
  co->m5 = ci_m5;
}

/* self = a self.
   self: coscrew (f in N; τ in N m); a: number.
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_coscrewf_scale(ksl_coscrewf_t *self, const float a) {
  const float self_0_new = self->m0 * a;
  const float self_1_new = self->m1 * a;
  const float self_2_new = self->m2 * a;
  const float self_3_new = self->m3 * a;
  const float self_4_new = self->m4 * a;
  const float self_5_new = self->m5 * a;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = -ci.
   ci, co: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_inverted(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3 = -ci->m3;
  const float co_4 = -ci->m4;
  const float co_5 = -ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* self = -self.
   self: coscrew (f in N; τ in N m).
   6 neg.
   Exact. */
static inline void ksl_coscrewf_invert(ksl_coscrewf_t *self) {
  const float self_0_new = -self->m0;
  const float self_1_new = -self->m1;
  const float self_2_new = -self->m2;
  const float self_3_new = -self->m3;
  const float self_4_new = -self->m4;
  const float self_5_new = -self->m5;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* y = a x + y.
   a: number; x, y: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_axpy_ccf(const float a, const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new_a = a * x->m0, y_0_new = y_0_new_a + y->m0;
  const float y_1_new_a = a * x->m1, y_1_new = y_1_new_a + y->m1;
  const float y_2_new_a = a * x->m2, y_2_new = y_2_new_a + y->m2;
  const float y_3_new_a = a * x->m3, y_3_new = y_3_new_a + y->m3;
  const float y_4_new_a = a * x->m4, y_4_new = y_4_new_a + y->m4;
  const float y_5_new_a = a * x->m5, y_5_new = y_5_new_a + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_xpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = x->m0 + y->m0;
  const float y_1_new = x->m1 + y->m1;
  const float y_2_new = x->m2 + y->m2;
  const float y_3_new = x->m3 + y->m3;
  const float y_4_new = x->m4 + y->m4;
  const float y_5_new = x->m5 + y->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* y = -x + y.
   x, y: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_nxpy_ccf(const ksl_coscrewf_t *x, ksl_coscrewf_t *y) {
  const float y_0_new = y->m0 - x->m0;
  const float y_1_new = y->m1 - x->m1;
  const float y_2_new = y->m2 - x->m2;
  const float y_3_new = y->m3 - x->m3;
  const float y_4_new = y->m4 - x->m4;
  const float y_5_new = y->m5 - x->m5;
  y->m0 = y_0_new;
  y->m1 = y_1_new;
  y->m2 = y_2_new;
  y->m3 = y_3_new;
  y->m4 = y_4_new;
  y->m5 = y_5_new;
}

/* co = a ci.
   a: number; ci, co: coscrew (f in N; τ in N m).
   6 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_product_acf(const float a, const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float co_0 = a * ci->m0;
  const float co_1 = a * ci->m1;
  const float co_2 = a * ci->m2;
  const float co_3 = a * ci->m3;
  const float co_4 = a * ci->m4;
  const float co_5 = a * ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 + c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float co_3 = c1->m3 + c2->m3;
  const float co_4 = c1->m4 + c2->m4;
  const float co_5 = c1->m5 + c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = c1 - c2.
   c1, c2, co: coscrew (f in N; τ in N m).
   6 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_ccf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 - c2->m0;
  const float co_1 = c1->m1 - c2->m1;
  const float co_2 = c1->m2 - c2->m2;
  const float co_3 = c1->m3 - c2->m3;
  const float co_4 = c1->m4 - c2->m4;
  const float co_5 = c1->m5 - c2->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* |ci|: |f|, or |τ| where every |f_i| is below 1e-9 (single: 1e-6).
   ci: coscrew (f in N; τ in N m).
   7 mul, 2 add, 1 sqrt, 6 abs, 9 less, 1 equal, 12 select. */
static inline float ksl_coscrewf_norm(const ksl_coscrewf_t *ci) {
  const float small_a = fabsf(ci->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(ci->m1), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(ci->m0),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0;
  const float p_1 = small == 1.0f ? ci->m4 : ci->m1;
  const float p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float r_b = s < 1.0f ? 3.689349e+19f : 1.0f, r = 1.0f < s ? 7.888609e-31f : r_b;
  const float norm = n * r;
  return norm;
}

/* self = self / |self|, with coscrew_norm; the zero coscrew stays zero.
   self: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrewf_normalize(ksl_coscrewf_t *self) {
  const float small_a = fabsf(self->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(self->m1), small_f = small_d < 1e-06f ? small_c : 0.0f,
      small_g = fabsf(self->m0), small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? self->m3 : self->m0;
  const float p_1 = small == 1.0f ? self->m4 : self->m1;
  const float p_2 = small == 1.0f ? self->m5 : self->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = self->m0 * up;
  const float z_1 = self->m1 * up;
  const float z_2 = self->m2 * up;
  const float z_3 = self->m3 * up;
  const float z_4 = self->m4 * up;
  const float z_5 = self->m5 * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float q_3 = z_3 / d;
  const float q_4 = z_4 / d;
  const float q_5 = z_5 / d;
  const float self_0_new = q_0 * down;
  const float self_1_new = q_1 * down;
  const float self_2_new = q_2 * down;
  const float self_3_new = q_3 * down;
  const float self_4_new = q_4 * down;
  const float self_5_new = q_5 * down;
  self->m0 = self_0_new;
  self->m1 = self_1_new;
  self->m2 = self_2_new;
  self->m3 = self_3_new;
  self->m4 = self_4_new;
  self->m5 = self_5_new;
}

/* co = ci / |ci|, with coscrew_norm; the zero coscrew stays zero.
   ci, co: coscrew (f in N; τ in N m).
   18 mul, 2 add, 6 div, 1 sqrt, 6 abs, 9 less, 2 equal, 13 select. */
static inline void ksl_coscrewf_normalized(const ksl_coscrewf_t *ci, ksl_coscrewf_t *co) {
  const float small_a = fabsf(ci->m2), small_c = small_a < 1e-06f ? 1.0f : 0.0f,
      small_d = fabsf(ci->m1), small_f = small_d < 1e-06f ? small_c : 0.0f, small_g = fabsf(ci->m0),
      small = small_g < 1e-06f ? small_f : 0.0f;
  const float p_0 = small == 1.0f ? ci->m3 : ci->m0;
  const float p_1 = small == 1.0f ? ci->m4 : ci->m1;
  const float p_2 = small == 1.0f ? ci->m5 : ci->m2;
  const float s_size_0 = fabsf(p_0);
  const float s_size_1 = fabsf(p_1);
  const float s_size_2 = fabsf(p_2);
  const float s_largest1 = s_size_0 < s_size_1 ? s_size_1 : s_size_0;
  const float s_largest2 = s_largest1 < s_size_2 ? s_size_2 : s_largest1;
  const float s_b = 4.611686e+18f < s_largest2 ? 2.7105054e-20f : 1.0f,
      s = s_largest2 < 8.881784e-16f ? 1.2676506e+30f : s_b;
  const float y_0 = p_0 * s;
  const float y_1 = p_1 * s;
  const float y_2 = p_2 * s;
  const float n_a = y_0 * y_0, n_b = y_1 * y_1, n_c = n_a + n_b, n_d = y_2 * y_2, n_e = n_c + n_d,
      n = sqrtf(n_e);
  const float d = n == 0.0f ? 1.0f : n;
  const float up = 1.0f < s ? s : 1.0f;
  const float down = s < 1.0f ? s : 1.0f;
  const float z_0 = ci->m0 * up;
  const float z_1 = ci->m1 * up;
  const float z_2 = ci->m2 * up;
  const float z_3 = ci->m3 * up;
  const float z_4 = ci->m4 * up;
  const float z_5 = ci->m5 * up;
  const float q_0 = z_0 / d;
  const float q_1 = z_1 / d;
  const float q_2 = z_2 / d;
  const float q_3 = z_3 / d;
  const float q_4 = z_4 / d;
  const float q_5 = z_5 / d;
  const float co_0 = q_0 * down;
  const float co_1 = q_1 * down;
  const float co_2 = q_2 * down;
  const float co_3 = q_3 * down;
  const float co_4 = q_4 * down;
  const float co_5 = q_5 * down;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (lin; ang).
   lin, ang: vector; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_lin_ang(const ksl_vec3f_t *lin, const ksl_vec3f_t *ang,
    ksl_coscrewf_t *co) {
  const float lin_x = lin->x;
  const float lin_y = lin->y;
  const float lin_z = lin->z;
  const float ang_x = ang->x;
  const float ang_y = ang->y;
  const float ang_z = ang->z;
  co->m0 = lin_x;
  co->m1 = lin_y;
  co->m2 = lin_z;
  co->m3 = ang_x;
  co->m4 = ang_y;
  co->m5 = ang_z;
}

/* x = (ang; lin) of ci.
   ci: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_to_angular_first(const ksl_coscrewf_t *ci, float x[6]) {
  const float ci_m3 = ci->m3;
  const float ci_m4 = ci->m4;
  const float ci_m5 = ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  x[0] = ci_m3;
  x[1] = ci_m4;
  x[2] = ci_m5;
  x[3] = ci_m0;
  x[4] = ci_m1;
  x[5] = ci_m2;
}

/* co = (lin; ang) of x = (ang; lin).
   x: six components with the angular part on top; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_coscrewf_from_angular_first(const float x[6], ksl_coscrewf_t *co) {
  const float x_3 = x[3];
  const float x_4 = x[4];
  const float x_5 = x[5];
  const float x_0 = x[0];
  const float x_1 = x[1];
  const float x_2 = x[2];
  co->m0 = x_3;
  co->m1 = x_4;
  co->m2 = x_5;
  co->m3 = x_0;
  co->m4 = x_1;
  co->m5 = x_2;
}

/* co = (c1.lin + c2.lin ; c1.ang).
   c1, c2, co: coscrew (f in N; τ in N m).
   3 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_cctf(const ksl_coscrewf_t *c1, const ksl_coscrewf_t *c2,
    ksl_coscrewf_t *co) {
  const float co_0 = c1->m0 + c2->m0;
  const float co_1 = c1->m1 + c2->m1;
  const float co_2 = c1->m2 + c2->m2;
  const float c1_m3 = c1->m3;
  const float c1_m4 = c1->m4;
  const float c1_m5 = c1->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = c1_m3;
  co->m4 = c1_m4;
  co->m5 = c1_m5;
}

/* co = [Ad]*(t) ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = t->y * ci->m2, co_3b = t->z * ci->m1, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = t->z * ci->m0, co_4b = t->x * ci->m2, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = t->x * ci->m1, co_5b = t->y * ci->m0, co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t)^-1 ci.
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtinvcf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c + ci->m3;
  const float co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c + ci->m4;
  const float co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5 = co_5c + ci->m5;
  const float ci_m0 = ci->m0;
  const float ci_m1 = ci->m1;
  const float ci_m2 = ci->m2;
  co->m0 = ci_m0;
  co->m1 = ci_m1;
  co->m2 = ci_m2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(t) (-ci).
   t: vector; ci, co: coscrew (f in N; τ in N m).
   6 mul, 6 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdtcinvf(const ksl_vec3f_t *t, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0 = -ci->m0;
  const float co_1 = -ci->m1;
  const float co_2 = -ci->m2;
  const float co_3a = t->z * ci->m1, co_3b = t->y * ci->m2, co_3c = co_3a - co_3b,
      co_3 = co_3c - ci->m3;
  const float co_4a = t->x * ci->m2, co_4b = t->z * ci->m0, co_4c = co_4a - co_4b,
      co_4 = co_4c - ci->m4;
  const float co_5a = t->y * ci->m0, co_5b = t->x * ci->m1, co_5c = co_5a - co_5b,
      co_5 = co_5c - ci->m5;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3 = co_3c + co_3d;
  const float co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4 = co_4c + co_4d;
  const float co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R)^-1 ci.
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrinvcf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m20 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = R->m01 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m21 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = R->m02 * ci->m0, co_2b = R->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m10 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m20 * ci->m5, co_3 = co_3c + co_3d;
  const float co_4a = R->m01 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m21 * ci->m5, co_4 = co_4c + co_4d;
  const float co_5a = R->m02 * ci->m3, co_5b = R->m12 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(R) (-ci).
   R: rotation or other 3×3 matrix; ci, co: coscrew (f in N; τ in N m).
   18 mul, 12 add, 6 neg.
   Error <= u |result| + 2 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_product_CoAdrcinvf(const ksl_mat3x3f_t *R, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float co_0a = R->m00 * ci->m0, co_0b = R->m01 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = R->m02 * ci->m2, co_0e = co_0c + co_0d, co_0 = -co_0e;
  const float co_1a = R->m10 * ci->m0, co_1b = R->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = R->m12 * ci->m2, co_1e = co_1c + co_1d, co_1 = -co_1e;
  const float co_2a = R->m20 * ci->m0, co_2b = R->m21 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = R->m22 * ci->m2, co_2e = co_2c + co_2d, co_2 = -co_2e;
  const float co_3a = R->m00 * ci->m3, co_3b = R->m01 * ci->m4, co_3c = co_3a + co_3b,
      co_3d = R->m02 * ci->m5, co_3e = co_3c + co_3d, co_3 = -co_3e;
  const float co_4a = R->m10 * ci->m3, co_4b = R->m11 * ci->m4, co_4c = co_4a + co_4b,
      co_4d = R->m12 * ci->m5, co_4e = co_4c + co_4d, co_4 = -co_4e;
  const float co_5a = R->m20 * ci->m3, co_5b = R->m21 * ci->m4, co_5c = co_5a + co_5b,
      co_5d = R->m22 * ci->m5, co_5e = co_5c + co_5d, co_5 = -co_5e;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) ci = [Ad]*(t) [Ad]*(R) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D)^-1 ci = [Ad]*(R^T) [Ad]*(-t) ci.
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdinvcf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_3a = D->m23 * ci->m1, w_3b = D->m13 * ci->m2, w_3c = w_3a - w_3b,
      w_3 = w_3c + ci->m3;
  const float w_4a = D->m03 * ci->m2, w_4b = D->m23 * ci->m0, w_4c = w_4a - w_4b,
      w_4 = w_4c + ci->m4;
  const float w_5a = D->m13 * ci->m0, w_5b = D->m03 * ci->m1, w_5c = w_5a - w_5b,
      w_5 = w_5c + ci->m5;
  const float co_0a = D->m00 * ci->m0, co_0b = D->m10 * ci->m1, co_0c = co_0a + co_0b,
      co_0d = D->m20 * ci->m2, co_0 = co_0c + co_0d;
  const float co_1a = D->m01 * ci->m0, co_1b = D->m11 * ci->m1, co_1c = co_1a + co_1b,
      co_1d = D->m21 * ci->m2, co_1 = co_1c + co_1d;
  const float co_2a = D->m02 * ci->m0, co_2b = D->m12 * ci->m1, co_2c = co_2a + co_2b,
      co_2d = D->m22 * ci->m2, co_2 = co_2c + co_2d;
  const float co_3a = D->m00 * w_3, co_3b = D->m10 * w_4, co_3c = co_3a + co_3b,
      co_3d = D->m20 * w_5, co_3 = co_3c + co_3d;
  const float co_4a = D->m01 * w_3, co_4b = D->m11 * w_4, co_4c = co_4a + co_4b,
      co_4d = D->m21 * w_5, co_4 = co_4c + co_4d;
  const float co_5a = D->m02 * w_3, co_5b = D->m12 * w_4, co_5c = co_5a + co_5b,
      co_5d = D->m22 * w_5, co_5 = co_5c + co_5d;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = [Ad]*(D) (-ci).
   D: displacement [R | t], R rotation, t in m; ci, co: coscrew (f in N; τ in N m).
   24 mul, 18 add, 6 neg.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_product_CoAdcinvf(const ksl_SE3f_t *D, const ksl_coscrewf_t *ci,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * ci->m0, w_0b = D->m01 * ci->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * ci->m2, w_0e = w_0c + w_0d, w_0 = -w_0e;
  const float w_1a = D->m10 * ci->m0, w_1b = D->m11 * ci->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * ci->m2, w_1e = w_1c + w_1d, w_1 = -w_1e;
  const float w_2a = D->m20 * ci->m0, w_2b = D->m21 * ci->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * ci->m2, w_2e = w_2c + w_2d, w_2 = -w_2e;
  const float w_3a = D->m00 * ci->m3, w_3b = D->m01 * ci->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * ci->m5, w_3e = w_3c + w_3d, w_3 = -w_3e;
  const float w_4a = D->m10 * ci->m3, w_4b = D->m11 * ci->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * ci->m5, w_4e = w_4c + w_4d, w_4 = -w_4e;
  const float w_5a = D->m20 * ci->m3, w_5b = D->m21 * ci->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * ci->m5, w_5e = w_5c + w_5d, w_5 = -w_5e;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tx: column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m20 * D->m13, co_3b = D->m10 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m00 * D->m23, co_4b = D->m20 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m10 * D->m03, co_5b = D->m00 * D->m13, co_5 = co_5a - co_5b;
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = D_m00;
  co->m1 = D_m10;
  co->m2 = D_m20;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_ty: column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m21 * D->m13, co_3b = D->m11 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m01 * D->m23, co_4b = D->m21 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m11 * D->m03, co_5b = D->m01 * D->m13, co_5 = co_5a - co_5b;
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = D_m01;
  co->m1 = D_m11;
  co->m2 = D_m21;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_tz: column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3a = D->m22 * D->m13, co_3b = D->m12 * D->m23, co_3 = co_3a - co_3b;
  const float co_4a = D->m02 * D->m23, co_4b = D->m22 * D->m03, co_4 = co_4a - co_4b;
  const float co_5a = D->m12 * D->m03, co_5b = D->m02 * D->m13, co_5 = co_5a - co_5b;
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = D_m02;
  co->m1 = D_m12;
  co->m2 = D_m22;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h_rx: column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrxf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m00 = D->m00;
  const float D_m10 = D->m10;
  const float D_m20 = D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m00;
  co->m4 = D_m10;
  co->m5 = D_m20;
}

/* co = h_ry: column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcryf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m01 = D->m01;
  const float D_m11 = D->m11;
  const float D_m21 = D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m01;
  co->m4 = D_m11;
  co->m5 = D_m21;
}

/* co = h_rz: column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   No arithmetic.
   Exact. */
static inline void ksl_hcrzf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float D_m02 = D->m02;
  const float D_m12 = D->m12;
  const float D_m22 = D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = D_m02;
  co->m4 = D_m12;
  co->m5 = D_m22;
}

/* co = -h_tx: -column 0 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m00;
  const float co_1 = -D->m10;
  const float co_2 = -D->m20;
  const float co_3a = D->m10 * D->m23, co_3b = D->m20 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m20 * D->m03, co_4b = D->m00 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m00 * D->m13, co_5b = D->m10 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ty: -column 1 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctyinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m01;
  const float co_1 = -D->m11;
  const float co_2 = -D->m21;
  const float co_3a = D->m11 * D->m23, co_3b = D->m21 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m21 * D->m03, co_4b = D->m01 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m01 * D->m13, co_5b = D->m11 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_tz: -column 2 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   6 mul, 3 add, 3 neg.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_hctzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_0 = -D->m02;
  const float co_1 = -D->m12;
  const float co_2 = -D->m22;
  const float co_3a = D->m12 * D->m23, co_3b = D->m22 * D->m13, co_3 = co_3a - co_3b;
  const float co_4a = D->m22 * D->m03, co_4b = D->m02 * D->m23, co_4 = co_4a - co_4b;
  const float co_5a = D->m02 * D->m13, co_5b = D->m12 * D->m03, co_5 = co_5a - co_5b;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rx: -column 3 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrxinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m00;
  const float co_4 = -D->m10;
  const float co_5 = -D->m20;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_ry: -column 4 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcryinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m01;
  const float co_4 = -D->m11;
  const float co_5 = -D->m21;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = -h_rz: -column 5 of [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; co: coscrew (f in N; τ in N m).
   3 neg.
   Exact. */
static inline void ksl_hcrzinvf(const ksl_SE3f_t *D, ksl_coscrewf_t *co) {
  const float co_3 = -D->m02;
  const float co_4 = -D->m12;
  const float co_5 = -D->m22;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* M = [Ad]*(D).
   D: displacement [R | t], R rotation, t in m; M: 6×6 operator.
   18 mul, 9 add.
   Error <= u |result| + 1 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline void ksl_CoAdf(const ksl_SE3f_t *D, ksl_mat6x6f_t *M) {
  const float M_30a = D->m20 * D->m13, M_30b = D->m10 * D->m23, M_30 = M_30a - M_30b;
  const float M_31a = D->m21 * D->m13, M_31b = D->m11 * D->m23, M_31 = M_31a - M_31b;
  const float M_32a = D->m22 * D->m13, M_32b = D->m12 * D->m23, M_32 = M_32a - M_32b;
  const float M_40a = D->m00 * D->m23, M_40b = D->m20 * D->m03, M_40 = M_40a - M_40b;
  const float M_41a = D->m01 * D->m23, M_41b = D->m21 * D->m03, M_41 = M_41a - M_41b;
  const float M_42a = D->m02 * D->m23, M_42b = D->m22 * D->m03, M_42 = M_42a - M_42b;
  const float M_50a = D->m10 * D->m03, M_50b = D->m00 * D->m13, M_50 = M_50a - M_50b;
  const float M_51a = D->m11 * D->m03, M_51b = D->m01 * D->m13, M_51 = M_51a - M_51b;
  const float M_52a = D->m12 * D->m03, M_52b = D->m02 * D->m13, M_52 = M_52a - M_52b;
  const float D_m00 = D->m00;
  const float D_m01 = D->m01;
  const float D_m02 = D->m02;
  const float D_m10 = D->m10;
  const float D_m11 = D->m11;
  const float D_m12 = D->m12;
  const float D_m20 = D->m20;
  const float D_m21 = D->m21;
  const float D_m22 = D->m22;
  M->at[0][0] = D_m00;
  M->at[1][0] = D_m01;
  M->at[2][0] = D_m02;
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = D_m10;
  M->at[1][1] = D_m11;
  M->at[2][1] = D_m12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = D_m20;
  M->at[1][2] = D_m21;
  M->at[2][2] = D_m22;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = M_30;
  M->at[1][3] = M_31;
  M->at[2][3] = M_32;
  M->at[3][3] = D_m00;
  M->at[4][3] = D_m01;
  M->at[5][3] = D_m02;
  M->at[0][4] = M_40;
  M->at[1][4] = M_41;
  M->at[2][4] = M_42;
  M->at[3][4] = D_m10;
  M->at[4][4] = D_m11;
  M->at[5][4] = D_m12;
  M->at[0][5] = M_50;
  M->at[1][5] = M_51;
  M->at[2][5] = M_52;
  M->at[3][5] = D_m20;
  M->at[4][5] = D_m21;
  M->at[5][5] = D_m22;
}

/* power = W ⊙ $ = f·v + τ·ω, W = c = (f; τ), $ = x = (ω; v).
   c: coscrew (f in N; τ in N m); x: six components with the angular part on top.
   6 mul, 5 add.
   Error <= u |result| + 3 u S, S the sum of the |terms| of the expanded formula; barring over-
     and underflow. */
static inline float ksl_reciprocal_productf(const ksl_coscrewf_t *c, const float x[6]) {
  const float power_a = c->m0 * x[3], power_b = c->m1 * x[4], power_c = power_a + power_b,
      power_d = c->m2 * x[5], power_e = power_c + power_d, power_f = c->m3 * x[0],
      power_g = c->m4 * x[1], power_h = power_f + power_g, power_i = c->m5 * x[2],
      power_j = power_h + power_i, power = power_e + power_j;
  return power;
}

/* co = [ad]*(s) c = (ω×f ; v×f + ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   18 mul, 12 add.
   Error <= u |result| + (lin: 1, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_0a = s->m4 * c->m2, co_0b = s->m5 * c->m1, co_0 = co_0a - co_0b;
  const float co_1a = s->m5 * c->m0, co_1b = s->m3 * c->m2, co_1 = co_1a - co_1b;
  const float co_2a = s->m3 * c->m1, co_2b = s->m4 * c->m0, co_2 = co_2a - co_2b;
  const float co_3a = s->m1 * c->m2, co_3b = s->m2 * c->m1, co_3c = co_3a - co_3b,
      co_3d = s->m4 * c->m5, co_3e = s->m5 * c->m4, co_3f = co_3d - co_3e, co_3 = co_3c + co_3f;
  const float co_4a = s->m2 * c->m0, co_4b = s->m0 * c->m2, co_4c = co_4a - co_4b,
      co_4d = s->m5 * c->m3, co_4e = s->m3 * c->m5, co_4f = co_4d - co_4e, co_4 = co_4c + co_4f;
  const float co_5a = s->m0 * c->m1, co_5b = s->m1 * c->m0, co_5c = co_5a - co_5b,
      co_5d = s->m3 * c->m4, co_5e = s->m4 * c->m3, co_5f = co_5d - co_5e, co_5 = co_5c + co_5f;
  co->m0 = co_0;
  co->m1 = co_1;
  co->m2 = co_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = (0 ; ω×τ).
   s: screw (v in m/s; ω in rad/s); c, co: coscrew (f in N; τ in N m).
   6 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 1) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_cross_scaf(const ksl_screwf_t *s, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float co_3a = s->m4 * c->m5, co_3b = s->m5 * c->m4, co_3 = co_3a - co_3b;
  const float co_4a = s->m5 * c->m3, co_4b = s->m3 * c->m5, co_4 = co_4a - co_4b;
  const float co_5a = s->m3 * c->m4, co_5b = s->m4 * c->m3, co_5 = co_5a - co_5b;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m01 * c->m1, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const float w_1a = D->m11 * c->m1, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const float w_2a = D->m21 * c->m1, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m02 * c->m2, w_0 = w_0a + w_0b;
  const float w_1a = D->m10 * c->m0, w_1b = D->m12 * c->m2, w_1 = w_1a + w_1b;
  const float w_2a = D->m20 * c->m0, w_2b = D->m22 * c->m2, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 1, ang: 4) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0 = w_0a + w_0b;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1 = w_1a + w_1b;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2 = w_2a + w_2b;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3c = w_3a + w_3b,
      w_3d = D->m02 * c->m5, w_3 = w_3c + w_3d;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4c = w_4a + w_4b,
      w_4d = D->m12 * c->m5, w_4 = w_4c + w_4d;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5c = w_5a + w_5b,
      w_5d = D->m22 * c->m5, w_5 = w_5c + w_5d;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m01 * c->m4, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const float w_4a = D->m11 * c->m4, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const float w_5a = D->m21 * c->m4, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * c->m3, w_3b = D->m02 * c->m5, w_3 = w_3a + w_3b;
  const float w_4a = D->m10 * c->m3, w_4b = D->m12 * c->m5, w_4 = w_4a + w_4b;
  const float w_5a = D->m20 * c->m3, w_5b = D->m22 * c->m5, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = H̄* c = [Ad]*(D) P c; P clears component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   21 mul, 15 add.
   Error <= u |result| + (lin: 2, ang: 5) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_constraint_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0a = D->m00 * c->m0, w_0b = D->m01 * c->m1, w_0c = w_0a + w_0b,
      w_0d = D->m02 * c->m2, w_0 = w_0c + w_0d;
  const float w_1a = D->m10 * c->m0, w_1b = D->m11 * c->m1, w_1c = w_1a + w_1b,
      w_1d = D->m12 * c->m2, w_1 = w_1c + w_1d;
  const float w_2a = D->m20 * c->m0, w_2b = D->m21 * c->m1, w_2c = w_2a + w_2b,
      w_2d = D->m22 * c->m2, w_2 = w_2c + w_2d;
  const float w_3a = D->m00 * c->m3, w_3b = D->m01 * c->m4, w_3 = w_3a + w_3b;
  const float w_4a = D->m10 * c->m3, w_4b = D->m11 * c->m4, w_4 = w_4a + w_4b;
  const float w_5a = D->m20 * c->m3, w_5b = D->m21 * c->m4, w_5 = w_5a + w_5b;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3c = co_3a - co_3b, co_3 = co_3c + w_3;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4c = co_4a - co_4b, co_4 = co_4c + w_4;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5c = co_5a - co_5b, co_5 = co_5c + w_5;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 0 of c, given in the frame of a tx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m00 * c->m0;
  const float w_1 = D->m10 * c->m0;
  const float w_2 = D->m20 * c->m0;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 1 of c, given in the frame of a ty joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctyf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m01 * c->m1;
  const float w_1 = D->m11 * c->m1;
  const float w_2 = D->m21 * c->m1;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 2 of c, given in the frame of a tz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   9 mul, 3 add.
   Error <= u |result| + (lin: 0, ang: 2) u S, S the sum of the |terms| of the expanded formula;
     barring over- and underflow. */
static inline void ksl_working_ctzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_0 = D->m02 * c->m2;
  const float w_1 = D->m12 * c->m2;
  const float w_2 = D->m22 * c->m2;
  const float co_3a = D->m13 * w_2, co_3b = D->m23 * w_1, co_3 = co_3a - co_3b;
  const float co_4a = D->m23 * w_0, co_4b = D->m03 * w_2, co_4 = co_4a - co_4b;
  const float co_5a = D->m03 * w_1, co_5b = D->m13 * w_0, co_5 = co_5a - co_5b;
  co->m0 = w_0;
  co->m1 = w_1;
  co->m2 = w_2;
  co->m3 = co_3;
  co->m4 = co_4;
  co->m5 = co_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 3 of c, given in the frame of a rx joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crxf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m00 * c->m3;
  const float w_4 = D->m10 * c->m3;
  const float w_5 = D->m20 * c->m3;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 4 of c, given in the frame of a ry joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_cryf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m01 * c->m4;
  const float w_4 = D->m11 * c->m4;
  const float w_5 = D->m21 * c->m4;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* co = h̄* c = [Ad]*(D) P c; P keeps component 5 of c, given in the frame of a rz joint at D.
   D: displacement [R | t], R rotation, t in m; c, co: coscrew (f in N; τ in N m).
   3 mul.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_working_crzf(const ksl_SE3f_t *D, const ksl_coscrewf_t *c,
    ksl_coscrewf_t *co) {
  const float w_3 = D->m02 * c->m5;
  const float w_4 = D->m12 * c->m5;
  const float w_5 = D->m22 * c->m5;
  co->m0 = 0.0f;
  co->m1 = 0.0f;
  co->m2 = 0.0f;
  co->m3 = w_3;
  co->m4 = w_4;
  co->m5 = w_5;
}

/* M = [ad]*(s) = [Ad]*' [Ad]*^-1 = [[ω~, 0], [v~, ω~]].
   s: screw (v in m/s; ω in rad/s); M: 6×6 operator.
   6 neg.
   Exact. */
static inline void ksl_coadf(const ksl_screwf_t *s, ksl_mat6x6f_t *M) {
  const float M_01 = -s->m5;
  const float M_12 = -s->m3;
  const float M_20 = -s->m4;
  const float M_31 = -s->m2;
  const float M_42 = -s->m0;
  const float M_50 = -s->m1;
  const float s_m4 = s->m4;
  const float s_m5 = s->m5;
  const float s_m3 = s->m3;
  const float s_m1 = s->m1;
  const float s_m2 = s->m2;
  const float s_m0 = s->m0;
  M->at[0][0] = 0.0f;
  M->at[1][0] = M_01;
  M->at[2][0] = s_m4;
  M->at[3][0] = 0.0f;
  M->at[4][0] = 0.0f;
  M->at[5][0] = 0.0f;
  M->at[0][1] = s_m5;
  M->at[1][1] = 0.0f;
  M->at[2][1] = M_12;
  M->at[3][1] = 0.0f;
  M->at[4][1] = 0.0f;
  M->at[5][1] = 0.0f;
  M->at[0][2] = M_20;
  M->at[1][2] = s_m3;
  M->at[2][2] = 0.0f;
  M->at[3][2] = 0.0f;
  M->at[4][2] = 0.0f;
  M->at[5][2] = 0.0f;
  M->at[0][3] = 0.0f;
  M->at[1][3] = M_31;
  M->at[2][3] = s_m1;
  M->at[3][3] = 0.0f;
  M->at[4][3] = M_01;
  M->at[5][3] = s_m4;
  M->at[0][4] = s_m2;
  M->at[1][4] = 0.0f;
  M->at[2][4] = M_42;
  M->at[3][4] = s_m5;
  M->at[4][4] = 0.0f;
  M->at[5][4] = M_12;
  M->at[0][5] = M_50;
  M->at[1][5] = s_m0;
  M->at[2][5] = 0.0f;
  M->at[3][5] = M_20;
  M->at[4][5] = s_m3;
  M->at[5][5] = 0.0f;
}

#ifndef KSL_NO_ALLOC
#include <stdlib.h>

/* n zeroed ksl_coscrew_t on the heap, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrew_t *ksl_coscrew_alloc(int n) {
  return n > 0 ? (ksl_coscrew_t *)calloc((size_t)n, sizeof(ksl_coscrew_t)) : NULL;
}

/* n zeroed ksl_coscrewf_t on the heap, to be freed by the caller; NULL for n <= 0 or when there
     is no memory. */
static inline ksl_coscrewf_t *ksl_coscrewf_alloc(int n) {
  return n > 0 ? (ksl_coscrewf_t *)calloc((size_t)n, sizeof(ksl_coscrewf_t)) : NULL;
}

#endif

#endif

/* Detects a build that breaks the promised bits. */
#ifndef KSL_SELFCHECK_H
#define KSL_SELFCHECK_H


/* NULL if arithmetic on double is rounded operation by operation where this is compiled; else
   what is wrong.  Looks at contraction, reassociation, flush-to-zero and excess precision. */
static inline const char *ksl_selfcheck(void) {
  const volatile double given[] = {1.0000000074505806, 1.0000000149011612, 2.2250738585072014e-308,
      1.7976931348623157e+308, 0.5, 1.0, 1.110223057712381e-16};
  const double x = given[0], nearly_square = given[1], smallest = given[2], largest = given[3];
  const double half = given[4], one = given[5], above_half_ulp = given[6];
  const double square = x * x, low = square - nearly_square;
  const double sum = one + smallest, difference = sum - one;
  const double smaller = smallest * half;
  const double twice = largest + largest, back = twice * half, next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -ffast-math";
  }
  if (smaller == 0) {
    return "flush-to-zero: subnormal results become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  return NULL;
}

/* NULL if arithmetic on float is rounded operation by operation where this is compiled; else
   what is wrong.  Looks at contraction, reassociation, flush-to-zero and excess precision. */
static inline const char *ksl_selfcheckf(void) {
  const volatile float given[] = {1.0002441f, 1.0004883f, 1.1754944e-38f, 3.4028235e+38f, 0.5f,
      1.0f, 5.963375e-08f};
  const float x = given[0], nearly_square = given[1], smallest = given[2], largest = given[3];
  const float half = given[4], one = given[5], above_half_ulp = given[6];
  const float square = x * x, low = square - nearly_square;
  const float sum = one + smallest, difference = sum - one;
  const float smaller = smallest * half;
  const float twice = largest + largest, back = twice * half, next = one + above_half_ulp;
  if (low != 0) {
    return "contraction: a product and a sum are fused; compile with -ffp-contract=off";
  }
  if (difference != 0) {
    return "reassociation: sums are reordered; compile without -ffast-math";
  }
  if (smaller == 0) {
    return "flush-to-zero: subnormal results become zero; link without -ffast-math";
  }
  if (back == largest || next == one) {
    return "excess precision: results are rounded twice, or not to their type (x87)";
  }
  return NULL;
}

#endif
