// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/frame_publisher.h"

#include <utility>

#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
FramePublisher::FramePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                               std::function<void()> ask_for_picture)
    : prefix_(parameters.frame_prefix),
      tf_(node, "/tf", 100, {subscriptions.tf, subscriptions.tf_missing, subscriptions.time_stands}, std::move(ask_for_picture))
{
  tf_static_.sendTransform(to_rig_pose(parameters.rig_pose, parameters.floor()));
}

void FramePublisher::publish(const FrameOutput& s)
{
  if (s.tf_due) tf_.publish([&](tf2_msgs::TFMessage& m) { fill_transforms(s, prefix_, m.transforms); });
}

}  // namespace drill_rig_sim
