#include "drill_rig_sim/solve/stepper.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/energy_balance.h"

namespace drill_rig_sim
{
const std::vector<Method>& method_table()
{
  static const std::vector<Method> table = {
      {IntegratorKind::bdf2, "bdf2", "BDF2, second order, L-stable, one solve a step, halved where the motion changes fast (default)", step_bdf2, false, true,
       nullptr},
      {IntegratorKind::implicit_euler, "implicit_euler", "implicit Euler, first order, L-stable", step_implicit_euler, false, false, nullptr},
      {IntegratorKind::linearly_implicit_euler, "linearly_implicit_euler", "linearly implicit Euler, first order, one solve without iteration", step_linearly_implicit_euler,
       false, false, nullptr},
      {IntegratorKind::trbdf2, "trbdf2", "TR-BDF2, second order, L-stable, two solves a step", step_trbdf2, true, false, nullptr},
      {IntegratorKind::generalised_alpha, "generalised_alpha", "generalised alpha, second order, spectral radius 1/2 at infinity", step_generalised_alpha, true, false,
       remember_generalised_alpha},
      {IntegratorKind::central_differences, "explicit", "central differences, second order, short steps only", step_explicit, true, false, nullptr},
  };
  return table;
}

const Method& find_method(IntegratorKind kind) noexcept
{
  for (const Method& method : method_table())
    if (kind == method.kind) return method;
  return method_table().front();
}

void predict(const SystemState& state, double time, double* u) noexcept
{
  // rate + time/2 times the last acceleration
  const double bend = state.last_step > 0.0 ? 0.5 * time / state.last_step : 0.0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const NodeRate& a = node.rate;
    const NodeRate& b = node.last_rate;
    Eigen::Map<Vector6d> guess(u + 6 * i);
    guess.head<3>() = time * (a.velocity + bend * (a.velocity - b.velocity));
    guess.tail<3>() = time * (a.tilt + bend * (a.tilt - b.tilt) + (a.spin + bend * (a.spin - b.spin)) * x_axis(node.orientation));
  }
}

bool StepContext::solve() noexcept
{
  NewtonLimits left = limits;
  left.max_iterations = std::min(limits.max_iterations, budget - iterations);
  const NewtonOutcome outcome = newton.solve(system, u, left);
  iterations += outcome.iterations;
  return outcome.converged;
}

Stepper::Stepper(System& system, const Method& method)
  : system_(system), method_(method), newton_(system.nodes()), u_(6 * system.nodes()), guess_(6 * system.nodes()), residual_(6 * system.nodes())
{
  limits_.tolerance = system.scene().numerics.newton_tolerance;
}

StepResult Stepper::attempt(SystemState& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept
{
  if (method_.needs_acceleration && state.last_step <= 0.0) find_acceleration(state, setpoints);
  if (balance_) balance_->begin_step(state, setpoints);
  system_.begin(state, step, setpoints);
  predict(state, step, u_.data());
  std::copy(u_.begin(), u_.end(), guess_.begin());
  StepContext context{state, step, system_, newton_, limits_, budget, u_.data(), residual_.data()};
  const bool solved = method_.step(context);
  counters_.newton_iterations += context.iterations;
  budget -= context.iterations;
  if (!solved) return StepResult::not_converged;
  error_estimate_ = predictor_distance() / 6.0;
  if (method_.refines && may_refine && error_estimate_ > largest_local_error) return StepResult::error_test_failed;
  if (balance_) balance_->end_step();
  system_.finish(state);
  if (method_.remember) method_.remember(state, step);
  system_.profiler().lap(Cost::other);
  extend_hole(system_, state, step);
  system_.profiler().lap(Cost::rock_penetration);
  ++counters_.steps;
  return StepResult::solved;
}

void prepare_start(const SystemState& state, Stage& stage) noexcept
{
  stage.dv_du = stage.da_du = 0.0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    stage.rate[i] = in_step_axes(state.nodes[i].rate, x_axis(state.nodes[i].orientation));
    stage.acceleration[i].setZero();
  }
  constexpr double held = 1e9;  // [1/s]
  stage.drive = {0.0, held, held * held, 0.0, 0.0};
}

void Stepper::find_acceleration(SystemState& state, const Setpoints& setpoints) noexcept
{
  system_.begin(state, 0.0, setpoints);
  prepare_start(state, system_.stage());
  std::fill(u_.begin(), u_.end(), 0.0);
  system_.evaluate(u_.data(), residual_.data(), nullptr);
  system_.accelerate(residual_.data());
  for (int i = 0; i < system_.nodes(); ++i)
  {
    NodeState& node = state.nodes[i];
    const Eigen::Vector3d n = x_axis(node.orientation), turning = system_.acceleration(i).tail<3>();
    node.acceleration = {system_.acceleration(i).head<3>(), turning - n * n.dot(turning), n.dot(turning)};
    node.averaged_acceleration = node.acceleration;
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
