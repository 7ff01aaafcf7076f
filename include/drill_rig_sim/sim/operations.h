#ifndef DRILL_RIG_SIM_SIM_OPERATIONS_H
#define DRILL_RIG_SIM_SIM_OPERATIONS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/program.h"

namespace drill_rig_sim
{
class Simulator;

/// What the driller is about.
struct OperationStatus
{
  int number = 0;  ///< of the operation, counted from 1; 0: none, or all are over
  int count = 0;   ///< of operations in all
  OperationKind kind = OperationKind::wait;
  double progress = 0.0;  ///< towards the end that is nearest, 0 to 1
};

/// The feed of drill and slide: block velocity by what the surface weight lacks, e = weight - surface_wob [N]. Against a string and lines of
/// stiffness K that stand on rock, weight grows with d W/dt = K (v - ROP), v the block's speed down. With v = e/(K T) + u and
/// du/dt = e/(4 K T^2) both poles lie at -1/(2 T), whatever the rock: critically damped, without a lasting error. T is feed_time.
struct WeightFeed
{
  static constexpr double feed_time = 8.0;  ///< T, longer than waves take up and down a string of 5 km [s]
  double learnt = 0.0;                      ///< u, downwards [m/s]

  /// Block velocity, + up [m/s], for `lacking` weight e [N], `stiffness` K [N/m], within +-`most` [m/s]; learns over `duration` [s] what is within.
  double velocity(double lacking, double stiffness, double most, double duration) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("learnt", learnt);
  }
};

/// Plays a scene's operations: gives the simulator the set points of the one under way before every frame, by the readings alone.
/// - flow and rotate ramp their set point; it stays in force.
/// - pick_up and slack_off move the block, ream up and down again `times`; all end with the brake set.
/// - tag lowers until the bit takes `weight`; it zeroes the weight (tare) at its beginning and again when the string has come to move steadily, after
///   tag_settles, and counts weight from then on, or within tag_near of the hole's depth. slack_off with a `weight` zeroes it at its beginning.
/// - drill keeps `weight` by the block (WeightFeed), and ends with the brake set.
/// - slide does the same with the drive holding an angle (or rocking about it), which it turns by what the toolface lacks whenever a toolface has
///   come that was measured toolface_settles after the last turn.
/// - oscillate rocks the string; without a `time` it goes on while others follow.
class OperationsPlayer
{
public:
  static constexpr double toolface_settles = 8.0;  ///< [s]
  static constexpr double tag_settles = 10.0;      ///< [s]
  static constexpr double tag_near = 0.5;          ///< [m]

  /// Works out the stiffness of string and lines. Allocates; nothing else here does.
  explicit OperationsPlayer(const Scene& scene);
  /// Ends what is over, begins what is next, and follows. Call before each frame.
  void apply(Simulator& simulator) noexcept;
  bool finished() const noexcept { return next_ == operations_.size(); }
  void rewind() noexcept;
  OperationStatus status() const noexcept;
  /// When each operation began, in order, and after them when the last one was over [s]; NaN: not yet.
  const std::vector<double>& began() const noexcept { return began_; }

  /// Where it is; the operations are the scene's.
  template <class V>
  void visit(V& v)
  {
    v("next", next_);
    v("under_way", under_way_);
    v("began", began_);
    v("began_at", began_at_);
    v("began_bit", began_bit_);
    v("began_hole", began_hole_);
    v("began_block", began_block_);
    v("began_load", began_load_);
    v("ramp", ramp_);
    v("feed", feed_);
    v("followed_at", followed_at_);
    v("legs", legs_);
    v("settled", settled_);
    v("angle", angle_);
    v("turned_at", turned_at_);
    v("toolface_seen", toolface_seen_);
    v("progress", progress_);
  }

private:
  void begin(Simulator& simulator) noexcept;
  void follow(Simulator& simulator) noexcept;
  void follow_ramp(Simulator& simulator) noexcept;
  void follow_weight(Simulator& simulator) noexcept;
  void follow_strokes(Simulator& simulator) noexcept;
  void follow_tag(Simulator& simulator) noexcept;
  void follow_toolface(Simulator& simulator) noexcept;
  void end(Simulator& simulator) const noexcept;
  double progress(const Simulator& simulator) const noexcept;
  double progress_in_place(const Simulator& simulator) const noexcept;

  std::vector<Operation> operations_;
  double stiffness_ = 0.0;  // of string and lines in series [N/m]
  std::size_t next_ = 0;
  bool under_way_ = false;
  std::vector<double> began_;
  double began_at_ = 0.0, began_bit_ = 0.0, began_hole_ = 0.0, began_block_ = 0.0, began_load_ = 0.0;  // time, bit depth, hole depth, block height, hook load
  Ramp ramp_;
  WeightFeed feed_;
  double followed_at_ = 0.0;  // [s]
  int legs_ = 0;              // of ream, that are over
  bool settled_ = false;      // tag moves steadily
  double angle_ = 0.0;        // of the drive that slide has asked for [rad]
  double turned_at_ = 0.0;    // when it did [s]
  std::uint64_t toolface_seen_ = 0;
  double progress_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
