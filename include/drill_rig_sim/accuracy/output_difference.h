// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_OUTPUT_DIFFERENCE_H
#define DRILL_RIG_SIM_ACCURACY_OUTPUT_DIFFERENCE_H

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/accuracy/sliding_mean.h"
#include "drill_rig_sim/accuracy/window_statistics.h"

namespace drill_rig_sim
{
/// Over how long differences are averaged [s].
constexpr double difference_window = 3.0;

/// Over how long statistics are compared [s].
constexpr double statistics_window = WindowStatistics::piece * WindowStatistics::pieces;

/// How far statistics of an output over statistics_window are apart in two models, each 0 or more.
struct StatisticDifferences
{
  double mean = 0.0, deviation = 0.0;  ///< in the output's unit
  double extremes = 0.0;               ///< of least or largest value, whichever is more, in the output's unit
  double period = 0.0;                 ///< relative; NaN where one of the two does not swing [-]

  template <class V>
  void visit(V& v)
  {
    v("mean", mean);
    v("deviation", deviation);
    v("extremes", extremes);
    v("period", period);
  }
};

/// How far one output of two models of the same rig is apart.
class OutputDifference
{
public:
  explicit OutputDifference(Output output = Output::hook_load) noexcept : output_(output) {}

  /// Its values in the two over a frame of `duration` [s]; the second is the one whose range counts.
  void add(double value, double other, double duration) noexcept;
  /// A value that the output is about to take: it counts in the range from now on. Call after add().
  void expect(double value) noexcept;
  /// Root mean square of the difference over the last window, in the output's unit; before the start there was none.
  double absolute() const noexcept;
  StatisticDifferences statistics() const noexcept;
  /// What the output has ranged over so far, a tenth of its mean magnitude, or the resolution of an instrument, whichever is
  /// most; in its unit.
  double scale() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("output", output_);
    v("squares", squares_);
    v("statistics", statistics_);
    v("statistics_other", statistics_other_);
    v("smooth", smooth_);
    v("smooth_other", smooth_other_);
    v("least", least_);
    v("most", most_);
    v("sum", sum_);
    v("time", time_);
  }

private:
  Output output_;
  SlidingMean<30> squares_;
  WindowStatistics statistics_, statistics_other_;
  SlidingMean<10> smooth_, smooth_other_;  // of a rate of penetration
  double least_ = 0.0, most_ = 0.0;
  double sum_ = 0.0, time_ = 0.0;  // of magnitudes, of the second model [unit s, s]
};

}  // namespace drill_rig_sim

#endif
