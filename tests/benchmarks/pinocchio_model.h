// Pinocchio's models built joint by joint, which needs no library of Pinocchio's.
#ifndef PINOCCHIO_MODEL_H
#define PINOCCHIO_MODEL_H

#include <pinocchio/fwd.hpp>  // first: it sets limits of Boost

#include <string>

#include <pinocchio/multibody.hpp>

// In the order of KINDS in pinocchio_loops.py.
inline pinocchio::JointModel joint(int kind) {
  switch (kind) {
    case 0: return pinocchio::JointModelRX();
    case 1: return pinocchio::JointModelRY();
    case 2: return pinocchio::JointModelRZ();
    default: return pinocchio::JointModelFreeFlyer();
  }
}

// A robot of joints: kind and parent of each, rotation by columns and translation of its placement,
// mass, centre of mass and moments (xx, xy, yy, xz, yz, zz) about it of what it moves.
inline pinocchio::Model model_of(long joints, const int *kinds, const int *parents,
    const double *placements, const double *inertias) {
  pinocchio::Model model;
  for (long i = 0; i < joints; ++i, placements += 12, inertias += 10) {
    const pinocchio::SE3 placement(Eigen::Map<const Eigen::Matrix3d>(placements),
        Eigen::Map<const Eigen::Vector3d>(placements + 9));
    const auto added = model.addJoint(static_cast<pinocchio::JointIndex>(parents[i]),
        joint(kinds[i]), placement, "joint" + std::to_string(i + 1));
    model.appendBodyToJoint(added, pinocchio::Inertia(inertias[0],
        Eigen::Map<const Eigen::Vector3d>(inertias + 1),
        pinocchio::Symmetric3(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(inertias + 4))));
  }
  return model;
}

#endif
