// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_TAG_H
#define DRILL_RIG_SIM_CREW_TAG_H

#include "drill_rig_sim/crew/steady_load.h"
#include "drill_rig_sim/instruments/period_mean.h"
#include "drill_rig_sim/instruments/signals.h"

namespace drill_rig_sim
{
/// What a tag is to do.
struct TagTask
{
  double speed = 0.0;      ///< of the block, down [m/s]
  double weight = 0.0;     ///< that the bit is to take [N]
  double mean_time = 0.0;  ///< of a mean of the hook load [s]
  double settles = 0.0;    ///< how long the zero is taken on a rig that heaves [s]
  bool may_lift = false;   ///< it has a zero of its own, and the rig does not heave

  template <class V>
  void visit(V& v)
  {
    v("speed", speed);
    v("weight", weight);
    v("mean_time", mean_time);
    v("settles", settles);
    v("may_lift", may_lift);
  }
};

/// Lowers a string at a constant speed until the bit takes a weight, and zeroes the weight on the way.
/// - The zero is renewed until it is steady (SteadyLoad), and from then on whenever it is: a load that falls faster is weight, on
/// bottom or above. On bottom it is refused, for a zero of the weight is one off bottom.
/// - A zero needs room: `turns_round` of SteadyLoad, and the time of a mean and steady_time at the speed, at least least_room. A
/// bit that hangs nearer to the bottom is lifted first. One that comes to bottom without a steady zero is lifted twice as far
/// each time, most_lifts times at most.
/// - A bit that comes to bottom before the pressure of the mud is steady is lifted and hangs there until it is.
/// - On a rig that heaves nothing is lifted, no load is steady, and the zero is taken for a settling time.
class Tag
{
public:
  static constexpr double least_room = 0.05;   ///< [m]
  static constexpr double steady_time = 4.0;   ///< in which a steady zero is known [s]
  static constexpr double steady = 0.05;       ///< of the weight: so far a steady zero may change [-],
  static constexpr double resolution = 0.001;  ///< or of the zero itself, what a good gauge tells apart [-]
  static constexpr int most_lifts = 4;

  void begin(const Readings& now, const TagTask& task) noexcept;
  /// Whether the weight is to be zeroed now.
  bool zeroes() const noexcept { return phase_ == Phase::hangs || (phase_ == Phase::lowers && (!has_zero_ || renews_)); }
  /// Of the block, + up [m/s]. `refused`: the weight was to be zeroed, but the bit is on bottom. `rise`: how far the block still
  /// rises when it is stopped [m]. `waits`: the pressure still changes.
  double velocity(const Readings& now, bool refused, double rise, bool waits) noexcept;
  /// Whether the weight that is shown is one on the bit.
  bool counts() const noexcept { return phase_ == Phase::weighs || (phase_ == Phase::lowers && has_zero_); }

  template <class V>
  void visit(V& v)
  {
    v("task", task_);
    v("mean", mean_);
    v("lifts_left", lifts_left_);
    v("phase", phase_);
    v("has_zero", has_zero_);
    v("renews", renews_);
    v("room", room_);
    v("lift_to", lift_to_);
    v("lowers_since", lowers_since_);
    v("turned_at", turned_at_);
    v("followed_at", followed_at_);
    v("load", load_);
  }

private:
  enum class Phase
  {
    lifts,
    hangs,
    lowers,
    weighs
  };

  void lift(const Readings& now) noexcept;
  void lower(const Readings& now) noexcept;
  void follow_load(const Readings& now, bool refused, bool waits) noexcept;

  TagTask task_;
  PeriodMean mean_;  // of the hook load
  int lifts_left_ = 0;
  Phase phase_ = Phase::lowers;
  bool has_zero_ = false;      // that will do, since it is lowered
  bool renews_ = false;        // as the load is steady now
  double room_ = 0.0;          // above bottom, to where it is lifted [m]
  double lift_to_ = 0.0;       // height of the block [m]
  double lowers_since_ = 0.0;  // [s]
  double turned_at_ = 0.0;     // [s]
  double followed_at_ = 0.0;   // [s]
  SteadyLoad load_;            // its mean
};

}  // namespace drill_rig_sim

#endif
