#include "drill_rig_sim/solve/newton.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
double largest(const std::vector<double>& values) noexcept
{
  double most = 0.0;
  for (double value : values)
  {
    const double size = std::abs(value);
    if (!(size <= most)) most = size;  // keeps a NaN
    if (!(most < 1e300)) return most;
  }
  return most;
}
}  // namespace

bool newton_converged(double increment, double before, const NewtonLimits& limits) noexcept
{
  if (increment > limits.max_move) return false;  // it was cut
  const double contraction = before > 0.0 ? increment / before : 1.0;
  return increment * std::fmin(1.0, contraction) < limits.tolerance;
}

Newton::Newton(int nodes) : step_(6 * nodes)
{
  tangent_.resize(nodes);
}

NewtonOutcome Newton::solve(System& system, double* u, const NewtonLimits& limits) noexcept
{
  NewtonOutcome out;
  double before = 0.0;
  while (out.iterations < limits.max_iterations)
  {
    system.evaluate(u, step_.data(), &tangent_);
    ++out.iterations;
    const bool solved = tangent_.solve(step_.data());
    ++system.work().solves;
    system.costs().lap(Cost::linear_solve);
    if (!solved) return out;
    out.increment = largest(step_);
    if (!std::isfinite(out.increment)) return out;
    const double scale = out.increment > limits.max_move ? limits.max_move / out.increment : 1.0;
    for (std::size_t k = 0; k < step_.size(); ++k) u[k] -= scale * step_[k];
    out.converged = newton_converged(out.increment, before, limits);
    if (out.converged) return out;
    before = out.increment;
  }
  return out;
}

}  // namespace drill_rig_sim
