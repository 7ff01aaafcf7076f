#ifndef DRILL_RIG_SIM_ROS_CLOCK_WATCH_H
#define DRILL_RIG_SIM_ROS_CLOCK_WATCH_H

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
/// Listens to /clock: passes it on to a rig that follows it, and knows what is wrong with it. Nobody has published it, it has gone
/// silent, a second node publishes it too: each is warned of once when it begins, and told in diagnostics as long as it lasts.
class ClockWatch
{
public:
  /// `hear` gets another rig's clock [ns]; called where the parameters say that the rig follows it.
  ClockWatch(ros::NodeHandle& node, const Parameters& parameters, std::function<void(std::int64_t)> hear);

  /// What is wrong with the clock now, one line; empty where nothing is.
  std::string trouble();

private:
  using Event = ros::MessageEvent<const rosgraph_msgs::Clock>;
  void take(const Event& event);
  std::string silence(const ros::SteadyTime& now) const;
  void warn();

  bool follows_;
  std::function<void(std::int64_t)> hear_;
  std::mutex mutex_;
  std::string publisher_;  // whose clock this is: the node itself, or the first that was heard
  std::string second_;     // another that publishes it
  ros::SteadyTime started_, heard_, second_heard_;
  std::string warned_of_;
  ros::Subscriber clock_;
  ros::WallTimer timer_;
};

}  // namespace drill_rig_sim

#endif
