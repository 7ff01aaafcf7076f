// SPDX-License-Identifier: BSD-3-Clause
#include "drill_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drill_rig_sim
{
bool Beat::due(double time, double frame) noexcept
{
  if (time < next_ - 0.5 * frame) return false;
  next_ += every_ * std::max(1.0, std::ceil((time + 0.5 * frame - next_) / every_));
  return true;
}

TimeSeries::TimeSeries(const std::string& name, double every, bool with_readings, bool with_errors)
    : name_(name), file_(open_output("--csv", name)), beat_(every), with_readings_(with_readings), with_errors_(with_errors)
{
  if (file_) write_csv_header(file_.get(), with_readings_, with_errors_);
}

void TimeSeries::add(const Simulator& simulator, double frame)
{
  const Truth& m = simulator.truth();
  if (!file_ || !beat_.due(m.time, frame)) return;
  write_csv_row(file_.get(), m, with_readings_ ? &simulator.readings() : nullptr, with_errors_ ? &simulator : nullptr);
}

void TimeSeries::close()
{
  close_output(std::move(file_), name_);
}

BagSeries::BagSeries(const std::string& name, double every, const Scene& scene, bool with_companion) : beat_(every)
{
  if (name.empty()) return;
  open_output("--bag", name).reset();  // says why not, if not
  bag_.emplace(name, scene, with_companion);
}

void BagSeries::add(const Simulator& simulator, double frame)
{
  if (bag_) bag_->add(simulator, beat_.due(simulator.truth().time, frame));
}

void BagSeries::close()
{
  if (bag_) bag_->close();
}

ProfileSeries::ProfileSeries(const std::string& name, double every)
    : name_(name), file_(open_output("--profile", name)), beat_(every)
{
  if (file_) write_profile_series_header(file_.get());
}

void ProfileSeries::add(const Simulator& simulator, double frame)
{
  const double time = simulator.truth().time;
  if (!file_ || !beat_.due(time, frame)) return;
  simulator.profile(profile_);
  write_profile_series_rows(file_.get(), time, profile_);
}

void ProfileSeries::close()
{
  close_output(std::move(file_), name_);
}

ChoiceSeries::ChoiceSeries(const std::string& name) : name_(name), file_(open_output("--explain", name))
{
  if (file_) std::fputs("time,step,guided_nodes,why\n", file_.get());
}

/// Empty: all is as in the last row.
std::string ChoiceSeries::why(const Simulator& simulator) const
{
  const SimulatorStatistics& s = simulator.statistics();
  if (!begun_) return std::string("level ") + s.level + (simulator.choice().empty() ? ", as given" : ": " + simulator.choice());
  if (s.guided_nodes != guided_)
    return s.guided_nodes < guided_ ? "pipe was set free: its compression comes near to buckling"
                                    : "pipe is guided again: it is calm";
  if (s.accuracy.doubt != doubt_) return s.accuracy.doubt == AccuracyDoubt::none ? "no warning any more" : text_of(s.accuracy);
  if (s.last_step > 0.0 && (s.last_step >= 2.0 * step_ || s.last_step <= 0.5 * step_))
    return s.last_step > step_ ? "longer steps are accurate enough" : "shorter steps are needed";
  return "";
}

void ChoiceSeries::add(const Simulator& simulator)
{
  if (!file_) return;
  const std::string reason = why(simulator);
  if (reason.empty()) return;
  const SimulatorStatistics& s = simulator.statistics();
  std::fprintf(file_.get(), "%.3f,%.3g,%d,\"%s\"\n", simulator.truth().time, s.last_step, s.guided_nodes, reason.c_str());
  begun_ = true;
  step_ = s.last_step;
  guided_ = s.guided_nodes;
  doubt_ = s.accuracy.doubt;
}

void ChoiceSeries::close()
{
  close_output(std::move(file_), name_);
}

}  // namespace drill_rig_sim
