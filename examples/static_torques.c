/* Static joint torques of a Franka Emika Panda that holds a payload: τ_i = h_i · Σ_{k>=i} c_k.

     D_i = D_{i-1} T_x(a_i) R_x(α_i) T_z(d_i) R_z(q_i)    frame of joint and link i in the base
     h_i = hsrz(D_i)                                      screw of the joint's axis
     c_k = CoAd(D_k r_k) (-(m_k g; 0))                    coscrew that supports the weight of link k

   all at the base's origin, where coscrews add.  τ_i is what motor i must supply to hold still, in
   N m.  examples/static_torques.py is the same program in Python, cites the data, and compares the
   results of both.

     cc -O2 -I generated/c/include examples/static_torques.c -lm */
#include <ksl/ksl.h>
#include <stdio.h>

enum { JOINTS = 7 };

/* Modified Denavit-Hartenberg parameters, mass and centre of mass in the link's frame; m, kg. */
typedef struct link_t {
  double a, d, alpha[2]; /* α as (sin α, cos α), exact */
  double mass, centre[3];
} link_t;

static const link_t LINKS[JOINTS] = {
  { +0.0000, 0.333, { +0, 1 }, 4.970684, { +0.003875, +0.002081, -0.047620 } },
  { +0.0000, 0.000, { -1, 0 }, 0.646926, { -0.003141, -0.028720, +0.003495 } },
  { +0.0000, 0.316, { +1, 0 }, 3.228604, { +0.027518, +0.039252, -0.066502 } },
  { +0.0825, 0.000, { +1, 0 }, 3.587895, { -0.053170, +0.104419, +0.027454 } },
  { -0.0825, 0.384, { -1, 0 }, 1.225946, { -0.011953, +0.041065, -0.038437 } },
  { +0.0000, 0.000, { +1, 0 }, 1.666555, { +0.060149, -0.014117, -0.010517 } },
  { +0.0880, 0.000, { +1, 0 }, 0.735522, { +0.010517, -0.004252, +0.061597 } },
};

static const double POSTURE[JOINTS] = { 0.3, -0.6, 0.4, -2.1, 0.5, 1.7, 0.8 }; /* q, in rad */
static const double GRAVITY[3] = { 0.0, 0.0, -9.81 }; /* g in the base's frame, in m/s² */
static const double FLANGE = 0.107; /* of the flange from joint 7, along its axis, in m */
static const double PAYLOAD_MASS = 3.0; /* in kg */
static const double PAYLOAD_CENTRE[3] = { 0.02, -0.01, 0.06 }; /* from the flange, in m */

/* c = CoAd(D r) (-(m g; 0)), r the centre of mass. */
static ksl_coscrew_t support(const ksl_SE3_t *D, const double mass, const double r[3]) {
  const ksl_vec3_t centre = ksl_vec3(r[0], r[1], r[2]), zero = ksl_vec3(0.0, 0.0, 0.0);
  const ksl_vec3_t g = ksl_vec3(GRAVITY[0], GRAVITY[1], GRAVITY[2]);
  ksl_vec3_t force, point;
  ksl_coscrew_t weight, c;
  ksl_product_av(mass, &g, &force);
  ksl_coscrew_from_lin_ang(&force, &zero, &weight);
  ksl_product_dv(D, &centre, &point);
  ksl_product_CoAdtcinv(&point, &weight, &c);
  return c;
}

static void static_torques(const double q[JOINTS], double tau[JOINTS]) {
  ksl_SE3_t frames[JOINTS], frame = ksl_SE3_identity();
  for (int i = 0; i < JOINTS; i++) {
    double dc[2];
    ksl_dc(q[i], dc);
    ksl_product_ddtx(&frame, LINKS[i].a, &frame);
    ksl_product_ddrx(&frame, LINKS[i].alpha, &frame);
    ksl_product_ddtz(&frame, LINKS[i].d, &frame);
    ksl_product_ddrz(&frame, dc, &frame);
    frames[i] = frame;
  }
  ksl_product_ddtz(&frame, FLANGE, &frame);
  ksl_coscrew_t load = support(&frame, PAYLOAD_MASS, PAYLOAD_CENTRE);
  for (int i = JOINTS - 1; i >= 0; i--) {
    const ksl_coscrew_t c = support(&frames[i], LINKS[i].mass, LINKS[i].centre);
    ksl_screw_t h;
    ksl_add_cc(&load, &c, &load);
    ksl_hsrz(&frames[i], &h);
    tau[i] = ksl_dot_cs(&load, &h);
  }
}

/* The same two functions in single precision; the data is rounded to it first. */
static ksl_coscrewf_t supportf(const ksl_SE3f_t *D, const float mass, const double r[3]) {
  const ksl_vec3f_t centre = ksl_vec3f((float)r[0], (float)r[1], (float)r[2]);
  const ksl_vec3f_t g = ksl_vec3f((float)GRAVITY[0], (float)GRAVITY[1], (float)GRAVITY[2]);
  const ksl_vec3f_t zero = ksl_vec3f(0.0f, 0.0f, 0.0f);
  ksl_vec3f_t force, point;
  ksl_coscrewf_t weight, c;
  ksl_product_avf(mass, &g, &force);
  ksl_coscrewf_from_lin_ang(&force, &zero, &weight);
  ksl_product_dvf(D, &centre, &point);
  ksl_product_CoAdtcinvf(&point, &weight, &c);
  return c;
}

static void static_torquesf(const float q[JOINTS], float tau[JOINTS]) {
  ksl_SE3f_t frames[JOINTS], frame = ksl_SE3f_identity();
  for (int i = 0; i < JOINTS; i++) {
    const float alpha[2] = { (float)LINKS[i].alpha[0], (float)LINKS[i].alpha[1] };
    float dc[2];
    ksl_dcf(q[i], dc);
    ksl_product_ddtxf(&frame, (float)LINKS[i].a, &frame);
    ksl_product_ddrxf(&frame, alpha, &frame);
    ksl_product_ddtzf(&frame, (float)LINKS[i].d, &frame);
    ksl_product_ddrzf(&frame, dc, &frame);
    frames[i] = frame;
  }
  ksl_product_ddtzf(&frame, (float)FLANGE, &frame);
  ksl_coscrewf_t load = supportf(&frame, (float)PAYLOAD_MASS, PAYLOAD_CENTRE);
  for (int i = JOINTS - 1; i >= 0; i--) {
    const ksl_coscrewf_t c = supportf(&frames[i], (float)LINKS[i].mass, LINKS[i].centre);
    ksl_screwf_t h;
    ksl_add_ccf(&load, &c, &load);
    ksl_hsrzf(&frames[i], &h);
    tau[i] = ksl_dot_csf(&load, &h);
  }
}

int main(void) {
  float qf[JOINTS], tauf[JOINTS];
  double tau[JOINTS];
  for (int i = 0; i < JOINTS; i++) {
    qf[i] = (float)POSTURE[i];
  }
  static_torques(POSTURE, tau);
  static_torquesf(qf, tauf);
  printf("# joint, torque in N m: double, single, both exact; double, single, in decimal\n");
  for (int i = 0; i < JOINTS; i++) {
    const double single = (double)tauf[i];
    printf("%d %a %a %.17g %.9g\n", i + 1, tau[i], single, tau[i], single);
  }
  return 0;
}
