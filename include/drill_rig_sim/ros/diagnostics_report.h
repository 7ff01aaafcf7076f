// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_DIAGNOSTICS_REPORT_H
#define DRILL_RIG_SIM_ROS_DIAGNOSTICS_REPORT_H

#include <diagnostic_msgs/DiagnosticArray.h>
#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstdint>
#include <optional>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/mailbox.h"

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

/// Why an operation was given up, one line; empty where none was.
std::string trouble_of(const OperationStatus& operation);

/// What /diagnostics says of a frame: time, physics, accuracy, commands. Remembers what the report before said, for what has
/// happened since.
class DiagnosticsReport
{
public:
  /// `name`: of the node, without the leading slash.
  explicit DiagnosticsReport(std::string name) : name_(std::move(name)) {}
  /// `clock_trouble`: what is wrong with /clock, `sender_trouble`: with who sends commands, empty where nothing is; `now`: of the
  /// steady clock [ns].
  diagnostic_msgs::DiagnosticArray on(const FrameRecord& frame, const Refusals& refusals, const std::string& clock_trouble,
                                      std::int64_t now, const std::string& sender_trouble = "");

private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  Status time_status(const FrameRecord& frame, const std::string& clock_trouble, std::int64_t now);
  Status physics_status(const FrameRecord& frame) const;
  Status accuracy_status(const FrameRecord& frame) const;
  Status command_status(const FrameRecord& frame, const Refusals& refusals, const std::string& sender_trouble);
  Status status(const std::string& part, const std::string& summary) const;

  std::string name_;
  RealTimeFactor factor_;
  double dropped_before_ = 0.0;
  std::uint64_t refused_before_ = 0, clamped_before_ = 0;
};

}  // namespace drill_rig_sim

#endif
