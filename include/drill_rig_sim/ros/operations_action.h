// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_OPERATIONS_ACTION_H
#define DRILL_RIG_SIM_ROS_OPERATIONS_ACTION_H

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>

#include <atomic>
#include <string>

#include "drill_rig_sim/RunOperationsAction.h"
#include "drill_rig_sim/ros/simulation_loop.h"

namespace drill_rig_sim
{
/// The action run_operations: what a driller does, given to a rig that runs. One goal at a time; a new one takes the place of the
/// one under way, whose block is braked first.
class OperationsAction
{
public:
  /// `node` calls back on its own callback queue.
  OperationsAction(ros::NodeHandle& node, SimulationLoop& loop);
  /// For the publishing thread, after each frame that is published: feedback and result.
  void follow(const FrameRecord& frame);

private:
  void begin();
  void cancel();
  std::string start(const std::string& operations);
  void give_feedback(const FrameRecord& frame);
  void end(bool success, const std::string& message);

  SimulationLoop& loop_;
  std::atomic<std::uint32_t> order_{0};  // under way; 0: none
  std::atomic<std::uint32_t> epoch_{0};  // of the rig that does it
  std::atomic<double> began_{0.0};       // time of the rig that does it [s]
  std::atomic<double> last_{0.0};        // the same, of its last frame: a reset sets the rig's time to 0 [s]
  double told_at_ = 0.0;                 // of the last feedback [s]
  int told_number_ = 0;
  actionlib::SimpleActionServer<RunOperationsAction> server_;
};

}  // namespace drill_rig_sim

#endif
