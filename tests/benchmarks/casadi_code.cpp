// C of Pinocchio's functions of a robot, written by CasADi.
#include <pinocchio/fwd.hpp>  // first: it sets limits of Boost

#include <cstdio>
#include <exception>

#include <pinocchio/autodiff/casadi.hpp>

#include "pinocchio_model.h"

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

using casadi::SX;
using Vector = Eigen::Matrix<SX, Eigen::Dynamic, 1>;

static Vector copied(const SX &x) {
  Vector found(x.size1());
  pinocchio::casadi::copy(x, found);
  return found;
}

template <typename Matrix>
SX copied(const Eigen::MatrixBase<Matrix> &x) {
  SX found(x.rows(), x.cols());
  pinocchio::casadi::copy(x, found);
  return found;
}

// Writes casadi.c to a folder, whose name ends in a slash, for a robot as model_of takes it.  Returns
// 0, or 1 if CasADi throws what it prints.
extern "C" __attribute__((visibility("default"))) int write_c(const char *folder, long joints,
    const int *kinds, const int *parents, const double *placements, const double *inertias) try {
  const auto model = model_of(joints, kinds, parents, placements, inertias).cast<SX>();
  pinocchio::DataTpl<SX> data(model);
  const SX q = SX::sym("q", model.nq), v = SX::sym("v", model.nv), a = SX::sym("a", model.nv);
  const SX tau = copied(pinocchio::rnea(model, data, copied(q), copied(v), copied(a)));
  const SX ddq = copied(pinocchio::aba(model, data, copied(q), copied(v), copied(a)));
  const SX M = SX::triu2symm(SX::triu(copied(pinocchio::crba(model, data, copied(q)))));
  casadi::CodeGenerator made("casadi.c");
  made.add(casadi::Function("inverse_dynamics", {q, v, a}, {tau}));
  made.add(casadi::Function("forward_dynamics", {q, v, a}, {ddq}));
  made.add(casadi::Function("mass_matrix", {q}, {M}));
  made.generate(folder);
  return 0;
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
