// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_STANDING_TOPIC_H
#define DRILL_RIG_SIM_ROS_STANDING_TOPIC_H

#include <ros/ros.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace drill_rig_sim
{
/// Whether a StandingTopic has subscribers, shared with the simulation thread.
struct Audience
{
  std::atomic<bool>& heard;              ///< whether there is a subscriber
  std::atomic<bool>& missing;            ///< a new subscriber waits: the simulation thread owes a message
  const std::atomic<bool>& time_stands;  ///< no frame comes before it is asked for
};

/// A topic that shows a state, made while it has subscribers. While time stands nothing is repeated: a new subscriber then
/// receives the last message, or, without one, has one made.
template <class Message>
class StandingTopic
{
public:
  /// `ask` is called when a message is owed while time may stand.
  StandingTopic(ros::NodeHandle& node, const std::string& name, std::uint32_t queue, const Audience& audience,
                std::function<void()> ask)
      : audience_(audience),
        ask_(std::move(ask)),
        publisher_(node.advertise<Message>(
            name, queue, [this](const ros::SingleSubscriberPublisher& s) { greet(s); },
            [this](const ros::SingleSubscriberPublisher&) { audience_.heard = publisher_.getNumSubscribers() > 0; }))
  {
  }

  /// Publishes what `fill(message)` makes of the last one, whose arrays keep their memory.
  template <class Fill>
  void publish(Fill fill)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fill(last_);
    publisher_.publish(last_);
    any_ = true;
  }

private:
  void greet(const ros::SingleSubscriberPublisher& subscriber)
  {
    const bool alone = !audience_.heard.exchange(true);
    if (!alone && audience_.time_stands && !audience_.missing)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (any_) subscriber.publish(last_);
      return;
    }
    audience_.missing = true;
    if (alone || audience_.time_stands) ask_();  // time may have come to stand since it was asked
  }

  Audience audience_;
  std::function<void()> ask_;
  std::mutex mutex_;  // guards last_ and any_: the greeting comes from another thread
  Message last_;
  bool any_ = false;
  ros::Publisher publisher_;
};

}  // namespace drill_rig_sim

#endif
