// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/clock_watch.h"

namespace drill_rig_sim
{
namespace
{
bool another_publishes_clock()
{
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return false;
  XmlRpc::XmlRpcValue& publishers = state[0];  // [[topic, [node, ...]], ...]
  for (int i = 0; i < publishers.size(); ++i)
  {
    if (static_cast<std::string>(publishers[i][0]) != "/clock") continue;
    XmlRpc::XmlRpcValue& nodes = publishers[i][1];
    for (int j = 0; j < nodes.size(); ++j)
      if (static_cast<std::string>(nodes[j]) != ros::this_node::getName()) return true;
  }
  return false;
}
}  // namespace

void HeardClock::hear(const std::string& publisher, const ros::SteadyTime& now)
{
  const bool gone = follows_ && (heard_.isZero() || (now - heard_).toSec() > silent);
  if (gone) publisher_ = publisher;  // the first, or the one that goes on after it
  if (publisher == publisher_)
  {
    heard_ = now;
  }
  else
  {
    second_ = publisher;
    second_heard_ = now;
  }
}

std::string HeardClock::silence(const ros::SteadyTime& now, bool published) const
{
  const ros::SteadyTime since = heard_.isZero() ? started_ : heard_;
  if ((now - since).toSec() <= silent) return "";
  if (heard_.isZero()) return "waiting for /clock, which has not been published yet";
  if (!published) return "/clock is no longer published; its last publisher was " + publisher_;
  return "/clock has stopped: " + publisher_ + " is paused or dead";
}

std::string HeardClock::trouble(const ros::SteadyTime& now, bool published) const
{
  std::string silent_for = follows_ ? silence(now, published) : "";
  if (!silent_for.empty()) return silent_for;
  if (second_.empty() || (now - second_heard_).toSec() > silent) return "";
  return "two nodes publish /clock: " + publisher_ + " and " + second_;
}

ClockWatch::ClockWatch(ros::NodeHandle& node, ros::NodeHandle& unhurried, const Parameters& parameters,
                       std::function<void(std::int64_t)> hear)
    : follows_(parameters.time_source() == TimeSource::other_rig),
      hear_(std::move(hear)),
      heard_(follows_ ? "" : ros::this_node::getName(), ros::SteadyTime::now()),
      node_(node)
{
  if (parameters.time_source() == TimeSource::wall) return;
  if (follows_)
    listen();
  else
    look_timer_ = unhurried.createWallTimer(ros::WallDuration(2.0), [this](const ros::WallTimerEvent&) { look(); });
  warn_timer_ = node.createWallTimer(ros::WallDuration(0.5), [this](const ros::WallTimerEvent&) { warn(); });
}

void ClockWatch::listen()
{
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>("/clock", 10, [this](const Event& event) { take(event); });
  clock_ = node_.subscribe(options);
}

// What the master knows may be out of date: it makes this node listen, no more.
void ClockWatch::look()
{
  const bool another = another_publishes_clock();
  ros::Subscriber not_needed;  // ends without the lock: it waits for take()
  const std::lock_guard<std::mutex> lock(mutex_);
  if (another && !clock_) listen();
  if (!another) std::swap(clock_, not_needed);
}

void ClockWatch::take(const Event& event)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.hear(event.getPublisherName(), ros::SteadyTime::now());
  }
  if (follows_) hear_(static_cast<std::int64_t>(event.getMessage()->clock.toNSec()));
}

std::string ClockWatch::trouble()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool published = clock_.getNumPublishers() > 0;
  return heard_.trouble(ros::SteadyTime::now(), published);
}

void ClockWatch::warn()
{
  const std::string now = trouble();
  if (!now.empty() && now != warned_of_) ROS_WARN_STREAM(now);
  warned_of_ = now;
}

}  // namespace drill_rig_sim
