/* A program as a user of the Kinematics Subroutine Library writes it; prints what it computes.

   R is no rotation: its entries are all different, to show which goes where, and small integers, so
   that nothing but the divisions by a norm is rounded, in either precision. */
#include <coscrew.h>
#include <inertia.h>
#include <quaternion.h>
#include <screw.h>
#include <trig.h>
#include <stdio.h>
#include <stdlib.h>

static void show(const char *what, const double *x, const int n) {
  printf("double %s", what);
  for (int i = 0; i < n; i++) { printf(" %a", x[i]); }
  printf("\n");
}

static void showf(const char *what, const float *x, const int n) {
  printf("single %s", what);
  for (int i = 0; i < n; i++) { printf(" %a", (double)x[i]); }
  printf("\n");
}

static void in_double(void) {
  const ksl_SE3_t D = ksl_SE3(1, 2, -3, 0.5, 4, 5, 6, -1.5, -7, 8, 9, 2.25);
  const ksl_SE3_t turn = ksl_SE3(0, 0, 1, 3, -1, 0, 0, 4, 0, -1, 0, 5);
  const ksl_mat3x3_t R = ksl_mat3x3(1, 2, -3, 4, 5, 6, -7, 8, 9);
  const ksl_vec3_t t = ksl_vec3(0.5, -1.5, 2.25);
  const ksl_screw_t s = ksl_screw(1.5, -2, 0.25, 3, -6, 2);
  const ksl_coscrew_t c = ksl_coscrew(2, -3, 6, 1, 4, -8), b = ksl_coscrew(-5, 7, 1, 0.5, 3, 2);
  const ksl_coscrew_t moment = ksl_coscrew(0, 0, 0, 1, 4, -8);
  const ksl_coscrew_t none = ksl_coscrew(0, 0, 0, 0, 0, 0);
  ksl_coscrew_t o, zeros, *sum = ksl_coscrew_alloc(3);
  ksl_screw_t r;
  ksl_vec3_t w;
  ksl_SE3_t E;
  double x[2];

  if (sum == NULL) { exit(1); }
  zeros = sum[2];
  show("coscrew_alloc", zeros.at, 6);
  for (int i = 0; i < 3; i++) { ksl_xpy_cc(&c, &sum[1]); }
  show("sum", sum[1].at, 6);
  free(sum);

  x[0] = c.lin.y; x[1] = c.ang.at[2];
  show("coscrew_parts", x, 2);
  x[0] = c.m1; x[1] = c.m5;
  show("coscrew_members", x, 2);
  x[0] = D.m12; x[1] = D.at[2][1];
  show("SE3_members", x, 2);
  x[0] = D.as_array[9]; x[1] = D.R.m20;
  show("SE3_array", x, 2);
  show("SE3_column", D.v1.at, 3);
  show("SE3_columns", D.v[3].at, 3);
  show("SE3_t", D.t.at, 3);
  show("mat3x3_as_array", R.as_array, 9);
  x[0] = R.at[2][0]; x[1] = R.v[1].z;
  show("mat3x3_members", x, 2);
  show("mat3x3_column", R.v2.at, 3);

  ksl_coscrew_copy(&c, &o); show("coscrew_copy", o.at, 6);
  ksl_coscrew_scale(&o, 2.5); show("coscrew_scale", o.at, 6);
  ksl_coscrew_inverted(&c, &o); show("coscrew_inverted", o.at, 6);
  o = b; ksl_coscrew_invert(&o); show("coscrew_invert", o.at, 6);
  o = b; ksl_axpy_cc(2.5, &c, &o); show("axpy_cc", o.at, 6);
  o = b; ksl_xpy_cc(&c, &o); show("xpy_cc", o.at, 6);
  o = b; ksl_nxpy_cc(&c, &o); show("nxpy_cc", o.at, 6);
  ksl_product_ac(2.5, &c, &o); show("product_ac", o.at, 6);
  ksl_add_cc(&c, &b, &o); show("add_cc", o.at, 6);
  ksl_subtract_cc(&c, &b, &o); show("subtract_cc", o.at, 6);
  ksl_cross_sc(&s, &c, &o); show("cross_sc", o.at, 6);
  ksl_product_CoAdtc(&t, &c, &o); show("product_CoAdtc", o.at, 6);
  ksl_product_CoAdtcinv(&t, &c, &o); show("product_CoAdtcinv", o.at, 6);
  ksl_product_CoAdrc(&R, &c, &o); show("product_CoAdrc", o.at, 6);
  ksl_product_CoAdrinvc(&R, &c, &o); show("product_CoAdrinvc", o.at, 6);
  ksl_product_CoAdc(&D, &c, &o); show("product_CoAdc", o.at, 6);
  ksl_product_CoAdinvc(&D, &c, &o); show("product_CoAdinvc", o.at, 6);
  ksl_product_CoAdc(&turn, &c, &o); ksl_product_CoAdinvc(&turn, &o, &o);
  show("there_and_back", o.at, 6);

  ksl_add_cct(&c, &b, &o); show("add_cct", o.at, 6);
  ksl_cross_sca(&s, &c, &o); show("cross_sca", o.at, 6);
  ksl_product_CoAdtinvc(&t, &c, &o); show("product_CoAdtinvc", o.at, 6);
  ksl_product_CoAdrcinv(&R, &c, &o); show("product_CoAdrcinv", o.at, 6);
  ksl_product_CoAdcinv(&D, &c, &o); show("product_CoAdcinv", o.at, 6);
  ksl_hcty(&D, &o); show("hcty", o.at, 6);
  ksl_hcrzinv(&D, &o); show("hcrzinv", o.at, 6);
  x[0] = ksl_coscrew_norm(&c); x[1] = ksl_coscrew_norm(&moment);
  show("coscrew_norm", x, 2);
  o = c; ksl_coscrew_normalize(&o); show("coscrew_normalize", o.at, 6);
  o = none; ksl_coscrew_normalize(&o); show("coscrew_normalize_zero", o.at, 6);

  ksl_product_Ads(&D, &s, &r); show("product_Ads", r.at, 6);
  ksl_product_Adinvs(&D, &s, &r); show("product_Adinvs", r.at, 6);
  ksl_cross_ss(&s, &s, &r); show("cross_ss", r.at, 6);
  ksl_hsrx(&D, &r); show("hsrx", r.at, 6);
  ksl_hsra(&D, &t, &r); show("hsra", r.at, 6);
  x[0] = ksl_dot_cs(&c, &s); x[1] = ksl_screw_norm(&s);
  show("dot_cs_and_screw_norm", x, 2);
  ksl_product_drv(&R, &t, &w); show("product_drv", w.at, 3);
  ksl_product_dv(&D, &s.lin, &w); show("product_dv", w.at, 3);
  ksl_cross_vv(&c.lin, &s.ang, &w); show("cross_vv", w.at, 3);
  ksl_product_dd(&D, &turn, &E); show("product_dd", E.as_array, 12);
  ksl_product_ddinv(&D, &turn, &E); show("product_ddinv", E.as_array, 12);
  ksl_dc(0.5, x); show("dc", x, 2);
}

