#ifndef DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <functional>
#include <mutex>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Publishes /diagnostics once per wall second, also while simulated time stands, and at once on each change of state.
class DiagnosticsPublisher
{
public:
  /// `last` gives the last frame published.
  DiagnosticsPublisher(ros::NodeHandle& node, std::function<FrameRecord()> last);
  void publish();

private:
  double real_time_factor(const FrameRecord& frame);
  diagnostic_msgs::DiagnosticStatus time_status(const FrameRecord& frame);
  diagnostic_msgs::DiagnosticStatus physics_status(const FrameRecord& frame) const;
  diagnostic_msgs::DiagnosticStatus command_status(const FrameRecord& frame);
  diagnostic_msgs::DiagnosticStatus status(const std::string& part) const;

  std::function<FrameRecord()> last_;
  std::string name_;
  std::mutex mutex_;
  ros::WallTime factor_since_;
  std::int64_t factor_stamp_ = 0;
  double factor_ = 1.0;
  double dropped_before_ = 0.0;
  std::uint64_t refused_before_ = 0;
  ros::Publisher diagnostics_;
  ros::WallTimer timer_;
};

}  // namespace drill_rig_sim

#endif
