// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_LAG_PAIR_H
#define DRILL_RIG_SIM_CREW_LAG_PAIR_H

#include <cmath>

namespace drill_rig_sim
{
/// Two first-order lags of a signal, one twice as slow as the other: they agree where it has come to rest. Units are the
/// signal's.
struct LagPair
{
  double fast = 0.0, slow = 0.0;

  /// The signal after `duration` [s] more. `time`: constant of the faster lag [s].
  void take(double value, double duration, double time) noexcept
  {
    fast += duration / (time + duration) * (value - fast);
    slow += duration / (2.0 * time + duration) * (value - slow);
  }
  double apart() const noexcept { return std::abs(fast - slow); }

  template <class V>
  void visit(V& v)
  {
    v("fast", fast);
    v("slow", slow);
  }
};

}  // namespace drill_rig_sim

#endif
