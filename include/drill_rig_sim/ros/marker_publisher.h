// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_MARKER_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_MARKER_PUBLISHER_H

#include <ros/ros.h>

#include <functional>

#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/marker_picture.h"
#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// Publishes the picture of the rig for rviz where it is due.
class MarkerPublisher
{
public:
  /// `ask_for_picture` is called for each new subscriber.
  MarkerPublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                  std::function<void()> ask_for_picture);
  void publish(const FrameOutput& s);

private:
  MarkerPicture picture_;
  Subscriptions& subscriptions_;
  ros::Publisher markers_;
};

}  // namespace drill_rig_sim

#endif
