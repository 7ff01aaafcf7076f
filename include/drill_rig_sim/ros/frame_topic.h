// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_FRAME_TOPIC_H
#define DRILL_RIG_SIM_ROS_FRAME_TOPIC_H

#include <ros/ros.h>

#include <cstdint>
#include <string>

namespace drill_rig_sim
{
/// A topic that has a message in every frame. Without a subscriber no message is made.
template <class Message>
class FrameTopic
{
public:
  /// `queue`: messages kept for a subscriber who is slow.
  FrameTopic(ros::NodeHandle& node, const std::string& name, std::uint32_t queue)
      : publisher_(node.advertise<Message>(name, queue))
  {
  }

  /// Publishes what `make()` returns, where there is a subscriber.
  template <class Make>
  void publish(Make make) const
  {
    if (publisher_.getNumSubscribers() > 0) publisher_.publish(make());
  }

private:
  ros::Publisher publisher_;
};

}  // namespace drill_rig_sim

#endif
