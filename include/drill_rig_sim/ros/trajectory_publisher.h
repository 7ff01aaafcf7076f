// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_TRAJECTORY_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_TRAJECTORY_PUBLISHER_H

#include <ros/ros.h>

#include <string>

#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Publishes the drilled well as a latched path, sent again when it has changed; each pose's x axis points down the hole.
class TrajectoryPublisher
{
public:
  TrajectoryPublisher(ros::NodeHandle& node, const Parameters& parameters);
  void publish(const FrameOutput& s);

private:
  std::string floor_;
  ros::Publisher trajectory_;
};

}  // namespace drill_rig_sim

#endif