static void turns_in_double(void) {
  const ksl_quaternion_t p = ksl_quaternion(1, -2, 0.5, 3), q = ksl_quaternion(-4, 0.25, 2, 1);
  const ksl_quaternion_t third = ksl_quaternion(0.5, 0.5, 0.5, 0.5);
  const ksl_vec3_t v = ksl_vec3(0.5, -1.5, 2.25);
  ksl_quaternion_t o, corners[4], *ones = ksl_quaternion_alloc(2);
  ksl_mat3x3_t R;
  double x[2], dci[2] = {0.5, -2}, t;

  if (ones == NULL) { exit(1); }
  o = ones[1];
  show("quaternion_alloc", o.at, 4);
  free(ones);
  x[0] = p.w; x[1] = p.at[2];
  show("quaternion_members", x, 2);
  show("quaternion_r", p.r.at, 3);
  x[0] = ksl_dot_qq(&p, &q); x[1] = 0;
  show("dot_qq", x, 2);
  o = q; ksl_axpy_qq(2.5, &p, &o); show("axpy_qq", o.at, 4);
  o = ksl_quaternion(2, 4, -4, 8); ksl_quaternion_normalize(&o); show("quaternion_normalize", o.at, 4);
  ksl_quaternion_product_qq(&p, &q, &o); show("product_qq", o.at, 4);
  ksl_quaternion_product_qconjq(&p, &q, &o); show("product_qconjq", o.at, 4);
  ksl_quaternion_product_qqconj(&p, &q, &o); show("product_qqconj", o.at, 4);
  ksl_quaternion_product_qconjqconj(&p, &q, &o); show("product_qconjqconj", o.at, 4);
  ksl_quaternion_product_qxq(dci, &q, &o); show("product_qxq", o.at, 4);
  ksl_quaternion_product_qqyconj(&p, dci, &o); show("product_qqyconj", o.at, 4);
  ksl_quaternion_product_qzconjqconj(dci, &q, &o); show("product_qzconjqconj", o.at, 4);
  ksl_quaternion_product_qconjqx(&p, dci, &o); show("product_qconjqx", o.at, 4);
  ksl_quaternion_product_qv(&p, &v, &o); show("product_qv", o.at, 4);
  ksl_quaternion_product_vqconj(&v, &p, &o); show("product_vqconj", o.at, 4);
  o = p; ksl_add_dpiToq(&v, &o); show("add_dpiToq", o.at, 4);
  o = p; ksl_subtract_dpiFromq(&v, &o); show("subtract_dpiFromq", o.at, 4);
  ksl_omega_to_dquaternion(&v, &third, &o); show("omega_to_dquaternion", o.at, 4);
  o = third; ksl_quaternion_toMat3x3(&o, &R); show("quaternion_toMat3x3", R.as_array, 9);
  ksl_mat3x3_toQuaternion(&R, &o); show("mat3x3_toQuaternion", o.at, 4);
  corners[0] = third; corners[1] = q;
  ksl_quaternion_product_uqinverseq(&corners[0], &corners[1], &o);
  show("product_uqinverseq", o.at, 4);
  t = 0.5;
  corners[0] = ksl_quaternion(0, 0, 0, 1); corners[1] = ksl_quaternion(0, 0, 1, 0);
  corners[2] = corners[1]; corners[3] = corners[0];
  ksl_quaternion_slerp(&corners[0], &corners[1], &t, &o); show("slerp", o.at, 4);
  ksl_quaternion_nlerp(&corners[0], &corners[1], &t, &o); show("nlerp", o.at, 4);
  ksl_quaternion_squad(corners, &t, &o); show("squad", o.at, 4);
}

