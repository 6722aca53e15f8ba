// Pinocchio as a library of loops over states, compiled from its headers for this processor.
//
// It links nothing of Pinocchio's wheel, whose objects have Eigen's alignment of another processor.
#include "pinocchio_model.h"

#include <tuple>

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

namespace {

using Row = Eigen::Map<const Eigen::VectorXd>;

struct Robot {
  pinocchio::Model model;
  pinocchio::Data data;
};

volatile double sink;

// Copies a matrix or vector row by row; returns the place after it.
template <typename Matrix>
double *copied(const Matrix &x, double *to) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Rows>(to, x.rows(), x.cols()) = x;
  return to + x.size();
}

// call(model, data, q, v, a) for each of n states: rows of x[1], x[2], x[3].  The matrices or vectors
// results(data) go to x[4], unless that is null.
template <typename Call, typename Results>
void each(long n, void *const *x, Call call, Results results) {
  Robot &robot = *static_cast<Robot *>(x[0]);
  const long nq = robot.model.nq, nv = robot.model.nv;
  const double *q = static_cast<const double *>(x[1]), *v = static_cast<const double *>(x[2]),
               *a = static_cast<const double *>(x[3]);
  double *to = static_cast<double *>(x[4]);
  for (long i = 0; i < n; ++i, q += nq, v += nv, a += nv) {
    call(robot.model, robot.data, Row(q, nq), Row(v, nv), Row(a, nv));
    std::apply([&to](const auto &...found) {
      ((sink = found.data()[0]), ...);
      if (to) ((to = copied(found, to)), ...);
    }, results(robot.data));
  }
}

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

// A robot of joints, as model_of takes them.
EXPORTED void *robot_of(long joints, const int *kinds, const int *parents,
    const double *placements, const double *inertias) {
  const pinocchio::Model model = model_of(joints, kinds, parents, placements, inertias);
  return new Robot{model, pinocchio::Data(model)};
}

#define LOOP(name, call, ...)                                                      \
  EXPORTED void name(long n, void *const *x) {                                         \
    each(n, x, [](const pinocchio::Model &model, pinocchio::Data &data, const Row &q,  \
        [[maybe_unused]] const Row &v, [[maybe_unused]] const Row &a) { call; },       \
        [](const pinocchio::Data &data) { return std::tie(__VA_ARGS__); });            \
  }

LOOP(inverse_dynamics, pinocchio::rnea(model, data, q, v, a), data.tau)
LOOP(forward_dynamics, pinocchio::aba(model, data, q, v, a), data.ddq)
LOOP(mass_matrix, pinocchio::crba(model, data, q), data.M)
LOOP(inverse_dynamics_derivatives, pinocchio::computeRNEADerivatives(model, data, q, v, a),
    data.dtau_dq, data.dtau_dv, data.M)
LOOP(forward_dynamics_derivatives, pinocchio::computeABADerivatives(model, data, q, v, a),
    data.ddq_dq, data.ddq_dv, data.Minv)
