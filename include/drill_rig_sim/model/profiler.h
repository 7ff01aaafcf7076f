// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_PROFILER_H
#define DRILL_RIG_SIM_MODEL_PROFILER_H

#include <array>
#include <chrono>
#include <cstddef>
#include <numeric>

namespace drill_rig_sim
{
/// What a step's time is spent on.
enum class Cost
{
  kinematics,        ///< positions, rotations and rates from the unknowns
  elements,          ///< beams: residual and tangent
  guided,            ///< all of the guided nodes but their linear solve
  inertia,           ///< and the mud's damping
  contact,           ///< location in the hole, normal force, friction
  bit,               ///< bottom, torque on bit
  rig,               ///< hoisting, top drive, constraints of the shaft
  linear_solve,      ///< block elimination
  rock_penetration,  ///< rock-breaking velocity and the hole's extension
  other,             ///< prediction, history, instruments
  count
};

/// Books the time of a run by what it was spent on: each lap() adds the time since the lap before. The monotonic clock is read
/// once a lap (some 25 ns), so laps stand around loops over the whole string, not inside them.
class Profiler
{
public:
  /// Time before this call is not counted.
  void restart() noexcept { last_ = Clock::now(); }

  void lap(Cost cost) noexcept
  {
    const Clock::time_point now = Clock::now();
    spent_[static_cast<std::size_t>(cost)] += now - last_;
    last_ = now;
  }

  /// Time booked so far [s].
  double seconds(Cost cost) const noexcept
  {
    return std::chrono::duration<double>(spent_[static_cast<std::size_t>(cost)]).count();
  }

  /// All time booked so far [s].
  double seconds() const noexcept
  {
    return std::chrono::duration<double>(std::accumulate(spent_.begin(), spent_.end(), Clock::duration::zero())).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  std::array<Clock::duration, static_cast<std::size_t>(Cost::count)> spent_{};
  Clock::time_point last_{};
};

}  // namespace drill_rig_sim

#endif
