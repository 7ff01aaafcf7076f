// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_HISTORY_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_HISTORY_H

#include <cstddef>
#include <ostream>
#include <vector>

#include "quantities.h"

namespace drill_rig_sim::console
{
/// What a chart is drawn against.
enum class Axis
{
  time,
  depth
};

struct Sample
{
  double time = 0.0;   // simulated [s]
  double depth = 0.0;  // of the hole [m]
  bool begins = true;  // nothing was received just before
  std::array<double, quantity_count> value{}, least{},
      most{};  // mean (of an angle the last), smallest and largest of its interval
};

struct ChartPoint
{
  double x, y;  // [s] or [m]; [SI]
};

/// A piece of a curve's line: points that belong together.
using Stroke = std::vector<ChartPoint>;

/// The last samples of all quantities against time or depth: at most `capacity`, one for each `interval`, the oldest go. A sample
/// is the mean of what came in its interval, of angles the last: the mean of 359 and 1 deg is none. Against time a line is broken
/// where no reading came for more than 5 s. It keeps the smallest and the largest too: the chart draws every peak.
class History
{
public:
  /// `interval`: [s] or [m].
  History(Axis axis, std::size_t capacity, double interval);
  /// Takes what is known at a time [s] and hole depth [m]. An axis that went back (another well, another clock) forgets all
  /// before.
  void add(double time, double depth, const Values& values);
  /// The next sample begins a new piece: the readings were not followed for a while.
  void interrupt() { interrupted_ = true; }
  void clear();

  Axis axis() const { return axis_; }
  std::size_t size() const { return samples_.size(); }
  bool empty() const { return samples_.empty(); }
  /// Oldest first.
  const Sample& operator[](std::size_t n) const { return samples_[(first_ + n) % samples_.size()]; }
  /// Place on the axis [s] or [m].
  double place(const Sample& sample) const { return axis_ == Axis::time ? sample.time : sample.depth; }
  /// The sample nearest to a place; `size()` where there is none.
  std::size_t nearest(double place) const;
  /// The line of a quantity between two places (and one sample beyond either), in strokes, thinned to least and largest of each
  /// of `columns`.
  std::vector<Stroke> line(Quantity quantity, double from, double to, std::size_t columns) const;
  /// A table of all samples and quantities in SI, as CSV with a line of names; what was not known is empty.
  void write_csv(std::ostream& out) const;

private:
  void push(const Sample& sample);
  std::size_t first_not_before(double place) const;

  Axis axis_;
  std::size_t capacity_;
  double interval_;
  std::vector<Sample> samples_;
  std::size_t first_ = 0;
  bool interrupted_ = true;
  // of the interval under way
  bool begun_ = false, begins_ = true;
  double since_ = 0.0, last_ = 0.0, last_time_ = 0.0, between_ = 0.0;
  std::array<double, quantity_count> sum_{}, least_{}, most_{};
  std::array<std::size_t, quantity_count> number_{};
};

}  // namespace drill_rig_sim::console

#endif
