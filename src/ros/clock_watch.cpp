#include "drill_rig_sim/ros/clock_watch.h"

#include <utility>

namespace drill_rig_sim
{
namespace
{
// A frame of the slowest rate there is takes 10 s; at the usual ones this is long.
constexpr double silent = 3.0;  // [wall s]
}  // namespace

ClockWatch::ClockWatch(ros::NodeHandle& node, const Parameters& parameters, std::function<void(std::int64_t)> hear)
    : follows_(parameters.time_source() == TimeSource::other_rig),
      hear_(std::move(hear)),
      publisher_(follows_ ? "" : ros::this_node::getName()),
      started_(ros::SteadyTime::now())
{
  if (parameters.time_source() == TimeSource::wall) return;
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event&>("/clock", 10, [this](const Event& event) { take(event); });
  clock_ = node.subscribe(options);
  timer_ = node.createWallTimer(ros::WallDuration(0.5), [this](const ros::WallTimerEvent&) { warn(); });
}

void ClockWatch::take(const Event& event)
{
  const ros::SteadyTime now = ros::SteadyTime::now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string& name = event.getPublisherName();
    const bool gone = follows_ && (heard_.isZero() || (now - heard_).toSec() > silent);
    if (gone) publisher_ = name;  // the first, or whoever goes on after it
    if (name == publisher_)
    {
      heard_ = now;
    }
    else
    {
      second_ = name;
      second_heard_ = now;
    }
  }
  if (follows_) hear_(static_cast<std::int64_t>(event.getMessage()->clock.toNSec()));
}

std::string ClockWatch::silence(const ros::SteadyTime& now) const
{
  const ros::SteadyTime since = heard_.isZero() ? started_ : heard_;
  if ((now - since).toSec() <= silent) return "";
  if (heard_.isZero()) return "waiting for /clock, which nobody has published yet";
  if (clock_.getNumPublishers() == 0) return "nobody publishes /clock any more, " + publisher_ + " did";
  return "/clock has stopped: " + publisher_ + " is paused or dead";
}

std::string ClockWatch::trouble()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::SteadyTime now = ros::SteadyTime::now();
  const std::string silent_for = follows_ ? silence(now) : "";
  if (!silent_for.empty()) return silent_for;
  if (second_.empty() || (now - second_heard_).toSec() > silent) return "";
  return "two nodes publish /clock: " + publisher_ + " and " + second_;
}

void ClockWatch::warn()
{
  const std::string now = trouble();
  if (!now.empty() && now != warned_of_) ROS_WARN_STREAM(now);
  warned_of_ = now;
}

}  // namespace drill_rig_sim
