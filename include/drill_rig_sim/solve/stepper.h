// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_STEPPER_H
#define DRILL_RIG_SIM_SOLVE_STEPPER_H

#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/solve/halving_integrator.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/step_control.h"

namespace drill_rig_sim
{
/// A step with a larger local error of a node position is subdivided [m]. At the default step, impacts exceed it; waves caused by
/// the winch do not.
constexpr double largest_local_error = 1e-4;

/// The fixed-step methods, the default first.
const std::vector<const Method*>& method_table();
/// The table's method; automatic, and what is no method of the table: the first, the default.
const Method& find_method(IntegratorKind kind) noexcept;

/// Real-time stepping with a method of the table, the hole extended after each step: steps of the given length, halved where they
/// must be, or, with numerics.step 0, steps as the control chooses them (step_control.h), as many of one length as fill what is
/// asked for. Noexcept and allocation-free after construction.
class Stepper : public HalvingIntegrator
{
public:
  Stepper(std::shared_ptr<const Model> model, const Method& method);

  const Method& method() const noexcept { return method_; }
  NewtonLimits& limits() noexcept { return limits_; }
  bool advance(State& state, double step, const Setpoints& setpoints) noexcept override;
  bool take_one_step(State& state, double step, const Setpoints& setpoints) noexcept override;
  const char* failure() const noexcept override;

private:
  StepResult attempt_by_control(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept;
  bool advance_by_control(State& state, double duration, const Setpoints& setpoints) noexcept;
  double find_stretch(const State& state, double step) noexcept;
  double predictor_distance() const noexcept;
  void find_acceleration(State& state, const Setpoints& setpoints) noexcept;
  StepResult attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept override;

  const Method& method_;
  Newton newton_;
  NewtonLimits limits_;
  std::optional<StepControl> control_;  // of variable steps
  double stretch_ = 1.0;                // what it says of the step just solved
  std::vector<double> u_;
  std::vector<double> guess_;
  std::vector<double> residual_;
};

}  // namespace drill_rig_sim

#endif
