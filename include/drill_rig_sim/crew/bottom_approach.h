// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_BOTTOM_APPROACH_H
#define DRILL_RIG_SIM_CREW_BOTTOM_APPROACH_H

#include "drill_rig_sim/crew/steady_load.h"
#include "drill_rig_sim/instruments/signals.h"

namespace drill_rig_sim
{
/// A string on its hook, as the approach to bottom needs it.
struct HookedString
{
  double stiffness = 0.0;  ///< K, axial, of pipe and lines in series [N/m]
  double mass = 0.0;       ///< M, of pipe and block [kg]
  double mean_time = 0.0;  ///< whole periods in which it rings, for a mean of the hook load [s]

  template <class V>
  void visit(V& v)
  {
    v("stiffness", stiffness);
    v("mass", mass);
    v("mean_time", mean_time);
  }
};

/// Lowers a bit to bottom, where WeightFeed keeps a weight W* [N].
/// - Over the last part the block's speed is v = W*/(K T), T = WeightFeed::feed_time, at most `fastest`: the speed with which
/// WeightFeed begins. On rock that does not
///   give way the weight rises by K v = W*/T. The hook load shows it later, by the time of a wave up the string (1 s from 5 km):
///   the bit gains W*/8 in that second.
/// - The bit's depth by the block is wrong by the change of the pipe's stretch, dF/K for a drag that changes by dF. The slow part
/// lasts slow_time, 5 W*/K, and goes on
///   for beyond_time below the bottom: dF may be from -2.5 W* to 5 W*. A bit that meets no weight there is in soft rock.
/// - Above it the block accelerates by a = inertia W*/M at most, so that neither the string's inertia nor its ringing is taken
/// for weight.
/// - While drag and the friction of the sheaves turn round, the hook load falls as on a bottom. Weight counts once the hook load
/// of the lowered string was steady (SteadyLoad). A bit that comes to
///   bottom before that, and whose weight is to be zeroed, is lifted, each time twice as far, and lowered again, most_lifts times
///   at most. On a rig that heaves the load is never steady: weight counts at once there.
/// The bit is on bottom once a lagged mean of the weight is `felt` W*.
class BottomApproach
{
public:
  static constexpr double fastest = 0.02;      ///< of the slow part, as of tag [m/s]
  static constexpr double slow_time = 40.0;    ///< of the slow part [s]
  static constexpr double beyond_time = 20.0;  ///< how long it goes on below the bottom [s]
  static constexpr double felt = 0.2;          ///< of W*: the bit is on bottom [-]
  static constexpr double felt_time = 1.0;     ///< of the lag of that weight [s]
  static constexpr double inertia = 0.1;       ///< M a of W* [-]
  static constexpr double steady = 0.05;       ///< of W*: of a steady hook load [-]
  static constexpr int most_lifts = 3;

  /// From where the bit is: for weight [N], not faster than `speed` [m/s]. `zeroes`: the weight is zeroed all the way down, which
  /// needs some way: a bit that is too near the bottom is lifted first.
  void begin(const Readings& now, const HookedString& string, double weight, double speed, bool zeroes, bool heaves) noexcept;
  /// Whether the bit is still on its way, by the readings after `duration` [s] more.
  bool goes_on(const Readings& now, double duration) noexcept;
  /// Of the block, + up [m/s]; for the next `duration` [s].
  double velocity(const Readings& now, double duration) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("begun", begun);
    v("over", over_);
    v("zeroes", zeroes_);
    v("lifts", lifts_);
    v("lifts_left", lifts_left_);
    v("settled", settled_);
    v("wanted", wanted_);
    v("most", most_);
    v("slow", slow_);
    v("gentle", gentle_);
    v("bottom", bottom_);
    v("room", room_);
    v("lift_to", lift_to_);
    v("load", load_);
    v("speed", speed_);
    v("mean_weight", mean_weight_);
  }

  bool begun = false;

private:
  void begin_to_lower(const Readings& now) noexcept;
  void lift(const Readings& now) noexcept;
  bool is_near(const Readings& now) const noexcept;

  bool over_ = false;  // bottom is reached for good
  bool zeroes_ = false;
  bool lifts_ = false;  // the block goes up, to lift_to_
  int lifts_left_ = 0;
  bool settled_ = false;      // the hook load of the lowered string was steady
  double wanted_ = 0.0;       // W* [N]
  double most_ = 0.0;         // [m/s]
  double slow_ = 0.0;         // v [m/s]
  double gentle_ = 0.0;       // a [m/s2]
  double bottom_ = 0.0;       // depth of the hole at the beginning, by the readings [m]
  double room_ = 0.0;         // above bottom, to where it is lifted [m]
  double lift_to_ = 0.0;      // height of the block [m]
  SteadyLoad load_;           // the hook load
  double speed_ = 0.0;        // down [m/s]
  double mean_weight_ = 0.0;  // [N]
};

}  // namespace drill_rig_sim

#endif
