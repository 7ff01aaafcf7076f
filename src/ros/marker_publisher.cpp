// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/marker_publisher.h"

#include <utility>

namespace drill_rig_sim
{
MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                                 std::function<void()> ask_for_picture)
    : picture_(parameters), subscriptions_(subscriptions)
{
  const auto greet = [this, ask_for_picture = std::move(ask_for_picture)](const ros::SingleSubscriberPublisher&)
  {
    subscriptions_.markers = true;
    ask_for_picture();
  };
  const auto bid_farewell = [this](const ros::SingleSubscriberPublisher&)
  { subscriptions_.markers = markers_.getNumSubscribers() > 0; };
  markers_ = node.advertise<visualization_msgs::MarkerArray>("markers", 10, greet, bid_farewell);
}

void MarkerPublisher::publish(const FrameOutput& s)
{
  if (s.rebuilt) picture_.restart();
  if (s.markers_due) markers_.publish(picture_.draw(s));
}

}  // namespace drill_rig_sim
