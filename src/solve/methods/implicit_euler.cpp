// SPDX-License-Identifier: BSD-3-Clause
// Implicit Euler:  rate = u / h,  acceleration = (rate - rate_n) / h.
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
bool step_implicit_euler(StepContext& context) noexcept
{
  prepare_implicit_euler(context.state, context.step, context.stage);
  return context.solve();
}
}  // namespace

const Method implicit_euler = {IntegratorKind::implicit_euler,
                               "implicit_euler",
                               "implicit Euler, first order, L-stable",
                               step_implicit_euler,
                               nullptr,
                               0,
                               false,
                               nullptr,
                               nullptr};

void prepare_implicit_euler(const State& state, double step, Stage& stage) noexcept
{
  const double c = 1.0 / step;
  stage.dv_du = c;
  stage.da_du = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    stage.rate[i].setZero();
    stage.acceleration[i] = -c * in_step_axes(state.nodes[i].rate, stage.normal[i]);
  }
  stage.drive = {step, c, c * c, 0.0, -c * state.drive.speed};
}

}  // namespace drill_rig_sim
