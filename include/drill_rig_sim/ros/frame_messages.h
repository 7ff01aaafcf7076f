// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_FRAME_MESSAGES_H
#define DRILL_RIG_SIM_ROS_FRAME_MESSAGES_H

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/JointState.h>

#include <array>
#include <string>
#include <vector>

#include "drill_rig_sim/BitTruth.h"
#include "drill_rig_sim/DownholeDynamics.h"
#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/MwdInclination.h"
#include "drill_rig_sim/MwdSurvey.h"
#include "drill_rig_sim/MwdToolface.h"
#include "drill_rig_sim/StepSimulation.h"
#include "drill_rig_sim/realtime/frame_output.h"

/// The messages of a frame, as values: what the publishers send. `floor`: name of the frame `rig_floor`, prefix included.
namespace drill_rig_sim
{
/// traveling_block (effort: hook load) and top_drive (effort: torque), as the instruments show them.
sensor_msgs::JointState to_joint_states(const FrameRecord& frame);

/// The truth at the bit.
geometry_msgs::PoseStamped to_bit_pose(const FrameRecord& frame, const std::string& floor);
geometry_msgs::TwistStamped to_bit_twist(const FrameRecord& frame, const std::string& floor);
geometry_msgs::WrenchStamped to_bit_wrench(const FrameRecord& frame, const std::string& floor);
BitTruth to_bit_truth(const FrameRecord& frame, const std::string& floor);

/// Telemetry; stamped when it was measured.
MwdSurvey to_mwd_survey(const FrameRecord& frame, const std::string& floor);
MwdToolface to_mwd_toolface(const FrameRecord& frame, const std::string& floor);
MwdInclination to_mwd_inclination(const FrameRecord& frame, const std::string& floor);
DownholeDynamics to_downhole_dynamics(const FrameRecord& frame, const std::string& floor);
/// What a step's answer contains of the last frame: readings, truth, bit, and telemetry that has come up.
void tell(const FrameRecord& frame, const std::string& floor, StepSimulation::Response& answer);

/// Fills the message in place: its arrays keep their memory.
void fill_drillstring_state(const FrameOutput& s, const std::string& floor, DrillstringState& m);

/// The well as a path; each pose's x axis points down the hole.
nav_msgs::Path to_path(const FrameOutput& s, const std::string& floor);

/// `world` to the rig floor. `pose`: x, y, z [m], roll, pitch, yaw [rad], about fixed axes in this order.
geometry_msgs::TransformStamped to_rig_pose(const std::array<double, 6>& pose, const std::string& floor);

/// Travelling block, top drive and the string's parts on the rig floor, names behind `prefix`; in place.
void fill_transforms(const FrameOutput& s, const std::string& prefix, std::vector<geometry_msgs::TransformStamped>& transforms);

}  // namespace drill_rig_sim

#endif
