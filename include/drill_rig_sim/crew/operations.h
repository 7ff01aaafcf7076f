// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_OPERATIONS_H
#define DRILL_RIG_SIM_CREW_OPERATIONS_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/bottom_approach.h"
#include "drill_rig_sim/crew/operation_trouble.h"
#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/crew/pressure_trend.h"
#include "drill_rig_sim/crew/tag.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
class RigControls;
struct Readings;

/// A tag whose load fell by its weight with the bit above the bottom, by the readings: drag, or an obstacle.
struct HungUp
{
  int number = 0;      ///< of the operation, counted from 1; 0: none
  double above = 0.0;  ///< of the bit over the bottom [m]

  template <class V>
  void visit(V& v)
  {
    v("number", number);
    v("above", above);
  }
};

/// "number 2, tag, ended 0.50 m above the bottom: ..."; empty for none. Allocates.
std::string text_of(const HungUp& hung_up);

/// What the driller is about.
struct OperationStatus
{
  int number = 0;  ///< of the operation, counted from 1; 0: none, or all are over
  int count = 0;   ///< of operations in all
  OperationKind kind = OperationKind::wait;
  double progress = 0.0;  ///< towards the end that is nearest, 0 to 1
  OperationTrouble trouble =
      OperationTrouble::none;  ///< why it was given up; the block is braked then, and no other operation begins
  HungUp hung_up;              ///< the last tag that ended off bottom
};

/// Operations that are over, by when they began (OperationsPlayer::began()).
std::size_t operations_over(const std::vector<double>& began) noexcept;

/// The feed of drill and slide, by the surface weight W [N] that is wanted to be W*. String and lines of stiffness K [N/m] stand
/// on rock: dW/dt = K (v - ROP), v the block's speed down. With v = c W* + (W* - W)/(K T), weight closes on W* with the time T on
/// rock that does not give way, and faster on one that gives way in proportion to weight, c W, once c is learnt: the mean of v -
/// (dW/dt)/K over that of W, both by a first-order lag. There is no lasting error on any rock, for what is learnt in a steady
/// state is its ROP. Weight that is too high is drilled off, never lifted off: sheaves that turn back take as much from the dead
/// line's reading as the bit bears, so that a weight read by it would rise with the block, and the block with the weight.
struct WeightFeed
{
  static constexpr double feed_time = 8.0;   ///< T, longer than waves take up and down a string of 5 km [s]
  static constexpr double learn_time = 4.0;  ///< of the lag [s]
  static constexpr double felt = 0.1;        ///< of W*: with less the bit may be off bottom, and c is taken for that at W* [-]
  double rate = 0.0;                         ///< mean rate of penetration, plus W/(K learn_time) [m/s]
  double mean_weight = 0.0;                  ///< [N]
  bool begun = false;

  /// Block velocity, + up [m/s], from -`most` [m/s] to 0, for the next `duration` [s].
  double velocity(double weight, double wanted, double stiffness, double most, double duration) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("rate", rate);
    v("mean_weight", mean_weight);
    v("begun", begun);
  }
};

/// Plays operations, a scene's or those that a running rig is asked for: gives the simulator the set points of the one under way
/// before every frame, only by the readings.
/// - flow and rotate ramp their set point; it stays in force.
/// - pick_up and slack_off move the block, ream up and down again to where it began `times`; all are stopped or turned back so
/// far ahead of their end as
///   the winch needs, and end with the brake set.
/// - tag lowers until the bit takes `weight`, with a zero of its own (Tag); it waits for a steady pressure for tag_settles and
/// pressure_settles at most. On a rig that heaves it takes tag_settles and a period of the waves at least. slack_off with a
/// `weight` zeroes it at its beginning.
/// - drill brings the bit to bottom (BottomApproach), keeps `weight` by the block (WeightFeed), and ends with the brake set.
/// Without a zero of the weight it
///   waits for a steady pressure and zeroes all the way down.
/// - slide does the same with the drive holding an angle (or rocking about it), which it turns by what the toolface lacks
/// whenever a toolface has
///   come that was measured toolface_settles after the last turn.
/// - steer commands a rotary steerable tool.
/// - connection runs the block to where the rig's crew (crew.h) adds a stand, or takes one away, and is over when that is done;
/// trip moves the bit to a depth, where it
///   stands at the end, the crew making connections on the way, whatever the scene's `connections` says. Both end with the brake
///   set.
/// - oscillate rocks the string; without a `time` it goes on while others follow.
/// An operation that gets into trouble or cannot reach its end (operation_trouble.h) is given up: the brake is set and nothing
/// else is played.
class OperationsPlayer
{
public:
  static constexpr double toolface_settles = 8.0;   ///< [s]
  static constexpr double tag_settles = 10.0;       ///< [s]
  static constexpr double pressure_settles = 60.0;  ///< how much longer tag waits for a steady pressure, at most [s]
  static constexpr double hangs_up = 0.1;           ///< least height of the bit over the bottom that is no tag of it [m]

