// Implicit Euler:  rate = u / h,  acceleration = (rate - rate_n) / h.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
void prepare_implicit_euler(const SystemState& state, double step, Stage& stage) noexcept
{
  const double c = 1.0 / step;
  stage.rate_by_u = c;
  stage.acceleration_by_u = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    stage.rate[i].setZero();
    stage.acceleration[i] = -c * in_step_axes(node.rate, x_axis(node.orientation));
  }
  stage.drive = {step, c, c * c, 0.0, -c * state.drive.speed};
}

bool step_implicit_euler(Attempt& attempt) noexcept
{
  prepare_implicit_euler(attempt.state, attempt.step, attempt.system.stage());
  return attempt.solve();
}
}  // namespace drill_rig_sim
