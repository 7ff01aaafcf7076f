// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_PRESSURE_TREND_H
#define DRILL_RIG_SIM_CREW_PRESSURE_TREND_H

#include "drill_rig_sim/crew/lag_pair.h"

namespace drill_rig_sim
{
/// Whether the stand-pipe pressure has come to rest: a pair of lags of it agrees. The mud's
/// pressures change the hook load, so that a zero of the weight waits for it.
struct PressureTrend
{
  static constexpr double trend_time = 2.0;                 ///< of the faster lag [s]
  static constexpr double share = 0.004, resolution = 2e4;  ///< they agree within the larger of these [-], [Pa]
  LagPair lags;                                             ///< [Pa]
  double at = 0.0;                                          ///< when the last was taken [s]
  bool begun = false;

  /// A pressure [Pa] at a time [s]; of the first one nothing is known of before.
  void take(double pressure, double time) noexcept;
  bool is_steady() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("lags", lags);
    v("at", at);
    v("begun", begun);
  }
};

}  // namespace drill_rig_sim

#endif
