// SPDX-License-Identifier: BSD-3-Clause
#include "history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drill_rig_sim::console
{
namespace
{
constexpr double longest_pause =
    5.0;  // between readings; after a longer one the line is broken, if they do not come that slowly [s]
}

History::History(Axis axis, std::size_t capacity, double interval) : axis_(axis), capacity_(capacity), interval_(interval)
{
  samples_.reserve(capacity);
}

void History::clear()
{
  samples_.clear();
  first_ = 0;
  begun_ = false;
  interrupted_ = true;
}

void History::push(const Sample& sample)
{
  if (samples_.size() < capacity_)
  {
    samples_.push_back(sample);
    return;
  }
  samples_[first_] = sample;
  first_ = (first_ + 1) % capacity_;
}

void History::add(double time, double depth, const Values& values)
{
  const double x = axis_ == Axis::time ? time : depth;
  if (!std::isfinite(x)) return;
  if (begun_ && x < last_ - 1e-9) clear();
  if (axis_ == Axis::time && begun_ && time - last_time_ > std::max(longest_pause, 3.0 * between_)) interrupted_ = true;
  between_ = begun_ ? time - last_time_ : 0.0;
  last_time_ = time;
  if (begun_ && x == last_) return;  // time stands, or nothing is drilled
  last_ = x;
  if (!begun_ || interrupted_)
  {
    begun_ = true;
    begins_ = interrupted_;
    interrupted_ = false;
    since_ = x;
    sum_.fill(0.0);
    number_.fill(0);
  }
  for (std::size_t n = 0; n < quantity_count; ++n)
  {
    const double v = values.value[n];
    if (!std::isfinite(v)) continue;
    const bool is_angle = quantities()[n].dimension == Dimension::angle;
    const bool first = is_angle || number_[n] == 0;
    least_[n] = first ? v : std::min(least_[n], v);
    most_[n] = first ? v : std::max(most_[n], v);
    sum_[n] = is_angle ? v : sum_[n] + v;
    number_[n] = is_angle ? 1 : number_[n] + 1;
  }
  if (x - since_ < interval_ * (1.0 - 1e-9)) return;
  Sample sample;
  sample.time = time;
  sample.depth = depth;
  sample.begins = begins_;
  for (std::size_t n = 0; n < quantity_count; ++n)
  {
    const bool known = number_[n] > 0;
    sample.value[n] = known ? sum_[n] / static_cast<double>(number_[n]) : missing;
    sample.least[n] = known ? least_[n] : missing;
    sample.most[n] = known ? most_[n] : missing;
  }
  push(sample);
  begins_ = false;
  since_ = x;
  sum_.fill(0.0);
  number_.fill(0);
}

std::size_t History::first_not_before(double place_wanted) const
{
  std::size_t low = 0, high = size();
  while (low < high)
  {
    const std::size_t middle = low + (high - low) / 2;
    if (place((*this)[middle]) < place_wanted)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

std::size_t History::nearest(double place_wanted) const
{
  if (empty()) return 0;
  const std::size_t above = first_not_before(place_wanted);
  if (above == 0) return 0;
  if (above == size()) return size() - 1;
  return place((*this)[above]) - place_wanted < place_wanted - place((*this)[above - 1]) ? above : above - 1;
}

namespace
{
// Least and largest of a column of the picture, in the order in which they came.
struct Column
{
  ChartPoint least{}, most{};
  bool filled = false;

  void take(const ChartPoint& p)
  {
    if (!filled || p.y < least.y) least = p;
    if (!filled || p.y > most.y) most = p;
    filled = true;
  }
  void empty_into(Stroke& stroke)
  {
    if (!filled) return;
    const bool rises = least.x <= most.x;
    stroke.push_back(rises ? least : most);
    if (least.x != most.x || least.y != most.y) stroke.push_back(rises ? most : least);
    filled = false;
  }
};
}  // namespace

std::vector<Stroke> History::line(Quantity quantity, double from, double to, std::size_t columns) const
{
  std::vector<Stroke> strokes;
  if (empty() || !(to > from) || columns == 0) return strokes;
  std::size_t begin = first_not_before(from), end = first_not_before(to);
  if (begin > 0) --begin;
  end = std::min(end + 1, size());
  const double width = (to - from) / static_cast<double>(columns);
  Column column;
  double last_column = -std::numeric_limits<double>::infinity();
  for (std::size_t n = begin; n < end; ++n)
  {
    const Sample& sample = (*this)[n];
    const std::size_t q = index_of(quantity);
    const double y = sample.value[q], x = place(sample);
    const bool breaks = sample.begins || !std::isfinite(y);
    const double here = std::floor((x - from) / width);
    if ((breaks || here != last_column) && !strokes.empty()) column.empty_into(strokes.back());
    if (breaks || strokes.empty()) strokes.emplace_back();
    last_column = here;
    if (std::isfinite(y))
      for (const double peak : {sample.least[q], y, sample.most[q]}) column.take({x, peak});
  }
  if (!strokes.empty()) column.empty_into(strokes.back());
  strokes.erase(std::remove_if(strokes.begin(), strokes.end(), [](const Stroke& s) { return s.empty(); }), strokes.end());
  return strokes;
}

void History::write_csv(std::ostream& out) const
{
  out << "time [s],hole_depth [m]";
  for (const QuantityRow& row : quantities())
    if (row.quantity != Quantity::hole_depth) out << "," << row.key << " [" << si_name(row.dimension) << "]";
  out << "\n";
  out.precision(9);
  for (std::size_t n = 0; n < size(); ++n)
  {
    const Sample& sample = (*this)[n];
    out << sample.time << "," << sample.depth;
    for (const QuantityRow& row : quantities())
    {
      if (row.quantity == Quantity::hole_depth) continue;
      out << ",";
      const double v = sample.value[index_of(row.quantity)];
      if (std::isfinite(v)) out << v;
    }
    out << "\n";
  }
}

}  // namespace drill_rig_sim::console
