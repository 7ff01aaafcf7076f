// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/halving_integrator.h"

#include "drill_rig_sim/solve/energy_balance.h"

namespace drill_rig_sim
{
namespace
{
constexpr int kMaxHalvings = 5;
constexpr int kMaxRefinements = 3;
constexpr int kBudget = 240;  // Newton iterations that one step may cost in all
constexpr int kLeftToHalve =
    60;  // of them those that must be left before a step is refined that has a solution: its eighths need some 16
}  // namespace

void HalvingIntegrator::open_books(const State& state, const Setpoints& setpoints) noexcept
{
  if (balance_) balance_->begin_step(state, setpoints);
}

void HalvingIntegrator::close_books(const State& state, const Stage& stage, const double* u) noexcept
{
  if (balance_) balance_->end_step(state, stage, u);
}

bool HalvingIntegrator::advance(State& state, double step, const Setpoints& setpoints) noexcept
{
  int budget = kBudget;
  int halvings = 0;
  int done = 0;  // in units of step / 2^kMaxHalvings
  constexpr int whole = 1 << kMaxHalvings;
  while (done < whole)
  {
    const int part = whole >> halvings;
    const bool may_refine = halvings < kMaxRefinements && budget > kLeftToHalve;
    const StepResult outcome = attempt(state, step * part / whole, setpoints, budget, may_refine);
    if (outcome == StepResult::solved)
    {
      done += part;
      // try the longer step again where the grid allows
      if (halvings > 0 && done % (2 * part) == 0) --halvings;
      continue;
    }
    if (outcome == StepResult::error_test_failed)
    {
      ++counters_.error_test_failures;
      ++halvings;
      continue;
    }
    ++counters_.convergence_failures;
    if (++halvings > kMaxHalvings || budget <= 0) return false;
  }
  return true;
}

}  // namespace drill_rig_sim
