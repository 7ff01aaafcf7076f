#ifndef DRILL_RIG_SIM_ACCURACY_OUTPUT_DIFFERENCE_H
#define DRILL_RIG_SIM_ACCURACY_OUTPUT_DIFFERENCE_H

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/accuracy/sliding_mean.h"

namespace drill_rig_sim
{
/// Over how long differences are averaged [s].
constexpr double difference_window = 3.0;

/// Over how long averages are compared [s].
constexpr double mean_window = 30.0;

/// How far one output of two models of the same rig is apart.
class OutputDifference
{
public:
  explicit OutputDifference(Output output = Output::hook_load) noexcept : output_(output) {}

  /// Its values in the two over a frame of `duration` [s]; the second is the one whose range counts.
  void add(double value, double other, double duration) noexcept;
  /// Root mean square of the difference over the last window, in the output's unit; before the start there was none.
  double absolute() const noexcept;
  /// Difference of the averages over the last mean_window, in the output's unit, 0 or more.
  double of_means() const noexcept;
  /// What the output has ranged over so far, a tenth of its mean magnitude, or what an instrument tells apart, whichever is most; in its unit.
  double scale() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("output", output_);
    v("squares", squares_);
    v("signed", signed_);
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
  SlidingMean<300> signed_;  // of the difference itself
  SlidingMean<10> smooth_, smooth_other_;  // of a rate of penetration
  double least_ = 0.0, most_ = 0.0;
  double sum_ = 0.0, time_ = 0.0;  // of magnitudes, of the second model [unit s, s]
};

}  // namespace drill_rig_sim

#endif
