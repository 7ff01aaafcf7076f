// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_CADENCE_H
#define DRILL_RIG_SIM_REALTIME_CADENCE_H

#include <algorithm>
#include <cstdint>

namespace drill_rig_sim
{
/// Says when something at a fixed rate is due.
class Cadence
{
public:
  /// `rate` [1/s], > 0.
  explicit Cadence(double rate) noexcept : period_(static_cast<std::int64_t>(1e9 / rate)) {}

  /// True once per period of the clock that `now` [ns] comes from; never early by more than a microsecond, no drift. After a gap
  /// no burst: at most two are made up for.
  bool due(std::int64_t now) noexcept
  {
    if (next_ == never) next_ = now;
    if (now + 1000 < next_) return false;
    next_ = std::max(next_ + period_, now - period_);
    return true;
  }

  /// The next time asked is due.
  void restart() noexcept { next_ = never; }

private:
  static constexpr std::int64_t never = INT64_MIN;
  std::int64_t period_;
  std::int64_t next_ = never;
};

}  // namespace drill_rig_sim

#endif
