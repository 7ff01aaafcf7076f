// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_INTEGRATOR_H
#define DRILL_RIG_SIM_SOLVE_INTEGRATOR_H

#include <cstdint>
#include <memory>

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"
#include "drill_rig_sim/solve/reference_report.h"

namespace drill_rig_sim
{
class EnergyBalance;

struct StepperCounters
{
  std::uint64_t steps = 0;
  std::uint64_t newton_iterations = 0;
  std::uint64_t convergence_failures = 0;  ///< without a solution, repeated in parts
  std::uint64_t error_test_failures = 0;   ///< repeated in parts because too much happened in them
};

/// Advances the state of a rig through time in steps of given length, at whose ends the hole is extended and set points change.
class Integrator
{
public:
  explicit Integrator(std::shared_ptr<const Model> model);
  virtual ~Integrator() = default;
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;

  /// Advances `state` by `step` [s]. False: it could not; the state then is the last one that was solved, still finite.
  virtual bool advance(State& state, double step, const Setpoints& setpoints) noexcept = 0;
  /// One step of `step` [s], whole, for integrators with variable steps. False: it has to be subdivided; `state` then
  /// is as it was, but wants a shorter one.
  virtual bool take_one_step(State&, double, const Setpoints&) noexcept { return false; }
  /// The next state is not the one that advance() left: whatever is remembered of the past is void.
  virtual void restart() noexcept {}
  /// Books the energy of all further steps in `balance`; null: no more.
  virtual void keep_balance(EnergyBalance* balance) noexcept = 0;

  /// Forces at the end of the last advance(); those along the string are worked out here.
  const RigForces& find_forces(const State& state) noexcept;
  Profiler& profiler() noexcept { return work_.profiler; }
  Work& work() noexcept { return work_.work; }
  const StepperCounters& counters() const noexcept { return counters_; }
  /// Continues the counters of `before`, after a change of the string's length.
  void count_on_from(const Integrator& before) noexcept
  {
    counters_ = before.counters_;
    work_.work = before.work_.work;
    work_.profiler = before.work_.profiler;
  }
  /// Why the last advance() could not, one line.
  virtual const char* failure() const noexcept
  {
    return "the step did not converge, even divided by 32; reset the well or restore a state";
  }
  /// Local error of the last step's positions, as the method estimates it [m]; 0 where it does not.
  double error_estimate() const noexcept { return error_estimate_; }
  /// Of the reference; null for the others.
  virtual const ReferenceReport* reference() const noexcept { return nullptr; }

protected:
  std::shared_ptr<const Model> model_;
  Stage stage_;
  Workspace work_;
  StepperCounters counters_;
  double error_estimate_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
