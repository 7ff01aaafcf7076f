// Implicit Euler:  rate = u / h,  acceleration = (rate - rate_n) / h.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
void prepare_implicit_euler(const SystemState& state, double step, const System&, Stage& stage) noexcept
{
  const double c = 1.0 / step;
  stage.coefficient = c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    stage.rate[i].setZero();
    stage.acceleration[i] << -c * node.rate.velocity, -c * (node.rate.tilt + node.rate.spin * x_axis(node.orientation));
  }
  stage.drive_rate = 0.0;
  stage.drive_acceleration = -c * state.drive.speed;
}
}  // namespace drill_rig_sim
