// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_SPAN_WALL_H
#define DRILL_RIG_SIM_MODEL_FORCES_SPAN_WALL_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Wall of the hole on the pipe between the nodes: the law of the nodes (contact/wall_contact.h) at the middle of each element
/// (SpanMotion), its force put on the ends by the same shape functions that say where the middle is. Without it a joint of pipe
/// under compression bows through the wall. In statics at full slip, as Stage::sliding says.
extern const Force span_wall;

/// The middle's six numbers from those of the ends: displacement and rotation, or their rates.
Vector6d middle(const SpanMotion& span, const Vector6d& lower, const Vector6d& upper) noexcept;

/// Adds J^T B J to the tangent of both ends, J the middle's motions by theirs. `block` B: 6x6, by displacement and rotation of
/// the middle.
void add_at_ends(const SpanMotion& span, int e, const Eigen::Matrix<double, 6, 6>& block, BlockTridiagonal& tangent) noexcept;

}  // namespace drill_rig_sim

#endif
