// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/frame_publisher.h"

#include <utility>

#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
FramePublisher::FramePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                               std::function<void()> ask_for_picture)
    : prefix_(parameters.frame_prefix),
      tf_(node, "/tf", 100, {subscriptions.tf, subscriptions.tf_missing, subscriptions.time_stands}, std::move(ask_for_picture)),
      tf_static_(node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true))
{
  tf2_msgs::TFMessage fixed;
  fixed.transforms.push_back(to_rig_pose(parameters.rig_pose, parameters.floor()));
  // it is invalid if a signal ends the node while it starts; tf2_ros' broadcaster then fails an assertion of roscpp
  if (tf_static_) tf_static_.publish(fixed);
}

void FramePublisher::publish(const FrameOutput& s)
{
  if (s.tf_due) tf_.publish([&](tf2_msgs::TFMessage& m) { fill_transforms(s, prefix_, m.transforms); });
}

}  // namespace drill_rig_sim
