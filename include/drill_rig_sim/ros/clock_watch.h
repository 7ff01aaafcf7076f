// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_CLOCK_WATCH_H
#define DRILL_RIG_SIM_ROS_CLOCK_WATCH_H

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
/// Which /clock is received, and what is wrong with it; knows only the times that it is given.
class HeardClock
{
public:
  static constexpr double silent = 3.0;  ///< a clock is missed after this [wall s]: a frame of the usual rates is far shorter

  /// `own`: name of the node where it publishes the clock itself; empty where the rig follows another's. `now`: when listening
  /// began.
  HeardClock(std::string own, const ros::SteadyTime& now) : follows_(own.empty()), publisher_(std::move(own)), started_(now) {}

  void hear(const std::string& publisher, const ros::SteadyTime& now);
  /// What is wrong with the clock now, one line; empty where nothing is. `published`: a publisher of it is known.
  std::string trouble(const ros::SteadyTime& now, bool published) const;

private:
  std::string silence(const ros::SteadyTime& now, bool published) const;

  bool follows_;
  std::string publisher_;  // whose clock this is: the node itself, or the first that was received
  std::string second_;     // another that publishes it
  ros::SteadyTime started_, heard_, second_heard_;
};

/// Listens to /clock: passes it on to a rig that follows it, and knows what is wrong with it. It has not been published, it has
/// gone silent, a second node publishes it too: each is warned of once when it begins, and reported in diagnostics as long as it
/// lasts. A rig that publishes the clock itself listens only where the master knows of another: its own would come back with
/// every frame.
class ClockWatch
{
public:
  /// `hear` gets another rig's clock [ns]; called where the parameters say that the rig follows it. `unhurried`: whose callbacks
  /// may wait for the master.
  ClockWatch(ros::NodeHandle& node, ros::NodeHandle& unhurried, const Parameters& parameters,
             std::function<void(std::int64_t)> hear);

  /// What is wrong with the clock now, one line; empty where nothing is.
  std::string trouble();

private:
  using Event = ros::MessageEvent<const rosgraph_msgs::Clock>;
  void take(const Event& event);
  void look();
  void listen();
  void warn();

  bool follows_;
  std::function<void(std::int64_t)> hear_;
  std::mutex mutex_;  // guards heard_ and clock_
  HeardClock heard_;
  std::string warned_of_;
  ros::NodeHandle node_;
  ros::Subscriber clock_;
  ros::WallTimer look_timer_, warn_timer_;
};

}  // namespace drill_rig_sim

#endif