static void bodies_in_double(void) {
  const ksl_vec3_t t = ksl_vec3(0.5, -1.5, 2.25), i = ksl_vec3(1, -0.5, 2), j = ksl_vec3(-2, 0.25, 1);
  const ksl_mat3x3_t R = ksl_mat3x3(1, 2, -3, 4, 5, 6, -7, 8, 9);
  const ksl_SE3_t D = ksl_SE3(1, 2, -3, 0.5, 4, 5, 6, -1.5, -7, 8, 9, 2.25);
  const ksl_inertia_t J = ksl_inertia(2, i, 5, 6, 7, 0.5, 0.25, -0.125);
  const ksl_inertia_t other = ksl_inertia(6, j, 3, 2, 4, -0.5, 0.125, 1);
  ksl_inertia_t o, *none = ksl_inertia_alloc(2);
  double x[2];

  if (none == NULL) { exit(1); }
  o = none[1];
  show("inertia_alloc", o.at, 10);
  free(none);
  show("inertia", J.at, 10);
  x[0] = J.mass; x[1] = J.mr.z;
  show("inertia_names", x, 2);
  x[0] = J.Iyx; x[1] = J.Izy;
  show("inertia_products", x, 2);
  x[0] = J.Ixz; x[1] = J.Iyy;
  show("inertia_moments", x, 2);
  ksl_inertia_copy(&J, &o); show("inertia_copy", o.at, 10);
  ksl_inertia_rotated(&J, &R, &o); show("inertia_rotated", o.at, 10);
  o = J; ksl_inertia_rotate(&o, &R); show("inertia_rotate", o.at, 10);
  ksl_inertia_translated(&J, &t, &o); show("inertia_translated", o.at, 10);
  o = J; ksl_inertia_translate(&o, &t); show("inertia_translate", o.at, 10);
  ksl_inertia_transformed(&J, &D, &o); show("inertia_transformed", o.at, 10);
  o = J; ksl_inertia_transform(&o, &D); show("inertia_transform", o.at, 10);
  o = J; ksl_inertia_merge(&o, &i, &other, &j, &D); show("inertia_merge", o.at, 10);
  o = ksl_inertia(2, i, 4, 9, 16, 0, 0, 0);
  x[0] = ksl_inertia_factor(&o);
  o = ksl_inertia(2, i, 0, 9, 9, 0, 0, 0);
  x[1] = ksl_inertia_factor(&o);
  show("inertia_factor", x, 2);
}

