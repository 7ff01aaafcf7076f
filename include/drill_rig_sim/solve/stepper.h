#ifndef DRILL_RIG_SIM_SOLVE_STEPPER_H
#define DRILL_RIG_SIM_SOLVE_STEPPER_H

#include <string>
#include <vector>

#include "drill_rig_sim/solve/halving_integrator.h"
#include "drill_rig_sim/solve/newton.h"
#include "drill_rig_sim/solve/extend_hole.h"
#include "drill_rig_sim/system/system.h"

namespace drill_rig_sim
{
/// What a method works with during one step; the system has begun it. All increments and rates are based on the start of the step.
struct StepContext
{
  const SystemState& state;  ///< at the start
  double step;               ///< [s]
  System& system;
  Newton& newton;
  NewtonLimits limits;
  int budget;                ///< Newton iterations that all stages may cost
  double* u;         ///< 6 per node; in: predicted for the whole step; out: increments at its end
  double* residual;  ///< scratch, 6 per node
  int iterations = 0;

  /// Newton's method on the stage as prepared, from u; the system is left at the solution. False: not converged.
  bool solve() noexcept;
};

/// A fixed-step method. A new one is a function in a file of its own and a line in method_table().
struct Method
{
  IntegratorKind kind;
  const char* name;
  const char* description;
  /// Takes one step: on success the system is left at its end, settled, ready for finish(). False: not solvable.
  bool (*step)(StepContext& context) noexcept;
  /// It starts from NodeState::acceleration, which must be known when there is no history.
  bool needs_acceleration;
  /// Its error is a sixth of what the solution is away from the extrapolation; a step with more than largest_local_error of it is refined.
  bool refines;
  /// What the method itself remembers, written into the state after finish(); null: nothing.
  void (*remember)(SystemState& state, double step) noexcept;
};

/// Local error of a node's place above which a step is repeated in halves [m]. Blows are above it at the default step, the waves that
/// a winch makes are not.
constexpr double largest_local_error = 1e-4;

const std::vector<Method>& method_table();
/// The table's method; automatic, and what is no method of the table: the first, the default.
const Method& find_method(IntegratorKind kind) noexcept;

/// The stage at the start of the step itself: u = 0 has the state's rates, accelerations are zero, the rotor is held.
void prepare_start(const SystemState& state, Stage& stage) noexcept;
/// Implicit Euler: first order, L-stable. Also starts the multi-step methods.
void prepare_implicit_euler(const SystemState& state, double step, Stage& stage) noexcept;
bool step_implicit_euler(StepContext& context) noexcept;
/// Linearly implicit Euler: one linear solve a step, about its start. First order.
bool step_linearly_implicit_euler(StepContext& context) noexcept;
/// BDF2 with variable step: second order, L-stable, one solve a step.
void prepare_bdf2(const SystemState& state, double step, Stage& stage) noexcept;
bool step_bdf2(StepContext& context) noexcept;
/// TR-BDF2: second order, one-step, L-stable, two solves a step.
bool step_trbdf2(StepContext& context) noexcept;
/// Generalised alpha (Chung and Hulbert), forces in balance at the ends of steps (Arnold and Bruels): second order, one solve a step.
bool step_generalised_alpha(StepContext& context) noexcept;
void remember_generalised_alpha(SystemState& state, double step) noexcept;
/// Central differences: second order, no solve, stable for short steps only (explicit_limit.h).
bool step_explicit(StepContext& context) noexcept;

/// A node's rates in the coordinates of u; `normal`: the section normal that they are split by.
inline Vector6d in_step_axes(const NodeRate& rate, const Eigen::Vector3d& normal) noexcept
{
  Vector6d out;
  out << rate.velocity, rate.tilt + rate.spin * normal;
  return out;
}

/// Extrapolates the last steps to `time` after the start of this one [s]: the first guess of u (6 per node).
void predict(const SystemState& state, double time, double* u) noexcept;

/// Fixed-step real-time stepping with a method of the table, the hole extended after each step.
/// Noexcept and allocation-free after construction.
class Stepper : public HalvingIntegrator
{
public:
  Stepper(System& system, const Method& method);

  const Method& method() const noexcept { return method_; }
  NewtonLimits& limits() noexcept { return limits_; }

private:
  double predictor_distance() const noexcept;
  void find_acceleration(SystemState& state, const Setpoints& setpoints) noexcept;
  StepResult attempt(SystemState& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept override;

  System& system_;
  Method method_;
  Newton newton_;
  NewtonLimits limits_;
  std::vector<double> u_;
  std::vector<double> guess_;
  std::vector<double> residual_;
};

}  // namespace drill_rig_sim

#endif
