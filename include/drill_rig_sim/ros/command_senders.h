// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_COMMAND_SENDERS_H
#define DRILL_RIG_SIM_ROS_COMMAND_SENDERS_H

#include <ros/ros.h>

#include <map>
#include <mutex>
#include <string>

namespace drill_rig_sim
{
/// Which nodes have sent commands of late, by topic: two on one topic overrule each other. Any thread may note and ask.
class CommandSenders
{
public:
  static constexpr double recent = 5.0;  ///< so long ago a command still counts, wall time [s]

  /// A command of a node has come on a topic.
  void note(const std::string& topic, const std::string& node, const ros::SteadyTime& now);
  /// The topics with two senders or more, and these, in one line; empty: there is none.
  std::string trouble(const ros::SteadyTime& now) const;

private:
  mutable std::mutex mutex_;
  std::map<std::string, std::map<std::string, ros::SteadyTime>> heard_;  // when, by topic and node
};

}  // namespace drill_rig_sim

#endif
