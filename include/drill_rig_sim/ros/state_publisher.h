#ifndef DRILL_RIG_SIM_ROS_STATE_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_STATE_PUBLISHER_H

#include <ros/ros.h>

#include <cstdint>
#include <string>

#include "drill_rig_sim/DrillstringState.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Publishes the readings (rig_state and its kin, downhole telemetry), the truth (truth/rig_state, the bit, the string's profile), the limits.
class StatePublisher
{
public:
  StatePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions);
  void publish(const FrameOutput& s);

private:
  void publish_rig(const FrameOutput& s);
  void publish_bit(const FrameOutput& s);
  void publish_telemetry(const FrameOutput& s);
  void publish_profile(const FrameOutput& s);

  std::string floor_;  // frame_id
  Subscriptions& subscriptions_;
  std::uint64_t last_survey_ = 0, last_toolface_ = 0;
  DrillstringState profile_;
  ros::Publisher hook_load_, torque_, rig_state_, true_rig_state_, rig_limits_, joint_states_;
  ros::Publisher bit_pose_, bit_twist_, bit_wrench_, mwd_, toolface_, drillstring_;
};

}  // namespace drill_rig_sim

#endif
