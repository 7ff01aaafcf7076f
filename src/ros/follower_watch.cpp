// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/follower_watch.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
bool Followers::leave_out_lost(std::size_t connected, const ros::SteadyTime& now)
{
  const std::size_t before = heard_.size();
  for (auto it = heard_.begin(); it != heard_.end() && heard_.size() > connected;)
    it = (now - it->second.at).toSec() > silent ? heard_.erase(it) : std::next(it);
  return heard_.size() < before;
}

std::string Followers::behind(std::int64_t stamp) const
{
  for (const auto& [name, heard] : heard_)
  {
    if (heard.next == failed) continue;
    if (heard.next <= stamp || heard.next > stamp + of_an_earlier_clock) return name;
  }
  return "";
}

std::string Followers::a_failed_one() const
{
  for (const auto& [name, heard] : heard_)
    if (heard.next == failed) return name;
  return "";
}

std::int64_t Followers::slowest() const
{
  std::int64_t least = failed;
  for (const auto& [name, heard] : heard_)
    if (heard.next != not_begun) least = std::min(least, heard.next);
  return least;
}

FollowerWatch::FollowerWatch(ros::NodeHandle& node, const Parameters& parameters, std::function<void(std::int64_t)> hear_slowest)
    : hear_slowest_(std::move(hear_slowest))
{
  if (parameters.clock != ClockMode::lockstep || parameters.time_source() != TimeSource::own) return;
  clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", parameters.queue());
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const ros::MessageEvent<const rosgraph_msgs::Clock>&>(
      "/clock_followers", 100, [this](const ros::MessageEvent<const rosgraph_msgs::Clock>& event) { take(event); });
  subscriber_ = node.subscribe(options);
  look_timer_ = node.createWallTimer(ros::WallDuration(0.5), [this](const ros::WallTimerEvent&) { look(); });
}

void FollowerWatch::take(const ros::MessageEvent<const rosgraph_msgs::Clock>& event)
{
  const ros::Time next = event.getMessage()->clock;
  std::int64_t slowest = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    followers_.hear(event.getPublisherName(),
                    next == ros::TIME_MAX ? Followers::failed : static_cast<std::int64_t>(next.toNSec()), ros::SteadyTime::now());
    slowest = followers_.slowest();
  }
  changed_.notify_all();
  hear_slowest_(slowest);
}

void FollowerWatch::look()
{
  std::int64_t slowest = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!followers_.leave_out_lost(subscriber_.getNumPublishers(), ros::SteadyTime::now())) return;
    slowest = followers_.slowest();
  }
  changed_.notify_all();
  hear_slowest_(slowest);
}

std::string FollowerWatch::wait_for(std::int64_t stamp)
{
  if (!subscriber_) return "";
  constexpr std::chrono::milliseconds patience(200);
  rosgraph_msgs::Clock clock;
  clock.clock = to_time(stamp);
  std::unique_lock<std::mutex> lock(mutex_);
  given_up_ = false;
  std::string behind = followers_.behind(stamp);
  while (!behind.empty() && !given_up_ && !ros::isShuttingDown())
  {
    if (changed_.wait_for(lock, patience) == std::cv_status::timeout) clock_.publish(clock);
    behind = followers_.behind(stamp);
  }
  if (!behind.empty()) return behind + " has not computed its frames up to this time yet";
  const std::string failed = followers_.a_failed_one();
  return failed.empty() ? "" : "the last frame of " + failed + " failed";
}

void FollowerWatch::give_up()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    given_up_ = true;
  }
  changed_.notify_all();
}

}  // namespace drill_rig_sim
