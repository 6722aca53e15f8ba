/* Model-predictive control of a six-joint arm within its motors' torques, each millisecond anew.

     minimise  Σ (x - aim)^T Q (x - aim)/2 + R |u - hold|²/2    over N steps of H, x = (q, v)
     with      x' = step(x, u),  |u| <= LIMIT,  from the measured x

   The generated step and its derivatives A, B are taken along the last plan.  ADMM solves the
   quadratic problem about it, as TinyMPC does: a Riccati recursion gives a plan, z is the one within
   limits, y drives them together.  Inputs, columns b of B, are eliminated one by one, so that no
   matrix is inverted: x' = A x, then x' += b u for each.  predictive.py compiles and draws this. */
#include "arm.h"
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { M = ARM_NV, X = 2 * M, N = 15, PASSES = 10, TICKS = 1500 };
static const double H = 0.02, TICK = 1e-3, RHO = 1e-3, R = 1e-4;
static const double LIMIT[M] = { 150, 150, 150, 28, 28, 28 }; /* N m */
static const double aim[X] = { 1.6, -0.3, 0.4, -0.1, 0.3, 1 };
static double hold[M]; /* torques at rest there */

static double x[N + 1][X], u[N][M], z[N][M], y[N][M], A[N][X * X], B[N][X * M];
static double K[N][M][X], S[N][M]; /* u = -K x - d; curvature along u */

static double Q(int k, int i) { return (i < M ? 10.0 : 0.1) * (k == N ? 20 : 1); }

static double dot(const double a[X], const double *b, int stride) {
  double sum = 0;
  for (int i = 0; i < X; i++) sum += a[i] * b[i * stride];
  return sum;
}

/* The states that follow the plan from x[0], with derivatives, and the gains about them. */
static void linearize(void) {
  double P[X][X] = { { 0 } }, AP[X][X];
  for (int k = 0; k < N; k++)
    arm_step_leapfrog_tau_derivatives(H, x[k], x[k] + M, u[k], x[k + 1], x[k + 1] + M, A[k], B[k]);
  for (int i = 0; i < X; i++) P[i][i] = Q(N, i);
  for (int k = N - 1; k >= 0; k--) {
    for (int m = 0; m < M; m++) {
      for (int i = 0; i < X; i++) K[k][m][i] = dot(P[i], B[k] + m, M);
      S[k][m] = R + RHO + dot(K[k][m], B[k] + m, M);
      for (int i = 0; i < X; i++)
        for (int j = 0; j < X; j++) P[i][j] -= K[k][m][i] * K[k][m][j] / S[k][m];
      for (int i = 0; i < X; i++) K[k][m][i] /= S[k][m];
    }
    for (int i = 0; i < X; i++)
      for (int j = 0; j < X; j++) AP[j][i] = dot(P[i], A[k] + j, X);
    for (int i = 0; i < X; i++)
      for (int j = 0; j < X; j++) P[i][j] = dot(AP[i], A[k] + j, X) + (i == j ? Q(k, i) : 0);
  }
}

/* A pass of ADMM. */
static void improve(void) {
  double p[X], above[X], d[N][M], dx[X] = { 0 };
  for (int i = 0; i < X; i++) p[i] = Q(N, i) * (x[N][i] - aim[i]);
  for (int k = N - 1; k >= 0; k--) {
    for (int m = 0; m < M; m++) {
      const double r = dot(p, B[k] + m, M) + R * (u[k][m] - hold[m])
          + RHO * (u[k][m] - z[k][m] + y[k][m]);
      d[k][m] = r / S[k][m];
      for (int i = 0; i < X; i++) p[i] -= K[k][m][i] * r;
    }
    for (int i = 0; i < X; i++) above[i] = dot(p, A[k] + i, X) + Q(k, i) * (x[k][i] - aim[i]);
    memcpy(p, above, sizeof p);
  }
  for (int k = 0; k < N; k++) {
    double next[X];
    for (int i = 0; i < X; i++) next[i] = dot(dx, A[k] + X * i, 1);
    for (int m = M - 1; m >= 0; m--) {
      const double du = -dot(next, K[k][m], 1) - d[k][m], to = u[k][m] + du + y[k][m];
      for (int i = 0; i < X; i++) next[i] += B[k][M * i + m] * du;
      z[k][m] = to > LIMIT[m] ? LIMIT[m] : to < -LIMIT[m] ? -LIMIT[m] : to;
      y[k][m] = to - z[k][m];
    }
    memcpy(dx, next, sizeof dx);
  }
}

/* Prints t, q, the torques and the controller's processor time in µs of each tick. */
int main(void) {
  const double still[M] = { 0 };
  double q[M] = { 0, -1.1, 1.6, -0.5, 0, 0 }, v[M] = { 0 };
  arm_inverse_dynamics(aim, still, still, hold);
  for (int tick = 0; tick < TICKS; tick++) {
    const clock_t start = clock();
    memcpy(x[0], q, sizeof q), memcpy(x[0] + M, v, sizeof v);
    linearize();
    for (int pass = 0; pass < PASSES; pass++) improve();
    memcpy(u, z, sizeof u);
    const double us = 1e6 * (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%g", tick * TICK);
    for (int i = 0; i < M; i++) printf(" %.9g", q[i]);
    for (int i = 0; i < M; i++) printf(" %.9g", u[0][i]);
    printf(" %g\n", us);
    arm_step_leapfrog_tau(TICK, q, v, u[0]);
  }
  return 0;
}
