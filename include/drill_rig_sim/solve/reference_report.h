// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_REFERENCE_REPORT_H
#define DRILL_RIG_SIM_SOLVE_REFERENCE_REPORT_H

#include <cstdint>

namespace drill_rig_sim
{
/// What a run took, since construction.
struct IdaStatistics
{
  std::uint64_t steps = 0;
  std::uint64_t residuals = 0;
  std::uint64_t jacobians = 0;  ///< each with a factorisation
  std::uint64_t newton_iterations = 0;
  std::uint64_t error_test_failures = 0;
  std::uint64_t newton_failures = 0;
  std::uint64_t starts = 0;
  int last_order = 0;
  double last_step = 0.0;      ///< [s]
  double smallest_step = 0.0;  ///< at the ends of advance() [s]
  int flag = 0;                ///< IDA's, of the last advance()

  /// Counts on from `before`; the last four stay this run's.
  void add(const IdaStatistics& before)
  {
    steps += before.steps;
    residuals += before.residuals;
    jacobians += before.jacobians;
    newton_iterations += before.newton_iterations;
    error_test_failures += before.error_test_failures;
    newton_failures += before.newton_failures;
    starts += before.starts;
  }
};

/// What the reference reports beside the counters that all integrators have.
struct ReferenceReport
{
  IdaStatistics ida;
  double drift = 0.0;       ///< largest violation of a joint at the ends of steps, |g| [m or rad]
  double rate_drift = 0.0;  ///< and of its rate, |G v| [m/s or rad/s]
};

}  // namespace drill_rig_sim

#endif