static void in_single(void) {
  const ksl_SE3f_t D = ksl_SE3f(1, 2, -3, 0.5f, 4, 5, 6, -1.5f, -7, 8, 9, 2.25f);
  const ksl_SE3f_t turn = ksl_SE3f(0, 0, 1, 3, -1, 0, 0, 4, 0, -1, 0, 5);
  const ksl_mat3x3f_t R = ksl_mat3x3f(1, 2, -3, 4, 5, 6, -7, 8, 9);
  const ksl_vec3f_t t = ksl_vec3f(0.5f, -1.5f, 2.25f);
  const ksl_screwf_t s = ksl_screwf(1.5f, -2, 0.25f, 3, -6, 2);
  const ksl_coscrewf_t c = ksl_coscrewf(2, -3, 6, 1, 4, -8), b = ksl_coscrewf(-5, 7, 1, 0.5f, 3, 2);
  const ksl_coscrewf_t moment = ksl_coscrewf(0, 0, 0, 1, 4, -8);
  const ksl_coscrewf_t none = ksl_coscrewf(0, 0, 0, 0, 0, 0);
  ksl_coscrewf_t o, zeros, *sum = ksl_coscrewf_alloc(3);
  ksl_screwf_t r;
  ksl_vec3f_t w;
  ksl_SE3f_t E;
  float x[2];

  if (sum == NULL) { exit(1); }
  zeros = sum[2];
  showf("coscrew_alloc", zeros.at, 6);
  for (int i = 0; i < 3; i++) { ksl_xpy_ccf(&c, &sum[1]); }
  showf("sum", sum[1].at, 6);
  free(sum);

  x[0] = c.lin.y; x[1] = c.ang.at[2];
  showf("coscrew_parts", x, 2);
  x[0] = c.m1; x[1] = c.m5;
  showf("coscrew_members", x, 2);
  x[0] = D.m12; x[1] = D.at[2][1];
  showf("SE3_members", x, 2);
  x[0] = D.as_array[9]; x[1] = D.R.m20;
  showf("SE3_array", x, 2);
  showf("SE3_column", D.v1.at, 3);
  showf("SE3_columns", D.v[3].at, 3);
  showf("SE3_t", D.t.at, 3);
  showf("mat3x3_as_array", R.as_array, 9);
  x[0] = R.at[2][0]; x[1] = R.v[1].z;
  showf("mat3x3_members", x, 2);
  showf("mat3x3_column", R.v2.at, 3);

  ksl_coscrewf_copy(&c, &o); showf("coscrew_copy", o.at, 6);
  ksl_coscrewf_scale(&o, 2.5f); showf("coscrew_scale", o.at, 6);
  ksl_coscrewf_inverted(&c, &o); showf("coscrew_inverted", o.at, 6);
  o = b; ksl_coscrewf_invert(&o); showf("coscrew_invert", o.at, 6);
  o = b; ksl_axpy_ccf(2.5f, &c, &o); showf("axpy_cc", o.at, 6);
  o = b; ksl_xpy_ccf(&c, &o); showf("xpy_cc", o.at, 6);
  o = b; ksl_nxpy_ccf(&c, &o); showf("nxpy_cc", o.at, 6);
  ksl_product_acf(2.5f, &c, &o); showf("product_ac", o.at, 6);
  ksl_add_ccf(&c, &b, &o); showf("add_cc", o.at, 6);
  ksl_subtract_ccf(&c, &b, &o); showf("subtract_cc", o.at, 6);
  ksl_cross_scf(&s, &c, &o); showf("cross_sc", o.at, 6);
  ksl_product_CoAdtcf(&t, &c, &o); showf("product_CoAdtc", o.at, 6);
  ksl_product_CoAdtcinvf(&t, &c, &o); showf("product_CoAdtcinv", o.at, 6);
  ksl_product_CoAdrcf(&R, &c, &o); showf("product_CoAdrc", o.at, 6);
  ksl_product_CoAdrinvcf(&R, &c, &o); showf("product_CoAdrinvc", o.at, 6);
  ksl_product_CoAdcf(&D, &c, &o); showf("product_CoAdc", o.at, 6);
  ksl_product_CoAdinvcf(&D, &c, &o); showf("product_CoAdinvc", o.at, 6);
  ksl_product_CoAdcf(&turn, &c, &o); ksl_product_CoAdinvcf(&turn, &o, &o);
  showf("there_and_back", o.at, 6);

  ksl_add_cctf(&c, &b, &o); showf("add_cct", o.at, 6);
  ksl_cross_scaf(&s, &c, &o); showf("cross_sca", o.at, 6);
  ksl_product_CoAdtinvcf(&t, &c, &o); showf("product_CoAdtinvc", o.at, 6);
  ksl_product_CoAdrcinvf(&R, &c, &o); showf("product_CoAdrcinv", o.at, 6);
  ksl_product_CoAdcinvf(&D, &c, &o); showf("product_CoAdcinv", o.at, 6);
  ksl_hctyf(&D, &o); showf("hcty", o.at, 6);
  ksl_hcrzinvf(&D, &o); showf("hcrzinv", o.at, 6);
  x[0] = ksl_coscrewf_norm(&c); x[1] = ksl_coscrewf_norm(&moment);
  showf("coscrew_norm", x, 2);
  o = c; ksl_coscrewf_normalize(&o); showf("coscrew_normalize", o.at, 6);
  o = none; ksl_coscrewf_normalize(&o); showf("coscrew_normalize_zero", o.at, 6);

  ksl_product_Adsf(&D, &s, &r); showf("product_Ads", r.at, 6);
  ksl_product_Adinvsf(&D, &s, &r); showf("product_Adinvs", r.at, 6);
  ksl_cross_ssf(&s, &s, &r); showf("cross_ss", r.at, 6);
  ksl_hsrxf(&D, &r); showf("hsrx", r.at, 6);
  ksl_hsraf(&D, &t, &r); showf("hsra", r.at, 6);
  x[0] = ksl_dot_csf(&c, &s); x[1] = ksl_screwf_norm(&s);
  showf("dot_cs_and_screw_norm", x, 2);
  ksl_product_drvf(&R, &t, &w); showf("product_drv", w.at, 3);
  ksl_product_dvf(&D, &s.lin, &w); showf("product_dv", w.at, 3);
  ksl_cross_vvf(&c.lin, &s.ang, &w); showf("cross_vv", w.at, 3);
  ksl_product_ddf(&D, &turn, &E); showf("product_dd", E.as_array, 12);
  ksl_product_ddinvf(&D, &turn, &E); showf("product_ddinv", E.as_array, 12);
  ksl_dcf(0.5f, x); showf("dc", x, 2);
}

