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

TimeSeries::TimeSeries(const std::string& name, double every, bool with_readings)
  : name_(name), file_(open_output("--csv", name)), beat_(every), with_readings_(with_readings)
{
  if (file_) write_csv_header(file_.get(), with_readings_);
}

void TimeSeries::add(const Simulator& simulator, double frame)
{
  const Truth& m = simulator.truth();
  if (file_ && beat_.due(m.time, frame)) write_csv_row(file_.get(), m, with_readings_ ? &simulator.readings() : nullptr);
}

void TimeSeries::close()
{
  close_output(std::move(file_), name_);
}

ProfileSeries::ProfileSeries(const std::string& name, double every) : name_(name), file_(open_output("--profile", name)), beat_(every)
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

}  // namespace drill_rig_sim
