// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/state_publisher.h"

#include <utility>

#include "drill_rig_sim/ros/accuracy_message.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
StatePublisher::StatePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                               std::function<void()> ask_for_picture)
    : floor_(parameters.floor()),
      hook_load_(node, "hook_load", parameters.queue()),
      torque_(node, "torque", parameters.queue()),
      rig_state_(node, "rig_state", parameters.queue()),
      rig_truth_(node, "truth/rig_state", parameters.queue()),
      joint_states_(node, "joint_states", parameters.queue()),
      bit_pose_(node, "bit/pose", parameters.queue()),
      bit_twist_(node, "bit/twist", parameters.queue()),
      bit_wrench_(node, "bit/wrench", parameters.queue()),
      true_bit_(node, "truth/bit", parameters.queue()),
      accuracy_(node, "accuracy", parameters.queue()),
      rig_limits_(node.advertise<RigLimits>("rig_limits", parameters.queue(), true)),
      mwd_(node.advertise<MwdSurvey>("downhole/mwd", parameters.queue())),
      toolface_(node.advertise<MwdToolface>("downhole/toolface", parameters.queue())),
      inclination_(node.advertise<MwdInclination>("downhole/inclination", parameters.queue())),
      dynamics_(node.advertise<DownholeDynamics>("downhole/dynamics", parameters.queue())),
      drillstring_(node, "drillstring_state", parameters.queue(),
                   {subscriptions.profile, subscriptions.profile_missing, subscriptions.time_stands}, std::move(ask_for_picture))
{
}

void StatePublisher::publish(const FrameOutput& s)
{
  if (s.rebuilt)
  {
    rig_limits_.publish(to_rig_limits(s.frame.rig, to_header(s.frame.stamp, floor_)));
    news_.forget();
  }
  if (s.restored) news_.skip(s.frame.readings);  // what had arrived before the state was saved does not arrive now
  if (s.state_due || s.state_again)
  {
    rig_state_.publish([&] { return to_rig_state(s.frame.readings, s.frame, floor_); });
    rig_truth_.publish([&] { return to_rig_truth(s.frame.truth, s.frame, floor_); });
  }
  if (s.state_due)
  {
    publish_rig(s);
    publish_bit(s);
  }
  if (s.accuracy_due) accuracy_.publish([&] { return to_accuracy(s.frame, floor_); });
  if (s.new_stamp) news_.tell(s.frame, floor_, [this](const char*, const auto& message) { send(message); });
  if (s.profile_due) drillstring_.publish([&](DrillstringState& m) { fill_drillstring_state(s, floor_, m); });
}

void StatePublisher::publish_rig(const FrameOutput& s)
{
  hook_load_.publish([&] { return to_number(s.frame.readings.hook_load); });
  torque_.publish([&] { return to_number(s.frame.readings.torque); });
  joint_states_.publish([&] { return to_joint_states(s.frame); });
}

void StatePublisher::publish_bit(const FrameOutput& s)
{
  bit_pose_.publish([&] { return to_bit_pose(s.frame, floor_); });
  bit_twist_.publish([&] { return to_bit_twist(s.frame, floor_); });
  bit_wrench_.publish([&] { return to_bit_wrench(s.frame, floor_); });
  true_bit_.publish([&] { return to_bit_truth(s.frame, floor_); });
}

}  // namespace drill_rig_sim
