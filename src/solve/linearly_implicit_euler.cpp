// Linearly implicit Euler: implicit Euler with its forces linearised about the start of the step, which is one Newton iteration from
// u = 0. Hairer and Wanner, Solving ODEs II, IV.9.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
bool step_linearly_implicit_euler(Attempt& attempt) noexcept
{
  prepare_implicit_euler(attempt.state, attempt.step, attempt.system.stage());
  std::fill(attempt.u, attempt.u + 6 * attempt.system.nodes(), 0.0);
  constexpr double any = 1e300;
  attempt.limits = {any, 1, any};
  return attempt.solve_and_settle();
}
}  // namespace drill_rig_sim
