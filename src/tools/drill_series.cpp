#include "drill_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drill_rig_sim
{
TimeSeries::TimeSeries(const std::string& name, double every, bool with_readings)
  : name_(name), file_(open_output("--csv", name)), every_(every), with_readings_(with_readings)
{
  if (file_) write_csv_header(file_.get(), with_readings_);
}

void TimeSeries::add(const Simulator& simulator, double frame)
{
  const Truth& m = simulator.truth();
  if (!file_ || m.time < next_row_ - 0.5 * frame) return;
  write_csv_row(file_.get(), m, with_readings_ ? &simulator.readings() : nullptr);
  next_row_ += every_ * std::max(1.0, std::ceil((m.time + 0.5 * frame - next_row_) / every_));
}

void TimeSeries::close()
{
  close_output(std::move(file_), name_);
}

}  // namespace drill_rig_sim
