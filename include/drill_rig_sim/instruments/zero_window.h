// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_ZERO_WINDOW_H
#define DRILL_RIG_SIM_INSTRUMENTS_ZERO_WINDOW_H

#include <array>
#include <cstddef>

namespace drill_rig_sim
{
/// Mean and standard deviation of hook load and stand-pipe pressure over the time before a zero of the weight.
struct Zero
{
  double duration = 0.0;                       ///< that they are of [s]
  double hook_load = 0.0;                      ///< [N]
  double hook_load_deviation = 0.0;            ///< [N]
  double stand_pipe_pressure = 0.0;            ///< [Pa]
  double stand_pipe_pressure_deviation = 0.0;  ///< [Pa]
};

/// Hook load and stand-pipe pressure of the last minute, as means and variances of quarters of a second: for a zero over a
/// duration that is asked for afterwards, so that no frame has to wait for it. Readings are weighted by the time since the one
/// before.
class ZeroWindow
{
public:
  static constexpr double shortest = 0.5;  ///< duration of a zero [s]
  static constexpr double longest = 60.0;  ///< [s]

  /// The signals at `time` [s]: hook load [N] and stand-pipe pressure [Pa]. A time that is not after the last one adds nothing.
  void take(double hook_load, double pressure, double time) noexcept;
  /// Forgets what came before.
  void restart() noexcept;
  /// How much it holds, at most some longest [s].
  double held() const noexcept { return held_; }
  /// Over the last `duration` [s], or up to a quarter of a second (or a frame, if that is longer) more; over all it holds if that
  /// is less.
  Zero over(double duration) const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("parts", parts_);
    v("newest", newest_);
    v("count", count_);
    v("last", last_);
    v("held", held_);
    v("begun", begun_);
  }

private:
  static constexpr double part_length = 0.25;  // [s]
  static constexpr std::size_t most_parts = static_cast<std::size_t>(longest / part_length) + 1;

  /// Mean of a signal and the integral of its squared deviation, by West (Comm. ACM 22, 1979, 532): sums of squares would lose
  /// digits.
  struct Moments
  {
    double mean = 0.0, square = 0.0;

    /// Another mean and integral, of `added` [s], joins what is of `weight` [s] so far.
    void join(double weight, const Moments& other, double added) noexcept;

    template <class V>
    void visit(V& v)
    {
      v("mean", mean);
      v("square", square);
    }
  };
  struct Part
  {
    double length = 0.0;  // [s]
    Moments hook_load, pressure;

    void join(const Part& other) noexcept;

    template <class V>
    void visit(V& v)
    {
      v("length", length);
      v("hook_load", hook_load);
      v("pressure", pressure);
    }
  };

  std::array<Part, most_parts> parts_;  // ring
  std::size_t newest_ = 0, count_ = 0;
  double last_ = 0.0;  // time of the last reading [s]
  double held_ = 0.0;  // [s]
  bool begun_ = false;
};

}  // namespace drill_rig_sim

#endif
