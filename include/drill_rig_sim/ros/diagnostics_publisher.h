// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H

#include <ros/ros.h>

#include <functional>
#include <mutex>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/diagnostics_report.h"

namespace drill_rig_sim
{
/// Publishes /diagnostics once per wall second, also while simulated time stands, and at once on each change of state.
///
/// diagnostic_updater's status words the parts; its Updater does not publish them. It counts its period in ros::Time, so that it
/// sleeps while simulated time stands, which is when diagnostics are wanted most; driven from outside by force_update() it still
/// stamps with ros::Time::now() and not with the stamp of the frame it reports; and it reads a
/// private parameter of its own beside the checked ones.
class DiagnosticsPublisher
{
public:
  /// `last` gives the last frame published, `clock_trouble` what is wrong with /clock, empty where nothing is.
  DiagnosticsPublisher(ros::NodeHandle& node, std::function<FrameRecord()> last, const Refusals& refusals,
                       const CommandSenders& senders, std::function<std::string()> clock_trouble);
  void publish();

private:
  std::function<FrameRecord()> last_;
  const Refusals& refusals_;
  const CommandSenders& senders_;
  std::function<std::string()> clock_trouble_;
  std::mutex mutex_;     // guards what follows: a change of state reports from another thread
  std::string trouble_;  // of the operations, logged once
  std::string hung_up_;  // likewise
  DiagnosticsReport report_;
  ros::Publisher diagnostics_;
  ros::WallTimer timer_;
};

}  // namespace drill_rig_sim

#endif
