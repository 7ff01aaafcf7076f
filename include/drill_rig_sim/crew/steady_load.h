// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_STEADY_LOAD_H
#define DRILL_RIG_SIM_CREW_STEADY_LOAD_H

#include "drill_rig_sim/crew/lag_pair.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
/// Tells when the load of a string that is lowered has come to rest, once drag and the friction of the sheaves have turned round.
/// It is steady while a pair of lags of it agrees, after the block has come down by the way over which the sheaves' friction
/// turns round.
class SteadyLoad
{
public:
  static constexpr double trend_time = 1.0;                       ///< of the faster lag [s]
  static constexpr double steady_time = 3.0;                      ///< how long they must agree [s]
  static constexpr double turns_round = 2.0 * sheave_presliding;  ///< way of the block [m]

  /// Anew, from a load [N] with the block at a height [m].
  void begin(double load, double block_height) noexcept;
  /// The load after `duration` [s] more. The lags agree `within` [N].
  void take(double load, double block_height, double duration, double within) noexcept;
  /// The lags begin anew, from a load [N].
  void restart(double load) noexcept;
  /// Whether the block has come down by turns_round.
  bool has_turned() const noexcept { return has_turned_; }
  /// Whether it is steady now, and has been for steady_time.
  bool is_steady() const noexcept { return steady_for_ >= steady_time; }

  template <class V>
  void visit(V& v)
  {
    v("lowers_from", lowers_from_);
    v("lags", lags_);
    v("has_turned", has_turned_);
    v("steady_for", steady_for_);
  }

private:
  double lowers_from_ = 0.0;  // the highest the block was [m]
  LagPair lags_;              // [N]
  bool has_turned_ = false;
  double steady_for_ = 0.0;  // [s]
};

}  // namespace drill_rig_sim

#endif
