/* A program as a user of the Kinematics Subroutine Library writes it; prints what it computes.

   R is no rotation: its entries are all different, to show which goes where, and small integers, so
   that nothing but the divisions by a norm is rounded, in either precision. */
#include <coscrew.h>
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

int main(void) {
  in_double();
  in_single();
  return 0;
}
