// Central differences (leapfrog), the rates half a step behind the places:
//   rate = rate_n + h acceleration_n,   u = h rate,   acceleration = M^-1 (forces at the end of the step, with these rates).
// One evaluation a step. The rotor, condensed as always, takes the trapezoidal rule for the turn of the string's top.
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
bool step_explicit(StepContext& context) noexcept
{
  const SystemState& state = context.state;
  const double h = context.step;
  System& system = context.system;
  Stage& stage = system.stage();
  stage.dv_du = stage.da_du = 0.0;
  const double late = state.last_step > 0.0 ? h : 0.5 * h;  // the first rates are no half step behind
  double sum = 0.0;  // finite if all are
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const Eigen::Vector3d n = x_axis(node.orientation);
    stage.rate[i] = in_step_axes(node.rate, n) + late * in_step_axes(node.acceleration, n);
    stage.acceleration[i].setZero();
    Eigen::Map<Vector6d>(context.u + 6 * i) = h * stage.rate[i];
    sum += stage.rate[i].squaredNorm();
  }
  if (!std::isfinite(sum)) return false;
  const double c = 2.0 / h;
  stage.drive = {h, c, c * c, -state.drive.speed, -2.0 * c * state.drive.speed - state.drive.acceleration};
  system.evaluate(context.u, context.residual, nullptr);
  system.accelerate(context.residual);
  for (int i = 0; i < system.nodes(); ++i) sum += system.acceleration(i).squaredNorm();
  return std::isfinite(sum);
}
}  // namespace drill_rig_sim