static void turns_in_single(void) {
  const ksl_quaternionf_t p = ksl_quaternionf(1, -2, 0.5f, 3), q = ksl_quaternionf(-4, 0.25f, 2, 1);
  const ksl_quaternionf_t third = ksl_quaternionf(0.5f, 0.5f, 0.5f, 0.5f);
  const ksl_vec3f_t v = ksl_vec3f(0.5f, -1.5f, 2.25f);
  ksl_quaternionf_t o, corners[4], *ones = ksl_quaternionf_alloc(2);
  ksl_mat3x3f_t R;
  float x[2], dci[2] = {0.5f, -2}, t;

  if (ones == NULL) { exit(1); }
  o = ones[1];
  showf("quaternion_alloc", o.at, 4);
  free(ones);
  x[0] = p.w; x[1] = p.at[2];
  showf("quaternion_members", x, 2);
  showf("quaternion_r", p.r.at, 3);
  x[0] = ksl_dot_qqf(&p, &q); x[1] = 0;
  showf("dot_qq", x, 2);
  o = q; ksl_axpy_qqf(2.5f, &p, &o); showf("axpy_qq", o.at, 4);
  o = ksl_quaternionf(2, 4, -4, 8); ksl_quaternionf_normalize(&o); showf("quaternion_normalize", o.at, 4);
  ksl_product_qqf(&p, &q, &o); showf("product_qq", o.at, 4);
  ksl_product_qconjqf(&p, &q, &o); showf("product_qconjq", o.at, 4);
  ksl_product_qqconjf(&p, &q, &o); showf("product_qqconj", o.at, 4);
  ksl_product_qconjqconjf(&p, &q, &o); showf("product_qconjqconj", o.at, 4);
  ksl_product_qxqf(dci, &q, &o); showf("product_qxq", o.at, 4);
  ksl_product_qqyconjf(&p, dci, &o); showf("product_qqyconj", o.at, 4);
  ksl_product_qzconjqconjf(dci, &q, &o); showf("product_qzconjqconj", o.at, 4);
  ksl_product_qconjqxf(&p, dci, &o); showf("product_qconjqx", o.at, 4);
  ksl_product_qvf(&p, &v, &o); showf("product_qv", o.at, 4);
  ksl_product_vqconjf(&v, &p, &o); showf("product_vqconj", o.at, 4);
  o = p; ksl_add_dpiToqf(&v, &o); showf("add_dpiToq", o.at, 4);
  o = p; ksl_subtract_dpiFromqf(&v, &o); showf("subtract_dpiFromq", o.at, 4);
  ksl_omega_to_dquaternionf(&v, &third, &o); showf("omega_to_dquaternion", o.at, 4);
  o = third; ksl_quaternionf_toMat3x3f(&o, &R); showf("quaternion_toMat3x3", R.as_array, 9);
  ksl_mat3x3f_toQuaternion(&R, &o); showf("mat3x3_toQuaternion", o.at, 4);
  corners[0] = third; corners[1] = q;
  ksl_product_uqinverseqf(&corners[0], &corners[1], &o);
  showf("product_uqinverseq", o.at, 4);
  t = 0.5f;
  corners[0] = ksl_quaternionf(0, 0, 0, 1); corners[1] = ksl_quaternionf(0, 0, 1, 0);
  corners[2] = corners[1]; corners[3] = corners[0];
  ksl_slerpf(&corners[0], &corners[1], &t, &o); showf("slerp", o.at, 4);
  ksl_nlerpf(&corners[0], &corners[1], &t, &o); showf("nlerp", o.at, 4);
  ksl_squadf(corners, &t, &o); showf("squad", o.at, 4);
}

