// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_PRESSURE_TREND_H
#define DRILL_RIG_SIM_CREW_PRESSURE_TREND_H

namespace drill_rig_sim
{
/// Whether the stand-pipe pressure has come to rest: two first-order lags of it, one twice as slow as the other, agree. The mud's
/// pressures change the hook load, so that a zero of the weight waits for it.
struct PressureTrend
{
  static constexpr double fast = 2.0, slow = 4.0;           ///< time constants [s]
  static constexpr double share = 0.004, resolution = 2e4;  ///< they agree within the larger of these [-], [Pa]
  double fast_mean = 0.0, slow_mean = 0.0;                  ///< [Pa]
  double at = 0.0;                                          ///< when the last was taken [s]
  bool begun = false;

  /// A pressure [Pa] at a time [s]; of the first one nothing is known of before.
  void take(double pressure, double time) noexcept;
  bool is_steady() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("fast_mean", fast_mean);
    v("slow_mean", slow_mean);
    v("at", at);
    v("begun", begun);
  }
};

}  // namespace drill_rig_sim

#endif
