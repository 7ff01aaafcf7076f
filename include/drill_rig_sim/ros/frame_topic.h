// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_FRAME_TOPIC_H
#define DRILL_RIG_SIM_ROS_FRAME_TOPIC_H

#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/ros.h>
#include <ros/topic_manager.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace drill_rig_sim
{
/// Whether something was posted since send_posted() was called last; by any thread.
inline std::atomic<bool> something_posted{false};

/// A topic that has a message in every frame. ros::Publisher wakes roscpp's sending thread for each message, which then looks
/// through all topics: with ten topics at 1 kHz that costs more than the sending. Here a message waits until send_posted() wakes
/// it for the whole frame, in the order in which the topics were advertised. Without a subscriber nothing is made.
template <class Message>
class FrameTopic
{
public:
  /// `queue`: messages kept for a subscriber who is slow.
  FrameTopic(ros::NodeHandle& node, const std::string& name, std::uint32_t queue)
      : publisher_(node.advertise<Message>(name, queue)),
        publication_(ros::TopicManager::instance()->lookupPublication(publisher_.getTopic()))
  {
  }

  /// Posts what `make()` returns, where there is a subscriber.
  template <class Make>
  void post(Make make) const
  {
    if (!publication_) return;
    if (!publication_->hasSubscribers())
    {
      publication_
          ->incrementSequence();  // the header's seq counts the messages without a subscriber too, as ros::Publisher's does
      return;
    }
    ros::SerializedMessage message = ros::serialization::serializeMessage<Message>(make());
    publication_->publish(message);
    something_posted = true;
  }

private:
  ros::Publisher publisher_;         // advertises as long as it lives
  ros::PublicationPtr publication_;  // none where the node was ended before it had begun
};

/// Has roscpp send what was posted on all topics, if anything was: its thread is woken for nothing else.
inline void send_posted()
{
  if (something_posted.exchange(false)) ros::PollManager::instance()->getPollSet().signal();
}

}  // namespace drill_rig_sim

#endif