static void bodies_in_single(void) {
  const ksl_vec3f_t t = ksl_vec3f(0.5f, -1.5f, 2.25f), i = ksl_vec3f(1, -0.5f, 2), j = ksl_vec3f(-2, 0.25f, 1);
  const ksl_mat3x3f_t R = ksl_mat3x3f(1, 2, -3, 4, 5, 6, -7, 8, 9);
  const ksl_SE3f_t D = ksl_SE3f(1, 2, -3, 0.5f, 4, 5, 6, -1.5f, -7, 8, 9, 2.25f);
  const ksl_inertiaf_t J = ksl_inertiaf(2, i, 5, 6, 7, 0.5f, 0.25f, -0.125f);
  const ksl_inertiaf_t other = ksl_inertiaf(6, j, 3, 2, 4, -0.5f, 0.125f, 1);
  ksl_inertiaf_t o, *none = ksl_inertiaf_alloc(2);
  float x[2];

  if (none == NULL) { exit(1); }
  o = none[1];
  showf("inertia_alloc", o.at, 10);
  free(none);
  showf("inertia", J.at, 10);
  x[0] = J.mass; x[1] = J.mr.z;
  showf("inertia_names", x, 2);
  x[0] = J.Iyx; x[1] = J.Izy;
  showf("inertia_products", x, 2);
  x[0] = J.Ixz; x[1] = J.Iyy;
  showf("inertia_moments", x, 2);
  ksl_inertiaf_copy(&J, &o); showf("inertia_copy", o.at, 10);
  ksl_inertiaf_rotated(&J, &R, &o); showf("inertia_rotated", o.at, 10);
  o = J; ksl_inertiaf_rotate(&o, &R); showf("inertia_rotate", o.at, 10);
  ksl_inertiaf_translated(&J, &t, &o); showf("inertia_translated", o.at, 10);
  o = J; ksl_inertiaf_translate(&o, &t); showf("inertia_translate", o.at, 10);
  ksl_inertiaf_transformed(&J, &D, &o); showf("inertia_transformed", o.at, 10);
  o = J; ksl_inertiaf_transform(&o, &D); showf("inertia_transform", o.at, 10);
  o = J; ksl_inertiaf_merge(&o, &i, &other, &j, &D); showf("inertia_merge", o.at, 10);
  o = ksl_inertiaf(2, i, 4, 9, 16, 0, 0, 0);
  x[0] = (float)ksl_inertiaf_factor(&o);
  o = ksl_inertiaf(2, i, 0, 9, 9, 0, 0, 0);
  x[1] = (float)ksl_inertiaf_factor(&o);
  showf("inertia_factor", x, 2);
}

int main(void) {
  in_double();
  turns_in_double();
  bodies_in_double();
  in_single();
  turns_in_single();
  bodies_in_single();
  return 0;
}
