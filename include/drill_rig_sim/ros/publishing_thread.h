// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_PUBLISHING_THREAD_H
#define DRILL_RIG_SIM_ROS_PUBLISHING_THREAD_H

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "drill_rig_sim/realtime/frame_ring.h"
#include "drill_rig_sim/ros/frame_publisher.h"
#include "drill_rig_sim/ros/frame_topic.h"
#include "drill_rig_sim/ros/marker_publisher.h"
#include "drill_rig_sim/ros/state_publisher.h"
#include "drill_rig_sim/ros/trajectory_publisher.h"

namespace drill_rig_sim
{
/// Takes the frames in order and publishes all topics of each with its one stamp; /clock last, so that a node that wakes by
/// the clock finds the frame's topics sent.
class PublishingThread
{
public:
  /// `on_frame` is called with each frame that is published, `on_change` after a change of run state or a refused command is
  /// known.
  PublishingThread(ros::NodeHandle& node, const Parameters& parameters, FrameRing& ring, Subscriptions& subscriptions,
                   std::function<void()> ask_for_picture, std::function<void(const FrameRecord&)> on_frame,
                   std::function<void()> on_change);
  ~PublishingThread();

  void start();
  /// Publishes what is left and ends. The ring's writer must have stopped.
  void finish();

  /// The last frame published.
  FrameRecord last() const;
  /// Waits until frames handed over before this call are published. The caller keeps the writer from writing more.
  void wait_until_published(std::uint64_t handed_over);

private:
  void run();
  void publish(const FrameOutput& s);
  void tell_leader(const FrameRecord& record);

  FrameRing& ring_;
  std::function<void(const FrameRecord&)> on_frame_;
  std::function<void()> on_change_;
  bool tells_time_;  // to this node's ros::Time, see start_roscpp()
  int priority_;     // SCHED_FIFO; 0: as all threads
  StatePublisher state_;
  FramePublisher frames_;
  MarkerPublisher markers_;
  TrajectoryPublisher trajectory_;
  std::int64_t period_;                                    // of a frame [ns]
  ros::Publisher next_frame_;                              // where the time is another rig's: how far this one has come
  std::optional<FrameTopic<rosgraph_msgs::Clock>> clock_;  // advertised last, so sent last; none where the time is another's

  mutable std::mutex mutex_;  // guards last_ and published_
  std::condition_variable arrived_;
  FrameRecord last_;
  std::uint64_t published_ = 0;
  std::thread thread_;
};

}  // namespace drill_rig_sim

#endif
