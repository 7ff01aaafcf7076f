// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_FRAME_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_FRAME_PUBLISHER_H

#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "drill_rig_sim/ros/standing_topic.h"

namespace drill_rig_sim
{
/// Publishes /tf (every frame a child of the rig floor) and, once, /tf_static (`world` to the rig floor).
class FramePublisher
{
public:
  /// `ask_for_picture` is called for the first subscriber, for nothing was made before.
  FramePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                 std::function<void()> ask_for_picture);
  void publish(const FrameOutput& s);

private:
  std::string prefix_;
  StandingTopic<tf2_msgs::TFMessage> tf_;  // not tf2_ros' broadcaster, which cannot greet a new subscriber alone
  ros::Publisher tf_static_;
};

}  // namespace drill_rig_sim

#endif
