// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/trajectory_publisher.h"

#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
TrajectoryPublisher::TrajectoryPublisher(ros::NodeHandle& node, const Parameters& parameters)
    : floor_(parameters.floor()), trajectory_(node.advertise<nav_msgs::Path>("trajectory", 10, true))
{
}

void TrajectoryPublisher::publish(const FrameOutput& s)
{
  if (!s.well_due || !s.new_stamp) return;  // a latched path needs no repeating
  trajectory_.publish(to_path(s, floor_));
}

}  // namespace drill_rig_sim
