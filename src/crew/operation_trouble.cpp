// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/operation_trouble.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/mud_motor.h"

namespace drill_rig_sim
{
const char* text_of(OperationTrouble trouble) noexcept
{
  switch (trouble)
  {
    case OperationTrouble::none:
      break;
    case OperationTrouble::motor_stalled:
      return "the mud motor has stalled; pick up, then use a smaller weight";
    case OperationTrouble::over_weight:
      return "the weight on bit is more than twice its set point and 30 kN above it; use a smaller speed";
    case OperationTrouble::below_bottom:
      return "to_depth is below the bottom of the hole, allowed: down to the bottom";
    case OperationTrouble::no_zero:
      return "the weight on bit is not zeroed, needed: tag before drill or slide";
    case OperationTrouble::tag_on_bottom:
      return "the weight on bit cannot be zeroed on bottom or in the slips, needed: pick_up first";
    case OperationTrouble::nothing_to_take:
      return "the block is at its highest position, and there is no stand to remove";
    case OperationTrouble::no_room_to_add:
      return "the block is at its lowest position, and no stand can be added";
    case OperationTrouble::block_at_stop:
      return "the block is at the end of its travel before the operation has ended; needed: a connection before it";
    case OperationTrouble::bottom_too_near:
      return "the bit reaches bottom before the block is low enough to add a stand, needed: drill deeper first";
  }
  return "";
}

double OperationTroubleWatch::over_weight(double wanted) noexcept
{
  return wanted + std::max(wanted, 30e3);
}

OperationTroubleWatch::OperationTroubleWatch(const Scene& scene)
{
  for (const PartSpec& part : scene.string)
    if (part.motor) stall_pressure_ = mud_motor_stall_pressure(*part.motor);
}

void OperationTroubleWatch::begin(double time) noexcept
{
  running_at_ = within_at_ = seen_at_ = moves_at_ = time;
}

OperationTrouble OperationTroubleWatch::look(const Operation& operation, const Readings& now) noexcept
{
  const bool drills = traits_of(operation.kind).drills;
  const double share = now.rop < no_hole ? no_hole_share : stall_share;
  const bool stalls = drills && stall_pressure_ > 0.0 && now.tared && now.differential_pressure >= share * stall_pressure_;
  if (!stalls) running_at_ = std::min(now.time, running_at_ + 2.0 * (now.time - seen_at_));
  seen_at_ = now.time;
  if (!drills || now.mean_surface_wob <= over_weight(operation.weight)) within_at_ = now.time;
  if (now.time - running_at_ >= stall_lasts) return OperationTrouble::motor_stalled;
  if (now.time - within_at_ >= over_weight_lasts) return OperationTrouble::over_weight;
  const bool at_stop = now.stop_reached && std::abs(now.block_velocity) < stands && (!drills || now.rop < no_hole);
  if (!traits_of(operation.kind).moves || is_set(operation.time) || !at_stop) moves_at_ = now.time;  // a time ends it as well
  return now.time - moves_at_ >= at_stop_lasts ? OperationTrouble::block_at_stop : OperationTrouble::none;
}

}  // namespace drill_rig_sim
