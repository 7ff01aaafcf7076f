// SPDX-License-Identifier: BSD-3-Clause
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
constexpr int last_increment = 1;  // u_-; the kernel's second

bool remembers(double ratio) noexcept
{
  return ratio > 0.0 && ratio < 2.3;
}

/// The formula for steps of length h after h_-.
struct Coefficients
{
  double c, p, q;

  Coefficients(double step, double ratio)
      : c((1.0 + 2.0 * ratio) / ((1.0 + ratio) * step)), p(ratio * ratio / ((1.0 + ratio) * step)), q((1.0 + ratio) / step)
  {
  }
};

double ratio_of(const State& state, double step) noexcept
{
  return state.memory.last_step > 0.0 ? step / state.memory.last_step : 0.0;
}

/// Rates and accelerations that do not follow from u, node by node.
void prepare_nodes(const State& state, const Coefficients& by, Stage& stage) noexcept
{
  const PastQuantity &increment = state.memory.past[last_increment], &rate = state.memory.past[last_rate];
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const Eigen::Vector3d& n = stage.normal[i];
    stage.rate[i] = -by.p * in_step_axes(increment.nodes[i], n);
    stage.acceleration[i] =
        by.c * stage.rate[i] + by.p * in_step_axes(rate.nodes[i], n) - by.q * in_step_axes(state.nodes[i].rate, n);
  }
}

void prepare(const State& state, double step, const HistoryKernel* history, Stage& stage) noexcept
{
  const double ratio = ratio_of(state, step);
  if (!remembers(ratio))
  {
    prepare_implicit_euler(state, step, stage);
    return;
  }
  const Coefficients by(step, ratio);
  stage.dv_du = by.c;
  stage.da_du = by.c * by.c;
  if (history)
    history->find_rates(state, {0.0, 0.0, -by.p}, {-by.q, by.p, -by.c * by.p}, stage);
  else
    prepare_nodes(state, by, stage);
  const double drive_rate = -by.p * state.memory.past[last_increment].rotor;
  stage.drive = {step, by.c, by.c * by.c, drive_rate,
                 by.c * drive_rate + by.p * state.memory.past[last_rate].rotor - by.q * state.drive.speed};
}

bool step_bdf2(StepContext& context) noexcept
{
  prepare(context.state, context.step, context.work.history, context.stage);
  return context.solve();
}

void remember_increment(const StepContext& context, MethodMemory& memory) noexcept
{
  remember(context.stage, context.work, increments, context.work.result.drive_increment, memory.past[last_increment]);
}

/// BDF2 ends (1 + r)^2/(6 r (1 + 2 r)) h^3 y''' too far. The extrapolation h rate_n + r h/2 (rate_n - rate_-) falls short by 1/6
/// + 1/(4 r) of h^3 y''' of its own and, as the rates are BDF2's and late by h_-^2 y'''/3 (that for equal steps), by 1/(3 r^2)
/// more. Without memory the step is implicit Euler's, which ends h^2 y''/2 too far, and the extrapolation falls short by as much.
double share_of_distance(double r) noexcept
{
  if (r <= 0.0) return 0.5;
  if (!remembers(r)) return 1.0;
  const double too_far = (1.0 + r) * (1.0 + r) / (6.0 * r * (1.0 + 2.0 * r));
  return too_far / (too_far + 1.0 / 6.0 + 1.0 / (4.0 * r) + 1.0 / (3.0 * r * r));
}
}  // namespace

const Method bdf2 = {IntegratorKind::bdf2,
                     "bdf2",
                     "BDF2, second order, L-stable, one solve a step, halved where the motion changes fast (default)",
                     step_bdf2,
                     remember_increment,
                     0,
                     true,
                     nullptr,
                     share_of_distance};

void prepare_bdf2(const State& state, double step, Stage& stage) noexcept
{
  prepare(state, step, nullptr, stage);
}

}  // namespace drill_rig_sim
