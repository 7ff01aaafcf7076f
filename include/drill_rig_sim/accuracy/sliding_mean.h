// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_SLIDING_MEAN_H
#define DRILL_RIG_SIM_ACCURACY_SLIDING_MEAN_H

#include <array>
#include <cstddef>

namespace drill_rig_sim
{
/// Mean of a signal over its last seconds, in pieces of a tenth of a second: of `Pieces` whole ones and the one under way.
/// Bounded, allocates nothing.
template <std::size_t Pieces>
class SlidingMean
{
public:
  static constexpr double piece = 0.1;  ///< [s]

  /// The signal was `value` for `duration` [s].
  void add(double value, double duration) noexcept
  {
    Piece& now = pieces_[newest_];
    now.sum += value * duration;
    now.duration += duration;
    if (now.duration < piece - rounding) return;
    newest_ = (newest_ + 1) % pieces_.size();
    pieces_[newest_] = Piece();
  }

  /// 0 before the first value.
  double mean() const noexcept
  {
    Piece all;
    for (const Piece& p : pieces_)
    {
      all.sum += p.sum;
      all.duration += p.duration;
    }
    return all.duration > 0.0 ? all.sum / all.duration : 0.0;
  }

  template <class V>
  void visit(V& v)
  {
    v("pieces", pieces_);
    v("newest", newest_);
  }

private:
  static constexpr double rounding = 1e-9;  // of sums of frames [s]
  struct Piece
  {
    double sum = 0.0, duration = 0.0;

    template <class V>
    void visit(V& v)
    {
      v("sum", sum);
      v("duration", duration);
    }
  };

  std::array<Piece, Pieces + 1> pieces_;  // ring
  std::size_t newest_ = 0;
};

}  // namespace drill_rig_sim

#endif
