#include "drill_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drill_rig_sim
{
TimeSeries::TimeSeries(const std::string& name, double every) : name_(name), file_(open_output("--csv", name)), every_(every)
{
  if (file_) write_csv_header(file_.get());
}

void TimeSeries::add(const Measurements& m, double frame)
{
  if (!file_ || m.time < next_row_ - 0.5 * frame) return;
  write_csv_row(file_.get(), m);
  next_row_ += every_ * std::max(1.0, std::ceil((m.time + 0.5 * frame - next_row_) / every_));
}

void TimeSeries::close()
{
  close_output(std::move(file_), name_);
}

}  // namespace drill_rig_sim
