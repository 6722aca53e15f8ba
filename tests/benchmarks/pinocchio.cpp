// Pinocchio as a library of loops over states, compiled from its headers for this processor.
//
// It links nothing of Pinocchio's wheel, whose objects have Eigen's alignment of another processor.
#include "pinocchio_model.h"

#include <cstring>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

namespace {

using Row = Eigen::Map<const Eigen::VectorXd>;

struct Robot {
  pinocchio::Model model;
  pinocchio::Data data;
};

volatile double sink;

// call(model, data, q, v, a) for each of n states: rows of x[1], x[2], x[3].  Its matrices or vectors
// go to x[4], in Eigen's order, unless that is null.
template <typename Call>
void each(long n, void *const *x, Call call) {
  Robot &robot = *static_cast<Robot *>(x[0]);
  const long nq = robot.model.nq, nv = robot.model.nv;
  const double *q = static_cast<const double *>(x[1]), *v = static_cast<const double *>(x[2]),
               *a = static_cast<const double *>(x[3]);
  double *results = static_cast<double *>(x[4]);
  for (long i = 0; i < n; ++i, q += nq, v += nv, a += nv) {
    const auto &found = call(robot.model, robot.data, Row(q, nq), Row(v, nv), Row(a, nv));
    sink = found.data()[0];
    if (results) {
      std::memcpy(results, found.data(), sizeof(double) * static_cast<size_t>(found.size()));
      results += found.size();
    }
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

#define LOOP(name, call)                                                               \
  EXPORTED void name(long n, void *const *x) {                                         \
    each(n, x, [](const pinocchio::Model &model, pinocchio::Data &data, const Row &q,  \
        [[maybe_unused]] const Row &v, [[maybe_unused]] const Row &a) -> const auto & { \
      return call;                                                                     \
    });                                                                                \
  }

LOOP(inverse_dynamics, pinocchio::rnea(model, data, q, v, a))
LOOP(forward_dynamics, pinocchio::aba(model, data, q, v, a))
LOOP(mass_matrix, pinocchio::crba(model, data, q))
