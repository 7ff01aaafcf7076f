// SPDX-License-Identifier: BSD-3-Clause
// TR-BDF2 (Bank et al. 1985; Hosea and Shampine, Appl. Numer. Math. 20, 1996): trapezoidal rule to t + g h, g = 2 - sqrt 2, then
// BDF2 from t and t + g h to t + h. With u_1, u_2 the increments since t and the same c = 2/(g h) = (2 - g)/((1 - g) h) in both
// stages,
//   rate_1 = c u_1 - rate_n,             acceleration_1 = c (rate_1 - rate_n) - acceleration_n
//   rate_2 = c (u_2 - w u_1),            acceleration_2 = c (rate_2 - w rate_1 + (w - 1) rate_n),   w = 1/(g (2 - g)).
// The embedded formula of third order on the same three rates differs from it by
//   h ((sqrt 2 - 1)/3 rate_n - 1/3 rate_1 + g/3 rate_2),   the local error (Hosea and Shampine, section 2).
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/model/forces/top_drive.h"
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{

const double kFirst = 2.0 - std::sqrt(2.0);              // g
const double kWeight = 1.0 / (kFirst * (2.0 - kFirst));  // w

double coefficient(double step)
{
  return 2.0 / (kFirst * step);
}

/// The trapezoidal rule.
void prepare_first(const State& state, const PastQuantity& acceleration, double c, Stage& stage) noexcept
{
  stage.dv_du = c;
  stage.da_du = c * c;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Eigen::Vector3d& n = stage.normal[i];
    stage.rate[i] = -in_step_axes(state.nodes[i].rate, n);
    stage.acceleration[i] = 2.0 * c * stage.rate[i] - in_step_axes(acceleration.nodes[i], n);
  }
  stage.drive = {0.0, c, c * c, -state.drive.speed, -2.0 * c * state.drive.speed - acceleration.rotor};
}

/// BDF2; the stage still holds the first one's rates, u and `drive_turn` its solution.
void prepare_second(const State& state, double c, const double* u, double drive_turn, Stage& stage) noexcept
{
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Vector6d u_1 = Eigen::Map<const Vector6d>(u + 6 * i);
    const Vector6d rate_n = in_step_axes(state.nodes[i].rate, stage.normal[i]);
    const Vector6d rate_1 = c * u_1 - rate_n;
    stage.rate[i] = -(c * kWeight) * u_1;
    stage.acceleration[i] = c * (stage.rate[i] - kWeight * rate_1 + (kWeight - 1.0) * rate_n);
  }
  const double speed = state.drive.speed, speed_1 = c * drive_turn - speed;
  stage.drive.rate_0 = -c * kWeight * drive_turn;
  stage.drive.acceleration_0 = c * (stage.drive.rate_0 - kWeight * speed_1 + (kWeight - 1.0) * speed);
}

bool step_trbdf2(StepContext& context) noexcept
{
  const double c = coefficient(context.step);
  const State& state = context.state;
  Stage& stage = context.stage;
  move_stage(context.model, state, kFirst * context.step, stage);
  prepare_first(state, context.past(last_acceleration), c, stage);
  predict(state, kFirst * context.step, context.u);
  if (!context.solve()) return false;

  const double turn = drive_increment(context.model, state, stage, context.u + 6 * context.model.top());
  prepare_second(state, c, context.u, turn, stage);
  move_stage(context.model, state, context.step, stage);
  // the same mean rate again is the first guess
  for (int k = 0; k < 6 * context.model.nodes(); ++k) context.u[k] /= kFirst;
  return context.solve();
}

/// Of the nodes' places; the stage still holds -c w u_1.
double embedded_error(const StepContext& context) noexcept
{
  static const double weight_n = (std::sqrt(2.0) - 1.0) / 3.0, weight_1 = -1.0 / 3.0, weight_2 = kFirst / 3.0;
  double most = 0.0;
  expand_motions(context.stage, context.work);
  for (std::size_t i = 0; i < context.work.nodes.size(); ++i)
  {
    const Eigen::Vector3d rate_n = context.state.nodes[i].rate.velocity;
    const Eigen::Vector3d rate_1 = -context.stage.rate[i].head<3>() / kWeight - rate_n;
    const Eigen::Vector3d error = weight_n * rate_n + weight_1 * rate_1 + weight_2 * context.work.nodes[i].rate.head<3>();
    most = std::max(most, error.cwiseAbs().maxCoeff());
  }
  return context.step * most;
}
}  // namespace

const Method trbdf2 = {IntegratorKind::trbdf2,
                       "trbdf2",
                       "TR-BDF2, second order, L-stable, two solves a step, halved where the motion changes fast",
                       step_trbdf2,
                       remember_acceleration,
                       1,
                       true,
                       embedded_error,
                       nullptr};

}  // namespace drill_rig_sim
