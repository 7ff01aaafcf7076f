// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_FOLLOWER_WATCH_H
#define DRILL_RIG_SIM_ROS_FOLLOWER_WATCH_H

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
/// How far the rigs have come that follow a clock, by the stamps of their next frames [ns]; knows only the times that it is
/// given.
class Followers
{
public:
  static constexpr std::int64_t not_begun = 0;       ///< the follower has not received a clock yet
  static constexpr std::int64_t failed = INT64_MAX;  ///< its last frame failed: there is no next one
  static constexpr std::int64_t of_an_earlier_clock =
      2'000'000'000;  ///< more than this ahead, a follower still shows the clock of an earlier run [ns]
  static constexpr double silent =
      2.0;  ///< of several, the ones that have said nothing for so long are those that have gone [wall s]

  void hear(const std::string& name, std::int64_t next, const ros::SteadyTime& now) { heard_[name] = {next, now}; }
  /// Leaves out those that are gone where `connected` is how many are still there. Returns whether there were any.
  bool leave_out_lost(std::size_t connected, const ros::SteadyTime& now);
  /// A follower that still has a frame to compute up to `stamp`; empty: none.
  std::string behind(std::int64_t stamp) const;
  /// A follower whose last frame failed; empty: none.
  std::string a_failed_one() const;
  /// The least stamp of a next frame; INT64_MAX without a follower that goes on.
  std::int64_t slowest() const;

private:
  struct Heard
  {
    std::int64_t next;
    ros::SteadyTime at;
  };
  std::map<std::string, Heard> heard_;
};

/// In lockstep: listens on /clock_followers to the rigs that follow this one's /clock. Rigs with another time know of none.
class FollowerWatch
{
public:
  /// `hear_slowest` gets the least stamp of the followers' next frames [ns], by any thread.
  FollowerWatch(ros::NodeHandle& node, const Parameters& parameters, std::function<void(std::int64_t)> hear_slowest);

  /// Waits until all followers have computed their frames up to `stamp` [ns]. Empty, or why one has not, one line. A follower
  /// that has not received a clock yet gets this one again. One caller at a time.
  std::string wait_for(std::int64_t stamp);
  /// By another thread: wait_for() under way returns.
  void give_up();

private:
  void take(const ros::MessageEvent<const rosgraph_msgs::Clock>& event);
  void look();

  std::function<void(std::int64_t)> hear_slowest_;
  std::mutex mutex_;  // guards followers_ and given_up_
  std::condition_variable changed_;
  Followers followers_;
  bool given_up_ = false;
  ros::Publisher clock_;
  ros::Subscriber subscriber_;
  ros::WallTimer look_timer_;
};

}  // namespace drill_rig_sim

#endif