  /// Works out stiffness and mass of the string. Allocates; nothing else here does.
  explicit OperationsPlayer(const Scene& scene);
  /// Ends what is over, begins what is next, and follows. Call before each frame.
  void apply(RigControls& rig) noexcept;
  bool finished() const noexcept { return next_ == operations_.size(); }
  void rewind() noexcept;
  /// Somebody else has the rig from now on: a block that moves for the operation under way is braked, and the crew goes.
  void stop(RigControls& rig) const noexcept;
  OperationStatus status() const noexcept;
  /// When each operation began, in order, and after them when the last one was over [s]; NaN: not yet.
  const std::vector<double>& began() const noexcept { return began_; }

  template <class V>
  void visit(V& v)
  {
    v("operations", operations_);
    v("string", string_);
    v("next", next_);
    v("began", began_);
    v("began_bit", began_bit_);
    v("began_hole", began_hole_);
    v("began_block", began_block_);
    v("began_load", began_load_);
    v("ramp", ramp_);
    v("approach", approach_);
    v("zeroes", zeroes_);
    v("feed", feed_);
    v("followed_at", followed_at_);
    v("legs", legs_);
    v("crew_came", crew_came_);
    v("tag", tag_);
    v("angle", angle_);
    v("turned_at", turned_at_);
    v("toolface_seen", toolface_seen_);
    v("progress", progress_);
    v("watch", watch_);
    v("trouble", trouble_);
    v("pressure", pressure_);
    v("hung_up", hung_up_);
  }

private:
  void begin(RigControls& rig) noexcept;
  void begin_tag(RigControls& rig, bool zeroed) noexcept;
  void follow(RigControls& rig) noexcept;
  void follow_nothing(RigControls& rig) noexcept;
  void follow_ramp(RigControls& rig) noexcept;
  void follow_slide(RigControls& rig) noexcept;
  void follow_weight(RigControls& rig) noexcept;
  void follow_strokes(RigControls& rig) noexcept;
  void follow_tag(RigControls& rig) noexcept;
  bool waits_for_pressure(const Readings& now) const noexcept;
  void follow_trip(RigControls& rig) noexcept;
  void follow_toolface(RigControls& rig) noexcept;
  void note_hang_up(const Readings& now) noexcept;
  void end(RigControls& rig) const noexcept;
  double progress(const RigControls& rig) const noexcept;
  double rise(const Readings& now) const noexcept;
  double way_to_go(const Readings& now) const noexcept;
  double progress_in_place(const RigControls& rig) const noexcept;

  std::vector<Operation> operations_;
  double acceleration_;  // of the winch [m/s2]
  double wave_period_;   // of a rig that heaves, over which weight is a mean [s]; else 0
  HookedString string_;  // when the operations were given
  std::size_t next_ = 0;
  std::vector<double> began_;
  double began_bit_ = 0.0, began_hole_ = 0.0, began_block_ = 0.0,
         began_load_ = 0.0;  // of the one under way: bit depth, hole depth, block height, hook load
  Ramp ramp_;
  PressureTrend pressure_;
  OperationTroubleWatch watch_;
  OperationTrouble trouble_ = OperationTrouble::none;
  BottomApproach approach_;
  bool zeroes_ = false;  // the weight, all the way down to bottom
  WeightFeed feed_;
  double followed_at_ = 0.0;  // [s]
  int legs_ = 0;              // of ream, that are over
  bool crew_came_ = false;    // has been at work since it began
  Tag tag_;
  double angle_ = 0.0;      // of the drive that slide has asked for [rad]
  double turned_at_ = 0.0;  // when it did [s]
  std::uint64_t toolface_seen_ = 0;
  double progress_ = 0.0;
  HungUp hung_up_;
};

}  // namespace drill_rig_sim

#endif
