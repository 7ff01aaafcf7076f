// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_ROS_STEP_REQUEST_H
#define DRILL_RIG_SIM_SRC_ROS_STEP_REQUEST_H

#include <cstdint>
#include <string>

#include "drill_rig_sim/StepSimulation.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// Frames that a step asks for, by their number or their time, at `rate` [1/s]. Throws Refusal for what is not allowed of frames,
/// time and commands.
std::uint32_t frames_of(const StepSimulation::Request& request, double rate);

/// A text of several lines, as those of a scene's problems are, for an answer of one.
std::string one_line(std::string text);

/// A rig whose last frame has failed is refused.
void require_good(const RunningRig& rig);

/// A step's commands, all of them or none. For between-frames callbacks.
void command_all(SimulationLoop& loop, const StepSimulation::Request& request);

}  // namespace drill_rig_sim

#endif
