// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_TOP_DRIVE_H
#define DRILL_RIG_SIM_MODEL_FORCES_TOP_DRIVE_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The torque meter on the string's top, its rotor and motor condensed (rig/top_drive.h). The shaft points down: spin is
/// clockwise looking downhole, a turn about -z.
extern const Force top_drive;

/// What the rotor has turned since the start of the step when the top node has moved by the six numbers `u` [rad].
double drive_increment(const Model& model, const State& start, const Stage& stage, const double* u) noexcept;

}  // namespace drill_rig_sim

#endif
