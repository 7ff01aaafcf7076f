#include "drill_rig_sim/solve/methods/method.h"

#include <algorithm>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
namespace
{
/// The batch kernel, if there is one and the motion is a stage's.
const HistoryKernel* history_of(const Workspace& work) noexcept
{
  return work.columns.moved ? work.history : nullptr;
}

NumberRows<const double> rows_of(const Workspace& work) noexcept
{
  return {work.nodes[0].orientation.coeffs().data(), sizeof(NodeMotion)};
}

NumberRows<double> rows_of(PastQuantity& past) noexcept
{
  return {past.nodes[0].velocity.data(), sizeof(NodeRate)};
}
}  // namespace

bool StepContext::solve() noexcept
{
  NewtonLimits left = limits;
  left.max_iterations = std::min(limits.max_iterations, budget - iterations);
  const NewtonOutcome outcome = newton.solve(at_stage(), u, left);
  iterations += outcome.iterations;
  expand_motions(stage, work);
  return outcome.converged;
}

void prepare_start(const State& state, Stage& stage) noexcept
{
  stage.dv_du = stage.da_du = 0.0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    stage.rate[i] = in_step_axes(state.nodes[i].rate, stage.normal[i]);
    stage.acceleration[i].setZero();
  }
  constexpr double held = 1e9;  // [1/s]
  stage.drive = {0.0, held, held * held, 0.0, 0.0};
}

void predict(const State& state, double time, double* u, const HistoryKernel* history) noexcept
{
  // rate + time/2 times the last acceleration
  const double bend = state.memory.last_step > 0.0 ? 0.5 * time / state.memory.last_step : 0.0;
  const std::vector<NodeRate>& before = state.memory.past[last_rate].nodes;
  if (history)
  {
    const NodeState& first = state.nodes[0];
    const NumberRows<const double> now{first.rate.velocity.data(), sizeof(NodeState)}, last{before[0].velocity.data(), sizeof(NodeRate)};
    const double of_now = time * (1.0 + bend), of_last = -time * bend;
    history->find_rates({static_cast<int>(state.nodes.size()), {first.orientation.coeffs().data(), sizeof(NodeState)}, {now, last, last},
                         {of_now, of_last, 0.0}, {of_now, of_last, 0.0}, u, u});
    return;
  }
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const NodeRate& a = node.rate;
    const NodeRate& b = before[i];
    Eigen::Map<Vector6d> guess(u + 6 * i);
    guess.head<3>() = time * (a.velocity + bend * (a.velocity - b.velocity));
    guess.tail<3>() = time * (a.tilt + bend * (a.tilt - b.tilt) + (a.spin + bend * (a.spin - b.spin)) * x_axis(node.orientation));
  }
}

void remember_last_rate(const Workspace& work, State& state) noexcept
{
  PastQuantity& past = state.memory.past[last_rate];
  past.rotor = state.drive.speed;
  if (const HistoryKernel* history = history_of(work))
  {
    history->carry(static_cast<int>(past.nodes.size()), rows_of(work), {state.nodes[0].rate.velocity.data(), sizeof(NodeState)}, rows_of(past));
    return;
  }
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeRate& before = state.nodes[i].rate;
    past.nodes[i] = {before.velocity, carried(work.nodes[i], before.tilt), before.spin};
  }
}

void remember(const Workspace& work, Vector6d NodeMotion::*vector, double rotor, PastQuantity& past) noexcept
{
  past.rotor = rotor;
  if (const HistoryKernel* history = history_of(work))
  {
    const auto at = (work.nodes[0].*vector).data() - rows_of(work).first;
    history->split(static_cast<int>(past.nodes.size()), rows_of(work), static_cast<int>(at), rows_of(past));
    return;
  }
  for (std::size_t i = 0; i < work.nodes.size(); ++i) past.nodes[i] = split(work.nodes[i], work.nodes[i].*vector);
}

void remember_acceleration(const StepContext& context, MethodMemory& memory) noexcept
{
  remember(context.work, &NodeMotion::acceleration, context.work.result.drive_acceleration, memory.past[last_acceleration]);
}

}  // namespace drill_rig_sim
