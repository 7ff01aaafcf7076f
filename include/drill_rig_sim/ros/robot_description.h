// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_ROBOT_DESCRIPTION_H
#define DRILL_RIG_SIM_ROS_ROBOT_DESCRIPTION_H

#include <string>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// The rig and its bottom-hole assembly as URDF, for rviz' RobotModel: one link for each frame that the node publishes, but for
/// pipe. All joints are floating: the node itself publishes the frames, and robot_state_publisher leaves floating joints alone.
/// Lengths and diameters in metres, by the scene. `frame_prefix`: before the name of each link.
std::string robot_description(const Scene& scene, const std::string& frame_prefix);

}  // namespace drill_rig_sim

#endif
