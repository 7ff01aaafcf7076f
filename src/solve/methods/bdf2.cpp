// BDF2 on steps of length h after h_- (ratio r = h / h_-), Hairer, Norsett and Wanner, Solving ODEs I, III.5:
//   y' = ( (1 + 2 r)/(1 + r) (y - y_n) - r^2/(1 + r) (y_n - y_-) ) / h.
// With u = y - y_n:  rate = c u - p u_-,  acceleration = c rate - q rate_n + p rate_-,
//   c = (1 + 2 r)/((1 + r) h),  p = r^2/((1 + r) h),  q = (1 + r)/h.
// Zero-stable for r < 1 + sqrt 2: halving and doubling are safe.
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
constexpr int last_increment = 1;  // u_-

bool step(StepContext& context) noexcept
{
  prepare_bdf2(context.state, context.step, context.stage);
  return context.solve();
}

void remember_increment(const StepContext& context, MethodMemory& memory) noexcept
{
  remember(context.work, &NodeMotion::increment, context.work.result.drive_increment, memory.past[last_increment]);
}
}  // namespace

const Method bdf2 = {IntegratorKind::bdf2, "bdf2", "BDF2, second order, L-stable, one solve a step, halved where the motion changes fast (default)", step,
                     remember_increment, 0, true, nullptr};

void prepare_bdf2(const State& state, double step, Stage& stage) noexcept
{
  const MethodMemory& memory = state.memory;
  const double ratio = memory.last_step > 0.0 ? step / memory.last_step : 0.0;
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
  const PastQuantity &increment = memory.past[last_increment], &rate = memory.past[last_rate];
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Eigen::Vector3d& n = stage.normal[i];
    stage.rate[i] = -p * in_step_axes(increment.nodes[i], n);
    stage.acceleration[i] = c * stage.rate[i] + p * in_step_axes(rate.nodes[i], n) - q * in_step_axes(state.nodes[i].rate, n);
  }
  const double drive_rate = -p * increment.rotor;
  stage.drive = {step, c, c * c, drive_rate, c * drive_rate + p * rate.rotor - q * state.drive.speed};
}

}  // namespace drill_rig_sim
