// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_OPERATION_TROUBLE_H
#define DRILL_RIG_SIM_CREW_OPERATION_TROUBLE_H

#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Why an operation was given up: drill and slide for the first two, others cannot reach their end.
enum class OperationTrouble
{
  none,
  motor_stalled,    ///< differential pressure stood at the motor's stall pressure for stall_lasts
  over_weight,      ///< surface weight on bit stood far above what was wanted for over_weight_lasts
  below_bottom,     ///< the depth of a trip is below the bottom of the hole
  no_zero,          ///< drill or slide begins on bottom or in the slips without a zero of the weight
  tag_on_bottom,    ///< tag begins there
  nothing_to_take,  ///< the block is at its highest place, and the crew has no stand to take away
  no_room_to_add,   ///< the block is at its lowest place, and the crew can add no stand
  block_at_stop,    ///< the block stands at an end of its travel
  bottom_too_near   ///< the bit is on bottom before the block is low enough for a connection
};

/// One line; empty for none.
const char* text_of(OperationTrouble trouble) noexcept;

/// Looks at what a driller looks at while drilling: differential pressure and weight. Not more often than what stands for
/// seconds.
class OperationTroubleWatch
{
public:
  static constexpr double stall_share = 0.97;  ///< of the stall pressure [-]
  static constexpr double no_hole_share =
      0.9;  ///< the same where no hole is made: the zero was taken with what the motor needs off bottom [-]
  static constexpr double no_hole = 1e-5;     ///< rate of penetration below which none is made [m/s]
  static constexpr double stall_lasts = 2.0;  ///< by which the time at it is longer than the time below: a gauge has noise [s]
  static constexpr double over_weight_lasts = 10.0;  ///< [s]
  static constexpr double at_stop_lasts = 10.0;      ///< by which the string's stretch has come to rest, or is drilled off [s]
  static constexpr double stands = 1e-4;             ///< speed of a block that stands [m/s]
  /// Weight on bit far above `wanted` [N]: twice as much, and at least 30 kN more.
  static double over_weight(double wanted) noexcept;

  explicit OperationTroubleWatch(const Scene& scene);
  /// An operation begins at this time [s].
  void begin(double time) noexcept;
  /// Of the operation under way, by the readings of the last frame. The differential pressure counts once it is zeroed (tare).
  OperationTrouble look(const Operation& operation, const Readings& now) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("running_at", running_at_);
    v("seen_at", seen_at_);
    v("within_at", within_at_);
    v("moves_at", moves_at_);
  }

private:
  double stall_pressure_ = 0.0;  // of the mud motor; 0: the string has none [Pa]
  double running_at_ = 0.0;      // when the motor was last below it; later by the time that it was below since [s]
  double seen_at_ = 0.0;         // the last look [s]
  double within_at_ = 0.0;       // when the weight was last within its bound [s]
  double moves_at_ = 0.0;        // when the block, or the hole, was last seen to get on [s]
};

}  // namespace drill_rig_sim

#endif
