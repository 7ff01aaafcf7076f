// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SYMMETRIC_MODES_H
#define DRILL_RIG_SIM_TEST_SYMMETRIC_MODES_H

#include <Eigen/Core>

namespace drill_rig_sim
{
/// Eigenvalues, the lowest first, and eigenvectors (columns) of a symmetric matrix.
struct SymmetricModes
{
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// By Eigen's solver, which takes five seconds to compile: once for all tests.
SymmetricModes modes_of(const Eigen::MatrixXd& symmetric);

}  // namespace drill_rig_sim

#endif
