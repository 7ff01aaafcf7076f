#ifndef DRILL_RIG_SIM_SOLVE_STEPPER_H
#define DRILL_RIG_SIM_SOLVE_STEPPER_H

#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/solve/newton.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
/// A one-stage implicit method: fills the stage's rate_0, acceleration_0 and c for a step of length `step` from `state`.
/// A new method is a function like this in a file of its own and a line in method_table().
struct Method
{
  const char* name;
  const char* description;
  void (*prepare)(const SystemState& state, double step, const System& system, Stage& stage) noexcept;
};

const std::vector<Method>& method_table();
/// Null for an unknown name; "auto" is the default method.
const Method* find_method(const std::string& name);

/// Implicit Euler: first order, L-stable. Also starts the multi-step methods.
void prepare_implicit_euler(const SystemState& state, double step, const System& system, Stage& stage) noexcept;
/// BDF2 with variable step: second order, L-stable, one solve a step.
void prepare_bdf2(const SystemState& state, double step, const System& system, Stage& stage) noexcept;

/// Extrapolates the last steps: the first guess of u (6 per node).
void predict(const SystemState& state, double step, double* u) noexcept;

struct StepperCounters
{
  std::uint64_t steps = 0;
  std::uint64_t newton_iterations = 0;
  std::uint64_t rejected_steps = 0;
};

/// Fixed-step real-time stepping: one implicit solve a step, the hole extended after each. A step whose Newton iteration does not
/// converge is repeated in halves, quarters, ... down to 1/32, all within a bounded number of iterations.
/// Noexcept and allocation-free after construction.
class Stepper
{
public:
  Stepper(System& system, const Method& method);

  /// Advances `state` by `step` [s]. False: it could not; the state then is the last one that was solved, still finite.
  bool advance(SystemState& state, double step, const Setpoints& setpoints) noexcept;

  const StepperCounters& counters() const noexcept { return counters_; }
  const Method& method() const noexcept { return method_; }
  NewtonLimits& limits() noexcept { return limits_; }
  /// Local error of the last step's positions, estimated from the distance between predictor and solution (Milne's device) [m].
  double error_estimate() const noexcept { return error_estimate_; }

private:
  double predictor_distance() const noexcept;
  void penetrate_rock(SystemState& state, double step) const noexcept;
  bool attempt(SystemState& state, double step, const Setpoints& setpoints, int& budget) noexcept;

  System& system_;
  Method method_;
  Newton newton_;
  NewtonLimits limits_;
  std::vector<double> u_;
  std::vector<double> guess_;
  std::vector<double> residual_;
  StepperCounters counters_;
  double error_estimate_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
