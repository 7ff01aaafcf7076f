// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_WINDOW_STATISTICS_H
#define DRILL_RIG_SIM_ACCURACY_WINDOW_STATISTICS_H

#include <array>
#include <cstddef>

namespace drill_rig_sim
{
/// Statistics of a signal over its last 30 s (statistics_window), in pieces of a second: of 30 whole ones and the one under way.
/// They stay near each other in two models of a rig whose instants do not, because a vibration in them runs out of phase.
/// Bounded, allocates nothing.
class WindowStatistics
{
public:
  static constexpr double piece = 1.0;  ///< [s]
  static constexpr std::size_t pieces = 30;

  /// The signal was `value` for `duration` [s].
  void add(double value, double duration) noexcept;

  /// All 0 before the first value.
  struct Summary
  {
    double mean, deviation, least, largest;  ///< deviation: standard deviation; in the signal's unit
    /// Mean time from one rise through the mean to the next, of rises and falls by half a deviation or more [s]; 0: fewer than
    /// three in the window. The mean is that of the window at the time: for half a minute after a large step nothing rises
    /// through it.
    double period;
  };
  Summary summary() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("pieces", pieces_);
    v("newest", newest_);
    v("time", time_);
    v("level", level_);
    v("band", band_);
    v("above", above_);
  }

private:
  struct Piece
  {
    double duration = 0.0, sum = 0.0, squares = 0.0;  // [s], [unit s], [unit2 s]
    double least = 0.0, largest = 0.0;
    int rises = 0;
    double first_rise = 0.0, last_rise = 0.0;  // since the start [s]

    template <class V>
    void visit(V& v)
    {
      v("duration", duration);
      v("sum", sum);
      v("squares", squares);
      v("least", least);
      v("largest", largest);
      v("rises", rises);
      v("first_rise", first_rise);
      v("last_rise", last_rise);
    }
  };
  Piece whole() const noexcept;

  std::array<Piece, pieces + 1> pieces_;  // ring
  std::size_t newest_ = 0;
  double time_ = 0.0;                // since the start [s]
  double level_ = 0.0, band_ = 0.0;  // mean, and how far from it a rise or fall must go, as of the last whole piece
  bool above_ = false;
};

}  // namespace drill_rig_sim

#endif
