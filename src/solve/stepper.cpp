// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/stepper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/forces/inertia.h"

namespace drill_rig_sim
{
namespace
{
// of variable steps
constexpr double first_step = 1e-3;     // [s]
constexpr double largest_growth = 1.8;  // from step to step; times 1.25, BDF2 still remembers, and is stable below 1 + sqrt 2
constexpr double least_stretch = 0.5;   // a step four times as wrong as allowed is repeated
constexpr double iterations = 800.0, in_time = 0.01;  // of Newton's, and the time that they are for [s]
constexpr double for_a_step = 4.0;                    // of them are kept for each step that is left
constexpr double shortest_rescue = 1e-6;              // where a step of shortest_step has no solution [s]
int budget_of(double duration) noexcept
{
  return static_cast<int>(iterations * std::ceil(duration / in_time));
}
}  // namespace

const std::vector<const Method*>& method_table()
{
  static const std::vector<const Method*> table = {&bdf2,   &implicit_euler,    &linearly_implicit_euler,
                                                   &trbdf2, &generalised_alpha, &explicit_differences};
  return table;
}

const Method& find_method(IntegratorKind kind) noexcept
{
  for (const Method* method : method_table())
    if (kind == method->kind) return *method;
  return *method_table().front();
}

Stepper::Stepper(std::shared_ptr<const Model> model, const Method& method)
    : HalvingIntegrator(std::move(model)), method_(method), newton_(*model_), u_(6 * model_->nodes()), guess_(u_), residual_(u_)
{
  const NumericsSpec& numerics = model_->scene().numerics;
  limits_.tolerance = numerics.newton_tolerance;
  if (numerics.has_variable_steps() && method_.share_of_distance) control_.emplace(*model_);
}

bool Stepper::advance(State& state, double step, const Setpoints& setpoints) noexcept
{
  return control_ ? advance_by_control(state, step, setpoints) : HalvingIntegrator::advance(state, step, setpoints);
}

const char* Stepper::failure() const noexcept
{
  return control_ ? "the step did not converge, even in steps of a microsecond; reset the well or restore a state"
                  : HalvingIntegrator::failure();
}

bool Stepper::take_one_step(State& state, double step, const Setpoints& setpoints) noexcept
{
  int budget = budget_of(step);
  return control_ && attempt_by_control(state, step, setpoints, budget, true) == StepResult::solved;
}

/// Also says how long the next attempt should be. The mud goes by these steps too.
StepResult Stepper::attempt_by_control(State& state, double step, const Setpoints& setpoints, int& budget,
                                       bool may_refine) noexcept
{
  const double flow = state.flow;
  const HydraulicState hydraulics = state.hydraulics;
  advance_mud(*model_, setpoints.pump.flow, step, state);
  const StepResult outcome = attempt(state, step, setpoints, budget, may_refine);
  if (outcome != StepResult::solved)
  {
    state.flow = flow;
    state.hydraulics = hydraulics;
  }
  double& wanted = state.step.wanted;
  if (outcome == StepResult::solved)
    wanted = std::min(step * std::clamp(0.9 * stretch_, 0.2, largest_growth), control_->longest(state));
  else if (outcome == StepResult::error_test_failed)
    wanted = step * std::clamp(0.9 * stretch_, 0.1, 0.5);
  else
    wanted = 0.25 * step;
  if (outcome == StepResult::error_test_failed) ++counters_.error_test_failures;
  if (outcome == StepResult::not_converged) ++counters_.convergence_failures;
  return outcome;
}

/// A step that fails is repeated shorter. The work is bounded: steps are no shorter than what is left of it allows, and when half
/// of it is done errors are no reason to repeat any more. Where a step of shortest_step has no solution, as where friction lets a
/// jammed bit go, steps are quartered until inertia gives one, and grow again from there.
bool Stepper::advance_by_control(State& state, double duration, const Setpoints& setpoints) noexcept
{
  if (state.step.wanted <= 0.0) state.step.wanted = first_step;
  const int whole = budget_of(duration);
  int budget = whole;
  double least = shortest_step;
  for (double left = duration; left > 0.0;)
  {
    const double wanted = std::ceil(left / std::clamp(state.step.wanted, least, longest_step) - may_be_longer);
    const double affordable = least < shortest_step ? wanted : std::floor(budget / for_a_step);
    const double step = left / std::max(1.0, std::min(wanted, affordable));
    const bool may_refine = step > shortest_step && budget > whole / 2;
    const StepResult outcome = attempt_by_control(state, step, setpoints, budget, may_refine);
    if (outcome == StepResult::solved)
    {
      left = step < left ? left - step : 0.0;
      least = std::min(shortest_step, largest_growth * least);
    }
    else if (outcome == StepResult::not_converged)
    {
      if (budget <= 0 || least <= shortest_rescue) return false;
      if (step < 1.5 * shortest_step) least *= 0.25;
    }
  }
  return true;
}

/// The local error of the step just solved, estimated by the distance to the extrapolation, goes into guess_.
double Stepper::find_stretch(const State& state, double step) noexcept
{
  const double share = method_.share_of_distance(state.memory.last_step > 0.0 ? step / state.memory.last_step : 0.0);
  for (std::size_t k = 0; k < u_.size(); ++k) guess_[k] = share * (u_[k] - guess_[k]);
  return control_->stretch(state, work_, guess_.data(), step);
}

StepResult Stepper::attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept
{
  if (method_.first_acceleration > 0 && state.memory.last_step <= 0.0) find_acceleration(state, setpoints);
  open_books(state, setpoints);
  begin_step(*model_, state, step, setpoints, stage_);
  predict(state, step, u_.data(), work_.history);
  std::copy(u_.begin(), u_.end(), guess_.begin());
  StepContext context{*model_, state, step, stage_, work_, newton_, limits_, budget, u_.data(), residual_.data()};
  const bool solved = method_.step(context);
  counters_.newton_iterations += context.iterations;
  budget -= context.iterations;
  if (!solved) return StepResult::not_converged;
  error_estimate_ = method_.local_error ? method_.local_error(context) : predictor_distance() / 6.0;
  if (control_)
  {
    stretch_ = find_stretch(state, step);
    if (may_refine && stretch_ < least_stretch) return StepResult::error_test_failed;
  }
  else if (method_.refines && may_refine && error_estimate_ > largest_local_error)
    return StepResult::error_test_failed;
  close_books(state, stage_, u_.data());
  remember_last_rate(stage_, work_, state);
  if (method_.remember) method_.remember(context, state.memory);
  state.memory.last_step = step;
  commit(stage_, work_, state);
  advance_discrete(*model_, stage_, work_, state);
  if (control_) StepControl::note(work_.result.forces, state.step);
  ++counters_.steps;
  return StepResult::solved;
}

void Stepper::find_acceleration(State& state, const Setpoints& setpoints) noexcept
{
  begin_step(*model_, state, 0.0, setpoints, stage_);
  prepare_start(state, stage_);
  std::fill(u_.begin(), u_.end(), 0.0);
  evaluate(*model_, state, stage_, u_.data(), work_, residual_.data(), nullptr);
  expand_motions(stage_, work_);
  accelerate(*model_, stage_, residual_.data(), work_);
  for (int k = 1; k <= method_.first_acceleration; ++k)
  {
    PastQuantity& past = state.memory.past[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
    {
      const Eigen::Vector3d &n = stage_.normal[i], turning = work_.nodes[i].acceleration.tail<3>();
      past.nodes[i] = {work_.nodes[i].acceleration.head<3>(), turning - n * n.dot(turning), n.dot(turning)};
    }
  }
}

double Stepper::predictor_distance() const noexcept
{
  double most = 0.0;
  for (std::size_t k = 0; k < u_.size(); k += 6)
    for (std::size_t c = k; c < k + 3; ++c) most = std::max(most, std::abs(u_[c] - guess_[c]));
  return most;
}

}  // namespace drill_rig_sim
