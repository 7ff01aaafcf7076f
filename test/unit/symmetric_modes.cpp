// SPDX-License-Identifier: BSD-3-Clause
#include "symmetric_modes.h"

#include <Eigen/Eigenvalues>

namespace drill_rig_sim
{
SymmetricModes modes_of(const Eigen::MatrixXd& symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace drill_rig_sim
