// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_TELEMETRY_H
#define DRILL_RIG_SIM_INSTRUMENTS_TELEMETRY_H

#include <array>
#include <cstddef>

#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
constexpr double least_flow_of_pulses = 1e-4;  ///< below it no pulse reaches the surface [m3/s]

/// Readings on their way up, in the order in which they were sent.
template <class Reading>
class TelemetryQueue
{
public:
  /// Sent at `time` [s]. One that finds no room is lost, as where telemetry is saturated.
  void push(const Reading& r, double time) noexcept
  {
    if (count_ == entry_.size()) return;
    const std::size_t last = (first_ + count_++) % entry_.size();
    entry_[last] = r;
    sent_[last] = time;
  }
  /// Takes the oldest if it was sent by `time` [s].
  bool pop_before(double time, Reading& r) noexcept
  {
    if (count_ == 0 || sent_[first_] > time) return false;
    r = entry_[first_];
    first_ = (first_ + 1) % entry_.size();
    --count_;
    return true;
  }

  template <class V>
  void visit(V& v)
  {
    v("entry", entry_);
    v("sent", sent_);
    v("first", first_);
    v("count", count_);
  }

private:
  std::array<Reading, most_on_the_way> entry_;
  std::array<double, most_on_the_way> sent_{};  // when [s]
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace drill_rig_sim

#endif
