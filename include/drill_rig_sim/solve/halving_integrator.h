// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_HALVING_INTEGRATOR_H
#define DRILL_RIG_SIM_SOLVE_HALVING_INTEGRATOR_H

#include "drill_rig_sim/solve/integrator.h"

namespace drill_rig_sim
{
/// What became of a step.
enum class StepResult
{
  solved,
  error_test_failed,  ///< solved, but worth halves; the state is untouched
  not_converged       ///< the state is untouched
};

/// An integrator whose steps may fail: a step that cannot be solved is repeated in halves, quarters, ... down to 1/32, one that
/// is too coarse for what happens in it down to 1/8, all within a bounded number of iterations.
class HalvingIntegrator : public Integrator
{
public:
  using Integrator::Integrator;
  bool advance(State& state, double step, const Setpoints& setpoints) noexcept override;
  void keep_balance(EnergyBalance* balance) noexcept final { balance_ = balance; }

protected:
  /// In attempt() before begin_step(), and once it is solved before commit().
  void open_books(const State& state, const Setpoints& setpoints) noexcept;
  void close_books(const State& state, const Stage& stage, const double* u) noexcept;

private:
  EnergyBalance* balance_ = nullptr;
  /// One step of `step` [s]. `budget`: Newton iterations left, reduced by those it took; `may_refine`: error_test_failed may be
  /// answered.
  virtual StepResult attempt(State& state, double step, const Setpoints& setpoints, int& budget, bool may_refine) noexcept = 0;
};

}  // namespace drill_rig_sim

#endif
