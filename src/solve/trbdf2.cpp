// TR-BDF2 (Bank et al. 1985; Hosea and Shampine, Appl. Numer. Math. 20, 1996): trapezoidal rule to t + g h, g = 2 - sqrt 2, then BDF2 from
// t and t + g h to t + h. With u_1, u_2 the increments since t and the same c = 2/(g h) = (2 - g)/((1 - g) h) in both stages,
//   rate_1 = c u_1 - rate_n,             acceleration_1 = c (rate_1 - rate_n) - acceleration_n
//   rate_2 = c (u_2 - w u_1),            acceleration_2 = c (rate_2 - w rate_1 + (w - 1) rate_n),   w = 1/(g (2 - g)).
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
const double kFirst = 2.0 - std::sqrt(2.0);          // g
const double kWeight = 1.0 / (kFirst * (2.0 - kFirst));  // w

double coefficient(double step)
{
  return 2.0 / (kFirst * step);
}

/// The trapezoidal rule.
void prepare_first(const SystemState& state, double c, Stage& stage) noexcept
{
  stage.dv_du = c;
  stage.da_du = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const Eigen::Vector3d n = x_axis(node.orientation);
    stage.rate[i] = -in_step_axes(node.rate, n);
    stage.acceleration[i] = 2.0 * c * stage.rate[i] - in_step_axes(node.acceleration, n);
  }
  stage.drive = {0.0, c, c * c, -state.drive.speed, -2.0 * c * state.drive.speed - state.drive.acceleration};
}

/// BDF2; the stage still holds the first one's rates, u and `drive_turn` its solution.
void prepare_second(const SystemState& state, double c, const double* u, double drive_turn, Stage& stage) noexcept
{
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const Vector6d u_1 = Eigen::Map<const Vector6d>(u + 6 * i);
    const Vector6d rate_n = in_step_axes(node.rate, x_axis(node.orientation));
    const Vector6d rate_1 = c * u_1 - rate_n;
    stage.rate[i] = -(c * kWeight) * u_1;
    stage.acceleration[i] = c * (stage.rate[i] - kWeight * rate_1 + (kWeight - 1.0) * rate_n);
  }
  const double speed = state.drive.speed, speed_1 = c * drive_turn - speed;
  stage.drive.rate_0 = -c * kWeight * drive_turn;
  stage.drive.acceleration_0 = c * (stage.drive.rate_0 - kWeight * speed_1 + (kWeight - 1.0) * speed);
}
}  // namespace

bool step_trbdf2(StepContext& context) noexcept
{
  const double c = coefficient(context.step);
  System& system = context.system;
  system.stage_at(kFirst * context.step);
  prepare_first(context.state, c, system.stage());
  predict(context.state, kFirst * context.step, context.u);
  if (!context.solve()) return false;

  prepare_second(context.state, c, context.u, system.drive_increment(context.u), system.stage());
  system.stage_at(context.step);
  // the same mean rate again is the first guess
  for (int k = 0; k < 6 * system.nodes(); ++k) context.u[k] /= kFirst;
  return context.solve();
}
}  // namespace drill_rig_sim
