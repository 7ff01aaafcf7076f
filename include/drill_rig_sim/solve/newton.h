#ifndef DRILL_RIG_SIM_SOLVE_NEWTON_H
#define DRILL_RIG_SIM_SOLVE_NEWTON_H

#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
struct NewtonLimits
{
  double tolerance = 1e-6;   ///< on the error left in u, [m] and [rad] alike: bit embedding and joint sag are of order 1e-3
  int max_iterations = 8;
  double max_move = 0.05;    ///< longest increment of one iteration [m, rad]
};

/// True when an increment [m, rad] ends the iteration; `before`: the increment of the iteration before, 0 for the first. An iteration
/// leaves less than its contraction times its increment.
bool newton_converged(double increment, double before, const NewtonLimits& limits) noexcept;

struct NewtonOutcome
{
  bool converged = false;
  int iterations = 0;
  double increment = 0.0;  ///< of the last iteration, largest component over all nodes [m, rad]
};

/// Newton's method on one stage of the system. Converges on the increment, not on the residual: a residual of 1e-3 N is below
/// round-off in a long string. Noexcept, allocation-free after construction.
class Newton
{
public:
  explicit Newton(int nodes);
  /// Improves `u` (6 per node, in: the guess) until R(u) = 0. A non-finite increment ends it, unconverged.
  NewtonOutcome solve(System& system, double* u, const NewtonLimits& limits) noexcept;

private:
  BlockTridiagonal tangent_;
  std::vector<double> step_;
};

}  // namespace drill_rig_sim

#endif
