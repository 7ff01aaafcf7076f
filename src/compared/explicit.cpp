// SPDX-License-Identifier: BSD-3-Clause
// Central differences (leapfrog), the rates half a step behind the places:
//   rate = rate_n + h acceleration_n,   u = h rate,   acceleration = M^-1 (forces at the end of the step, with these rates).
// One evaluation a step. The rotor, condensed as always, takes the trapezoidal rule for the turn of the string's top.
#include <cmath>

#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
bool step_explicit(StepContext& context) noexcept
{
  const State& state = context.state;
  const double h = context.step;
  Stage& stage = context.stage;
  stage.dv_du = stage.da_du = 0.0;
  const double late = state.memory.last_step > 0.0 ? h : 0.5 * h;  // the first rates are no half step behind
  double sum = 0.0;                                                // finite if all are
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Eigen::Vector3d& n = stage.normal[i];
    stage.rate[i] = in_step_axes(state.nodes[i].rate, n) + late * in_step_axes(context.past(last_acceleration).nodes[i], n);
    stage.acceleration[i].setZero();
    Eigen::Map<Vector6d>(context.u + 6 * i) = h * stage.rate[i];
    sum += stage.rate[i].squaredNorm();
  }
  if (!std::isfinite(sum)) return false;
  const double c = 2.0 / h;
  stage.drive = {h, c, c * c, -state.drive.speed, -2.0 * c * state.drive.speed - context.past(last_acceleration).rotor};
  evaluate(context.model, state, stage, context.u, context.work, context.residual, nullptr);
  accelerate(context.model, stage, context.residual, context.work);
  for (std::size_t i = 0; i < stage.acceleration.size(); ++i)
  {
    stage.acceleration[i] = context.work.nodes[i].acceleration;
    sum += stage.acceleration[i].squaredNorm();
  }
  return std::isfinite(sum);
}
}  // namespace

const Method explicit_differences = {IntegratorKind::central_differences,
                                     "explicit",
                                     "central differences, second order, short steps only",
                                     step_explicit,
                                     remember_acceleration,
                                     1,
                                     false,
                                     nullptr,
                                     nullptr};

}  // namespace drill_rig_sim
