// BDF2 on steps of length h after h_- (ratio r = h / h_-), Hairer, Norsett and Wanner, Solving ODEs I, III.5:
//   y' = ( (1 + 2 r)/(1 + r) (y - y_n) - r^2/(1 + r) (y_n - y_-) ) / h.
// With u = y - y_n:  rate = c u - p u_-,  acceleration = c rate - q rate_n + p rate_-,
//   c = (1 + 2 r)/((1 + r) h),  p = r^2/((1 + r) h),  q = (1 + r)/h.
// Zero-stable for r < 1 + sqrt 2: halving and doubling are safe.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
void prepare_bdf2(const SystemState& state, double step, Stage& stage) noexcept
{
  const double ratio = state.last_step > 0.0 ? step / state.last_step : 0.0;
  if (ratio <= 0.0 || ratio > 2.3)  // no usable history
  {
    prepare_implicit_euler(state, step, stage);
    return;
  }
  const double c = (1.0 + 2.0 * ratio) / ((1.0 + ratio) * step);
  const double p = ratio * ratio / ((1.0 + ratio) * step);
  const double q = (1.0 + ratio) / step;
  stage.dv_du = c;
  stage.da_du = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const Eigen::Vector3d n = x_axis(node.orientation);
    stage.rate[i] = -p * in_step_axes(node.last_increment, n);
    stage.acceleration[i] = c * stage.rate[i] + p * in_step_axes(node.last_rate, n) - q * in_step_axes(node.rate, n);
  }
  const DriveState& drive = state.drive;
  const double drive_rate = -p * drive.last_increment;
  stage.drive = {step, c, c * c, drive_rate, c * drive_rate + p * drive.last_speed - q * drive.speed};
}

bool step_bdf2(StepContext& context) noexcept
{
  prepare_bdf2(context.state, context.step, context.system.stage());
  return context.solve();
}
}  // namespace drill_rig_sim
