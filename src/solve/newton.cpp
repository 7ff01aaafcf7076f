// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/newton.h"

#include <cmath>
#include <limits>
#include <utility>

#include "drill_rig_sim/model/evaluate.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kServes = 0.2;  // a kept tangent whose increments shrink less than this is made anew

/// Not a number if one of them, six a node, is not finite.
double largest(const std::vector<double>& values) noexcept
{
  using Six = Eigen::Array<double, 6, 1>;
  Six most = Six::Zero(), sum = Six::Zero();
  for (std::size_t k = 0; k < values.size(); k += 6)
  {
    const Six size = Eigen::Map<const Six>(values.data() + k).abs();
    most = most.max(size);
    sum += size;
  }
  return most.maxCoeff() + (sum - sum).sum();
}
}  // namespace

bool newton_converged(double increment, double before, const NewtonLimits& limits) noexcept
{
  if (increment > limits.max_increment) return false;  // it was cut
  const double contraction = before > 0.0 ? increment / before : 1.0;
  return increment * std::fmin(1.0, contraction) < limits.tolerance;
}

Newton::Newton(const Model& model) : step_(6 * model.nodes()), last_(step_)
{
  tangent_.resize(model.nodes(), model.kernel());
}

/// Into step_; returns its largest component, not a number where there is none.
double Newton::find_increment(const StageContext& problem, const double* u, bool new_tangent) noexcept
{
  evaluate(problem.model, problem.start, problem.stage, u, problem.work, step_.data(), new_tangent ? &tangent_ : nullptr);
  bool solved = true;
  if (new_tangent)
  {
    solved = solve_increment(problem.stage, tangent_, step_.data());
    ++problem.work.work.solves;
  }
  else
  {
    solve_increment_again(problem.stage, tangent_, step_.data());
    ++problem.work.work.substitutions;
  }
  problem.work.profiler.lap(Cost::linear_solve);
  return solved ? largest(step_) : std::numeric_limits<double>::quiet_NaN();
}

void Newton::apply(double scale, double* u) const noexcept
{
  const auto size = static_cast<Eigen::Index>(step_.size());
  Eigen::Map<Eigen::ArrayXd>(u, size) -= scale * Eigen::Map<const Eigen::ArrayXd>(step_.data(), size);
}

void Newton::go_back(double* u) const noexcept
{
  for (std::size_t k = 0; k < last_.size(); ++k) u[k] += 0.5 * last_[k];
}

NewtonOutcome Newton::solve(const StageContext& problem, double* u, const NewtonLimits& limits) noexcept
{
  NewtonOutcome out;
  double before = 0.0;
  bool new_tangent = true;
  while (!new_tangent || out.iterations < limits.max_iterations)
  {
    out.increment = find_increment(problem, u, new_tangent);
    if (new_tangent) ++out.iterations;
    if (!std::isfinite(out.increment)) return out;
    if (!new_tangent)
    {
      out.converged = out.increment < limits.tolerance;
      if (out.converged) return out;
      new_tangent = out.increment > kServes * before;
      if (out.increment > before)
      {
        go_back(u);
        before = 0.0;
      }
      if (new_tangent) continue;
    }
    const double scale = out.increment > limits.max_increment ? limits.max_increment / out.increment : 1.0;
    apply(scale, u);
    out.converged = newton_converged(out.increment, before, limits);
    if (out.converged)
    {
      update(problem.model, problem.start, problem.stage, u, problem.work);
      return out;
    }
    before = out.increment;
    new_tangent = scale < 1.0;
    std::swap(step_, last_);
  }
  return out;
}

bool Newton::improve(const StageContext& problem, double* u) noexcept
{
  if (!std::isfinite(find_increment(problem, u, true))) return false;
  apply(1.0, u);
  return true;
}

}  // namespace drill_rig_sim
