// SPDX-License-Identifier: BSD-3-Clause
// Generalised alpha (Chung and Hulbert, J. Appl. Mech. 60, 1993) in the form of Arnold and Bruels (Multibody Syst. Dyn. 18,
// 2007): the equations of motion hold at the ends of the steps, for the true acceleration; the rates follow from an averaged one,
// a:
//   (1 - am) a + am a_n = (1 - af) acceleration + af acceleration_n
//   u = h rate_n + h^2 ((1/2 - b) a_n + b a),   rate = rate_n + h ((1 - g) a_n + g a)
// am = (2 r - 1)/(r + 1), af = r/(r + 1), g = 1/2 + af - am, b = (g + 1/2)^2/4; r: spectral radius at infinite frequency.
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
namespace
{
constexpr int averaged_acceleration = 2;  // a

constexpr double kRadius = 0.5;  // contact and tool joints ring at 1e3 rad/s: they must die out
constexpr double kAm = (2.0 * kRadius - 1.0) / (kRadius + 1.0);
constexpr double kAf = kRadius / (kRadius + 1.0);
constexpr double kGamma = 0.5 + kAf - kAm;
constexpr double kBeta = 0.25 * (kGamma + 0.5) * (kGamma + 0.5);

/// rate_0 and acceleration_0 for numbers or vectors alike.
template <typename T>
void constants(double step, const T& rate_n, const T& a_n, const T& acceleration_n, T& rate_0, T& acceleration_0) noexcept
{
  const T free_flight = step * rate_n + (step * step * (0.5 - kBeta)) * a_n;  // u for a = 0
  rate_0 = rate_n + (step * (1.0 - kGamma)) * a_n - (kGamma / (kBeta * step)) * free_flight;
  acceleration_0 = (1.0 / (1.0 - kAf)) * (kAm * a_n - kAf * acceleration_n - ((1.0 - kAm) / (kBeta * step * step)) * free_flight);
}

/// (rate - rate_n)/h = (1 - g) a_n + g a, solved for a.
template <typename T>
T next_average(double step, const T& now, const T& before, const T& a) noexcept
{
  return ((now - before) / step - (1.0 - kGamma) * a) / kGamma;
}

/// `before`: the rates at the start, in the axes of the coming normal; `a`: at the start, in its axes.
NodeRate averaged(const NodeMotion& node, const NodeRate& before, const NodeRate& a, double step) noexcept
{
  const NodeRate now = split(node, node.rate);
  const Eigen::Vector3d n = node.normal.normalized();
  NodeRate out;
  out.velocity = next_average(step, now.velocity, before.velocity, a.velocity);
  out.tilt = next_average(step, now.tilt, before.tilt, Eigen::Vector3d(a.tilt - n * n.dot(a.tilt)));
  out.spin = next_average(step, now.spin, before.spin, a.spin);
  return out;
}

bool step_generalised_alpha(StepContext& context) noexcept
{
  const State& state = context.state;
  const double h = context.step;
  Stage& stage = context.stage;
  const PastQuantity &a = context.past(averaged_acceleration), &acceleration = context.past(last_acceleration);
  stage.dv_du = kGamma / (kBeta * h);
  stage.da_du = (1.0 - kAm) / ((1.0 - kAf) * kBeta * h * h);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Eigen::Vector3d& n = stage.normal[i];
    constants<Vector6d>(h, in_step_axes(state.nodes[i].rate, n), in_step_axes(a.nodes[i], n),
                        in_step_axes(acceleration.nodes[i], n), stage.rate[i], stage.acceleration[i]);
  }
  stage.drive.dv_du = stage.dv_du;
  stage.drive.da_du = stage.da_du;
  constants(h, state.drive.speed, a.rotor, acceleration.rotor, stage.drive.rate_0, stage.drive.acceleration_0);
  return context.solve();
}

/// memory's last rate is that of this step's start already.
void remember_accelerations(const StepContext& context, MethodMemory& memory) noexcept
{
  const StageResult& result = context.work.result;
  remember_acceleration(context, memory);
  expand_motions(context.stage, context.work);
  PastQuantity& a = memory.past[averaged_acceleration];
  const PastQuantity& before = memory.past[last_rate];
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
    a.nodes[i] = averaged(context.work.nodes[i], before.nodes[i], a.nodes[i], context.step);
  a.rotor = next_average(context.step, result.drive.speed, before.rotor, a.rotor);
}
}  // namespace

const Method generalised_alpha = {IntegratorKind::generalised_alpha,
                                  "generalised_alpha",
                                  "generalised alpha, second order, spectral radius 1/2 at infinity",
                                  step_generalised_alpha,
                                  remember_accelerations,
                                  2,
                                  false,
                                  nullptr,
                                  nullptr};

}  // namespace drill_rig_sim
