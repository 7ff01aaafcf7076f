// SPDX-License-Identifier: BSD-3-Clause
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

/// Calls guided(run) for the runs of nodes whose motions are known in two coordinates alone, other(run) for what is between them.
template <class Guided, class Other>
void each_run(const Stage& stage, int nodes, const Guided& guided, const Other& other)
{
  for (const Runs::Run& run : stage.inner_nodes) guided(run);
  each_between(stage.inner_nodes, nodes, [&](int first, int last) { other(Runs::Run{first, last}); });
}
}  // namespace

bool StepContext::solve() noexcept
{
  NewtonLimits left = limits;
  left.max_iterations = std::min(limits.max_iterations, budget - iterations);
  const NewtonOutcome outcome = newton.solve(at_stage(), u, left);
  iterations += outcome.iterations;
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
  if (history) return history->extrapolate(state, time * (1.0 + bend), -time * bend, u);
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

void remember_last_rate(const Stage& stage, Workspace& work, State& state) noexcept
{
  PastQuantity& past = state.memory.past[last_rate];
  past.rotor = state.drive.speed;
  if (const HistoryKernel* history = history_of(work))
    return each_run(
        stage, static_cast<int>(past.nodes.size()),
        [&](Runs::Run run) { history->carry_guided(stage, work, state, run, past.nodes); },
        [&](Runs::Run run) { history->carry(work, state, run, past.nodes); });
  expand_motions(stage, work);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeRate& before = state.nodes[i].rate;
    past.nodes[i] = {before.velocity, carried(work.nodes[i], before.tilt), before.spin};
  }
}

void remember(const Stage& stage, Workspace& work, const NodeQuantity& quantity, double rotor, PastQuantity& past) noexcept
{
  past.rotor = rotor;
  if (const HistoryKernel* history = history_of(work))
  {
    const Column &along = work.guided.*quantity.along, &about = work.guided.*quantity.about;
    return each_run(
        stage, static_cast<int>(past.nodes.size()),
        [&](Runs::Run run) { history->split_guided(stage, along, about, run, past.nodes); },
        [&](Runs::Run run) { history->split(work, quantity.vector, run, past.nodes); });
  }
  expand_motions(stage, work);
  for (std::size_t i = 0; i < work.nodes.size(); ++i) past.nodes[i] = split(work.nodes[i], work.nodes[i].*quantity.vector);
}

void remember_acceleration(const StepContext& context, MethodMemory& memory) noexcept
{
  remember(context.stage, context.work, accelerations, context.work.result.drive_acceleration, memory.past[last_acceleration]);
}

}  // namespace drill_rig_sim
