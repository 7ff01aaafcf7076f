// Implicit Euler:  rate = u / h,  acceleration = (rate - rate_n) / h.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
void prepare_implicit_euler(const SystemState& state, double step, Stage& stage) noexcept
{
  const double c = 1.0 / step;
  stage.dv_du = c;
  stage.da_du = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    stage.rate[i].setZero();
    stage.acceleration[i] = -c * in_step_axes(node.rate, x_axis(node.orientation));
  }
  stage.drive = {step, c, c * c, 0.0, -c * state.drive.speed};
}

bool step_implicit_euler(StepContext& context) noexcept
{
  prepare_implicit_euler(context.state, context.step, context.system.stage());
  return context.solve();
}
}  // namespace drill_rig_sim
