// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_BIT_H
#define DRILL_RIG_SIM_MODEL_FORCES_BIT_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The bit on the bottom: its weight in mud, the bottom's push (contact/bit_bottom.h), the torque on bit (contact/bit_torque.h),
/// the face's friction across the bottom (contact/bit_face.h), and the mud motor that bit and gauge load. After the wall in its
/// list: the rock feels the gauge's force too. In statics at rest, with the start's torque.
extern const Force bit_on_bottom;

/// Of the bit as a body on node 0, in mud [N].
double bit_weight(const StageContext& at) noexcept;

}  // namespace drill_rig_sim

#endif
