// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SERIES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SERIES_H

#include <optional>
#include <string>

#include "drill_output.h"
#include "drill_rig_sim/ros/run_bag.h"

namespace drill_rig_sim
{
/// Tells when something that is written every so often is due.
class Beat
{
public:
  explicit Beat(double every) : every_(every) {}
  /// True at the start and once per `every` seconds, in the frame of `frame` [s] whose end `time` is nearest to.
  bool due(double time, double frame) noexcept;

private:
  double every_;
  double next_ = 0.0;  // [s]
};

/// The bag of a run: its measurements every so often, telemetry when it arrives. One without a file writes nothing.
class BagSeries
{
public:
  /// Opens the file `name`, unless that is empty. Throws UsageError with one line if it cannot be written. `every`: between
  /// measurements [s]; `scene`: the run's; `with_companion`: as RunBag.
  BagSeries(const std::string& name, double every, const Scene& scene, bool with_companion);
  /// As TimeSeries. Throws std::runtime_error with one line if it cannot be written.
  void add(const Simulator& simulator, double frame);
  /// Throws std::runtime_error with one line if not all of it reached the disk.
  void close();

private:
  std::optional<RunBag> bag_;
  Beat beat_;
};

/// The time series of a run: a row every so often. One without a file writes nothing.
class TimeSeries
{
public:
  /// Opens the file `name`, unless that is empty, and writes the header. Throws UsageError with one line if it cannot be written.
  /// `every`: between two rows [s]. `with_readings`, `with_errors`: as write_csv_header().
  TimeSeries(const std::string& name, double every, bool with_readings, bool with_errors);
  /// Writes a row if one is due; call at the start and after each frame of `frame` [s].
  void add(const Simulator& simulator, double frame);
  /// Throws ComputationError with one line if not all of it reached the disk.
  void close();

private:
  std::string name_;
  File file_;
  Beat beat_;
  bool with_readings_, with_errors_;
};

/// The forces along the string during a run, a row per node every so often. One without a file writes nothing.
class ProfileSeries
{
public:
  /// As TimeSeries.
  ProfileSeries(const std::string& name, double every);
  void add(const Simulator& simulator, double frame);
  void close();

private:
  std::string name_;
  File file_;
  Beat beat_;
  StringProfile profile_;
};

/// The history of what was modelled during a run: a row where nodes became free or guided, where steps became twice as
/// long or half, and where an accuracy warning began or ended; the first says what level auto has chosen. One without a file
/// writes nothing.
class ChoiceSeries
{
public:
  /// As TimeSeries.
  explicit ChoiceSeries(const std::string& name);
  void add(const Simulator& simulator);
  void close();

private:
  std::string why(const Simulator& simulator) const;

  std::string name_;
  File file_;
  bool begun_ = false;
  // of the last row
  double step_ = 0.0;
  int guided_ = 0;
  AccuracyDoubt doubt_ = AccuracyDoubt::none;
};

}  // namespace drill_rig_sim

#endif
