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
/// A topic that shows a state, made while somebody hears it. While time stands nothing is repeated: whoever subscribes then gets the last message, it
/// alone, or, where nobody heard the topic before, has one made.
template <class Message>
class StandingTopic
{
public:
  /// `heard`: whether anybody subscribes; `missing`: whoever did first has got none yet, and `ask` is called then. Both are for the simulation thread.
  StandingTopic(ros::NodeHandle& node, const std::string& name, std::uint32_t queue, std::atomic<bool>& heard, std::atomic<bool>& missing,
                std::function<void()> ask)
      : heard_(heard),
        missing_(missing),
        ask_(std::move(ask)),
        publisher_(node.advertise<Message>(
            name, queue, [this](const ros::SingleSubscriberPublisher& s) { greet(s); },
            [this](const ros::SingleSubscriberPublisher&) { heard_ = publisher_.getNumSubscribers() > 0; }))
  {
  }

  /// Publishes what `fill(message)` makes of the last one, whose arrays keep their memory.
  template <class Fill>
  void publish(Fill fill)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fill(last_);
    publisher_.publish(last_);
    sent_ = ros::WallTime::now();
  }

private:
  void greet(const ros::SingleSubscriberPublisher& subscriber)
  {
    const ros::WallDuration standing_still(0.5);  // longer than between two messages at any rate in use
    if (!heard_.exchange(true))
    {
      missing_ = true;
      ask_();
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!missing_ && !sent_.isZero() && ros::WallTime::now() - sent_ > standing_still) subscriber.publish(last_);
  }

  std::atomic<bool>&heard_, &missing_;
  std::function<void()> ask_;
  std::mutex mutex_;  // guards last_ and sent_: the greeting comes from another thread
  Message last_;
  ros::WallTime sent_;
  ros::Publisher publisher_;
};

}  // namespace drill_rig_sim

#endif
