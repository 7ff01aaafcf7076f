// Linearly implicit Euler: implicit Euler with its forces linearised about the start of the step, which is one Newton iteration from
// u = 0. Hairer and Wanner, Solving ODEs II, IV.9.
#include <algorithm>

#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
bool step_linearly_implicit_euler(StepContext& context) noexcept
{
  prepare_implicit_euler(context.state, context.step, context.system.stage());
  std::fill(context.u, context.u + 6 * context.system.nodes(), 0.0);
  ++context.iterations;
  if (!context.newton.improve(context.system, context.u)) return false;
  context.system.settle(context.u);
  return true;
}
}  // namespace drill_rig_sim
