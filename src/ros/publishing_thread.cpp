// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/publishing_thread.h"

#include <algorithm>
#include <utility>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
PublishingThread::PublishingThread(ros::NodeHandle& node, const Parameters& parameters, FrameRing& ring,
                                   Subscriptions& subscriptions, std::function<void()> ask_for_picture,
                                   std::function<void(const FrameRecord&)> on_frame, std::function<void()> on_change)
    : ring_(ring),
      on_frame_(std::move(on_frame)),
      on_change_(std::move(on_change)),
      tells_time_(parameters.publish_clock && parameters.use_sim_time),
      priority_(std::max(0, parameters.realtime.fifo_priority - 1)),
      state_(node, parameters, subscriptions, ask_for_picture),
      frames_(node, parameters, subscriptions, ask_for_picture),
      markers_(node, parameters, subscriptions, std::move(ask_for_picture)),
      trajectory_(node, parameters),
      period_(parameters.frame_period())
{
  if (parameters.time_source() == TimeSource::other_rig)
    next_frame_ = node.advertise<rosgraph_msgs::Clock>("/clock_followers", 1, true);
  if (parameters.publish_clock) clock_.emplace(node, "/clock", parameters.queue());
}

PublishingThread::~PublishingThread()
{
  finish();
}

void PublishingThread::start()
{
  thread_ = std::thread([this] { run(); });
}

void PublishingThread::finish()
{
  if (!thread_.joinable()) return;
  ring_.close();
  thread_.join();
}

FrameRecord PublishingThread::last() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

void PublishingThread::wait_until_published(std::uint64_t handed_over)
{
  std::unique_lock<std::mutex> lock(mutex_);
  arrived_.wait(lock, [&] { return published_ >= handed_over; });
}

void PublishingThread::run()
{
  name_thread("publishing");
  prioritise_thread(priority_, -1);
  while (const FrameOutput* s = ring_.next())
  {
    publish(*s);
    on_frame_(s->frame);
    bool changed = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      changed = last_.run_state != s->frame.run_state || last_.commands_refused != s->frame.commands_refused;
      last_ = s->frame;
      ++published_;
    }
    arrived_.notify_all();
    ring_.release();
    if (changed) on_change_();
  }
}

void PublishingThread::publish(const FrameOutput& s)
{
  if (tells_time_ && s.new_stamp) ros::Time::setNow(to_time(s.frame.stamp));
  state_.publish(s);
  frames_.publish(s);
  markers_.publish(s);
  trajectory_.publish(s);
  if (clock_ && s.new_stamp)
  {
    clock_->publish(
        [&]
        {
          rosgraph_msgs::Clock clock;
          clock.clock = to_time(s.frame.stamp);
          return clock;
        });
  }
  if (next_frame_) tell_leader(s.frame);
}

void PublishingThread::tell_leader(const FrameRecord& record)
{
  rosgraph_msgs::Clock next;
  if (record.run_state == RunState::failed)
    next.clock = ros::TIME_MAX;
  else if (record.stamp != 0)  // before the first clock there is no time to publish
    next.clock = to_time(record.stamp + period_);
  next_frame_.publish(next);
}

}  // namespace drill_rig_sim
