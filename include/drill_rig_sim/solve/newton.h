// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_NEWTON_H
#define DRILL_RIG_SIM_SOLVE_NEWTON_H

#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/model/stage_context.h"

namespace drill_rig_sim
{
struct NewtonLimits
{
  double tolerance = 1e-6;      ///< on the error left in u, [m] and [rad] alike: bit embedding and joint sag are of order 1e-3
  int max_iterations = 8;       ///< tangents
  double max_increment = 0.05;  ///< longest increment of one iteration [m, rad]
};

/// True when an increment [m, rad] ends the iteration; `before`: the increment of the iteration before, 0 for the first. An
/// iteration leaves less than its contraction times its increment.
bool newton_converged(double increment, double before, const NewtonLimits& limits) noexcept;

struct NewtonOutcome
{
  bool converged = false;
  int iterations = 0;      ///< tangents
  double increment = 0.0;  ///< the last, largest component over all nodes [m, rad]
};

/// Newton's method on one stage of the system. Converges on the increment, not on the residual: a residual of 1e-3 N is below
/// round-off in a long string. A tangent is kept while its increments shrink at least fivefold. A residual costs a third of
/// an iteration and shows whether the last increment was enough. If the kept tangent asks for a larger increment than the one
/// just made, that increment crossed a kink of contact or friction: half of it is taken back. Noexcept, allocation-free after
/// construction.
class Newton
{
public:
  explicit Newton(const Model& model);
  /// Improves `u` (6 per node, in: the guess) until R(u) = 0, and leaves `work` as evaluated or updated there. A non-finite
  /// increment ends it, unconverged.
  NewtonOutcome solve(const StageContext& problem, double* u, const NewtonLimits& limits) noexcept;
  /// One increment, whole, with the tangent at `u`. False: there is none.
  bool improve(const StageContext& problem, double* u) noexcept;

private:
  double find_increment(const StageContext& problem, const double* u, bool new_tangent) noexcept;
  void apply(double scale, double* u) const noexcept;
  void go_back(double* u) const noexcept;

  BlockTridiagonal tangent_;
  std::vector<double> step_, last_;  // the increment under way, and the one before it
};

}  // namespace drill_rig_sim

#endif
