// C of Pinocchio's functions of a robot, written by CasADi.
#include <pinocchio/fwd.hpp>  // first: it sets limits of Boost

#include <cstdio>
#include <exception>

#include <pinocchio/autodiff/casadi.hpp>

#include "pinocchio_model.h"

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
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

using Data = pinocchio::DataTpl<SX>;

static SX symmetric(const SX &x) { return SX::triu2symm(SX::triu(x)); }

// Matrices with all their entries, which are written row by row.
static std::vector<SX> by_rows(std::vector<SX> matrices) {
  for (SX &x : matrices) x = SX::densify(x.T());
  return matrices;
}

// Writes casadi.c to a folder, whose name ends in a slash, for a robot as model_of takes it: its
// dynamics; or, with derivatives 1, their derivatives by Pinocchio's recursions and (_ad) by
// automatic differentiation; or, with 2, those of inverse dynamics by the recursion alone.
// Returns 0, or 1 if CasADi throws what it prints.
extern "C" __attribute__((visibility("default"))) int write_c(const char *folder, int derivatives,
    long joints, const int *kinds, const int *parents, const double *placements,
    const double *inertias) try {
  const auto model = model_of(joints, kinds, parents, placements, inertias).cast<SX>();
  Data data(model);
  const SX q = SX::sym("q", model.nq), v = SX::sym("v", model.nv), a = SX::sym("a", model.nv);
  const Vector q_of = copied(q), v_of = copied(v), a_of = copied(a);
  const SX M = symmetric(copied(pinocchio::crba(model, data, q_of)));
  casadi::CodeGenerator made("casadi.c");
  const auto add = [&made](const char *name, const std::vector<SX> &given,
      const std::vector<SX> &results) {
    made.add(casadi::Function(name, given, results));
  };
  add("mass_matrix", {q}, {M});
  if (derivatives) {
    Data inverse(model);
    pinocchio::computeRNEADerivatives(model, inverse, q_of, v_of, a_of);
    add("inverse_dynamics_derivatives", {q, v, a}, by_rows(
        {copied(inverse.dtau_dq), copied(inverse.dtau_dv), symmetric(copied(inverse.M))}));
  }
  if (derivatives != 2) {
    const SX tau = copied(pinocchio::rnea(model, data, q_of, v_of, a_of));
    const SX ddq = copied(pinocchio::aba(model, data, q_of, v_of, a_of));
    if (!derivatives) {
      add("inverse_dynamics", {q, v, a}, {tau});
      add("forward_dynamics", {q, v, a}, {ddq});
    } else {
      const auto jacobians = [&](const SX &x) {
        return by_rows({SX::jacobian(x, q), SX::jacobian(x, v), SX::jacobian(x, a)});
      };
      Data forward(model);
      pinocchio::computeABADerivatives(model, forward, q_of, v_of, a_of);
      add("forward_dynamics_derivatives", {q, v, a}, by_rows(
          {copied(forward.ddq_dq), copied(forward.ddq_dv), symmetric(copied(forward.Minv))}));
      add("inverse_dynamics_derivatives_ad", {q, v, a}, jacobians(tau));
      add("forward_dynamics_derivatives_ad", {q, v, a}, jacobians(ddq));
    }
  }
  made.generate(folder);
  return 0;
} catch (const std::exception &error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
