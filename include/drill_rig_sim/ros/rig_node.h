// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_RIG_NODE_H
#define DRILL_RIG_SIM_ROS_RIG_NODE_H

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "drill_rig_sim/realtime/frame_ring.h"
#include "drill_rig_sim/ros/clock_watch.h"
#include "drill_rig_sim/ros/diagnostics_publisher.h"
#include "drill_rig_sim/ros/follower_watch.h"
#include "drill_rig_sim/ros/mailbox.h"
#include "drill_rig_sim/ros/operations_action.h"
#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/ros/publishing_thread.h"
#include "drill_rig_sim/ros/services.h"
#include "drill_rig_sim/ros/signals.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// The node: a simulation thread, a publishing thread, and callbacks for commands, services and timers.
///   topics -> Mailbox -> SimulationLoop (owns Simulator, Timekeeper) -> FrameRing -> PublishingThread -> topics
///   services -> SimulationLoop::between_frames()
class RigNode
{
public:
  /// Reads the parameters, builds the rig and starts. Throws std::exception, what() says what is wrong.
  RigNode();
  ~RigNode();

  /// Returns once the node has left the master. A step under way is ended as soon as that begins: roscpp waits for its answer.
  void wait_for_shutdown();

private:
  void say_what_runs();

  ros::CallbackQueue service_queue_;
  ros::NodeHandle node_;
  ros::NodeHandle service_node_;  // calls back on service_queue_
  Parameters parameters_;
  Scene scene_;
  Mailbox mailbox_;
  FrameRing ring_;
  SimulationLoop loop_;
  SignalHold registering_;  // until all below is on the master
  OperationsAction operations_;
  ClockWatch clock_;
  FollowerWatch followers_;
  PublishingThread publishing_;
  DiagnosticsPublisher diagnostics_;
  Services services_;
  ros::AsyncSpinner spinner_;
  ros::AsyncSpinner service_spinner_;
};

}  // namespace drill_rig_sim

#endif
