// Linearly implicit Euler: implicit Euler with its forces linearised about the start of the step, which is one Newton iteration from
// u = 0. Hairer and Wanner, Solving ODEs II, IV.9.
#include <algorithm>

#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
bool step_linearly_implicit_euler(Attempt& attempt) noexcept
{
  prepare_implicit_euler(attempt.state, attempt.step, attempt.system.stage());
  std::fill(attempt.u, attempt.u + 6 * attempt.system.nodes(), 0.0);
  ++attempt.iterations;
  if (!attempt.newton.improve(attempt.system, attempt.u)) return false;
  attempt.system.settle(attempt.u);
  return true;
}
}  // namespace drill_rig_sim
