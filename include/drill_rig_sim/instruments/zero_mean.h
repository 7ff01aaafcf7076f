// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_ZERO_MEAN_H
#define DRILL_RIG_SIM_INSTRUMENTS_ZERO_MEAN_H

#include "drill_rig_sim/instruments/period_mean.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/zero_window.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/string/mesh.h"

namespace drill_rig_sim
{
/// A string that hangs off bottom in the lines, as one rod.
struct HungString
{
  double mass = 0.0;       ///< of the pipe [kg]
  double stiffness = 0.0;  ///< of the pipe, axial [N/m]
  double lines = 0.0;      ///< stiffness of the lines under its weight [N/m]

  /// The block at a height [m].
  HungString(const Mesh& mesh, const HoistingSpec& hoisting, double block_height);
  /// Period of the slowest axial vibration, with the block's mass [kg] on the lines; [s].
  double ring_period(double block_mass) const noexcept;
};

/// The hook load of which a zero of the weight is taken: its mean over whole periods in which the string rings in the lines, at
/// least shortest_mean; of a floating rig over a period of the waves. On a rig that does not heave the mean begins anew where the
/// block starts, stops or turns back, and where the string starts or stops turning: friction acts another way then. A block that
/// starts has to move by twice sheave_presliding first, over which the friction of its sheaves turns round. A mean over a
/// duration that is asked for begins anew there too, and where the pump's set point changes, and on bottom and in the slips.
class ZeroMean
{
public:
  static constexpr double shortest_mean = 2.0;  ///< [s]

  /// How long a mean is, of a string that rings with a period [s]: [s].
  static double mean_time(double period) noexcept;

  ZeroMean() = default;
  /// `wave_period` [s]: 0 on a rig that does not heave; the mean's length comes with rings_with() then.
  explicit ZeroMean(double wave_period);
  /// The string rings with another period [s]: at the start, and where pipe was added or taken away.
  void rings_with(double period) noexcept;
  /// The hook load [N] with the other signals of its instant. The same instant may be given again.
  void take(double hook_load, const RigSignals& now, bool on_bottom = false) noexcept;
  /// [N]
  double mean() const noexcept { return mean_.mean(); }
  /// What there is for a zero over a duration.
  const ZeroWindow& window() const noexcept { return window_; }

  /// What it remembers; periods are the rig's.
  template <class V>
  void visit(V& v)
  {
    v("mean", mean_);
    v("direction", direction_);
    v("turns", turns_);
    v("began_at", began_at_);
    v("flow", flow_);
    v("window", window_);
  }

private:
  bool heaves_ = false;
  PeriodMean mean_;
  int direction_ = 0;  // of the block: + up
  bool turns_ = false;
  double flow_ = 0.0;  // set point [m3/s]
  ZeroWindow window_;
  double began_at_ = 0.0;  // height of the block where it took its direction [m]
};

}  // namespace drill_rig_sim

#endif
