// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_PERIOD_MEAN_H
#define DRILL_RIG_SIM_INSTRUMENTS_PERIOD_MEAN_H

#include <array>
#include <cstddef>

namespace drill_rig_sim
{
/// The mean of a signal over the last period of the waves that swing it: what a driller on a floating rig reads off a hook load.
class PeriodMean
{
public:
  PeriodMean() = default;
  /// `period` [s]; 0: no waves, and the mean is the signal as it is.
  explicit PeriodMean(double period) : period_(period) {}
  /// The signal is `value` at `time` [s], and was straight since the last call. The same time may be given again.
  void take(double value, double time) noexcept;
  /// Over the last period, or over all there was if that is less.
  double mean() const noexcept;
  /// Another period [s]. What it remembers stays.
  void set_period(double period) noexcept { period_ = period; }
  /// Forgets what came before: the mean begins with the next value.
  void restart() noexcept { held_ = 0; }

  template <class V>
  void visit(V& v)
  {
    v("samples", samples_);
    v("newest", newest_);
    v("held", held_);
    v("now", now_);
    v("value", value_);
  }

private:
  static constexpr std::size_t pieces = 64;  // of a period: between them the integral counts as straight
  struct Sample
  {
    double time = 0.0, integral = 0.0;

    template <class V>
    void visit(V& v)
    {
      v("time", time);
      v("integral", integral);
    }
  };
  const Sample& back(std::size_t k) const noexcept { return samples_[(newest_ + samples_.size() - k) % samples_.size()]; }

  double period_ = 0.0;
  std::array<Sample, pieces + 2> samples_;  // ring
  std::size_t newest_ = 0, held_ = 0;
  Sample now_;
  double value_ = 0.0;
};

}  // namespace drill_rig_sim

#endif
