// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_CONVERSIONS_H
#define DRILL_RIG_SIM_ROS_CONVERSIONS_H

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Header.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "drill_rig_sim/MudPumpCommand.h"
#include "drill_rig_sim/RigLimits.h"
#include "drill_rig_sim/RigState.h"
#include "drill_rig_sim/RigTruth.h"
#include "drill_rig_sim/SteeringCommand.h"
#include "drill_rig_sim/TopDriveCommand.h"
#include "drill_rig_sim/WinchCommand.h"
#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/realtime/frame_output.h"

/// Between the simulator's values and the messages.
namespace drill_rig_sim
{
ros::Time to_time(std::int64_t stamp);
std_msgs::Header to_header(std::int64_t stamp, const std::string& frame_id);
std_msgs::Float64 to_number(double value);
geometry_msgs::Point to_point(const Eigen::Vector3d& v);
geometry_msgs::Vector3 to_vector(const Eigen::Vector3d& v);
/// Normalised.
geometry_msgs::Quaternion to_quaternion(const Eigen::Quaterniond& q);
/// Turns the x axis into `direction`.
geometry_msgs::Quaternion pointing(const Eigen::Vector3d& direction);

/// An unknown mode stays unknown: the simulator refuses it.
WinchSetpoint to_setpoint(const WinchCommand& m);
TopDriveSetpoint to_setpoint(const TopDriveCommand& m);
PumpSetpoint to_setpoint(const MudPumpCommand& m);
SteeringSetpoint to_setpoint(const SteeringCommand& m);

/// What the crew does, else the operation under way; empty: nothing.
std::string what_is_done(const FrameRecord& frame);

/// The readings of a frame, and its truth.
RigState to_rig_state(const ShownSignals& from, const FrameRecord& frame, const std::string& frame_id);
RigTruth to_rig_truth(const TrueSignals& from, const FrameRecord& frame, const std::string& frame_id);
RigLimits to_rig_limits(const RigSpec& rig, const std_msgs::Header& header);

}  // namespace drill_rig_sim

#endif
