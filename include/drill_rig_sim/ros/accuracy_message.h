// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_ACCURACY_MESSAGE_H
#define DRILL_RIG_SIM_ROS_ACCURACY_MESSAGE_H

#include <string>

#include "drill_rig_sim/Accuracy.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Level, nodes and coordinates of the companion; empty without one.
std::string text_of(const CompanionStatistics& companion);
/// Why the error is not measured, one line; empty while it is.
std::string why_not_measured(const SimulatorStatistics& physics);
/// Share of the computing time since the start that the companion takes [-].
double companion_cost_share(const SimulatorStatistics& physics) noexcept;

/// `floor`: name of the frame `rig_floor`.
Accuracy to_accuracy(const FrameRecord& frame, const std::string& floor);

}  // namespace drill_rig_sim

#endif
