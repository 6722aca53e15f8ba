/* Made by `coscrew generate`; changes are overwritten. */
/* SPDX-License-Identifier: MIT */
/* coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors. */
/* Spatial inertias of rigid bodies: mass, first moment, second moments about the origin.
   Accurate tier: double compensated, single computed in double. */
#ifndef KSL_SPATIAL_INERTIA_ACCURATE_H
#define KSL_SPATIAL_INERTIA_ACCURATE_H

#include "ksl_exact.h"

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul, 10 add, 10 product error.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_scale_accurate(ksl_spatial_inertia_t *self, const double a) {
  const double self_0_new = KSL_MUL(self->m, a), self_1_new = KSL_MUL(self->h.x, a),
      self_2_new = KSL_MUL(self->h.y, a), self_3_new = KSL_MUL(self->h.z, a),
      self_4_new = KSL_MUL(self->xx, a), self_5_new = KSL_MUL(self->yy, a),
      self_6_new = KSL_MUL(self->zz, a), self_7_new = KSL_MUL(self->xy, a),
      self_8_new = KSL_MUL(self->xz, a), self_9_new = KSL_MUL(self->yz, a);
  const double self_0_new_rounded = self_0_new + ksl_product_error(self->m, a, self_0_new),
      self_1_new_rounded = self_1_new + ksl_product_error(self->h.x, a, self_1_new),
      self_2_new_rounded = self_2_new + ksl_product_error(self->h.y, a, self_2_new),
      self_3_new_rounded = self_3_new + ksl_product_error(self->h.z, a, self_3_new),
      self_4_new_rounded = self_4_new + ksl_product_error(self->xx, a, self_4_new),
      self_5_new_rounded = self_5_new + ksl_product_error(self->yy, a, self_5_new),
      self_6_new_rounded = self_6_new + ksl_product_error(self->zz, a, self_6_new),
      self_7_new_rounded = self_7_new + ksl_product_error(self->xy, a, self_7_new),
      self_8_new_rounded = self_8_new + ksl_product_error(self->xz, a, self_8_new),
      self_9_new_rounded = self_9_new + ksl_product_error(self->yz, a, self_9_new);
  self->m = self_0_new_rounded;
  self->h.x = self_1_new_rounded;
  self->h.y = self_2_new_rounded;
  self->h.z = self_3_new_rounded;
  self->xx = self_4_new_rounded;
  self->yy = self_5_new_rounded;
  self->zz = self_6_new_rounded;
  self->xy = self_7_new_rounded;
  self->xz = self_8_new_rounded;
  self->yz = self_9_new_rounded;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   70 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_add_BB_accurate(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m + B2->m, Bo_0_right = Bo_0 - B1->m;
  const double Bo_1 = B1->h.x + B2->h.x, Bo_1_right = Bo_1 - B1->h.x;
  const double Bo_2 = B1->h.y + B2->h.y, Bo_2_right = Bo_2 - B1->h.y;
  const double Bo_3 = B1->h.z + B2->h.z, Bo_3_right = Bo_3 - B1->h.z;
  const double Bo_4 = B1->xx + B2->xx, Bo_4_right = Bo_4 - B1->xx;
  const double Bo_5 = B1->yy + B2->yy, Bo_5_right = Bo_5 - B1->yy;
  const double Bo_6 = B1->zz + B2->zz, Bo_6_right = Bo_6 - B1->zz;
  const double Bo_7 = B1->xy + B2->xy, Bo_7_right = Bo_7 - B1->xy;
  const double Bo_8 = B1->xz + B2->xz, Bo_8_right = Bo_8 - B1->xz;
  const double Bo_9 = B1->yz + B2->yz, Bo_9_right = Bo_9 - B1->yz;
  const double Bo_0_rounded = Bo_0 + (B1->m - (Bo_0 - Bo_0_right) + (B2->m - Bo_0_right)),
      Bo_1_rounded = Bo_1 + (B1->h.x - (Bo_1 - Bo_1_right) + (B2->h.x - Bo_1_right)),
      Bo_2_rounded = Bo_2 + (B1->h.y - (Bo_2 - Bo_2_right) + (B2->h.y - Bo_2_right)),
      Bo_3_rounded = Bo_3 + (B1->h.z - (Bo_3 - Bo_3_right) + (B2->h.z - Bo_3_right)),
      Bo_4_rounded = Bo_4 + (B1->xx - (Bo_4 - Bo_4_right) + (B2->xx - Bo_4_right)),
      Bo_5_rounded = Bo_5 + (B1->yy - (Bo_5 - Bo_5_right) + (B2->yy - Bo_5_right)),
      Bo_6_rounded = Bo_6 + (B1->zz - (Bo_6 - Bo_6_right) + (B2->zz - Bo_6_right)),
      Bo_7_rounded = Bo_7 + (B1->xy - (Bo_7 - Bo_7_right) + (B2->xy - Bo_7_right)),
      Bo_8_rounded = Bo_8 + (B1->xz - (Bo_8 - Bo_8_right) + (B2->xz - Bo_8_right)),
      Bo_9_rounded = Bo_9 + (B1->yz - (Bo_9 - Bo_9_right) + (B2->yz - Bo_9_right));
  Bo->m = Bo_0_rounded;
  Bo->h.x = Bo_1_rounded;
  Bo->h.y = Bo_2_rounded;
  Bo->h.z = Bo_3_rounded;
  Bo->xx = Bo_4_rounded;
  Bo->yy = Bo_5_rounded;
  Bo->zz = Bo_6_rounded;
  Bo->xy = Bo_7_rounded;
  Bo->xz = Bo_8_rounded;
  Bo->yz = Bo_9_rounded;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   70 add.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_subtract_BB_accurate(const ksl_spatial_inertia_t *B1,
    const ksl_spatial_inertia_t *B2, ksl_spatial_inertia_t *Bo) {
  const double Bo_0 = B1->m - B2->m, Bo_0_right = B1->m - Bo_0;
  const double Bo_1 = B1->h.x - B2->h.x, Bo_1_right = B1->h.x - Bo_1;
  const double Bo_2 = B1->h.y - B2->h.y, Bo_2_right = B1->h.y - Bo_2;
  const double Bo_3 = B1->h.z - B2->h.z, Bo_3_right = B1->h.z - Bo_3;
  const double Bo_4 = B1->xx - B2->xx, Bo_4_right = B1->xx - Bo_4;
  const double Bo_5 = B1->yy - B2->yy, Bo_5_right = B1->yy - Bo_5;
  const double Bo_6 = B1->zz - B2->zz, Bo_6_right = B1->zz - Bo_6;
  const double Bo_7 = B1->xy - B2->xy, Bo_7_right = B1->xy - Bo_7;
  const double Bo_8 = B1->xz - B2->xz, Bo_8_right = B1->xz - Bo_8;
  const double Bo_9 = B1->yz - B2->yz, Bo_9_right = B1->yz - Bo_9;
  const double Bo_0_rounded = Bo_0 + (B1->m - (Bo_0 + Bo_0_right) - (B2->m - Bo_0_right)),
      Bo_1_rounded = Bo_1 + (B1->h.x - (Bo_1 + Bo_1_right) - (B2->h.x - Bo_1_right)),
      Bo_2_rounded = Bo_2 + (B1->h.y - (Bo_2 + Bo_2_right) - (B2->h.y - Bo_2_right)),
      Bo_3_rounded = Bo_3 + (B1->h.z - (Bo_3 + Bo_3_right) - (B2->h.z - Bo_3_right)),
      Bo_4_rounded = Bo_4 + (B1->xx - (Bo_4 + Bo_4_right) - (B2->xx - Bo_4_right)),
      Bo_5_rounded = Bo_5 + (B1->yy - (Bo_5 + Bo_5_right) - (B2->yy - Bo_5_right)),
      Bo_6_rounded = Bo_6 + (B1->zz - (Bo_6 + Bo_6_right) - (B2->zz - Bo_6_right)),
      Bo_7_rounded = Bo_7 + (B1->xy - (Bo_7 + Bo_7_right) - (B2->xy - Bo_7_right)),
      Bo_8_rounded = Bo_8 + (B1->xz - (Bo_8 + Bo_8_right) - (B2->xz - Bo_8_right)),
      Bo_9_rounded = Bo_9 + (B1->yz - (Bo_9 + Bo_9_right) - (B2->yz - Bo_9_right));
  Bo->m = Bo_0_rounded;
  Bo->h.x = Bo_1_rounded;
  Bo->h.y = Bo_2_rounded;
  Bo->h.z = Bo_3_rounded;
  Bo->xx = Bo_4_rounded;
  Bo->yy = Bo_5_rounded;
  Bo->zz = Bo_6_rounded;
  Bo->xy = Bo_7_rounded;
  Bo->xz = Bo_8_rounded;
  Bo->yz = Bo_9_rounded;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   15 mul, 66 add, 3 product error, 9 product rest.
   Error <= u |result| + (m: 0, h: 0, I: 15) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_from_com_accurate(const double m, const ksl_vec3_t *com,
    const ksl_mat3x3_t *Ic, ksl_spatial_inertia_t *Bo) {
  const double h_0 = KSL_MUL(m, com->x), h_1 = KSL_MUL(m, com->y), h_2 = KSL_MUL(m, com->z);
  const double h_0_lo = ksl_product_error(m, com->x, h_0), squares_0 = KSL_MUL(com->x, h_0),
      squares_0_cross2 = KSL_MUL(com->x, h_0_lo);
  const double h_1_lo = ksl_product_error(m, com->y, h_1), squares_1 = KSL_MUL(com->y, h_1),
      squares_1_cross2 = KSL_MUL(com->y, h_1_lo);
  const double h_2_lo = ksl_product_error(m, com->z, h_2), squares_2 = KSL_MUL(com->z, h_2),
      squares_2_cross2 = KSL_MUL(com->z, h_2_lo);
  const double Bo_4a = squares_1 + squares_2, Bo_4a_right = Bo_4a - squares_1,
      Bo_4a_lo1 = ksl_product_rest(com->y, h_1, squares_1, Bo_4a - Bo_4a_right)
          + ksl_product_rest(com->z, h_2, squares_2, Bo_4a_right), Bo_4 = Ic->m00 + Bo_4a,
      Bo_4_right = Bo_4 - Ic->m00;
  const double Bo_5a = squares_0 + squares_2, Bo_5a_right = Bo_5a - squares_0,
      Bo_5a_lo1 = ksl_product_rest(com->x, h_0, squares_0, Bo_5a - Bo_5a_right)
          + ksl_product_rest(com->z, h_2, squares_2, Bo_5a_right), Bo_5 = Ic->m11 + Bo_5a,
      Bo_5_right = Bo_5 - Ic->m11;
  const double Bo_6a = squares_0 + squares_1, Bo_6a_right = Bo_6a - squares_0,
      Bo_6a_lo1 = ksl_product_rest(com->x, h_0, squares_0, Bo_6a - Bo_6a_right)
          + ksl_product_rest(com->y, h_1, squares_1, Bo_6a_right), Bo_6 = Ic->m22 + Bo_6a,
      Bo_6_right = Bo_6 - Ic->m22;
  const double Bo_7a = KSL_MUL(com->y, h_0), Bo_7 = Ic->m01 - Bo_7a, Bo_7_right = Ic->m01 - Bo_7;
  const double Bo_8a = KSL_MUL(com->z, h_0), Bo_8 = Ic->m02 - Bo_8a, Bo_8_right = Ic->m02 - Bo_8;
  const double Bo_9a = KSL_MUL(com->z, h_1), Bo_9 = Ic->m12 - Bo_9a, Bo_9_right = Ic->m12 - Bo_9;
  const double h_0_rounded = h_0 + h_0_lo, h_1_rounded = h_1 + h_1_lo, h_2_rounded = h_2 + h_2_lo;
  const double Bo_4_rounded = Bo_4
          + (Ic->m00 - (Bo_4 - Bo_4_right) + (Bo_4a - Bo_4_right)
          + (Bo_4a_lo1 + (squares_1_cross2 + squares_2_cross2))),
      Bo_5_rounded = Bo_5
          + (Ic->m11 - (Bo_5 - Bo_5_right) + (Bo_5a - Bo_5_right)
          + (Bo_5a_lo1 + (squares_0_cross2 + squares_2_cross2))),
      Bo_6_rounded = Bo_6
          + (Ic->m22 - (Bo_6 - Bo_6_right) + (Bo_6a - Bo_6_right)
          + (Bo_6a_lo1 + (squares_0_cross2 + squares_1_cross2))),
      Bo_7_rounded = Bo_7
          + (Ic->m01 - (Bo_7 + Bo_7_right) - ksl_product_rest(com->y, h_0, Bo_7a, Bo_7_right)
          - KSL_MUL(com->y, h_0_lo)),
      Bo_8_rounded = Bo_8
          + (Ic->m02 - (Bo_8 + Bo_8_right) - ksl_product_rest(com->z, h_0, Bo_8a, Bo_8_right)
          - KSL_MUL(com->z, h_0_lo)),
      Bo_9_rounded = Bo_9
          + (Ic->m12 - (Bo_9 + Bo_9_right) - ksl_product_rest(com->z, h_1, Bo_9a, Bo_9_right)
          - KSL_MUL(com->z, h_1_lo));
  Bo->m = m;
  Bo->h.x = h_0_rounded;
  Bo->h.y = h_1_rounded;
  Bo->h.z = h_2_rounded;
  Bo->xx = Bo_4_rounded;
  Bo->yy = Bo_5_rounded;
  Bo->zz = Bo_6_rounded;
  Bo->xy = Bo_7_rounded;
  Bo->xz = Bo_8_rounded;
  Bo->yz = Bo_9_rounded;
}

/* Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of mass;
     NaN where m = 0.
   J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
     kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
     xz, yz in kg m^2).
   15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_spatial_inertia_from_inertia_accurate(const ksl_inertia_t *J,
    ksl_spatial_inertia_t *Bo) {
  const double c_0 = J->mt.x / J->m, c_0_product = KSL_MUL(c_0, J->m);
  const double c_1 = J->mt.y / J->m, c_1_product = KSL_MUL(c_1, J->m),
      c_1_lo = (J->mt.y - c_1_product - ksl_product_error(c_1, J->m, c_1_product)) / J->m;
  const double c_2 = J->mt.z / J->m, c_2_product = KSL_MUL(c_2, J->m),
      c_2_lo = (J->mt.z - c_2_product - ksl_product_error(c_2, J->m, c_2_product)) / J->m;
  const double squares_0 = KSL_MUL(J->mt.x, c_0),
      squares_0_cross2 = KSL_MUL(J->mt.x, (J->mt.x - c_0_product
          - ksl_product_error(c_0, J->m, c_0_product)) / J->m);
  const double squares_1 = KSL_MUL(J->mt.y, c_1), squares_1_cross2 = KSL_MUL(J->mt.y, c_1_lo);
  const double squares_2 = KSL_MUL(J->mt.z, c_2), squares_2_cross2 = KSL_MUL(J->mt.z, c_2_lo);
  const double Bo_4a = squares_1 + squares_2, Bo_4a_right = Bo_4a - squares_1,
      Bo_4a_lo1 = ksl_product_rest(J->mt.y, c_1, squares_1, Bo_4a - Bo_4a_right)
          + ksl_product_rest(J->mt.z, c_2, squares_2, Bo_4a_right), Bo_4 = J->Ixx + Bo_4a,
      Bo_4_right = Bo_4 - J->Ixx;
  const double Bo_5a = squares_0 + squares_2, Bo_5a_right = Bo_5a - squares_0,
      Bo_5a_lo1 = ksl_product_rest(J->mt.x, c_0, squares_0, Bo_5a - Bo_5a_right)
          + ksl_product_rest(J->mt.z, c_2, squares_2, Bo_5a_right), Bo_5 = J->Iyy + Bo_5a,
      Bo_5_right = Bo_5 - J->Iyy;
  const double Bo_6a = squares_0 + squares_1, Bo_6a_right = Bo_6a - squares_0,
      Bo_6a_lo1 = ksl_product_rest(J->mt.x, c_0, squares_0, Bo_6a - Bo_6a_right)
          + ksl_product_rest(J->mt.y, c_1, squares_1, Bo_6a_right), Bo_6 = J->Izz + Bo_6a,
      Bo_6_right = Bo_6 - J->Izz;
  const double Bo_7a = KSL_MUL(J->mt.x, c_1), Bo_7 = J->Ixy - Bo_7a, Bo_7_right = J->Ixy - Bo_7;
  const double Bo_8a = KSL_MUL(J->mt.x, c_2), Bo_8 = J->Izx - Bo_8a, Bo_8_right = J->Izx - Bo_8;
  const double Bo_9a = KSL_MUL(J->mt.y, c_2), Bo_9 = J->Iyz - Bo_9a, Bo_9_right = J->Iyz - Bo_9;
  const double Bo_4_rounded = Bo_4
          + (J->Ixx - (Bo_4 - Bo_4_right) + (Bo_4a - Bo_4_right)
          + (Bo_4a_lo1 + (squares_1_cross2 + squares_2_cross2)));
  const double Bo_5_rounded = Bo_5
          + (J->Iyy - (Bo_5 - Bo_5_right) + (Bo_5a - Bo_5_right)
          + (Bo_5a_lo1 + (squares_0_cross2 + squares_2_cross2)));
  const double Bo_6_rounded = Bo_6
          + (J->Izz - (Bo_6 - Bo_6_right) + (Bo_6a - Bo_6_right)
          + (Bo_6a_lo1 + (squares_0_cross2 + squares_1_cross2)));
  const double Bo_7_rounded = Bo_7
          + (J->Ixy - (Bo_7 + Bo_7_right) - ksl_product_rest(J->mt.x, c_1, Bo_7a, Bo_7_right)
          - KSL_MUL(J->mt.x, c_1_lo));
  const double Bo_8_rounded = Bo_8
          + (J->Izx - (Bo_8 + Bo_8_right) - ksl_product_rest(J->mt.x, c_2, Bo_8a, Bo_8_right)
          - KSL_MUL(J->mt.x, c_2_lo));
  const double Bo_9_rounded = Bo_9
          + (J->Iyz - (Bo_9 + Bo_9_right) - ksl_product_rest(J->mt.y, c_2, Bo_9a, Bo_9_right)
          - KSL_MUL(J->mt.y, c_2_lo));
  const double Bo_4_final = Bo_4_rounded == Bo_4_rounded ? Bo_4_rounded : Bo_4;
  const double Bo_5_final = Bo_5_rounded == Bo_5_rounded ? Bo_5_rounded : Bo_5;
  const double Bo_6_final = Bo_6_rounded == Bo_6_rounded ? Bo_6_rounded : Bo_6;
  const double Bo_7_final = Bo_7_rounded == Bo_7_rounded ? Bo_7_rounded : Bo_7;
  const double Bo_8_final = Bo_8_rounded == Bo_8_rounded ? Bo_8_rounded : Bo_8;
  const double Bo_9_final = Bo_9_rounded == Bo_9_rounded ? Bo_9_rounded : Bo_9;
  const double J_m = J->m;
  const double J_mt_x = J->mt.x;
  const double J_mt_y = J->mt.y;
  const double J_mt_z = J->mt.z;
  Bo->m = J_m;
  Bo->h.x = J_mt_x;
  Bo->h.y = J_mt_y;
  Bo->h.z = J_mt_z;
  Bo->xx = Bo_4_final;
  Bo->yy = Bo_5_final;
  Bo->zz = Bo_6_final;
  Bo->xy = Bo_7_final;
  Bo->xz = Bo_8_final;
  Bo->yz = Bo_9_final;
}

/* Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of mass;
     NaN where m = 0.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
     yz, zx in kg m^2).
   15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_inertia_from_spatial_inertia_accurate(const ksl_spatial_inertia_t *B,
    ksl_inertia_t *Jo) {
  const double c_0 = B->h.x / B->m, c_0_product = KSL_MUL(c_0, B->m);
  const double c_1 = B->h.y / B->m, c_1_product = KSL_MUL(c_1, B->m),
      c_1_lo = (B->h.y - c_1_product - ksl_product_error(c_1, B->m, c_1_product)) / B->m;
  const double c_2 = B->h.z / B->m, c_2_product = KSL_MUL(c_2, B->m),
      c_2_lo = (B->h.z - c_2_product - ksl_product_error(c_2, B->m, c_2_product)) / B->m;
  const double squares_0 = KSL_MUL(B->h.x, c_0),
      squares_0_cross2 = KSL_MUL(B->h.x, (B->h.x - c_0_product
          - ksl_product_error(c_0, B->m, c_0_product)) / B->m);
  const double squares_1 = KSL_MUL(B->h.y, c_1), squares_1_cross2 = KSL_MUL(B->h.y, c_1_lo);
  const double squares_2 = KSL_MUL(B->h.z, c_2), squares_2_cross2 = KSL_MUL(B->h.z, c_2_lo);
  const double Jo_4a = squares_1 + squares_2, Jo_4a_right = Jo_4a - squares_1,
      Jo_4a_lo1 = ksl_product_rest(B->h.y, c_1, squares_1, Jo_4a - Jo_4a_right)
          + ksl_product_rest(B->h.z, c_2, squares_2, Jo_4a_right), Jo_4 = B->xx - Jo_4a,
      Jo_4_right = B->xx - Jo_4;
  const double Jo_5a = squares_0 + squares_2, Jo_5a_right = Jo_5a - squares_0,
      Jo_5a_lo1 = ksl_product_rest(B->h.x, c_0, squares_0, Jo_5a - Jo_5a_right)
          + ksl_product_rest(B->h.z, c_2, squares_2, Jo_5a_right), Jo_5 = B->yy - Jo_5a,
      Jo_5_right = B->yy - Jo_5;
  const double Jo_6a = squares_0 + squares_1, Jo_6a_right = Jo_6a - squares_0,
      Jo_6a_lo1 = ksl_product_rest(B->h.x, c_0, squares_0, Jo_6a - Jo_6a_right)
          + ksl_product_rest(B->h.y, c_1, squares_1, Jo_6a_right), Jo_6 = B->zz - Jo_6a,
      Jo_6_right = B->zz - Jo_6;
  const double Jo_7a = KSL_MUL(B->h.x, c_1), Jo_7 = Jo_7a + B->xy, Jo_7_right = Jo_7 - Jo_7a;
  const double Jo_8a = KSL_MUL(B->h.y, c_2), Jo_8 = Jo_8a + B->yz, Jo_8_right = Jo_8 - Jo_8a;
  const double Jo_9a = KSL_MUL(B->h.x, c_2), Jo_9 = Jo_9a + B->xz, Jo_9_right = Jo_9 - Jo_9a;
  const double Jo_4_rounded = Jo_4
          + (B->xx - (Jo_4 + Jo_4_right) - (Jo_4a - Jo_4_right)
          - (Jo_4a_lo1 + (squares_1_cross2 + squares_2_cross2)));
  const double Jo_5_rounded = Jo_5
          + (B->yy - (Jo_5 + Jo_5_right) - (Jo_5a - Jo_5_right)
          - (Jo_5a_lo1 + (squares_0_cross2 + squares_2_cross2)));
  const double Jo_6_rounded = Jo_6
          + (B->zz - (Jo_6 + Jo_6_right) - (Jo_6a - Jo_6_right)
          - (Jo_6a_lo1 + (squares_0_cross2 + squares_1_cross2)));
  const double Jo_7_rounded = Jo_7
          + (ksl_product_rest(B->h.x, c_1, Jo_7a, Jo_7 - Jo_7_right) + (B->xy - Jo_7_right)
          + KSL_MUL(B->h.x, c_1_lo));
  const double Jo_8_rounded = Jo_8
          + (ksl_product_rest(B->h.y, c_2, Jo_8a, Jo_8 - Jo_8_right) + (B->yz - Jo_8_right)
          + KSL_MUL(B->h.y, c_2_lo));
  const double Jo_9_rounded = Jo_9
          + (ksl_product_rest(B->h.x, c_2, Jo_9a, Jo_9 - Jo_9_right) + (B->xz - Jo_9_right)
          + KSL_MUL(B->h.x, c_2_lo));
  const double Jo_4_final = Jo_4_rounded == Jo_4_rounded ? Jo_4_rounded : Jo_4;
  const double Jo_5_final = Jo_5_rounded == Jo_5_rounded ? Jo_5_rounded : Jo_5;
  const double Jo_6_final = Jo_6_rounded == Jo_6_rounded ? Jo_6_rounded : Jo_6;
  const double Jo_7_final = Jo_7_rounded == Jo_7_rounded ? Jo_7_rounded : Jo_7;
  const double Jo_8_final = Jo_8_rounded == Jo_8_rounded ? Jo_8_rounded : Jo_8;
  const double Jo_9_final = Jo_9_rounded == Jo_9_rounded ? Jo_9_rounded : Jo_9;
  const double B_m = B->m;
  const double B_h_x = B->h.x;
  const double B_h_y = B->h.y;
  const double B_h_z = B->h.z;
  Jo->m = B_m;
  Jo->mt.x = B_h_x;
  Jo->mt.y = B_h_y;
  Jo->mt.z = B_h_z;
  Jo->Ixx = Jo_4_final;
  Jo->Iyy = Jo_5_final;
  Jo->Izz = Jo_6_final;
  Jo->Ixy = Jo_7_final;
  Jo->Iyz = Jo_8_final;
  Jo->Izx = Jo_9_final;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 mul, 9 add, 3 product error, 6 div, 3 equal, 3 select.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertia_com_accurate(const ksl_spatial_inertia_t *B,
    ksl_vec3_t *vo) {
  const double vo_0 = B->h.x / B->m, vo_0_product = KSL_MUL(vo_0, B->m);
  const double vo_1 = B->h.y / B->m, vo_1_product = KSL_MUL(vo_1, B->m);
  const double vo_2 = B->h.z / B->m, vo_2_product = KSL_MUL(vo_2, B->m);
  const double vo_0_rounded = vo_0
          + (B->h.x - vo_0_product - ksl_product_error(vo_0, B->m, vo_0_product)) / B->m;
  const double vo_1_rounded = vo_1
          + (B->h.y - vo_1_product - ksl_product_error(vo_1, B->m, vo_1_product)) / B->m;
  const double vo_2_rounded = vo_2
          + (B->h.z - vo_2_product - ksl_product_error(vo_2, B->m, vo_2_product)) / B->m;
  const double vo_0_final = vo_0_rounded == vo_0_rounded ? vo_0_rounded : vo_0;
  const double vo_1_final = vo_1_rounded == vo_1_rounded ? vo_1_rounded : vo_1;
  const double vo_2_final = vo_2_rounded == vo_2_rounded ? vo_2_rounded : vo_2;
  vo->x = vo_0_final;
  vo->y = vo_1_final;
  vo->z = vo_2_final;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   15 mul, 69 add, 3 product error, 9 product rest, 6 div, 6 equal, 6 select. */
static inline void ksl_spatial_inertia_about_com_accurate(const ksl_spatial_inertia_t *B,
    ksl_mat3x3_t *Ro) {
  const double c_0 = B->h.x / B->m, c_0_product = KSL_MUL(c_0, B->m);
  const double c_1 = B->h.y / B->m, c_1_product = KSL_MUL(c_1, B->m),
      c_1_lo = (B->h.y - c_1_product - ksl_product_error(c_1, B->m, c_1_product)) / B->m;
  const double c_2 = B->h.z / B->m, c_2_product = KSL_MUL(c_2, B->m),
      c_2_lo = (B->h.z - c_2_product - ksl_product_error(c_2, B->m, c_2_product)) / B->m;
  const double squares_0 = KSL_MUL(B->h.x, c_0),
      squares_0_cross2 = KSL_MUL(B->h.x, (B->h.x - c_0_product
          - ksl_product_error(c_0, B->m, c_0_product)) / B->m);
  const double squares_1 = KSL_MUL(B->h.y, c_1), squares_1_cross2 = KSL_MUL(B->h.y, c_1_lo);
  const double squares_2 = KSL_MUL(B->h.z, c_2), squares_2_cross2 = KSL_MUL(B->h.z, c_2_lo);
  const double about_0a = squares_1 + squares_2, about_0a_right = about_0a - squares_1,
      about_0a_lo1 = ksl_product_rest(B->h.y, c_1, squares_1, about_0a - about_0a_right)
          + ksl_product_rest(B->h.z, c_2, squares_2, about_0a_right), about_0 = B->xx - about_0a,
      about_0_right = B->xx - about_0;
  const double about_1a = squares_0 + squares_2, about_1a_right = about_1a - squares_0,
      about_1a_lo1 = ksl_product_rest(B->h.x, c_0, squares_0, about_1a - about_1a_right)
          + ksl_product_rest(B->h.z, c_2, squares_2, about_1a_right), about_1 = B->yy - about_1a,
      about_1_right = B->yy - about_1;
  const double about_2a = squares_0 + squares_1, about_2a_right = about_2a - squares_0,
      about_2a_lo1 = ksl_product_rest(B->h.x, c_0, squares_0, about_2a - about_2a_right)
          + ksl_product_rest(B->h.y, c_1, squares_1, about_2a_right), about_2 = B->zz - about_2a,
      about_2_right = B->zz - about_2;
  const double about_3a = KSL_MUL(B->h.x, c_1), about_3 = about_3a + B->xy,
      about_3_right = about_3 - about_3a;
  const double about_4a = KSL_MUL(B->h.x, c_2), about_4 = about_4a + B->xz,
      about_4_right = about_4 - about_4a;
  const double about_5a = KSL_MUL(B->h.y, c_2), about_5 = about_5a + B->yz,
      about_5_right = about_5 - about_5a;
  const double about_0_rounded = about_0
          + (B->xx - (about_0 + about_0_right) - (about_0a - about_0_right)
          - (about_0a_lo1 + (squares_1_cross2 + squares_2_cross2)));
  const double about_3_rounded = about_3
          + (ksl_product_rest(B->h.x, c_1, about_3a, about_3 - about_3_right)
          + (B->xy - about_3_right) + KSL_MUL(B->h.x, c_1_lo)),
      about_3_final = about_3_rounded == about_3_rounded ? about_3_rounded : about_3;
  const double about_4_rounded = about_4
          + (ksl_product_rest(B->h.x, c_2, about_4a, about_4 - about_4_right)
          + (B->xz - about_4_right) + KSL_MUL(B->h.x, c_2_lo)),
      about_4_final = about_4_rounded == about_4_rounded ? about_4_rounded : about_4;
  const double about_1_rounded = about_1
          + (B->yy - (about_1 + about_1_right) - (about_1a - about_1_right)
          - (about_1a_lo1 + (squares_0_cross2 + squares_2_cross2)));
  const double about_5_rounded = about_5
          + (ksl_product_rest(B->h.y, c_2, about_5a, about_5 - about_5_right)
          + (B->yz - about_5_right) + KSL_MUL(B->h.y, c_2_lo)),
      about_5_final = about_5_rounded == about_5_rounded ? about_5_rounded : about_5;
  const double about_2_rounded = about_2
          + (B->zz - (about_2 + about_2_right) - (about_2a - about_2_right)
          - (about_2a_lo1 + (squares_0_cross2 + squares_1_cross2)));
  const double about_0_final = about_0_rounded == about_0_rounded ? about_0_rounded : about_0;
  const double about_1_final = about_1_rounded == about_1_rounded ? about_1_rounded : about_1;
  const double about_2_final = about_2_rounded == about_2_rounded ? about_2_rounded : about_2;
  Ro->m00 = about_0_final;
  Ro->m01 = about_3_final;
  Ro->m02 = about_4_final;
  Ro->m10 = about_3_final;
  Ro->m11 = about_1_final;
  Ro->m12 = about_5_final;
  Ro->m20 = about_4_final;
  Ro->m21 = about_5_final;
  Ro->m22 = about_2_final;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 102 add, 24 product rest.
   Error <= u |result| + (lin: 11, ang: 19) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Bs_accurate(const ksl_spatial_inertia_t *B, const ksl_screw_t *s,
    ksl_coscrew_t *co) {
  const double co_0a = KSL_MUL(B->m, s->m0), co_0b = KSL_MUL(B->h.z, s->m4),
      co_0c = KSL_MUL(B->h.y, s->m5), co_0d = co_0b - co_0c, co_0d_right = co_0b - co_0d,
      co_0 = co_0a + co_0d, co_0_right = co_0 - co_0a,
      co_0d_lo = ksl_product_rest(B->h.z, s->m4, co_0b, co_0d + co_0d_right)
          - ksl_product_rest(B->h.y, s->m5, co_0c, co_0d_right);
  const double co_1a = KSL_MUL(B->m, s->m1), co_1b = KSL_MUL(B->h.x, s->m5),
      co_1c = KSL_MUL(B->h.z, s->m3), co_1d = co_1b - co_1c, co_1d_right = co_1b - co_1d,
      co_1 = co_1a + co_1d, co_1_right = co_1 - co_1a,
      co_1d_lo = ksl_product_rest(B->h.x, s->m5, co_1b, co_1d + co_1d_right)
          - ksl_product_rest(B->h.z, s->m3, co_1c, co_1d_right);
  const double co_2a = KSL_MUL(B->m, s->m2), co_2b = KSL_MUL(B->h.y, s->m3),
      co_2c = KSL_MUL(B->h.x, s->m4), co_2d = co_2b - co_2c, co_2d_right = co_2b - co_2d,
      co_2 = co_2a + co_2d, co_2_right = co_2 - co_2a,
      co_2d_lo = ksl_product_rest(B->h.y, s->m3, co_2b, co_2d + co_2d_right)
          - ksl_product_rest(B->h.x, s->m4, co_2c, co_2d_right);
  const double co_3a = KSL_MUL(B->h.y, s->m2), co_3b = KSL_MUL(B->h.z, s->m1),
      co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c, co_3d = KSL_MUL(B->xx, s->m3),
      co_3e = KSL_MUL(B->xy, s->m4), co_3f = co_3d + co_3e, co_3f_right = co_3f - co_3d,
      co_3g = KSL_MUL(B->xz, s->m5), co_3h = co_3f + co_3g, co_3h_right = co_3h - co_3f,
      co_3f_lo = ksl_product_rest(B->xx, s->m3, co_3d, co_3f - co_3f_right)
          + ksl_product_rest(B->xy, s->m4, co_3e, co_3f_right), co_3 = co_3c + co_3h,
      co_3_right = co_3 - co_3c,
      co_3h_lo = co_3f - (co_3h - co_3h_right) + ksl_product_rest(B->xz, s->m5, co_3g, co_3h_right)
          + co_3f_lo,
      co_3c_lo = ksl_product_rest(B->h.y, s->m2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(B->h.z, s->m1, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(B->h.z, s->m0), co_4b = KSL_MUL(B->h.x, s->m2),
      co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c, co_4d = KSL_MUL(B->yy, s->m4),
      co_4e = KSL_MUL(B->xy, s->m3), co_4f = co_4d + co_4e, co_4f_right = co_4f - co_4d,
      co_4g = KSL_MUL(B->yz, s->m5), co_4h = co_4f + co_4g, co_4h_right = co_4h - co_4f,
      co_4f_lo = ksl_product_rest(B->yy, s->m4, co_4d, co_4f - co_4f_right)
          + ksl_product_rest(B->xy, s->m3, co_4e, co_4f_right), co_4 = co_4c + co_4h,
      co_4_right = co_4 - co_4c,
      co_4h_lo = co_4f - (co_4h - co_4h_right) + ksl_product_rest(B->yz, s->m5, co_4g, co_4h_right)
          + co_4f_lo,
      co_4c_lo = ksl_product_rest(B->h.z, s->m0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(B->h.x, s->m2, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(B->h.x, s->m1), co_5b = KSL_MUL(B->h.y, s->m0),
      co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c, co_5d = KSL_MUL(B->zz, s->m5),
      co_5e = KSL_MUL(B->xz, s->m3), co_5f = co_5d + co_5e, co_5f_right = co_5f - co_5d,
      co_5g = KSL_MUL(B->yz, s->m4), co_5h = co_5f + co_5g, co_5h_right = co_5h - co_5f,
      co_5f_lo = ksl_product_rest(B->zz, s->m5, co_5d, co_5f - co_5f_right)
          + ksl_product_rest(B->xz, s->m3, co_5e, co_5f_right), co_5 = co_5c + co_5h,
      co_5_right = co_5 - co_5c,
      co_5h_lo = co_5f - (co_5h - co_5h_right) + ksl_product_rest(B->yz, s->m4, co_5g, co_5h_right)
          + co_5f_lo,
      co_5c_lo = ksl_product_rest(B->h.x, s->m1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(B->h.y, s->m0, co_5b, co_5c_right);
  const double co_0_rounded = co_0
          + (ksl_product_rest(B->m, s->m0, co_0a, co_0 - co_0_right) + (co_0d - co_0_right)
          + co_0d_lo),
      co_1_rounded = co_1
          + (ksl_product_rest(B->m, s->m1, co_1a, co_1 - co_1_right) + (co_1d - co_1_right)
          + co_1d_lo),
      co_2_rounded = co_2
          + (ksl_product_rest(B->m, s->m2, co_2a, co_2 - co_2_right) + (co_2d - co_2_right)
          + co_2d_lo),
      co_3_rounded = co_3
          + (co_3c - (co_3 - co_3_right) + (co_3h - co_3_right) + co_3h_lo + co_3c_lo),
      co_4_rounded = co_4
          + (co_4c - (co_4 - co_4_right) + (co_4h - co_4_right) + co_4h_lo + co_4c_lo),
      co_5_rounded = co_5
          + (co_5c - (co_5 - co_5_right) + (co_5h - co_5_right) + co_5h_lo + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   34 mul, 142 add, 25 product rest.
   Error <= u |result| + 44 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline double ksl_spatial_inertia_energy_accurate(const ksl_spatial_inertia_t *B,
    const ksl_screw_t *s) {
  const double square_a = KSL_MUL(s->m0, s->m0), square_b = KSL_MUL(s->m1, s->m1),
      square_c = square_a + square_b, square_c_right = square_c - square_a,
      square_d = KSL_MUL(s->m2, s->m2), square = square_c + square_d,
      square_right = square - square_c,
      square_c_lo = ksl_product_rest(s->m0, s->m0, square_a, square_c - square_c_right)
          + ksl_product_rest(s->m1, s->m1, square_b, square_c_right),
      square_lo = square_c - (square - square_right)
          + ksl_product_rest(s->m2, s->m2, square_d, square_right) + square_c_lo;
  const double L_0a = KSL_MUL(B->xx, s->m3), L_0b = KSL_MUL(B->xy, s->m4), L_0c = L_0a + L_0b,
      L_0c_right = L_0c - L_0a, L_0d = KSL_MUL(B->xz, s->m5), L_0 = L_0c + L_0d,
      L_0_right = L_0 - L_0c,
      L_0c_lo = ksl_product_rest(B->xx, s->m3, L_0a, L_0c - L_0c_right)
          + ksl_product_rest(B->xy, s->m4, L_0b, L_0c_right),
      L_0_lo = L_0c - (L_0 - L_0_right) + ksl_product_rest(B->xz, s->m5, L_0d, L_0_right) + L_0c_lo;
  const double L_1a = KSL_MUL(B->yy, s->m4), L_1b = KSL_MUL(B->xy, s->m3), L_1c = L_1a + L_1b,
      L_1c_right = L_1c - L_1a, L_1d = KSL_MUL(B->yz, s->m5), L_1 = L_1c + L_1d,
      L_1_right = L_1 - L_1c,
      L_1c_lo = ksl_product_rest(B->yy, s->m4, L_1a, L_1c - L_1c_right)
          + ksl_product_rest(B->xy, s->m3, L_1b, L_1c_right),
      L_1_lo = L_1c - (L_1 - L_1_right) + ksl_product_rest(B->yz, s->m5, L_1d, L_1_right) + L_1c_lo;
  const double L_2a = KSL_MUL(B->zz, s->m5), L_2b = KSL_MUL(B->xz, s->m3), L_2c = L_2a + L_2b,
      L_2c_right = L_2c - L_2a, L_2d = KSL_MUL(B->yz, s->m4), L_2 = L_2c + L_2d,
      L_2_right = L_2 - L_2c,
      L_2c_lo = ksl_product_rest(B->zz, s->m5, L_2a, L_2c - L_2c_right)
          + ksl_product_rest(B->xz, s->m3, L_2b, L_2c_right),
      L_2_lo = L_2c - (L_2 - L_2_right) + ksl_product_rest(B->yz, s->m4, L_2d, L_2_right) + L_2c_lo;
  const double square_sum = square + square_lo, square_sum_right = square_sum - square,
      twice_a = KSL_MUL(B->m, square_sum), L_0_sum = L_0 + L_0_lo, L_0_sum_right = L_0_sum - L_0,
      twice_b = KSL_MUL(s->m3, L_0_sum), L_1_sum = L_1 + L_1_lo, L_1_sum_right = L_1_sum - L_1,
      twice_c = KSL_MUL(s->m4, L_1_sum), twice_d = twice_b + twice_c,
      twice_d_right = twice_d - twice_b,
      twice_b_cross2 = KSL_MUL(s->m3, L_0 - (L_0_sum - L_0_sum_right) + (L_0_lo - L_0_sum_right)),
      twice_d_lo1 = ksl_product_rest(s->m3, L_0_sum, twice_b, twice_d - twice_d_right)
          + ksl_product_rest(s->m4, L_1_sum, twice_c, twice_d_right), L_2_sum = L_2 + L_2_lo,
      L_2_sum_right = L_2_sum - L_2, twice_e = KSL_MUL(s->m5, L_2_sum), twice_f = twice_d + twice_e,
      twice_f_right = twice_f - twice_d,
      twice_f_lo1 = twice_d - (twice_f - twice_f_right)
          + ksl_product_rest(s->m5, L_2_sum, twice_e, twice_f_right),
      twice_d_lo = twice_d_lo1
          + (twice_b_cross2
          + KSL_MUL(s->m4, L_1 - (L_1_sum - L_1_sum_right) + (L_1_lo - L_1_sum_right))),
      twice = twice_a + twice_f, twice_right = twice - twice_a,
      twice_f_lo = twice_f_lo1
          + KSL_MUL(s->m5, L_2 - (L_2_sum - L_2_sum_right) + (L_2_lo - L_2_sum_right)) + twice_d_lo,
      twice_lo2 = ksl_product_rest(B->m, square_sum, twice_a, twice - twice_right)
          + (twice_f - twice_right) + twice_f_lo,
      twice_lo = twice_lo2
          + KSL_MUL(B->m, square - (square_sum - square_sum_right)
          + (square_lo - square_sum_right));
  const double across_0a = KSL_MUL(B->h.z, s->m4), across_0b = KSL_MUL(B->h.y, s->m5),
      across_0 = across_0a - across_0b, across_0_right = across_0a - across_0,
      across_0_lo = ksl_product_rest(B->h.z, s->m4, across_0a, across_0 + across_0_right)
          - ksl_product_rest(B->h.y, s->m5, across_0b, across_0_right);
  const double across_1a = KSL_MUL(B->h.x, s->m5), across_1b = KSL_MUL(B->h.z, s->m3),
      across_1 = across_1a - across_1b, across_1_right = across_1a - across_1,
      across_1_lo = ksl_product_rest(B->h.x, s->m5, across_1a, across_1 + across_1_right)
          - ksl_product_rest(B->h.z, s->m3, across_1b, across_1_right);
  const double across_2a = KSL_MUL(B->h.y, s->m3), across_2b = KSL_MUL(B->h.x, s->m4),
      across_2 = across_2a - across_2b, across_2_right = across_2a - across_2,
      across_2_lo = ksl_product_rest(B->h.y, s->m3, across_2a, across_2 + across_2_right)
          - ksl_product_rest(B->h.x, s->m4, across_2b, across_2_right);
  const double across_0_sum = across_0 + across_0_lo, across_0_sum_right = across_0_sum - across_0,
      energy_a = KSL_MUL(s->m0, across_0_sum), across_1_sum = across_1 + across_1_lo,
      across_1_sum_right = across_1_sum - across_1, energy_b = KSL_MUL(s->m1, across_1_sum),
      energy_c = energy_a + energy_b, energy_c_right = energy_c - energy_a,
      energy_a_cross2 = KSL_MUL(s->m0, across_0 - (across_0_sum - across_0_sum_right)
          + (across_0_lo - across_0_sum_right)),
      energy_c_left_rest = ksl_product_rest(s->m0, across_0_sum, energy_a, energy_c
          - energy_c_right),
      energy_c_cross = energy_a_cross2
          + KSL_MUL(s->m1, across_1 - (across_1_sum - across_1_sum_right)
          + (across_1_lo - across_1_sum_right)), across_2_sum = across_2 + across_2_lo,
      across_2_sum_right = across_2_sum - across_2, energy_d = KSL_MUL(s->m2, across_2_sum),
      energy_e = energy_c + energy_d, energy_e_right = energy_e - energy_c,
      energy_e_lo1 = energy_c - (energy_e - energy_e_right)
          + ksl_product_rest(s->m2, across_2_sum, energy_d, energy_e_right),
      energy_e_lo2 = energy_e_lo1
          + KSL_MUL(s->m2, across_2 - (across_2_sum - across_2_sum_right)
          + (across_2_lo - across_2_sum_right)), twice_sum = twice + twice_lo,
      twice_sum_right = twice_sum - twice, energy_f = KSL_MUL(0.5, twice_sum),
      energy = energy_e + energy_f, energy_right = energy - energy_e,
      energy_f_cross2 = KSL_MUL(0.5, twice - (twice_sum - twice_sum_right)
          + (twice_lo - twice_sum_right)),
      energy_e_lo = energy_e_lo2
          + (energy_c_left_rest + ksl_product_rest(s->m1, across_1_sum, energy_b, energy_c_right)
          + energy_c_cross);
  const double energy_rounded = energy
          + (energy_e - (energy - energy_right) + (energy_f - energy_right) + energy_f_cross2
          + energy_e_lo);
  return energy_rounded;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   63 mul, 324 add, 3 product error, 51 product rest, 6 neg.
   Error <= u |result| + (lin: 36, ang: 42) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_net_wrench_accurate(const ksl_spatial_inertia_t *B,
    const ksl_vec3_t *w, const ksl_screw_t *ds, ksl_coscrew_t *co) {
  const double ww_0 = KSL_MUL(w->x, w->x), ww_1 = KSL_MUL(w->y, w->y), ww_2 = KSL_MUL(w->z, w->z),
      ww_3 = KSL_MUL(w->x, w->y), ww_4 = KSL_MUL(w->x, w->z), ww_5 = KSL_MUL(w->y, w->z);
  const double U_0a = ww_1 + ww_2, U_0a_right = U_0a - ww_1, U_0 = -U_0a;
  const double U_1 = ww_3 - ds->m5, U_1_right = ww_3 - U_1,
      U_1_lo = ksl_product_rest(w->x, w->y, ww_3, U_1 + U_1_right) - (ds->m5 - U_1_right);
  const double U_2 = ds->m4 + ww_4, U_2_right = U_2 - ds->m4,
      U_2_lo = ds->m4 - (U_2 - U_2_right) + ksl_product_rest(w->x, w->z, ww_4, U_2_right);
  const double U_3 = ds->m5 + ww_3, U_3_right = U_3 - ds->m5,
      U_3_lo = ds->m5 - (U_3 - U_3_right) + ksl_product_rest(w->x, w->y, ww_3, U_3_right);
  const double U_4a = ww_0 + ww_2, U_4a_right = U_4a - ww_0, U_4 = -U_4a;
  const double U_5 = ww_5 - ds->m3, U_5_right = ww_5 - U_5,
      U_5_lo = ksl_product_rest(w->y, w->z, ww_5, U_5 + U_5_right) - (ds->m3 - U_5_right);
  const double U_6 = ww_4 - ds->m4, U_6_right = ww_4 - U_6,
      U_6_lo = ksl_product_rest(w->x, w->z, ww_4, U_6 + U_6_right) - (ds->m4 - U_6_right);
  const double U_7 = ds->m3 + ww_5, U_7_right = U_7 - ds->m3,
      U_7_lo = ds->m3 - (U_7 - U_7_right) + ksl_product_rest(w->y, w->z, ww_5, U_7_right);
  const double U_8a = ww_0 + ww_1, U_8a_right = U_8a - ww_0, U_8 = -U_8a;
  const double others_0 = B->zz - B->yy, others_0_right = B->zz - others_0,
      others_0_lo = B->zz - (others_0 + others_0_right) - (B->yy - others_0_right);
  const double others_1 = B->xx - B->zz, others_1_right = B->xx - others_1,
      others_1_lo = B->xx - (others_1 + others_1_right) - (B->zz - others_1_right);
  const double others_2 = B->yy - B->xx, others_2_right = B->yy - others_2,
      others_2_lo = B->yy - (others_2 + others_2_right) - (B->xx - others_2_right);
  const double squares_0 = ww_1 - ww_2, squares_0_right = ww_1 - squares_0,
      squares_0_lo = ksl_product_rest(w->y, w->y, ww_1, squares_0 + squares_0_right)
          - ksl_product_rest(w->z, w->z, ww_2, squares_0_right);
  const double squares_1 = ww_2 - ww_0, squares_1_right = ww_2 - squares_1,
      squares_1_lo = ksl_product_rest(w->z, w->z, ww_2, squares_1 + squares_1_right)
          - ksl_product_rest(w->x, w->x, ww_0, squares_1_right);
  const double squares_2 = ww_0 - ww_1, squares_2_right = ww_0 - squares_2,
      squares_2_lo = ksl_product_rest(w->x, w->x, ww_0, squares_2 + squares_2_right)
          - ksl_product_rest(w->y, w->y, ww_1, squares_2_right);
  const double own_0a = KSL_MUL(B->xx, ds->m3), others_0_sum = others_0 + others_0_lo,
      others_0_sum_right = others_0_sum - others_0, own_0b = KSL_MUL(ww_5, others_0_sum),
      own_0b_cross2 = KSL_MUL(ww_5, others_0 - (others_0_sum - others_0_sum_right)
          + (others_0_lo - others_0_sum_right)), own_0 = own_0a + own_0b,
      own_0_right = own_0 - own_0a,
      own_0_lo1 = ksl_product_rest(B->xx, ds->m3, own_0a, own_0 - own_0_right)
          + ksl_product_rest(ww_5, others_0_sum, own_0b, own_0_right);
  const double own_1a = KSL_MUL(B->yy, ds->m4), others_1_sum = others_1 + others_1_lo,
      others_1_sum_right = others_1_sum - others_1, own_1b = KSL_MUL(ww_4, others_1_sum),
      own_1b_cross2 = KSL_MUL(ww_4, others_1 - (others_1_sum - others_1_sum_right)
          + (others_1_lo - others_1_sum_right)), own_1 = own_1a + own_1b,
      own_1_right = own_1 - own_1a,
      own_1_lo1 = ksl_product_rest(B->yy, ds->m4, own_1a, own_1 - own_1_right)
          + ksl_product_rest(ww_4, others_1_sum, own_1b, own_1_right);
  const double own_2a = KSL_MUL(B->zz, ds->m5), others_2_sum = others_2 + others_2_lo,
      others_2_sum_right = others_2_sum - others_2, own_2b = KSL_MUL(ww_3, others_2_sum),
      own_2b_cross2 = KSL_MUL(ww_3, others_2 - (others_2_sum - others_2_sum_right)
          + (others_2_lo - others_2_sum_right)), own_2 = own_2a + own_2b,
      own_2_right = own_2 - own_2a,
      own_2_lo1 = ksl_product_rest(B->zz, ds->m5, own_2a, own_2 - own_2_right)
          + ksl_product_rest(ww_3, others_2_sum, own_2b, own_2_right);
  const double U_3_sum = U_3 + U_3_lo, U_3_sum_right = U_3_sum - U_3,
      U_3_sum_lo = U_3 - (U_3_sum - U_3_sum_right) + (U_3_lo - U_3_sum_right),
      N_0a = KSL_MUL(B->xz, U_3_sum), U_6_sum = U_6 + U_6_lo, U_6_sum_right = U_6_sum - U_6,
      U_6_sum_lo = U_6 - (U_6_sum - U_6_sum_right) + (U_6_lo - U_6_sum_right),
      N_0b = KSL_MUL(B->xy, U_6_sum), N_0c = N_0a - N_0b, N_0c_right = N_0a - N_0c,
      N_0c_lo1 = ksl_product_rest(B->xz, U_3_sum, N_0a, N_0c + N_0c_right)
          - ksl_product_rest(B->xy, U_6_sum, N_0b, N_0c_right),
      squares_0_sum = squares_0 + squares_0_lo, squares_0_sum_right = squares_0_sum - squares_0,
      N_0d = KSL_MUL(B->yz, squares_0_sum), N_0e = N_0c + N_0d, N_0e_right = N_0e - N_0c,
      N_0d_cross2 = KSL_MUL(B->yz, squares_0 - (squares_0_sum - squares_0_sum_right)
          + (squares_0_lo - squares_0_sum_right)),
      N_0e_lo2 = N_0c - (N_0e - N_0e_right)
          + ksl_product_rest(B->yz, squares_0_sum, N_0d, N_0e_right) + N_0d_cross2,
      N_0 = N_0e + own_0, N_0_right = N_0 - N_0e,
      N_0_lo2 = N_0e - (N_0 - N_0_right) + (own_0 - N_0_right)
          + (own_0_lo1
          + (KSL_MUL(ksl_product_error(w->y, w->z, ww_5), others_0_sum) + own_0b_cross2));
  const double U_7_sum = U_7 + U_7_lo, U_7_sum_right = U_7_sum - U_7,
      U_7_sum_lo = U_7 - (U_7_sum - U_7_sum_right) + (U_7_lo - U_7_sum_right),
      N_1a = KSL_MUL(B->xy, U_7_sum), U_1_sum = U_1 + U_1_lo, U_1_sum_right = U_1_sum - U_1,
      U_1_sum_lo = U_1 - (U_1_sum - U_1_sum_right) + (U_1_lo - U_1_sum_right),
      N_1b = KSL_MUL(B->yz, U_1_sum), N_1c = N_1a - N_1b, N_1c_right = N_1a - N_1c,
      N_1c_lo1 = ksl_product_rest(B->xy, U_7_sum, N_1a, N_1c + N_1c_right)
          - ksl_product_rest(B->yz, U_1_sum, N_1b, N_1c_right),
      squares_1_sum = squares_1 + squares_1_lo, squares_1_sum_right = squares_1_sum - squares_1,
      N_1d = KSL_MUL(B->xz, squares_1_sum), N_1e = N_1c + N_1d, N_1e_right = N_1e - N_1c,
      N_1d_cross2 = KSL_MUL(B->xz, squares_1 - (squares_1_sum - squares_1_sum_right)
          + (squares_1_lo - squares_1_sum_right)),
      N_1e_lo2 = N_1c - (N_1e - N_1e_right)
          + ksl_product_rest(B->xz, squares_1_sum, N_1d, N_1e_right) + N_1d_cross2,
      N_1 = N_1e + own_1, N_1_right = N_1 - N_1e,
      N_1_lo2 = N_1e - (N_1 - N_1_right) + (own_1 - N_1_right)
          + (own_1_lo1
          + (KSL_MUL(ksl_product_error(w->x, w->z, ww_4), others_1_sum) + own_1b_cross2));
  const double squares_2_sum = squares_2 + squares_2_lo,
      squares_2_sum_right = squares_2_sum - squares_2, N_2a = KSL_MUL(B->xy, squares_2_sum),
      U_2_sum = U_2 + U_2_lo, U_2_sum_right = U_2_sum - U_2,
      U_2_sum_lo = U_2 - (U_2_sum - U_2_sum_right) + (U_2_lo - U_2_sum_right),
      N_2b = KSL_MUL(B->yz, U_2_sum), U_5_sum = U_5 + U_5_lo, U_5_sum_right = U_5_sum - U_5,
      U_5_sum_lo = U_5 - (U_5_sum - U_5_sum_right) + (U_5_lo - U_5_sum_right),
      N_2c = KSL_MUL(B->xz, U_5_sum), N_2d = N_2b - N_2c, N_2d_right = N_2b - N_2d,
      N_2d_lo1 = ksl_product_rest(B->yz, U_2_sum, N_2b, N_2d + N_2d_right)
          - ksl_product_rest(B->xz, U_5_sum, N_2c, N_2d_right), N_2e = N_2a + N_2d,
      N_2e_right = N_2e - N_2a,
      N_2e_lo1 = ksl_product_rest(B->xy, squares_2_sum, N_2a, N_2e - N_2e_right)
          + (N_2d - N_2e_right),
      N_2a_cross2 = KSL_MUL(B->xy, squares_2 - (squares_2_sum - squares_2_sum_right)
          + (squares_2_lo - squares_2_sum_right)), N_2 = N_2e + own_2, N_2_right = N_2 - N_2e,
      N_2_lo2 = N_2e - (N_2 - N_2_right) + (own_2 - N_2_right)
          + (own_2_lo1
          + (KSL_MUL(ksl_product_error(w->x, w->y, ww_3), others_2_sum) + own_2b_cross2));
  const double co_0a = KSL_MUL(B->m, ds->m0), co_0b = KSL_MUL(B->h.x, U_0),
      co_0c = KSL_MUL(B->h.y, U_1_sum), co_0d = co_0b + co_0c, co_0d_right = co_0d - co_0b,
      co_0b_cross2 = KSL_MUL(B->h.x,
          -(ksl_product_rest(w->y, w->y, ww_1, U_0a - U_0a_right)
          + ksl_product_rest(w->z, w->z, ww_2, U_0a_right))),
      co_0d_lo1 = ksl_product_rest(B->h.x, U_0, co_0b, co_0d - co_0d_right)
          + ksl_product_rest(B->h.y, U_1_sum, co_0c, co_0d_right), co_0e = KSL_MUL(B->h.z, U_2_sum),
      co_0f = co_0d + co_0e, co_0f_right = co_0f - co_0d,
      co_0f_lo2 = co_0d - (co_0f - co_0f_right)
          + ksl_product_rest(B->h.z, U_2_sum, co_0e, co_0f_right) + KSL_MUL(B->h.z, U_2_sum_lo),
      co_0 = co_0a + co_0f, co_0_right = co_0 - co_0a,
      co_0_lo1 = ksl_product_rest(B->m, ds->m0, co_0a, co_0 - co_0_right) + (co_0f - co_0_right);
  const double co_1a = KSL_MUL(B->m, ds->m1), co_1b = KSL_MUL(B->h.x, U_3_sum),
      co_1c = KSL_MUL(B->h.y, U_4), co_1d = co_1b + co_1c, co_1d_right = co_1d - co_1b,
      co_1c_cross2 = KSL_MUL(B->h.y,
          -(ksl_product_rest(w->x, w->x, ww_0, U_4a - U_4a_right)
          + ksl_product_rest(w->z, w->z, ww_2, U_4a_right))),
      co_1d_lo1 = ksl_product_rest(B->h.x, U_3_sum, co_1b, co_1d - co_1d_right)
          + ksl_product_rest(B->h.y, U_4, co_1c, co_1d_right), co_1e = KSL_MUL(B->h.z, U_5_sum),
      co_1f = co_1d + co_1e, co_1f_right = co_1f - co_1d,
      co_1f_lo2 = co_1d - (co_1f - co_1f_right)
          + ksl_product_rest(B->h.z, U_5_sum, co_1e, co_1f_right) + KSL_MUL(B->h.z, U_5_sum_lo),
      co_1 = co_1a + co_1f, co_1_right = co_1 - co_1a,
      co_1_lo1 = ksl_product_rest(B->m, ds->m1, co_1a, co_1 - co_1_right) + (co_1f - co_1_right);
  const double co_2a = KSL_MUL(B->m, ds->m2), co_2b = KSL_MUL(B->h.x, U_6_sum),
      co_2c = KSL_MUL(B->h.y, U_7_sum), co_2d = co_2b + co_2c, co_2d_right = co_2d - co_2b,
      co_2d_lo1 = ksl_product_rest(B->h.x, U_6_sum, co_2b, co_2d - co_2d_right)
          + ksl_product_rest(B->h.y, U_7_sum, co_2c, co_2d_right), co_2e = KSL_MUL(B->h.z, U_8),
      co_2f = co_2d + co_2e, co_2f_right = co_2f - co_2d,
      co_2e_cross2 = KSL_MUL(B->h.z,
          -(ksl_product_rest(w->x, w->x, ww_0, U_8a - U_8a_right)
          + ksl_product_rest(w->y, w->y, ww_1, U_8a_right))),
      co_2f_lo2 = co_2d - (co_2f - co_2f_right) + ksl_product_rest(B->h.z, U_8, co_2e, co_2f_right)
          + co_2e_cross2, co_2 = co_2a + co_2f, co_2_right = co_2 - co_2a,
      co_2f_lo = co_2f_lo2
          + (co_2d_lo1 + (KSL_MUL(B->h.x, U_6_sum_lo) + KSL_MUL(B->h.y, U_7_sum_lo)));
  const double co_3a = KSL_MUL(B->h.y, ds->m2), co_3b = KSL_MUL(B->h.z, ds->m1),
      co_3c = co_3a - co_3b, co_3c_right = co_3a - co_3c, co_3 = co_3c + N_0,
      co_3_right = co_3 - co_3c;
  const double N_0_lo = N_0_lo2
          + (N_0e_lo2 + (N_0c_lo1 + (KSL_MUL(B->xz, U_3_sum_lo) - KSL_MUL(B->xy, U_6_sum_lo))));
  const double co_3c_lo = ksl_product_rest(B->h.y, ds->m2, co_3a, co_3c + co_3c_right)
          - ksl_product_rest(B->h.z, ds->m1, co_3b, co_3c_right);
  const double co_4a = KSL_MUL(B->h.z, ds->m0), co_4b = KSL_MUL(B->h.x, ds->m2),
      co_4c = co_4a - co_4b, co_4c_right = co_4a - co_4c, co_4 = co_4c + N_1,
      co_4_right = co_4 - co_4c;
  const double N_1_lo = N_1_lo2
          + (N_1e_lo2 + (N_1c_lo1 + (KSL_MUL(B->xy, U_7_sum_lo) - KSL_MUL(B->yz, U_1_sum_lo))));
  const double co_4c_lo = ksl_product_rest(B->h.z, ds->m0, co_4a, co_4c + co_4c_right)
          - ksl_product_rest(B->h.x, ds->m2, co_4b, co_4c_right);
  const double co_5a = KSL_MUL(B->h.x, ds->m1), co_5b = KSL_MUL(B->h.y, ds->m0),
      co_5c = co_5a - co_5b, co_5c_right = co_5a - co_5c, co_5 = co_5c + N_2,
      co_5_right = co_5 - co_5c;
  const double N_2_lo = N_2_lo2
          + (N_2e_lo1 + (N_2d_lo1 + (KSL_MUL(B->yz, U_2_sum_lo) - KSL_MUL(B->xz, U_5_sum_lo)))
          + N_2a_cross2);
  const double co_5c_lo = ksl_product_rest(B->h.x, ds->m1, co_5a, co_5c + co_5c_right)
          - ksl_product_rest(B->h.y, ds->m0, co_5b, co_5c_right);
  const double co_0_rounded = co_0
          + (co_0_lo1 + (co_0f_lo2 + (co_0d_lo1 + (co_0b_cross2 + KSL_MUL(B->h.y, U_1_sum_lo))))),
      co_1_rounded = co_1
          + (co_1_lo1 + (co_1f_lo2 + (co_1d_lo1 + (KSL_MUL(B->h.x, U_3_sum_lo) + co_1c_cross2)))),
      co_2_rounded = co_2
          + (ksl_product_rest(B->m, ds->m2, co_2a, co_2 - co_2_right) + (co_2f - co_2_right)
          + co_2f_lo),
      co_3_rounded = co_3 + (co_3c - (co_3 - co_3_right) + (N_0 - co_3_right) + N_0_lo + co_3c_lo),
      co_4_rounded = co_4 + (co_4c - (co_4 - co_4_right) + (N_1 - co_4_right) + N_1_lo + co_4c_lo),
      co_5_rounded = co_5 + (co_5c - (co_5 - co_5_right) + (N_2 - co_5_right) + N_2_lo + co_5c_lo);
  co->m0 = co_0_rounded;
  co->m1 = co_1_rounded;
  co->m2 = co_2_rounded;
  co->m3 = co_3_rounded;
  co->m4 = co_4_rounded;
  co->m5 = co_5_rounded;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   33 mul, 138 add, 6 product error, 6 product rest.
   Error <= u |result| + (m: 0, h: 2, I: 20) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_shifted_accurate(const ksl_vec3_t *t,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double mt_0 = KSL_MUL(t->x, B->m), mt_1 = KSL_MUL(t->y, B->m), mt_2 = KSL_MUL(t->z, B->m);
  const double mt_0_lo = ksl_product_error(t->x, B->m, mt_0), half_0 = KSL_MUL(0.5, mt_0);
  const double mt_1_lo = ksl_product_error(t->y, B->m, mt_1), half_1 = KSL_MUL(0.5, mt_1);
  const double mt_2_lo = ksl_product_error(t->z, B->m, mt_2), half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = B->h.x + half_0, n_0_right = n_0 - B->h.x,
      n_0_lo = B->h.x - (n_0 - n_0_right) + (half_0 - n_0_right) + KSL_MUL(0.5, mt_0_lo);
  const double n_1 = B->h.y + half_1, n_1_right = n_1 - B->h.y,
      n_1_lo = B->h.y - (n_1 - n_1_right) + (half_1 - n_1_right) + KSL_MUL(0.5, mt_1_lo);
  const double n_2 = B->h.z + half_2, n_2_right = n_2 - B->h.z,
      n_2_lo = B->h.z - (n_2 - n_2_right) + (half_2 - n_2_right) + KSL_MUL(0.5, mt_2_lo);
  const double tn0 = KSL_MUL(t->x, n_0);
  const double tn1 = KSL_MUL(t->y, n_1);
  const double tn2 = KSL_MUL(t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0),
      own_0_cross2 = KSL_MUL(2.0, ksl_product_error(t->x, n_0, tn0) + KSL_MUL(t->x, n_0_lo));
  const double own_1 = KSL_MUL(2.0, tn1),
      own_1_cross2 = KSL_MUL(2.0, ksl_product_error(t->y, n_1, tn1) + KSL_MUL(t->y, n_1_lo));
  const double own_2 = KSL_MUL(2.0, tn2),
      own_2_cross2 = KSL_MUL(2.0, ksl_product_error(t->z, n_2, tn2) + KSL_MUL(t->z, n_2_lo));
  const double pairs_0 = own_1 + own_2, pairs_0_right = pairs_0 - own_1;
  const double pairs_1 = own_0 + own_2, pairs_1_right = pairs_1 - own_0;
  const double pairs_2 = own_0 + own_1, pairs_2_right = pairs_2 - own_0;
  const double pairs_3a = KSL_MUL(t->x, n_1), pairs_3b = KSL_MUL(t->y, n_0),
      pairs_3 = pairs_3a + pairs_3b, pairs_3_right = pairs_3 - pairs_3a,
      pairs_3_lo1 = ksl_product_rest(t->x, n_1, pairs_3a, pairs_3 - pairs_3_right)
          + ksl_product_rest(t->y, n_0, pairs_3b, pairs_3_right);
  const double pairs_4a = KSL_MUL(t->x, n_2), pairs_4b = KSL_MUL(t->z, n_0),
      pairs_4 = pairs_4a + pairs_4b, pairs_4_right = pairs_4 - pairs_4a,
      pairs_4_lo1 = ksl_product_rest(t->x, n_2, pairs_4a, pairs_4 - pairs_4_right)
          + ksl_product_rest(t->z, n_0, pairs_4b, pairs_4_right);
  const double pairs_5a = KSL_MUL(t->y, n_2), pairs_5b = KSL_MUL(t->z, n_1),
      pairs_5 = pairs_5a + pairs_5b, pairs_5_right = pairs_5 - pairs_5a,
      pairs_5_lo1 = ksl_product_rest(t->y, n_2, pairs_5a, pairs_5 - pairs_5_right)
          + ksl_product_rest(t->z, n_1, pairs_5b, pairs_5_right);
  const double moved_0 = B->h.x + mt_0, moved_0_right = moved_0 - B->h.x;
  const double moved_1 = B->h.y + mt_1, moved_1_right = moved_1 - B->h.y;
  const double moved_2 = B->h.z + mt_2, moved_2_right = moved_2 - B->h.z;
  const double Bo_4 = B->xx + pairs_0, Bo_4_right = Bo_4 - B->xx;
  const double pairs_0_lo = own_1 - (pairs_0 - pairs_0_right) + (own_2 - pairs_0_right)
          + own_2_cross2 + own_1_cross2;
  const double Bo_5 = B->yy + pairs_1, Bo_5_right = Bo_5 - B->yy;
  const double pairs_1_lo = own_0 - (pairs_1 - pairs_1_right) + (own_2 - pairs_1_right)
          + own_2_cross2 + own_0_cross2;
  const double Bo_6 = B->zz + pairs_2, Bo_6_right = Bo_6 - B->zz;
  const double pairs_2_lo = own_0 - (pairs_2 - pairs_2_right) + (own_1 - pairs_2_right)
          + own_1_cross2 + own_0_cross2;
  const double Bo_7 = B->xy - pairs_3, Bo_7_right = B->xy - Bo_7;
  const double Bo_8 = B->xz - pairs_4, Bo_8_right = B->xz - Bo_8;
  const double Bo_9 = B->yz - pairs_5, Bo_9_right = B->yz - Bo_9;
  const double moved_0_rounded = moved_0
          + (B->h.x - (moved_0 - moved_0_right) + (mt_0 - moved_0_right) + mt_0_lo),
      moved_1_rounded = moved_1
          + (B->h.y - (moved_1 - moved_1_right) + (mt_1 - moved_1_right) + mt_1_lo),
      moved_2_rounded = moved_2
          + (B->h.z - (moved_2 - moved_2_right) + (mt_2 - moved_2_right) + mt_2_lo);
  const double Bo_4_rounded = Bo_4
          + (B->xx - (Bo_4 - Bo_4_right) + (pairs_0 - Bo_4_right) + pairs_0_lo),
      Bo_5_rounded = Bo_5 + (B->yy - (Bo_5 - Bo_5_right) + (pairs_1 - Bo_5_right) + pairs_1_lo),
      Bo_6_rounded = Bo_6 + (B->zz - (Bo_6 - Bo_6_right) + (pairs_2 - Bo_6_right) + pairs_2_lo),
      Bo_7_rounded = Bo_7
          + (B->xy - (Bo_7 + Bo_7_right) - (pairs_3 - Bo_7_right)
          - (pairs_3_lo1 + (KSL_MUL(t->x, n_1_lo) + KSL_MUL(t->y, n_0_lo)))),
      Bo_8_rounded = Bo_8
          + (B->xz - (Bo_8 + Bo_8_right) - (pairs_4 - Bo_8_right)
          - (pairs_4_lo1 + (KSL_MUL(t->x, n_2_lo) + KSL_MUL(t->z, n_0_lo)))),
      Bo_9_rounded = Bo_9
          + (B->yz - (Bo_9 + Bo_9_right) - (pairs_5 - Bo_9_right)
          - (pairs_5_lo1 + (KSL_MUL(t->y, n_2_lo) + KSL_MUL(t->z, n_1_lo))));
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0_rounded;
  Bo->h.y = moved_1_rounded;
  Bo->h.z = moved_2_rounded;
  Bo->xx = Bo_4_rounded;
  Bo->yy = Bo_5_rounded;
  Bo->zz = Bo_6_rounded;
  Bo->xy = Bo_7_rounded;
  Bo->xz = Bo_8_rounded;
  Bo->yz = Bo_9_rounded;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   105 mul, 420 add, 6 product error, 60 product rest.
   Error <= u |result| + (m: 0, h: 16, I: 35) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertia_transformed_accurate(const ksl_SE3_t *D,
    const ksl_spatial_inertia_t *B, ksl_spatial_inertia_t *Bo) {
  const double RI_0a = KSL_MUL(D->m00, B->xx), RI_0b = KSL_MUL(D->m01, B->xy),
      RI_0c = RI_0a + RI_0b, RI_0c_right = RI_0c - RI_0a, RI_0d = KSL_MUL(D->m02, B->xz),
      RI_0 = RI_0c + RI_0d, RI_0_right = RI_0 - RI_0c,
      RI_0c_lo = ksl_product_rest(D->m00, B->xx, RI_0a, RI_0c - RI_0c_right)
          + ksl_product_rest(D->m01, B->xy, RI_0b, RI_0c_right),
      RI_0_lo = RI_0c - (RI_0 - RI_0_right) + ksl_product_rest(D->m02, B->xz, RI_0d, RI_0_right)
          + RI_0c_lo;
  const double RI_1a = KSL_MUL(D->m00, B->xy), RI_1b = KSL_MUL(D->m01, B->yy),
      RI_1c = RI_1a + RI_1b, RI_1c_right = RI_1c - RI_1a, RI_1d = KSL_MUL(D->m02, B->yz),
      RI_1 = RI_1c + RI_1d, RI_1_right = RI_1 - RI_1c,
      RI_1c_lo = ksl_product_rest(D->m00, B->xy, RI_1a, RI_1c - RI_1c_right)
          + ksl_product_rest(D->m01, B->yy, RI_1b, RI_1c_right),
      RI_1_lo = RI_1c - (RI_1 - RI_1_right) + ksl_product_rest(D->m02, B->yz, RI_1d, RI_1_right)
          + RI_1c_lo;
  const double RI_2a = KSL_MUL(D->m00, B->xz), RI_2b = KSL_MUL(D->m01, B->yz),
      RI_2c = RI_2a + RI_2b, RI_2c_right = RI_2c - RI_2a, RI_2d = KSL_MUL(D->m02, B->zz),
      RI_2 = RI_2c + RI_2d, RI_2_right = RI_2 - RI_2c,
      RI_2c_lo = ksl_product_rest(D->m00, B->xz, RI_2a, RI_2c - RI_2c_right)
          + ksl_product_rest(D->m01, B->yz, RI_2b, RI_2c_right),
      RI_2_lo = RI_2c - (RI_2 - RI_2_right) + ksl_product_rest(D->m02, B->zz, RI_2d, RI_2_right)
          + RI_2c_lo;
  const double RI_3a = KSL_MUL(D->m10, B->xx), RI_3b = KSL_MUL(D->m11, B->xy),
      RI_3c = RI_3a + RI_3b, RI_3c_right = RI_3c - RI_3a, RI_3d = KSL_MUL(D->m12, B->xz),
      RI_3 = RI_3c + RI_3d, RI_3_right = RI_3 - RI_3c,
      RI_3c_lo = ksl_product_rest(D->m10, B->xx, RI_3a, RI_3c - RI_3c_right)
          + ksl_product_rest(D->m11, B->xy, RI_3b, RI_3c_right),
      RI_3_lo = RI_3c - (RI_3 - RI_3_right) + ksl_product_rest(D->m12, B->xz, RI_3d, RI_3_right)
          + RI_3c_lo;
  const double RI_4a = KSL_MUL(D->m10, B->xy), RI_4b = KSL_MUL(D->m11, B->yy),
      RI_4c = RI_4a + RI_4b, RI_4c_right = RI_4c - RI_4a, RI_4d = KSL_MUL(D->m12, B->yz),
      RI_4 = RI_4c + RI_4d, RI_4_right = RI_4 - RI_4c,
      RI_4c_lo = ksl_product_rest(D->m10, B->xy, RI_4a, RI_4c - RI_4c_right)
          + ksl_product_rest(D->m11, B->yy, RI_4b, RI_4c_right),
      RI_4_lo = RI_4c - (RI_4 - RI_4_right) + ksl_product_rest(D->m12, B->yz, RI_4d, RI_4_right)
          + RI_4c_lo;
  const double RI_5a = KSL_MUL(D->m10, B->xz), RI_5b = KSL_MUL(D->m11, B->yz),
      RI_5c = RI_5a + RI_5b, RI_5c_right = RI_5c - RI_5a, RI_5d = KSL_MUL(D->m12, B->zz),
      RI_5 = RI_5c + RI_5d, RI_5_right = RI_5 - RI_5c,
      RI_5c_lo = ksl_product_rest(D->m10, B->xz, RI_5a, RI_5c - RI_5c_right)
          + ksl_product_rest(D->m11, B->yz, RI_5b, RI_5c_right),
      RI_5_lo = RI_5c - (RI_5 - RI_5_right) + ksl_product_rest(D->m12, B->zz, RI_5d, RI_5_right)
          + RI_5c_lo;
  const double RI_6a = KSL_MUL(D->m20, B->xx), RI_6b = KSL_MUL(D->m21, B->xy),
      RI_6c = RI_6a + RI_6b, RI_6c_right = RI_6c - RI_6a, RI_6d = KSL_MUL(D->m22, B->xz),
      RI_6 = RI_6c + RI_6d, RI_6_right = RI_6 - RI_6c,
      RI_6c_lo = ksl_product_rest(D->m20, B->xx, RI_6a, RI_6c - RI_6c_right)
          + ksl_product_rest(D->m21, B->xy, RI_6b, RI_6c_right),
      RI_6_lo = RI_6c - (RI_6 - RI_6_right) + ksl_product_rest(D->m22, B->xz, RI_6d, RI_6_right)
          + RI_6c_lo;
  const double RI_7a = KSL_MUL(D->m20, B->xy), RI_7b = KSL_MUL(D->m21, B->yy),
      RI_7c = RI_7a + RI_7b, RI_7c_right = RI_7c - RI_7a, RI_7d = KSL_MUL(D->m22, B->yz),
      RI_7 = RI_7c + RI_7d, RI_7_right = RI_7 - RI_7c,
      RI_7c_lo = ksl_product_rest(D->m20, B->xy, RI_7a, RI_7c - RI_7c_right)
          + ksl_product_rest(D->m21, B->yy, RI_7b, RI_7c_right),
      RI_7_lo = RI_7c - (RI_7 - RI_7_right) + ksl_product_rest(D->m22, B->yz, RI_7d, RI_7_right)
          + RI_7c_lo;
  const double RI_8a = KSL_MUL(D->m20, B->xz), RI_8b = KSL_MUL(D->m21, B->yz),
      RI_8c = RI_8a + RI_8b, RI_8c_right = RI_8c - RI_8a, RI_8d = KSL_MUL(D->m22, B->zz),
      RI_8 = RI_8c + RI_8d, RI_8_right = RI_8 - RI_8c,
      RI_8c_lo = ksl_product_rest(D->m20, B->xz, RI_8a, RI_8c - RI_8c_right)
          + ksl_product_rest(D->m21, B->yz, RI_8b, RI_8c_right),
      RI_8_lo = RI_8c - (RI_8 - RI_8_right) + ksl_product_rest(D->m22, B->zz, RI_8d, RI_8_right)
          + RI_8c_lo;
  const double turned_1a = KSL_MUL(D->m00, B->h.x), turned_1b = KSL_MUL(D->m01, B->h.y),
      turned_1c = turned_1a + turned_1b, turned_1c_right = turned_1c - turned_1a,
      turned_1d = KSL_MUL(D->m02, B->h.z), turned_1 = turned_1c + turned_1d,
      turned_1_right = turned_1 - turned_1c,
      turned_1c_lo = ksl_product_rest(D->m00, B->h.x, turned_1a, turned_1c - turned_1c_right)
          + ksl_product_rest(D->m01, B->h.y, turned_1b, turned_1c_right),
      turned_1_lo = turned_1c - (turned_1 - turned_1_right)
          + ksl_product_rest(D->m02, B->h.z, turned_1d, turned_1_right) + turned_1c_lo;
  const double turned_2a = KSL_MUL(D->m10, B->h.x), turned_2b = KSL_MUL(D->m11, B->h.y),
      turned_2c = turned_2a + turned_2b, turned_2c_right = turned_2c - turned_2a,
      turned_2d = KSL_MUL(D->m12, B->h.z), turned_2 = turned_2c + turned_2d,
      turned_2_right = turned_2 - turned_2c,
      turned_2c_lo = ksl_product_rest(D->m10, B->h.x, turned_2a, turned_2c - turned_2c_right)
          + ksl_product_rest(D->m11, B->h.y, turned_2b, turned_2c_right),
      turned_2_lo = turned_2c - (turned_2 - turned_2_right)
          + ksl_product_rest(D->m12, B->h.z, turned_2d, turned_2_right) + turned_2c_lo;
  const double turned_3a = KSL_MUL(D->m20, B->h.x), turned_3b = KSL_MUL(D->m21, B->h.y),
      turned_3c = turned_3a + turned_3b, turned_3c_right = turned_3c - turned_3a,
      turned_3d = KSL_MUL(D->m22, B->h.z), turned_3 = turned_3c + turned_3d,
      turned_3_right = turned_3 - turned_3c,
      turned_3c_lo = ksl_product_rest(D->m20, B->h.x, turned_3a, turned_3c - turned_3c_right)
          + ksl_product_rest(D->m21, B->h.y, turned_3b, turned_3c_right),
      turned_3_lo = turned_3c - (turned_3 - turned_3_right)
          + ksl_product_rest(D->m22, B->h.z, turned_3d, turned_3_right) + turned_3c_lo;
  const double RI_0_sum = RI_0 + RI_0_lo, RI_0_sum_right = RI_0_sum - RI_0,
      RI_0_sum_lo = RI_0 - (RI_0_sum - RI_0_sum_right) + (RI_0_lo - RI_0_sum_right),
      turned_4a = KSL_MUL(D->m00, RI_0_sum), RI_1_sum = RI_1 + RI_1_lo,
      RI_1_sum_right = RI_1_sum - RI_1,
      RI_1_sum_lo = RI_1 - (RI_1_sum - RI_1_sum_right) + (RI_1_lo - RI_1_sum_right),
      turned_4b = KSL_MUL(D->m01, RI_1_sum), turned_4c = turned_4a + turned_4b,
      turned_4c_right = turned_4c - turned_4a,
      turned_4c_left_rest = ksl_product_rest(D->m00, RI_0_sum, turned_4a, turned_4c
          - turned_4c_right),
      turned_4c_lo1 = turned_4c_left_rest
          + ksl_product_rest(D->m01, RI_1_sum, turned_4b, turned_4c_right),
      RI_2_sum = RI_2 + RI_2_lo, RI_2_sum_right = RI_2_sum - RI_2,
      RI_2_sum_lo = RI_2 - (RI_2_sum - RI_2_sum_right) + (RI_2_lo - RI_2_sum_right),
      turned_4d = KSL_MUL(D->m02, RI_2_sum), turned_4 = turned_4c + turned_4d,
      turned_4_right = turned_4 - turned_4c,
      turned_4_lo2 = turned_4c - (turned_4 - turned_4_right)
          + ksl_product_rest(D->m02, RI_2_sum, turned_4d, turned_4_right)
          + KSL_MUL(D->m02, RI_2_sum_lo);
  const double RI_3_sum = RI_3 + RI_3_lo, RI_3_sum_right = RI_3_sum - RI_3,
      RI_3_sum_lo = RI_3 - (RI_3_sum - RI_3_sum_right) + (RI_3_lo - RI_3_sum_right),
      turned_5a = KSL_MUL(D->m10, RI_3_sum), RI_4_sum = RI_4 + RI_4_lo,
      RI_4_sum_right = RI_4_sum - RI_4,
      RI_4_sum_lo = RI_4 - (RI_4_sum - RI_4_sum_right) + (RI_4_lo - RI_4_sum_right),
      turned_5b = KSL_MUL(D->m11, RI_4_sum), turned_5c = turned_5a + turned_5b,
      turned_5c_right = turned_5c - turned_5a,
      turned_5c_left_rest = ksl_product_rest(D->m10, RI_3_sum, turned_5a, turned_5c
          - turned_5c_right),
      turned_5c_lo1 = turned_5c_left_rest
          + ksl_product_rest(D->m11, RI_4_sum, turned_5b, turned_5c_right),
      RI_5_sum = RI_5 + RI_5_lo, RI_5_sum_right = RI_5_sum - RI_5,
      RI_5_sum_lo = RI_5 - (RI_5_sum - RI_5_sum_right) + (RI_5_lo - RI_5_sum_right),
      turned_5d = KSL_MUL(D->m12, RI_5_sum), turned_5 = turned_5c + turned_5d,
      turned_5_right = turned_5 - turned_5c,
      turned_5_lo2 = turned_5c - (turned_5 - turned_5_right)
          + ksl_product_rest(D->m12, RI_5_sum, turned_5d, turned_5_right)
          + KSL_MUL(D->m12, RI_5_sum_lo);
  const double RI_6_sum = RI_6 + RI_6_lo, RI_6_sum_right = RI_6_sum - RI_6,
      turned_6a = KSL_MUL(D->m20, RI_6_sum), RI_7_sum = RI_7 + RI_7_lo,
      RI_7_sum_right = RI_7_sum - RI_7, turned_6b = KSL_MUL(D->m21, RI_7_sum),
      turned_6c = turned_6a + turned_6b, turned_6c_right = turned_6c - turned_6a,
      turned_6a_cross2 = KSL_MUL(D->m20, RI_6 - (RI_6_sum - RI_6_sum_right)
          + (RI_6_lo - RI_6_sum_right)),
      turned_6c_left_rest = ksl_product_rest(D->m20, RI_6_sum, turned_6a, turned_6c
          - turned_6c_right),
      turned_6c_cross = turned_6a_cross2
          + KSL_MUL(D->m21, RI_7 - (RI_7_sum - RI_7_sum_right) + (RI_7_lo - RI_7_sum_right)),
      RI_8_sum = RI_8 + RI_8_lo, RI_8_sum_right = RI_8_sum - RI_8,
      turned_6d = KSL_MUL(D->m22, RI_8_sum), turned_6 = turned_6c + turned_6d,
      turned_6_right = turned_6 - turned_6c,
      turned_6_lo1 = turned_6c - (turned_6 - turned_6_right)
          + ksl_product_rest(D->m22, RI_8_sum, turned_6d, turned_6_right),
      turned_6c_lo = turned_6c_left_rest
          + ksl_product_rest(D->m21, RI_7_sum, turned_6b, turned_6c_right) + turned_6c_cross;
  const double turned_7a = KSL_MUL(D->m10, RI_0_sum), turned_7b = KSL_MUL(D->m11, RI_1_sum),
      turned_7c = turned_7a + turned_7b, turned_7c_right = turned_7c - turned_7a,
      turned_7c_left_rest = ksl_product_rest(D->m10, RI_0_sum, turned_7a, turned_7c
          - turned_7c_right),
      turned_7c_lo1 = turned_7c_left_rest
          + ksl_product_rest(D->m11, RI_1_sum, turned_7b, turned_7c_right),
      turned_7d = KSL_MUL(D->m12, RI_2_sum), turned_7 = turned_7c + turned_7d,
      turned_7_right = turned_7 - turned_7c,
      turned_7_lo2 = turned_7c - (turned_7 - turned_7_right)
          + ksl_product_rest(D->m12, RI_2_sum, turned_7d, turned_7_right)
          + KSL_MUL(D->m12, RI_2_sum_lo);
  const double turned_8a = KSL_MUL(D->m20, RI_0_sum), turned_8b = KSL_MUL(D->m21, RI_1_sum),
      turned_8c = turned_8a + turned_8b, turned_8c_right = turned_8c - turned_8a,
      turned_8c_left_rest = ksl_product_rest(D->m20, RI_0_sum, turned_8a, turned_8c
          - turned_8c_right),
      turned_8c_lo1 = turned_8c_left_rest
          + ksl_product_rest(D->m21, RI_1_sum, turned_8b, turned_8c_right),
      turned_8d = KSL_MUL(D->m22, RI_2_sum), turned_8 = turned_8c + turned_8d,
      turned_8_right = turned_8 - turned_8c,
      turned_8_lo2 = turned_8c - (turned_8 - turned_8_right)
          + ksl_product_rest(D->m22, RI_2_sum, turned_8d, turned_8_right)
          + KSL_MUL(D->m22, RI_2_sum_lo);
  const double turned_9a = KSL_MUL(D->m20, RI_3_sum), turned_9b = KSL_MUL(D->m21, RI_4_sum),
      turned_9c = turned_9a + turned_9b, turned_9c_right = turned_9c - turned_9a,
      turned_9c_left_rest = ksl_product_rest(D->m20, RI_3_sum, turned_9a, turned_9c
          - turned_9c_right),
      turned_9c_lo1 = turned_9c_left_rest
          + ksl_product_rest(D->m21, RI_4_sum, turned_9b, turned_9c_right),
      turned_9d = KSL_MUL(D->m22, RI_5_sum), turned_9 = turned_9c + turned_9d,
      turned_9_right = turned_9 - turned_9c,
      turned_9_lo2 = turned_9c - (turned_9 - turned_9_right)
          + ksl_product_rest(D->m22, RI_5_sum, turned_9d, turned_9_right)
          + KSL_MUL(D->m22, RI_5_sum_lo);
  const double mt_0 = KSL_MUL(D->m03, B->m), mt_1 = KSL_MUL(D->m13, B->m),
      mt_2 = KSL_MUL(D->m23, B->m);
  const double mt_0_lo = ksl_product_error(D->m03, B->m, mt_0), half_0 = KSL_MUL(0.5, mt_0);
  const double mt_1_lo = ksl_product_error(D->m13, B->m, mt_1), half_1 = KSL_MUL(0.5, mt_1);
  const double mt_2_lo = ksl_product_error(D->m23, B->m, mt_2), half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = turned_1 + half_0, n_0_right = n_0 - turned_1,
      n_0_lo = turned_1 - (n_0 - n_0_right) + (half_0 - n_0_right) + KSL_MUL(0.5, mt_0_lo)
          + turned_1_lo;
  const double n_1 = turned_2 + half_1, n_1_right = n_1 - turned_2,
      n_1_lo = turned_2 - (n_1 - n_1_right) + (half_1 - n_1_right) + KSL_MUL(0.5, mt_1_lo)
          + turned_2_lo;
  const double n_2 = turned_3 + half_2, n_2_right = n_2 - turned_3,
      n_2_lo = turned_3 - (n_2 - n_2_right) + (half_2 - n_2_right) + KSL_MUL(0.5, mt_2_lo)
          + turned_3_lo;
  const double n_0_sum = n_0 + n_0_lo, n_0_sum_right = n_0_sum - n_0,
      n_0_sum_lo = n_0 - (n_0_sum - n_0_sum_right) + (n_0_lo - n_0_sum_right),
      tn0 = KSL_MUL(D->m03, n_0_sum);
  const double n_1_sum = n_1 + n_1_lo, n_1_sum_right = n_1_sum - n_1,
      n_1_sum_lo = n_1 - (n_1_sum - n_1_sum_right) + (n_1_lo - n_1_sum_right),
      tn1 = KSL_MUL(D->m13, n_1_sum);
  const double n_2_sum = n_2 + n_2_lo, n_2_sum_right = n_2_sum - n_2,
      n_2_sum_lo = n_2 - (n_2_sum - n_2_sum_right) + (n_2_lo - n_2_sum_right),
      tn2 = KSL_MUL(D->m23, n_2_sum);
  const double own_0 = KSL_MUL(2.0, tn0),
      own_0_cross2 = KSL_MUL(2.0, ksl_product_error(D->m03, n_0_sum, tn0)
          + KSL_MUL(D->m03, n_0_sum_lo));
  const double own_1 = KSL_MUL(2.0, tn1),
      own_1_cross2 = KSL_MUL(2.0, ksl_product_error(D->m13, n_1_sum, tn1)
          + KSL_MUL(D->m13, n_1_sum_lo));
  const double own_2 = KSL_MUL(2.0, tn2),
      own_2_cross2 = KSL_MUL(2.0, ksl_product_error(D->m23, n_2_sum, tn2)
          + KSL_MUL(D->m23, n_2_sum_lo));
  const double pairs_0 = own_1 + own_2, pairs_0_right = pairs_0 - own_1;
  const double pairs_1 = own_0 + own_2, pairs_1_right = pairs_1 - own_0;
  const double pairs_2 = own_0 + own_1, pairs_2_right = pairs_2 - own_0;
  const double pairs_3a = KSL_MUL(D->m03, n_1_sum), pairs_3b = KSL_MUL(D->m13, n_0_sum),
      pairs_3 = pairs_3a + pairs_3b, pairs_3_right = pairs_3 - pairs_3a,
      pairs_3_lo1 = ksl_product_rest(D->m03, n_1_sum, pairs_3a, pairs_3 - pairs_3_right)
          + ksl_product_rest(D->m13, n_0_sum, pairs_3b, pairs_3_right);
  const double pairs_4a = KSL_MUL(D->m03, n_2_sum), pairs_4b = KSL_MUL(D->m23, n_0_sum),
      pairs_4 = pairs_4a + pairs_4b, pairs_4_right = pairs_4 - pairs_4a,
      pairs_4_lo1 = ksl_product_rest(D->m03, n_2_sum, pairs_4a, pairs_4 - pairs_4_right)
          + ksl_product_rest(D->m23, n_0_sum, pairs_4b, pairs_4_right);
  const double pairs_5a = KSL_MUL(D->m13, n_2_sum), pairs_5b = KSL_MUL(D->m23, n_1_sum),
      pairs_5 = pairs_5a + pairs_5b, pairs_5_right = pairs_5 - pairs_5a,
      pairs_5_lo1 = ksl_product_rest(D->m13, n_2_sum, pairs_5a, pairs_5 - pairs_5_right)
          + ksl_product_rest(D->m23, n_1_sum, pairs_5b, pairs_5_right);
  const double moved_0 = turned_1 + mt_0, moved_0_right = moved_0 - turned_1;
  const double moved_1 = turned_2 + mt_1, moved_1_right = moved_1 - turned_2;
  const double moved_2 = turned_3 + mt_2, moved_2_right = moved_2 - turned_3;
  const double Bo_4 = turned_4 + pairs_0, Bo_4_right = Bo_4 - turned_4;
  const double pairs_0_lo = own_1 - (pairs_0 - pairs_0_right) + (own_2 - pairs_0_right)
          + own_2_cross2 + own_1_cross2;
  const double turned_4_lo = turned_4_lo2
          + (turned_4c_lo1 + (KSL_MUL(D->m00, RI_0_sum_lo) + KSL_MUL(D->m01, RI_1_sum_lo)));
  const double Bo_5 = turned_5 + pairs_1, Bo_5_right = Bo_5 - turned_5;
  const double pairs_1_lo = own_0 - (pairs_1 - pairs_1_right) + (own_2 - pairs_1_right)
          + own_2_cross2 + own_0_cross2;
  const double turned_5_lo = turned_5_lo2
          + (turned_5c_lo1 + (KSL_MUL(D->m10, RI_3_sum_lo) + KSL_MUL(D->m11, RI_4_sum_lo)));
  const double Bo_6 = turned_6 + pairs_2, Bo_6_right = Bo_6 - turned_6;
  const double pairs_2_lo = own_0 - (pairs_2 - pairs_2_right) + (own_1 - pairs_2_right)
          + own_1_cross2 + own_0_cross2;
  const double turned_6_lo = turned_6_lo1
          + KSL_MUL(D->m22, RI_8 - (RI_8_sum - RI_8_sum_right) + (RI_8_lo - RI_8_sum_right))
          + turned_6c_lo;
  const double Bo_7 = turned_7 - pairs_3, Bo_7_right = turned_7 - Bo_7,
      Bo_7_lo2 = turned_7 - (Bo_7 + Bo_7_right) - (pairs_3 - Bo_7_right)
          - (pairs_3_lo1 + (KSL_MUL(D->m03, n_1_sum_lo) + KSL_MUL(D->m13, n_0_sum_lo)));
  const double Bo_8 = turned_8 - pairs_4, Bo_8_right = turned_8 - Bo_8,
      Bo_8_lo2 = turned_8 - (Bo_8 + Bo_8_right) - (pairs_4 - Bo_8_right)
          - (pairs_4_lo1 + (KSL_MUL(D->m03, n_2_sum_lo) + KSL_MUL(D->m23, n_0_sum_lo)));
  const double Bo_9 = turned_9 - pairs_5, Bo_9_right = turned_9 - Bo_9,
      Bo_9_lo2 = turned_9 - (Bo_9 + Bo_9_right) - (pairs_5 - Bo_9_right)
          - (pairs_5_lo1 + (KSL_MUL(D->m13, n_2_sum_lo) + KSL_MUL(D->m23, n_1_sum_lo)));
  const double moved_0_rounded = moved_0
          + (turned_1 - (moved_0 - moved_0_right) + (mt_0 - moved_0_right) + mt_0_lo + turned_1_lo),
      moved_1_rounded = moved_1
          + (turned_2 - (moved_1 - moved_1_right) + (mt_1 - moved_1_right) + mt_1_lo + turned_2_lo),
      moved_2_rounded = moved_2
          + (turned_3 - (moved_2 - moved_2_right) + (mt_2 - moved_2_right) + mt_2_lo + turned_3_lo);
  const double Bo_4_rounded = Bo_4
          + (turned_4 - (Bo_4 - Bo_4_right) + (pairs_0 - Bo_4_right) + pairs_0_lo + turned_4_lo),
      Bo_5_rounded = Bo_5
          + (turned_5 - (Bo_5 - Bo_5_right) + (pairs_1 - Bo_5_right) + pairs_1_lo + turned_5_lo),
      Bo_6_rounded = Bo_6
          + (turned_6 - (Bo_6 - Bo_6_right) + (pairs_2 - Bo_6_right) + pairs_2_lo + turned_6_lo),
      Bo_7_rounded = Bo_7
          + (Bo_7_lo2
          + (turned_7_lo2
          + (turned_7c_lo1 + (KSL_MUL(D->m10, RI_0_sum_lo) + KSL_MUL(D->m11, RI_1_sum_lo))))),
      Bo_8_rounded = Bo_8
          + (Bo_8_lo2
          + (turned_8_lo2
          + (turned_8c_lo1 + (KSL_MUL(D->m20, RI_0_sum_lo) + KSL_MUL(D->m21, RI_1_sum_lo))))),
      Bo_9_rounded = Bo_9
          + (Bo_9_lo2
          + (turned_9_lo2
          + (turned_9c_lo1 + (KSL_MUL(D->m20, RI_3_sum_lo) + KSL_MUL(D->m21, RI_4_sum_lo)))));
  const double B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = moved_0_rounded;
  Bo->h.y = moved_1_rounded;
  Bo->h.z = moved_2_rounded;
  Bo->xx = Bo_4_rounded;
  Bo->yy = Bo_5_rounded;
  Bo->zz = Bo_6_rounded;
  Bo->xy = Bo_7_rounded;
  Bo->xz = Bo_8_rounded;
  Bo->yz = Bo_9_rounded;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   42 mul, 258 add, 10 product error, 10 product rest, 20 div, 6 neg, 9 less, 1 equal, 26 select. */
static inline double ksl_spatial_inertia_consistency_accurate(const ksl_spatial_inertia_t *B) {
  const double twice_trace_a = B->xx + B->yy, twice_trace_a_right = twice_trace_a - B->xx,
      twice_trace = twice_trace_a + B->zz, twice_trace_right = twice_trace - twice_trace_a,
      twice_trace_lo1 = twice_trace_a - (twice_trace - twice_trace_right)
          + (B->zz - twice_trace_right);
  const double trace = KSL_MUL(0.5, twice_trace),
      trace_cross2 = KSL_MUL(0.5, twice_trace_lo1
          + (B->xx - (twice_trace_a - twice_trace_a_right) + (B->yy - twice_trace_a_right)));
  const double sigma_0 = trace - B->xx, sigma_0_right = trace - sigma_0,
      sigma_0_lo = trace - (sigma_0 + sigma_0_right) - (B->xx - sigma_0_right) + trace_cross2;
  const double sigma_1 = trace - B->yy, sigma_1_right = trace - sigma_1,
      sigma_1_lo = trace - (sigma_1 + sigma_1_right) - (B->yy - sigma_1_right) + trace_cross2;
  const double sigma_2 = trace - B->zz, sigma_2_right = trace - sigma_2,
      sigma_2_lo = trace - (sigma_2 + sigma_2_right) - (B->zz - sigma_2_right) + trace_cross2;
  const double divisor0 = 0.0 < B->m ? B->m : 1.0;
  const double l0_0 = B->h.x / divisor0, l0_0_product = KSL_MUL(l0_0, divisor0),
      l0_0_lo = (B->h.x - l0_0_product - ksl_product_error(l0_0, divisor0, l0_0_product))
          / divisor0;
  const double l0_1 = B->h.y / divisor0, l0_1_product = KSL_MUL(l0_1, divisor0),
      l0_1_lo = (B->h.y - l0_1_product - ksl_product_error(l0_1, divisor0, l0_1_product))
          / divisor0;
  const double l0_2 = B->h.z / divisor0, l0_2_product = KSL_MUL(l0_2, divisor0);
  const double u1_0a = KSL_MUL(B->h.x, l0_0), u1_0 = sigma_0 - u1_0a, u1_0_right = sigma_0 - u1_0,
      u1_0_lo = sigma_0 - (u1_0 + u1_0_right) - ksl_product_rest(B->h.x, l0_0, u1_0a, u1_0_right)
          - KSL_MUL(B->h.x, l0_0_lo) + sigma_0_lo;
  const double u1_1a = KSL_MUL(B->h.y, l0_0), u1_1b = u1_1a + B->xy, u1_1b_right = u1_1b - u1_1a,
      u1_1 = -u1_1b,
      u1_1_lo =
          -(ksl_product_rest(B->h.y, l0_0, u1_1a, u1_1b - u1_1b_right) + (B->xy - u1_1b_right)
          + KSL_MUL(B->h.y, l0_0_lo));
  const double u1_2a = KSL_MUL(B->h.z, l0_0), u1_2b = u1_2a + B->xz, u1_2b_right = u1_2b - u1_2a,
      u1_2 = -u1_2b,
      u1_2_lo =
          -(ksl_product_rest(B->h.z, l0_0, u1_2a, u1_2b - u1_2b_right) + (B->xz - u1_2b_right)
          + KSL_MUL(B->h.z, l0_0_lo));
  const double u1_0_sum = u1_0 + u1_0_lo, u1_0_sum_right = u1_0_sum - u1_0,
      u1_0_sum_lo = u1_0 - (u1_0_sum - u1_0_sum_right) + (u1_0_lo - u1_0_sum_right),
      divisor1 = 0.0 < u1_0_sum ? u1_0_sum : 1.0, divisor1_lo = 0.0 < u1_0_sum ? u1_0_sum_lo : 0.0;
  const double u1_1_sum = u1_1 + u1_1_lo, u1_1_sum_right = u1_1_sum - u1_1,
      u1_1_sum_lo = u1_1 - (u1_1_sum - u1_1_sum_right) + (u1_1_lo - u1_1_sum_right),
      divisor1_sum = divisor1 + divisor1_lo, divisor1_sum_right = divisor1_sum - divisor1,
      divisor1_sum_lo = divisor1 - (divisor1_sum - divisor1_sum_right)
          + (divisor1_lo - divisor1_sum_right), l1_0 = u1_1_sum / divisor1_sum,
      l1_0_product = KSL_MUL(l1_0, divisor1_sum),
      l1_0_residual = u1_1_sum - l1_0_product - ksl_product_error(l1_0, divisor1_sum, l1_0_product)
          + u1_1_sum_lo - KSL_MUL(l1_0, divisor1_sum_lo), l1_0_lo = l1_0_residual / divisor1_sum;
  const double u1_2_sum = u1_2 + u1_2_lo, u1_2_sum_right = u1_2_sum - u1_2,
      u1_2_sum_lo = u1_2 - (u1_2_sum - u1_2_sum_right) + (u1_2_lo - u1_2_sum_right),
      l1_1 = u1_2_sum / divisor1_sum, l1_1_product = KSL_MUL(l1_1, divisor1_sum),
      l1_1_residual = u1_2_sum - l1_1_product - ksl_product_error(l1_1, divisor1_sum, l1_1_product)
          + u1_2_sum_lo - KSL_MUL(l1_1, divisor1_sum_lo);
  const double u2_0a = KSL_MUL(B->h.y, l0_1), u2_0b = sigma_1 - u2_0a,
      u2_0b_right = sigma_1 - u2_0b, u2_0c = KSL_MUL(u1_1_sum, l1_0), u2_0 = u2_0b - u2_0c,
      u2_0_right = u2_0b - u2_0,
      u2_0_lo1 = u2_0b - (u2_0 + u2_0_right) - ksl_product_rest(u1_1_sum, l1_0, u2_0c, u2_0_right),
      u2_0b_lo = sigma_1 - (u2_0b + u2_0b_right)
          - ksl_product_rest(B->h.y, l0_1, u2_0a, u2_0b_right) - KSL_MUL(B->h.y, l0_1_lo)
          + sigma_1_lo,
      u2_0_lo = u2_0_lo1 - (KSL_MUL(u1_1_sum_lo, l1_0) + KSL_MUL(u1_1_sum, l1_0_lo)) + u2_0b_lo;
  const double u2_1a = KSL_MUL(B->h.z, l0_1), u2_1b = u2_1a + B->yz, u2_1b_right = u2_1b - u2_1a,
      u2_1c = KSL_MUL(u1_2_sum, l1_0), u2_1d = u2_1b + u2_1c, u2_1d_right = u2_1d - u2_1b,
      u2_1d_lo1 = u2_1b - (u2_1d - u2_1d_right)
          + ksl_product_rest(u1_2_sum, l1_0, u2_1c, u2_1d_right),
      u2_1b_lo = ksl_product_rest(B->h.z, l0_1, u2_1a, u2_1b - u2_1b_right) + (B->yz - u2_1b_right)
          + KSL_MUL(B->h.z, l0_1_lo), u2_1 = -u2_1d,
      u2_1_lo = -(u2_1d_lo1 + (KSL_MUL(u1_2_sum_lo, l1_0) + KSL_MUL(u1_2_sum, l1_0_lo)) + u2_1b_lo);
  const double u2_0_sum = u2_0 + u2_0_lo, u2_0_sum_right = u2_0_sum - u2_0,
      u2_0_sum_lo = u2_0 - (u2_0_sum - u2_0_sum_right) + (u2_0_lo - u2_0_sum_right),
      divisor2 = 0.0 < u2_0_sum ? u2_0_sum : 1.0, divisor2_lo = 0.0 < u2_0_sum ? u2_0_sum_lo : 0.0;
  const double u2_1_sum = u2_1 + u2_1_lo, u2_1_sum_right = u2_1_sum - u2_1,
      u2_1_sum_lo = u2_1 - (u2_1_sum - u2_1_sum_right) + (u2_1_lo - u2_1_sum_right),
      divisor2_sum = divisor2 + divisor2_lo, divisor2_sum_right = divisor2_sum - divisor2,
      l2 = u2_1_sum / divisor2_sum, l2_product = KSL_MUL(l2, divisor2_sum),
      l2_cross = KSL_MUL(l2, divisor2 - (divisor2_sum - divisor2_sum_right)
          + (divisor2_lo - divisor2_sum_right));
  const double u3a = KSL_MUL(B->h.z, l0_2), u3b = sigma_2 - u3a, u3b_right = sigma_2 - u3b,
      u3a_cross2 = KSL_MUL(B->h.z, (B->h.z - l0_2_product
          - ksl_product_error(l0_2, divisor0, l0_2_product)) / divisor0),
      u3c = KSL_MUL(u1_2_sum, l1_1), u3d = u3b - u3c, u3d_right = u3b - u3d,
      u3c_cross = KSL_MUL(u1_2_sum_lo, l1_1) + KSL_MUL(u1_2_sum, l1_1_residual / divisor1_sum),
      u3b_lo = sigma_2 - (u3b + u3b_right) - ksl_product_rest(B->h.z, l0_2, u3a, u3b_right)
          - u3a_cross2 + sigma_2_lo, u3e = KSL_MUL(u2_1_sum, l2),
      u3e_cross2 = KSL_MUL(u2_1_sum, (u2_1_sum - l2_product
          - ksl_product_error(l2, divisor2_sum, l2_product) + u2_1_sum_lo - l2_cross)
          / divisor2_sum), u3 = u3d - u3e, u3_right = u3d - u3,
      u3_lo2 = u3d - (u3 + u3_right) - ksl_product_rest(u2_1_sum, l2, u3e, u3_right)
          - (KSL_MUL(u2_1_sum_lo, l2) + u3e_cross2),
      u3_lo = u3_lo2
          + (u3b - (u3d + u3d_right) - ksl_product_rest(u1_2_sum, l1_1, u3c, u3d_right) - u3c_cross
          + u3b_lo);
  const double part0a = B->m / divisor0, part0a_product = KSL_MUL(part0a, divisor0),
      part0a_lo = (B->m - part0a_product - ksl_product_error(part0a, divisor0, part0a_product))
          / divisor0, part0 = 0.0 < B->m ? part0a : B->m, part0_lo = 0.0 < B->m ? part0a_lo : 0.0;
  const double sigma_0_sum = sigma_0 + sigma_0_lo, sigma_0_sum_right = sigma_0_sum - sigma_0,
      sigma_0_sum_lo = sigma_0 - (sigma_0_sum - sigma_0_sum_right)
          + (sigma_0_lo - sigma_0_sum_right), own1 = 0.0 < sigma_0_sum ? sigma_0_sum : 1.0,
      own1_lo = 0.0 < sigma_0_sum ? sigma_0_sum_lo : 0.0;
  const double own1_sum = own1 + own1_lo, own1_sum_right = own1_sum - own1,
      part1a = u1_0_sum / own1_sum, part1a_product = KSL_MUL(part1a, own1_sum),
      part1a_numerator = u1_0_sum - part1a_product
          - ksl_product_error(part1a, own1_sum, part1a_product) + u1_0_sum_lo,
      part1a_lo = (part1a_numerator
          - KSL_MUL(part1a, own1 - (own1_sum - own1_sum_right) + (own1_lo - own1_sum_right)))
          / own1_sum, part1 = 0.0 < sigma_0_sum ? part1a : sigma_0_sum,
      part1_lo = 0.0 < sigma_0_sum ? part1a_lo : sigma_0_sum_lo;
  const double part0_sum = part0 + part0_lo, part0_sum_right = part0_sum - part0,
      part0_sum_lo = part0 - (part0_sum - part0_sum_right) + (part0_lo - part0_sum_right),
      part1_sum = part1 + part1_lo, part1_sum_right = part1_sum - part1,
      part1_sum_lo = part1 - (part1_sum - part1_sum_right) + (part1_lo - part1_sum_right),
      smallest1 = part0_sum < part1_sum ? part0_sum : part1_sum,
      smallest1_lo = part0_sum < part1_sum ? part0_sum_lo : part1_sum_lo;
  const double sigma_1_sum = sigma_1 + sigma_1_lo, sigma_1_sum_right = sigma_1_sum - sigma_1,
      sigma_1_sum_lo = sigma_1 - (sigma_1_sum - sigma_1_sum_right)
          + (sigma_1_lo - sigma_1_sum_right), own2 = 0.0 < sigma_1_sum ? sigma_1_sum : 1.0,
      own2_lo = 0.0 < sigma_1_sum ? sigma_1_sum_lo : 0.0;
  const double own2_sum = own2 + own2_lo, own2_sum_right = own2_sum - own2,
      part2a = u2_0_sum / own2_sum, part2a_product = KSL_MUL(part2a, own2_sum),
      part2a_numerator = u2_0_sum - part2a_product
          - ksl_product_error(part2a, own2_sum, part2a_product) + u2_0_sum_lo,
      part2a_lo = (part2a_numerator
          - KSL_MUL(part2a, own2 - (own2_sum - own2_sum_right) + (own2_lo - own2_sum_right)))
          / own2_sum, part2 = 0.0 < sigma_1_sum ? part2a : sigma_1_sum,
      part2_lo = 0.0 < sigma_1_sum ? part2a_lo : sigma_1_sum_lo;
  const double smallest1_sum = smallest1 + smallest1_lo,
      smallest1_sum_right = smallest1_sum - smallest1,
      smallest1_sum_lo = smallest1 - (smallest1_sum - smallest1_sum_right)
          + (smallest1_lo - smallest1_sum_right), part2_sum = part2 + part2_lo,
      part2_sum_right = part2_sum - part2,
      part2_sum_lo = part2 - (part2_sum - part2_sum_right) + (part2_lo - part2_sum_right),
      smallest2 = smallest1_sum < part2_sum ? smallest1_sum : part2_sum,
      smallest2_lo = smallest1_sum < part2_sum ? smallest1_sum_lo : part2_sum_lo;
  const double sigma_2_sum = sigma_2 + sigma_2_lo, sigma_2_sum_right = sigma_2_sum - sigma_2,
      sigma_2_sum_lo = sigma_2 - (sigma_2_sum - sigma_2_sum_right)
          + (sigma_2_lo - sigma_2_sum_right), own3 = 0.0 < sigma_2_sum ? sigma_2_sum : 1.0,
      own3_lo = 0.0 < sigma_2_sum ? sigma_2_sum_lo : 0.0;
  const double u3_sum = u3 + u3_lo, u3_sum_right = u3_sum - u3, own3_sum = own3 + own3_lo,
      own3_sum_right = own3_sum - own3, part3a = u3_sum / own3_sum,
      part3a_product = KSL_MUL(part3a, own3_sum),
      part3a_exact = u3_sum - part3a_product - ksl_product_error(part3a, own3_sum, part3a_product),
      part3a_cross = KSL_MUL(part3a, own3 - (own3_sum - own3_sum_right)
          + (own3_lo - own3_sum_right)),
      part3a_lo = (part3a_exact + (u3 - (u3_sum - u3_sum_right) + (u3_lo - u3_sum_right))
          - part3a_cross) / own3_sum, part3 = 0.0 < sigma_2_sum ? part3a : sigma_2_sum,
      part3_lo = 0.0 < sigma_2_sum ? part3a_lo : sigma_2_sum_lo;
  const double smallest2_sum = smallest2 + smallest2_lo,
      smallest2_sum_right = smallest2_sum - smallest2,
      smallest2_sum_lo = smallest2 - (smallest2_sum - smallest2_sum_right)
          + (smallest2_lo - smallest2_sum_right), part3_sum = part3 + part3_lo,
      part3_sum_right = part3_sum - part3,
      part3_sum_lo = part3 - (part3_sum - part3_sum_right) + (part3_lo - part3_sum_right),
      smallest3 = smallest2_sum < part3_sum ? smallest2_sum : part3_sum;
  const double smallest3_rounded = smallest3
          + (smallest2_sum < part3_sum ? smallest2_sum_lo : part3_sum_lo),
      smallest3_final = smallest3_rounded == smallest3_rounded ? smallest3_rounded : smallest3;
  return smallest3_final;
}

/* self = a self.
   self: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in
     kg m^2); a: number.
   10 mul.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_spatial_inertiaf_scale_accurate(ksl_spatial_inertiaf_t *self,
    const float a) {
  const double self_0_new = (double)self->m * (double)a, self_1_new = (double)self->h.x * (double)a,
      self_2_new = (double)self->h.y * (double)a, self_3_new = (double)self->h.z * (double)a,
      self_4_new = (double)self->xx * (double)a, self_5_new = (double)self->yy * (double)a,
      self_6_new = (double)self->zz * (double)a, self_7_new = (double)self->xy * (double)a,
      self_8_new = (double)self->xz * (double)a, self_9_new = (double)self->yz * (double)a;
  self->m = (float)self_0_new;
  self->h.x = (float)self_1_new;
  self->h.y = (float)self_2_new;
  self->h.z = (float)self_3_new;
  self->xx = (float)self_4_new;
  self->yy = (float)self_5_new;
  self->zz = (float)self_6_new;
  self->xy = (float)self_7_new;
  self->xz = (float)self_8_new;
  self->yz = (float)self_9_new;
}

/* Bo = B1 + B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_add_BBf_accurate(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
  const double Bo_0 = (double)B1->m + (double)B2->m, Bo_1 = (double)B1->h.x + (double)B2->h.x,
      Bo_2 = (double)B1->h.y + (double)B2->h.y, Bo_3 = (double)B1->h.z + (double)B2->h.z,
      Bo_4 = (double)B1->xx + (double)B2->xx, Bo_5 = (double)B1->yy + (double)B2->yy,
      Bo_6 = (double)B1->zz + (double)B2->zz, Bo_7 = (double)B1->xy + (double)B2->xy,
      Bo_8 = (double)B1->xz + (double)B2->xz, Bo_9 = (double)B1->yz + (double)B2->yz;
  Bo->m = (float)Bo_0;
  Bo->h.x = (float)Bo_1;
  Bo->h.y = (float)Bo_2;
  Bo->h.z = (float)Bo_3;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* Bo = B1 - B2.
   B1, B2, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz,
     yz in kg m^2).
   10 add.
   Error <= u |result| + 1/32 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline void ksl_subtract_BBf_accurate(const ksl_spatial_inertiaf_t *B1,
    const ksl_spatial_inertiaf_t *B2, ksl_spatial_inertiaf_t *Bo) {
  const double Bo_0 = (double)B1->m - (double)B2->m, Bo_1 = (double)B1->h.x - (double)B2->h.x,
      Bo_2 = (double)B1->h.y - (double)B2->h.y, Bo_3 = (double)B1->h.z - (double)B2->h.z,
      Bo_4 = (double)B1->xx - (double)B2->xx, Bo_5 = (double)B1->yy - (double)B2->yy,
      Bo_6 = (double)B1->zz - (double)B2->zz, Bo_7 = (double)B1->xy - (double)B2->xy,
      Bo_8 = (double)B1->xz - (double)B2->xz, Bo_9 = (double)B1->yz - (double)B2->yz;
  Bo->m = (float)Bo_0;
  Bo->h.x = (float)Bo_1;
  Bo->h.y = (float)Bo_2;
  Bo->h.z = (float)Bo_3;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* Bo: mass m, centre of mass com, second moments Ic about it (kg m^2; only the upper triangle is
     read): h = m com, I = Ic - m com~ com~.
   m: number; com: vector; Ic: rotation or other 3×3 matrix; Bo: spatial inertia (m in kg; h = m
     c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   9 mul, 9 add.
   Error <= u |result| + (m: 0, h: 1/32, I: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_com_accurate(const float m, const ksl_vec3f_t *com,
    const ksl_mat3x3f_t *Ic, ksl_spatial_inertiaf_t *Bo) {
  const double h_0 = (double)m * (double)com->x, h_1 = (double)m * (double)com->y,
      h_2 = (double)m * (double)com->z;
  const double squares_0 = KSL_MUL((double)com->x, h_0), squares_1 = KSL_MUL((double)com->y, h_1),
      squares_2 = KSL_MUL((double)com->z, h_2);
  const double Bo_4 = (double)Ic->m00 + (squares_1 + squares_2),
      Bo_5 = (double)Ic->m11 + (squares_0 + squares_2),
      Bo_6 = (double)Ic->m22 + (squares_0 + squares_1),
      Bo_7 = (double)Ic->m01 - KSL_MUL((double)com->y, h_0),
      Bo_8 = (double)Ic->m02 - KSL_MUL((double)com->z, h_0),
      Bo_9 = (double)Ic->m12 - KSL_MUL((double)com->z, h_1);
  Bo->m = m;
  Bo->h.x = (float)h_0;
  Bo->h.y = (float)h_1;
  Bo->h.z = (float)h_2;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* Bo = (m, mt, I - mt~ mt~ / m) from the inertia J, whose moments are about the centre of mass;
     NaN where m = 0.
   J: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy, yz, zx in
     kg m^2); Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy,
     xz, yz in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_from_inertia_accurate(const ksl_inertiaf_t *J,
    ksl_spatial_inertiaf_t *Bo) {
  const double c_0 = (double)J->mt.x / (double)J->m, c_1 = (double)J->mt.y / (double)J->m,
      c_2 = (double)J->mt.z / (double)J->m;
  const double squares_0 = KSL_MUL((double)J->mt.x, c_0), squares_1 = KSL_MUL((double)J->mt.y, c_1),
      squares_2 = KSL_MUL((double)J->mt.z, c_2);
  const double Bo_4 = (double)J->Ixx + (squares_1 + squares_2),
      Bo_5 = (double)J->Iyy + (squares_0 + squares_2),
      Bo_6 = (double)J->Izz + (squares_0 + squares_1),
      Bo_7 = (double)J->Ixy - KSL_MUL((double)J->mt.x, c_1),
      Bo_8 = (double)J->Izx - KSL_MUL((double)J->mt.x, c_2),
      Bo_9 = (double)J->Iyz - KSL_MUL((double)J->mt.y, c_2);
  const float J_m = J->m;
  const float J_mt_x = J->mt.x;
  const float J_mt_y = J->mt.y;
  const float J_mt_z = J->mt.z;
  Bo->m = J_m;
  Bo->h.x = J_mt_x;
  Bo->h.y = J_mt_y;
  Bo->h.z = J_mt_z;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* Jo = (m, h, I + h~ h~ / m) from the spatial inertia B, with moments about the centre of mass;
     NaN where m = 0.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Jo: inertia (m in kg; mt = m c in kg m; I about the centre of mass c, xx, yy, zz, xy,
     yz, zx in kg m^2).
   6 mul, 9 add, 3 div.
   Error of a moment <= 4 u times the sum of its |terms|, barring over- and underflow. */
static inline void ksl_inertiaf_from_spatial_inertia_accurate(const ksl_spatial_inertiaf_t *B,
    ksl_inertiaf_t *Jo) {
  const double c_0 = (double)B->h.x / (double)B->m, c_1 = (double)B->h.y / (double)B->m,
      c_2 = (double)B->h.z / (double)B->m;
  const double squares_0 = KSL_MUL((double)B->h.x, c_0), squares_1 = KSL_MUL((double)B->h.y, c_1),
      squares_2 = KSL_MUL((double)B->h.z, c_2);
  const double Jo_4 = (double)B->xx - (squares_1 + squares_2),
      Jo_5 = (double)B->yy - (squares_0 + squares_2),
      Jo_6 = (double)B->zz - (squares_0 + squares_1),
      Jo_7 = KSL_MUL((double)B->h.x, c_1) + (double)B->xy,
      Jo_8 = KSL_MUL((double)B->h.y, c_2) + (double)B->yz,
      Jo_9 = KSL_MUL((double)B->h.x, c_2) + (double)B->xz;
  const float B_m = B->m;
  const float B_h_x = B->h.x;
  const float B_h_y = B->h.y;
  const float B_h_z = B->h.z;
  Jo->m = B_m;
  Jo->mt.x = B_h_x;
  Jo->mt.y = B_h_y;
  Jo->mt.z = B_h_z;
  Jo->Ixx = (float)Jo_4;
  Jo->Iyy = (float)Jo_5;
  Jo->Izz = (float)Jo_6;
  Jo->Ixy = (float)Jo_7;
  Jo->Iyz = (float)Jo_8;
  Jo->Izx = (float)Jo_9;
}

/* vo = h / m, the centre of mass in m.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); vo: vector.
   3 div.
   Error <= u |result|, barring over- and underflow. */
static inline void ksl_spatial_inertiaf_com_accurate(const ksl_spatial_inertiaf_t *B,
    ksl_vec3f_t *vo) {
  const double vo_0 = (double)B->h.x / (double)B->m, vo_1 = (double)B->h.y / (double)B->m,
      vo_2 = (double)B->h.z / (double)B->m;
  vo->x = (float)vo_0;
  vo->y = (float)vo_1;
  vo->z = (float)vo_2;
}

/* Ro = I + h~ h~ / m, the second moments about the centre of mass.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); Ro: rotation or other 3×3 matrix.
   6 mul, 9 add, 3 div. */
static inline void ksl_spatial_inertiaf_about_com_accurate(const ksl_spatial_inertiaf_t *B,
    ksl_mat3x3f_t *Ro) {
  const double c_0 = (double)B->h.x / (double)B->m, c_1 = (double)B->h.y / (double)B->m,
      c_2 = (double)B->h.z / (double)B->m;
  const double squares_0 = KSL_MUL((double)B->h.x, c_0), squares_1 = KSL_MUL((double)B->h.y, c_1),
      squares_2 = KSL_MUL((double)B->h.z, c_2);
  const double about_0 = (double)B->xx - (squares_1 + squares_2),
      about_1 = (double)B->yy - (squares_0 + squares_2),
      about_2 = (double)B->zz - (squares_0 + squares_1),
      about_3 = KSL_MUL((double)B->h.x, c_1) + (double)B->xy,
      about_4 = KSL_MUL((double)B->h.x, c_2) + (double)B->xz,
      about_5 = KSL_MUL((double)B->h.y, c_2) + (double)B->yz;
  Ro->m00 = (float)about_0;
  Ro->m01 = (float)about_3;
  Ro->m02 = (float)about_4;
  Ro->m10 = (float)about_3;
  Ro->m11 = (float)about_1;
  Ro->m12 = (float)about_5;
  Ro->m20 = (float)about_4;
  Ro->m21 = (float)about_5;
  Ro->m22 = (float)about_2;
}

/* co = B s = (m v - h × ω; h × v + I ω), the momentum of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   24 mul, 18 add.
   Error <= u |result| + (lin: 3/32, ang: 1/8) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_product_Bsf_accurate(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s, ksl_coscrewf_t *co) {
  const double co_0 = ksl_product_sum((double)B->m, (double)s->m0, ksl_product_sum(-(double)B->h.y,
      (double)s->m5, (double)B->h.z * (double)s->m4)),
      co_1 = ksl_product_sum((double)B->m, (double)s->m1, ksl_product_sum(-(double)B->h.z,
          (double)s->m3, (double)B->h.x * (double)s->m5)),
      co_2 = ksl_product_sum((double)B->m, (double)s->m2, ksl_product_sum(-(double)B->h.x,
          (double)s->m4, (double)B->h.y * (double)s->m3));
  const double co_3h = ksl_product_sum((double)B->xz, (double)s->m5, ksl_product_sum((double)B->xy,
      (double)s->m4, (double)B->xx * (double)s->m3)),
      co_3 = ksl_product_sum(-(double)B->h.z, (double)s->m1, (double)B->h.y * (double)s->m2)
          + co_3h;
  const double co_4h = ksl_product_sum((double)B->yz, (double)s->m5, ksl_product_sum((double)B->xy,
      (double)s->m3, (double)B->yy * (double)s->m4)),
      co_4 = ksl_product_sum(-(double)B->h.x, (double)s->m2, (double)B->h.z * (double)s->m0)
          + co_4h;
  const double co_5h = ksl_product_sum((double)B->yz, (double)s->m4, ksl_product_sum((double)B->xz,
      (double)s->m3, (double)B->zz * (double)s->m5)),
      co_5 = ksl_product_sum(-(double)B->h.y, (double)s->m0, (double)B->h.x * (double)s->m1)
          + co_5h;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* s·B s / 2, the kinetic energy in J of a body that moves with s.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); s: screw (v in m/s; ω in rad/s).
   26 mul, 17 add.
   Error <= u |result| + 1/4 u^2 S, S the sum of the |terms| of the expanded formula; barring
     over- and underflow. */
static inline float ksl_spatial_inertiaf_energy_accurate(const ksl_spatial_inertiaf_t *B,
    const ksl_screwf_t *s) {
  const double square = ksl_product_sum((double)s->m2, (double)s->m2, ksl_product_sum((double)s->m1,
      (double)s->m1, (double)s->m0 * (double)s->m0));
  const double L_0 = ksl_product_sum((double)B->xz, (double)s->m5, ksl_product_sum((double)B->xy,
      (double)s->m4, (double)B->xx * (double)s->m3)),
      L_1 = ksl_product_sum((double)B->yz, (double)s->m5, ksl_product_sum((double)B->xy,
          (double)s->m3, (double)B->yy * (double)s->m4)),
      L_2 = ksl_product_sum((double)B->yz, (double)s->m4, ksl_product_sum((double)B->xz,
          (double)s->m3, (double)B->zz * (double)s->m5));
  const double twice = KSL_MUL((double)B->m, square)
          + (KSL_MUL((double)s->m3, L_0) + KSL_MUL((double)s->m4, L_1)
          + KSL_MUL((double)s->m5, L_2));
  const double across_0 = ksl_product_sum(-(double)B->h.y, (double)s->m5, (double)B->h.z
          * (double)s->m4),
      across_1 = ksl_product_sum(-(double)B->h.z, (double)s->m3, (double)B->h.x * (double)s->m5),
      across_2 = ksl_product_sum(-(double)B->h.x, (double)s->m4, (double)B->h.y * (double)s->m3);
  const double energy = KSL_MUL((double)s->m0, across_0) + KSL_MUL((double)s->m1, across_1)
          + KSL_MUL((double)s->m2, across_2) + KSL_MUL(0.5, twice);
  return (float)energy;
}

/* co = B ds + (w × (w × h); w × I w): the net wrench, about the origin, of a body with angular
     velocity w and acceleration ds = (a; w'), where a is that of the point now at the origin; if
     a is less gravity's, so is the wrench.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2); w: vector; ds: screw (v in m/s; ω in rad/s); co: coscrew (f in N; τ in N m).
   39 mul, 42 add, 3 neg.
   Error <= u |result| + (lin: 3/16, ang: 7/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_net_wrench_accurate(const ksl_spatial_inertiaf_t *B,
    const ksl_vec3f_t *w, const ksl_screwf_t *ds, ksl_coscrewf_t *co) {
  const double ww_0 = (double)w->x * (double)w->x, ww_1 = (double)w->y * (double)w->y,
      ww_2 = (double)w->z * (double)w->z, ww_3 = (double)w->x * (double)w->y,
      ww_4 = (double)w->x * (double)w->z, ww_5 = (double)w->y * (double)w->z;
  const double U_0 = -ww_1 - ww_2, U_1 = ww_3 - (double)ds->m5, U_2 = (double)ds->m4 + ww_4,
      U_3 = (double)ds->m5 + ww_3, U_4 = -ww_0 - ww_2, U_5 = ww_5 - (double)ds->m3,
      U_6 = ww_4 - (double)ds->m4, U_7 = (double)ds->m3 + ww_5, U_8 = -ww_0 - ww_1;
  const double others_0 = (double)B->zz - (double)B->yy, others_1 = (double)B->xx - (double)B->zz,
      others_2 = (double)B->yy - (double)B->xx;
  const double squares_0 = ww_1 - ww_2, squares_1 = ww_2 - ww_0, squares_2 = ww_0 - ww_1;
  const double own_0 = ksl_product_sum((double)B->xx, (double)ds->m3, KSL_MUL(ww_5, others_0)),
      own_1 = ksl_product_sum((double)B->yy, (double)ds->m4, KSL_MUL(ww_4, others_1)),
      own_2 = ksl_product_sum((double)B->zz, (double)ds->m5, KSL_MUL(ww_3, others_2));
  const double N_0 = KSL_MUL((double)B->xz, U_3) - KSL_MUL((double)B->xy, U_6)
          + KSL_MUL((double)B->yz, squares_0) + own_0,
      N_1 = KSL_MUL((double)B->xy, U_7) - KSL_MUL((double)B->yz, U_1)
          + KSL_MUL((double)B->xz, squares_1) + own_1,
      N_2 = KSL_MUL((double)B->xy, squares_2)
          + (KSL_MUL((double)B->yz, U_2) - KSL_MUL((double)B->xz, U_5)) + own_2;
  const double co_0 = ksl_product_sum((double)B->m, (double)ds->m0, KSL_MUL((double)B->h.x, U_0)
          + KSL_MUL((double)B->h.y, U_1) + KSL_MUL((double)B->h.z, U_2)),
      co_1 = ksl_product_sum((double)B->m, (double)ds->m1, KSL_MUL((double)B->h.x, U_3)
          + KSL_MUL((double)B->h.y, U_4) + KSL_MUL((double)B->h.z, U_5)),
      co_2 = ksl_product_sum((double)B->m, (double)ds->m2, KSL_MUL((double)B->h.x, U_6)
          + KSL_MUL((double)B->h.y, U_7) + KSL_MUL((double)B->h.z, U_8)),
      co_3 = ksl_product_sum(-(double)B->h.z, (double)ds->m1, (double)B->h.y * (double)ds->m2)
          + N_0,
      co_4 = ksl_product_sum(-(double)B->h.x, (double)ds->m2, (double)B->h.z * (double)ds->m0)
          + N_1,
      co_5 = ksl_product_sum(-(double)B->h.y, (double)ds->m0, (double)B->h.x * (double)ds->m1)
          + N_2;
  co->m0 = (float)co_0;
  co->m1 = (float)co_1;
  co->m2 = (float)co_2;
  co->m3 = (float)co_3;
  co->m4 = (float)co_4;
  co->m5 = (float)co_5;
}

/* Bo = B moved by t: m, h + m t, I - t~ (h + m t)~ - h~ t~.
   t: vector; B, Bo: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz,
     xy, xz, yz in kg m^2).
   18 mul, 18 add.
   Error <= u |result| + (m: 0, h: 1/16, I: 5/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_shifted_accurate(const ksl_vec3f_t *t,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const double mt_0 = (double)t->x * (double)B->m, mt_1 = (double)t->y * (double)B->m,
      mt_2 = (double)t->z * (double)B->m;
  const double half_0 = KSL_MUL(0.5, mt_0), half_1 = KSL_MUL(0.5, mt_1),
      half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = (double)B->h.x + half_0, n_1 = (double)B->h.y + half_1,
      n_2 = (double)B->h.z + half_2;
  const double tn0 = KSL_MUL((double)t->x, n_0);
  const double tn1 = KSL_MUL((double)t->y, n_1);
  const double tn2 = KSL_MUL((double)t->z, n_2);
  const double own_0 = KSL_MUL(2.0, tn0), own_1 = KSL_MUL(2.0, tn1), own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MUL((double)t->x, n_1) + KSL_MUL((double)t->y, n_0),
      pairs_4 = KSL_MUL((double)t->x, n_2) + KSL_MUL((double)t->z, n_0),
      pairs_5 = KSL_MUL((double)t->y, n_2) + KSL_MUL((double)t->z, n_1);
  const double moved_0 = (double)B->h.x + mt_0, moved_1 = (double)B->h.y + mt_1,
      moved_2 = (double)B->h.z + mt_2;
  const double Bo_4 = (double)B->xx + pairs_0, Bo_5 = (double)B->yy + pairs_1,
      Bo_6 = (double)B->zz + pairs_2, Bo_7 = (double)B->xy - pairs_3,
      Bo_8 = (double)B->xz - pairs_4, Bo_9 = (double)B->yz - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = (float)moved_0;
  Bo->h.y = (float)moved_1;
  Bo->h.z = (float)moved_2;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* Bo = [Ad]*(D) B [Ad]^-1(D): B, given in the frame at D, in the reference frame.
   D: displacement [R | t], R rotation, t in m; B, Bo: spatial inertia (m in kg; h = m c in kg m;
     I about the origin, xx, yy, zz, xy, xz, yz in kg m^2).
   72 mul, 54 add.
   Error <= u |result| + (m: 0, h: 1/8, I: 7/32) u^2 S, S the sum of the |terms| of the expanded
     formula; barring over- and underflow. */
static inline void ksl_spatial_inertiaf_transformed_accurate(const ksl_SE3f_t *D,
    const ksl_spatial_inertiaf_t *B, ksl_spatial_inertiaf_t *Bo) {
  const double RI_0 = ksl_product_sum((double)D->m02, (double)B->xz, ksl_product_sum((double)D->m01,
      (double)B->xy, (double)D->m00 * (double)B->xx)),
      RI_1 = ksl_product_sum((double)D->m02, (double)B->yz, ksl_product_sum((double)D->m01,
          (double)B->yy, (double)D->m00 * (double)B->xy)),
      RI_2 = ksl_product_sum((double)D->m02, (double)B->zz, ksl_product_sum((double)D->m01,
          (double)B->yz, (double)D->m00 * (double)B->xz)),
      RI_3 = ksl_product_sum((double)D->m12, (double)B->xz, ksl_product_sum((double)D->m11,
          (double)B->xy, (double)D->m10 * (double)B->xx)),
      RI_4 = ksl_product_sum((double)D->m12, (double)B->yz, ksl_product_sum((double)D->m11,
          (double)B->yy, (double)D->m10 * (double)B->xy)),
      RI_5 = ksl_product_sum((double)D->m12, (double)B->zz, ksl_product_sum((double)D->m11,
          (double)B->yz, (double)D->m10 * (double)B->xz)),
      RI_6 = ksl_product_sum((double)D->m22, (double)B->xz, ksl_product_sum((double)D->m21,
          (double)B->xy, (double)D->m20 * (double)B->xx)),
      RI_7 = ksl_product_sum((double)D->m22, (double)B->yz, ksl_product_sum((double)D->m21,
          (double)B->yy, (double)D->m20 * (double)B->xy)),
      RI_8 = ksl_product_sum((double)D->m22, (double)B->zz, ksl_product_sum((double)D->m21,
          (double)B->yz, (double)D->m20 * (double)B->xz));
  const double turned_1 = ksl_product_sum((double)D->m02, (double)B->h.z,
      ksl_product_sum((double)D->m01, (double)B->h.y, (double)D->m00 * (double)B->h.x)),
      turned_2 = ksl_product_sum((double)D->m12, (double)B->h.z, ksl_product_sum((double)D->m11,
          (double)B->h.y, (double)D->m10 * (double)B->h.x)),
      turned_3 = ksl_product_sum((double)D->m22, (double)B->h.z, ksl_product_sum((double)D->m21,
          (double)B->h.y, (double)D->m20 * (double)B->h.x)),
      turned_4 = KSL_MUL((double)D->m00, RI_0) + KSL_MUL((double)D->m01, RI_1)
          + KSL_MUL((double)D->m02, RI_2),
      turned_5 = KSL_MUL((double)D->m10, RI_3) + KSL_MUL((double)D->m11, RI_4)
          + KSL_MUL((double)D->m12, RI_5),
      turned_6 = KSL_MUL((double)D->m20, RI_6) + KSL_MUL((double)D->m21, RI_7)
          + KSL_MUL((double)D->m22, RI_8),
      turned_7 = KSL_MUL((double)D->m10, RI_0) + KSL_MUL((double)D->m11, RI_1)
          + KSL_MUL((double)D->m12, RI_2),
      turned_8 = KSL_MUL((double)D->m20, RI_0) + KSL_MUL((double)D->m21, RI_1)
          + KSL_MUL((double)D->m22, RI_2),
      turned_9 = KSL_MUL((double)D->m20, RI_3) + KSL_MUL((double)D->m21, RI_4)
          + KSL_MUL((double)D->m22, RI_5);
  const double mt_0 = (double)D->m03 * (double)B->m, mt_1 = (double)D->m13 * (double)B->m,
      mt_2 = (double)D->m23 * (double)B->m;
  const double half_0 = KSL_MUL(0.5, mt_0), half_1 = KSL_MUL(0.5, mt_1),
      half_2 = KSL_MUL(0.5, mt_2);
  const double n_0 = turned_1 + half_0, n_1 = turned_2 + half_1, n_2 = turned_3 + half_2;
  const double tn0 = KSL_MUL((double)D->m03, n_0);
  const double tn1 = KSL_MUL((double)D->m13, n_1);
  const double tn2 = KSL_MUL((double)D->m23, n_2);
  const double own_0 = KSL_MUL(2.0, tn0), own_1 = KSL_MUL(2.0, tn1), own_2 = KSL_MUL(2.0, tn2);
  const double pairs_0 = own_1 + own_2, pairs_1 = own_0 + own_2, pairs_2 = own_0 + own_1,
      pairs_3 = KSL_MUL((double)D->m03, n_1) + KSL_MUL((double)D->m13, n_0),
      pairs_4 = KSL_MUL((double)D->m03, n_2) + KSL_MUL((double)D->m23, n_0),
      pairs_5 = KSL_MUL((double)D->m13, n_2) + KSL_MUL((double)D->m23, n_1);
  const double moved_0 = turned_1 + mt_0, moved_1 = turned_2 + mt_1, moved_2 = turned_3 + mt_2;
  const double Bo_4 = turned_4 + pairs_0, Bo_5 = turned_5 + pairs_1, Bo_6 = turned_6 + pairs_2,
      Bo_7 = turned_7 - pairs_3, Bo_8 = turned_8 - pairs_4, Bo_9 = turned_9 - pairs_5;
  const float B_m = B->m;
  Bo->m = B_m;
  Bo->h.x = (float)moved_0;
  Bo->h.y = (float)moved_1;
  Bo->h.z = (float)moved_2;
  Bo->xx = (float)Bo_4;
  Bo->yy = (float)Bo_5;
  Bo->zz = (float)Bo_6;
  Bo->xy = (float)Bo_7;
  Bo->xz = (float)Bo_8;
  Bo->yz = (float)Bo_9;
}

/* the smallest pivot of [[m, h^T], [h, tr(I)/2 1 - I]], each divided by its diagonal entry:
     positive exactly if a body of positive density has this inertia.
   B: spatial inertia (m in kg; h = m c in kg m; I about the origin, xx, yy, zz, xy, xz, yz in kg
     m^2).
   11 mul, 15 add, 10 div, 3 neg, 9 less, 13 select. */
static inline float ksl_spatial_inertiaf_consistency_accurate(const ksl_spatial_inertiaf_t *B) {
  const double twice_trace = (double)B->xx + (double)B->yy + (double)B->zz;
  const double trace = KSL_MUL(0.5, twice_trace);
  const double sigma_0 = trace - (double)B->xx, sigma_1 = trace - (double)B->yy,
      sigma_2 = trace - (double)B->zz;
  const double divisor0 = 0.0 < (double)B->m ? (double)B->m : 1.0;
  const double l0_0 = (double)B->h.x / divisor0, l0_1 = (double)B->h.y / divisor0,
      l0_2 = (double)B->h.z / divisor0;
  const double u1_0 = sigma_0 - KSL_MUL((double)B->h.x, l0_0),
      u1_1 = -KSL_MUL((double)B->h.y, l0_0) - (double)B->xy,
      u1_2 = -KSL_MUL((double)B->h.z, l0_0) - (double)B->xz;
  const double divisor1 = 0.0 < u1_0 ? u1_0 : 1.0;
  const double l1_0 = u1_1 / divisor1, l1_1 = u1_2 / divisor1;
  const double u2_0 = sigma_1 - KSL_MUL((double)B->h.y, l0_1) - KSL_MUL(u1_1, l1_0),
      u2_1 = -KSL_MUL((double)B->h.z, l0_1) - (double)B->yz - KSL_MUL(u1_2, l1_0);
  const double divisor2 = 0.0 < u2_0 ? u2_0 : 1.0;
  const double l2 = u2_1 / divisor2;
  const double u3 = sigma_2 - KSL_MUL((double)B->h.z, l0_2) - KSL_MUL(u1_2, l1_1)
          - KSL_MUL(u2_1, l2);
  const double part0a = (double)B->m / divisor0, part0 = 0.0 < (double)B->m ? part0a : (double)B->m;
  const double own1 = 0.0 < sigma_0 ? sigma_0 : 1.0;
  const double part1a = u1_0 / own1, part1 = 0.0 < sigma_0 ? part1a : sigma_0;
  const double smallest1 = part0 < part1 ? part0 : part1;
  const double own2 = 0.0 < sigma_1 ? sigma_1 : 1.0;
  const double part2a = u2_0 / own2, part2 = 0.0 < sigma_1 ? part2a : sigma_1;
  const double smallest2 = smallest1 < part2 ? smallest1 : part2;
  const double own3 = 0.0 < sigma_2 ? sigma_2 : 1.0;
  const double part3a = u3 / own3, part3 = 0.0 < sigma_2 ? part3a : sigma_2;
  const double smallest3 = smallest2 < part3 ? smallest2 : part3;
  return (float)smallest3;
}

#endif
