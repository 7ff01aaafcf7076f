#ifndef DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_DIAGNOSTICS_PUBLISHER_H

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/ros.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Simulated seconds per wall second, measured over at least half a wall second of running.
class RealTimeFactor
{
public:
  /// `ticked`: simulated time that has passed [s]; `now`: of the steady clock [ns]. Nothing before the first half second.
  std::optional<double> update(double ticked, RunState state, std::int64_t now) noexcept;

private:
  static constexpr std::int64_t shortest = 500'000'000;  // [ns]
  std::optional<double> factor_;
  bool begun_ = false;
  bool stood_ = false;  // paused or failed when last asked
  double ticked_ = 0.0;
  std::int64_t since_ = 0;
};

/// Publishes /diagnostics once per wall second, also while simulated time stands, and at once on each change of state.
///
/// diagnostic_updater's status words the parts; its Updater does not publish them. It counts its period in ros::Time, so that it
/// sleeps while simulated time stands, which is when diagnostics are wanted most; driven from outside by force_update() it still
/// stamps with ros::Time::now(), the /clock as this node has received it back, and not with the frame's own stamp; and it reads a
/// private parameter of its own beside the checked ones.
class DiagnosticsPublisher
{
public:
  /// `last` gives the last frame published, `clock_trouble` what is wrong with /clock, empty where nothing is.
  DiagnosticsPublisher(ros::NodeHandle& node, std::function<FrameRecord()> last, std::function<std::string()> clock_trouble);
  void publish();

private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  Status time_status(const FrameRecord& frame);
  Status physics_status(const FrameRecord& frame) const;
  Status command_status(const FrameRecord& frame);
  Status status(const std::string& part, const std::string& summary) const;

  std::function<FrameRecord()> last_;
  std::function<std::string()> clock_trouble_;
  std::string name_;
  std::mutex mutex_;
  RealTimeFactor factor_;
  double dropped_before_ = 0.0;
  std::uint64_t refused_before_ = 0, clamped_before_ = 0;
  ros::Publisher diagnostics_;
  ros::WallTimer timer_;
};

}  // namespace drill_rig_sim

#endif
