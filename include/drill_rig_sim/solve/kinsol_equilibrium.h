// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_KINSOL_EQUILIBRIUM_H
#define DRILL_RIG_SIM_SOLVE_KINSOL_EQUILIBRIUM_H

#include <functional>
#include <vector>

namespace drill_rig_sim
{
/// A square nonlinear system for KINSOL: the residual at u, and the solution of J(u) x = b.
struct NonlinearProblem
{
  std::function<void(const double* u, double* residual)> residual;
  std::function<bool(const double* u, double* b)> solve_tangent;  ///< overwrites b with J^-1 b; false: singular
};

struct KinsolOutcome
{
  bool converged = false;
  int iterations = 0;
  double residual = 0.0;  ///< largest component left
};

/// KINSOL, Newton with line search, until no component of the residual exceeds `tolerance`, in `most_iterations` at most
/// (one is made in any case). u: guess in, solution out.
KinsolOutcome kinsol_solve(const NonlinearProblem& problem, double tolerance, int most_iterations, std::vector<double>& u);

}  // namespace drill_rig_sim

#endif
