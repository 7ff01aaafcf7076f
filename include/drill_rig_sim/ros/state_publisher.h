// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_STATE_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_STATE_PUBLISHER_H

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>

#include <functional>
#include <string>

#include "drill_rig_sim/Accuracy.h"
#include "drill_rig_sim/BitTruth.h"
#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/RigState.h"
#include "drill_rig_sim/RigTruth.h"
#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/frame_topic.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "drill_rig_sim/ros/standing_topic.h"
#include "drill_rig_sim/ros/telemetry_news.h"

namespace drill_rig_sim
{
/// Publishes the readings (rig_state and its kin, downhole telemetry), the truth (truth/rig_state, the bit, the string's
/// profile), the accuracy, the limits.
class StatePublisher
{
public:
  /// `ask_for_picture` is called for the first subscriber of the string's profile.
  StatePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                 std::function<void()> ask_for_picture);
  void publish(const FrameOutput& s);

private:
  void publish_rig(const FrameOutput& s);
  void publish_bit(const FrameOutput& s);
  void send(const MwdSurvey& m) { mwd_.publish(m); }
  void send(const MwdToolface& m) { toolface_.publish(m); }
  void send(const MwdInclination& m) { inclination_.publish(m); }
  void send(const DownholeDynamics& m) { dynamics_.publish(m); }

  std::string floor_;  // frame_id
  TelemetryNews news_;
  FrameTopic<std_msgs::Float64> hook_load_, torque_;
  FrameTopic<RigState> rig_state_;
  FrameTopic<RigTruth> rig_truth_;
  FrameTopic<sensor_msgs::JointState> joint_states_;
  FrameTopic<geometry_msgs::PoseStamped> bit_pose_;
  FrameTopic<geometry_msgs::TwistStamped> bit_twist_;
  FrameTopic<geometry_msgs::WrenchStamped> bit_wrench_;
  FrameTopic<BitTruth> true_bit_;
  FrameTopic<Accuracy> accuracy_;
  ros::Publisher rig_limits_, mwd_, toolface_, inclination_, dynamics_;
  StandingTopic<DrillstringState> drillstring_;
};

}  // namespace drill_rig_sim

#endif
