#ifndef DRILL_RIG_SIM_SOLVE_STEPPER_H
#define DRILL_RIG_SIM_SOLVE_STEPPER_H

#include <string>
#include <vector>

#include "drill_rig_sim/solve/halving_integrator.h"
#include "drill_rig_sim/solve/methods/method.h"

namespace drill_rig_sim
{
/// Local error of a node's place above which a step is repeated in halves [m]. Blows are above it at the default step, the waves that
/// a winch makes are not.
constexpr double largest_local_error = 1e-4;

/// The fixed-step methods, the default first.
const std::vector<const Method*>& method_table();
/// The table's method; automatic, and what is no method of the table: the first, the default.
const Method& find_method(IntegratorKind kind) noexcept;

/// Fixed-step real-time stepping with a method of the table, the hole extended after each step.
/// Noexcept and allocation-free after construction.
class Stepper : public HalvingIntegrator
{
public:
  Stepper(std::shared_ptr<const Model> model, const Method& method);

  const Method& method() const noexcept { return method_; }
  NewtonLimits& limits() noexcept { return limits_; }

private:
  double predictor_distance() const noexcept;
  void find_acceleration(State& state, const Setpoints& setpoints) noexcept;
  StepResult attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept override;

  const Method& method_;
  Newton newton_;
  NewtonLimits limits_;
  std::vector<double> u_;
  std::vector<double> guess_;
  std::vector<double> residual_;
};

}  // namespace drill_rig_sim

#endif
