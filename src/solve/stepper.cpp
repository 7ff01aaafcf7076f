#include "drill_rig_sim/solve/stepper.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
namespace
{
constexpr int kMaxHalvings = 5;
constexpr int kBudget = 120;  // Newton iterations that one step may cost in all
}  // namespace

const std::vector<Method>& method_table()
{
  static const std::vector<Method> table = {
      {"bdf2", "BDF2, second order, L-stable, one solve a step (default)", prepare_bdf2},
      {"implicit_euler", "implicit Euler, first order, L-stable", prepare_implicit_euler},
  };
  return table;
}

const Method* find_method(const std::string& name)
{
  for (const Method& method : method_table())
    if (name == method.name || name == "auto") return &method;
  return nullptr;
}

void predict(const SystemState& state, double step, double* u) noexcept
{
  // rate + h/2 times the last acceleration
  const double bend = state.last_step > 0.0 ? 0.5 * step / state.last_step : 0.0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
  {
    const NodeState& node = state.nodes[i];
    const NodeRate& a = node.rate;
    const NodeRate& b = node.last_rate;
    Eigen::Map<Vector6d> guess(u + 6 * i);
    guess.head<3>() = step * (a.velocity + bend * (a.velocity - b.velocity));
    guess.tail<3>() = step * (a.tilt + bend * (a.tilt - b.tilt) + (a.spin + bend * (a.spin - b.spin)) * x_axis(node.orientation));
  }
}

Stepper::Stepper(System& system, const Method& method)
  : system_(system), method_(method), newton_(system.nodes()), u_(6 * system.nodes()), guess_(6 * system.nodes()), residual_(6 * system.nodes())
{
}

bool Stepper::advance(SystemState& state, double step, const Setpoints& setpoints) noexcept
{
  int budget = kBudget;
  int halvings = 0;
  int done = 0;  // in units of step / 2^kMaxHalvings
  constexpr int whole = 1 << kMaxHalvings;
  while (done < whole)
  {
    const int part = whole >> halvings;
    if (attempt(state, step * part / whole, setpoints, budget))
    {
      done += part;
      // try the longer step again where the grid allows
      if (halvings > 0 && done % (2 * part) == 0) --halvings;
      continue;
    }
    ++counters_.rejected_steps;
    if (++halvings > kMaxHalvings || budget <= 0) return false;
  }
  return true;
}

bool Stepper::attempt(SystemState& state, double step, const Setpoints& setpoints, int& budget) noexcept
{
  system_.begin(state, step, setpoints);
  method_.prepare(state, step, system_, system_.stage());
  predict(state, step, u_.data());
  std::copy(u_.begin(), u_.end(), guess_.begin());
  NewtonLimits limits = limits_;
  limits.max_iterations = std::min(limits.max_iterations, budget);
  const NewtonOutcome outcome = newton_.solve(system_, u_.data(), limits);
  counters_.newton_iterations += outcome.iterations;
  budget -= outcome.iterations;
  if (!outcome.converged) return false;
  error_estimate_ = predictor_distance() / 6.0;
  system_.evaluate(u_.data(), residual_.data(), nullptr);
  system_.finish(state);
  system_.costs().lap(Cost::other);
  penetrate_rock(state, step);
  system_.costs().lap(Cost::rock_penetration);
  ++counters_.steps;
  return true;
}

void Stepper::penetrate_rock(SystemState& state, double step) const noexcept
{
  state.bit.rock_velocity = system_.rock_velocity(state);
  state.well.extend(step * state.bit.rock_velocity, x_axis(state.nodes[0].orientation));
}

double Stepper::predictor_distance() const noexcept
{
  double most = 0.0;
  for (std::size_t k = 0; k < u_.size(); k += 6)
    for (std::size_t c = k; c < k + 3; ++c) most = std::max(most, std::abs(u_[c] - guess_[c]));
  return most;
}

}  // namespace drill_rig_sim
