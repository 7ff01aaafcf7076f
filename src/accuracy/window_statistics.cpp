// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/accuracy/window_statistics.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double frame_rounding = 1e-9;  // of sums of frames [s]
constexpr double half_deviation = 0.5;   // of which noise about the mean makes no rise
constexpr int fewest_rises = 3;
}  // namespace

void WindowStatistics::add(double value, double duration) noexcept
{
  Piece& now = pieces_[newest_];
  now.least = now.duration > 0.0 ? std::min(now.least, value) : value;
  now.largest = now.duration > 0.0 ? std::max(now.largest, value) : value;
  now.duration += duration;
  now.sum += value * duration;
  now.squares += value * value * duration;
  time_ += duration;
  if (above_ ? value < level_ - band_ : value > level_ + band_)
  {
    above_ = !above_;
    if (above_ && band_ > 0.0)
    {
      if (now.rises++ == 0) now.first_rise = time_;
      now.last_rise = time_;
    }
  }
  if (now.duration < piece - frame_rounding) return;
  const Summary window = summary();
  level_ = window.mean;
  band_ = half_deviation * window.deviation;
  newest_ = (newest_ + 1) % pieces_.size();
  pieces_[newest_] = Piece();
}

WindowStatistics::Piece WindowStatistics::whole() const noexcept
{
  Piece all;
  for (const Piece& p : pieces_)
  {
    if (p.duration == 0.0) continue;
    all.least = all.duration > 0.0 ? std::min(all.least, p.least) : p.least;
    all.largest = all.duration > 0.0 ? std::max(all.largest, p.largest) : p.largest;
    all.duration += p.duration;
    all.sum += p.sum;
    all.squares += p.squares;
    if (p.rises > 0)
    {
      all.first_rise = all.rises > 0 ? std::min(all.first_rise, p.first_rise) : p.first_rise;
      all.last_rise = std::max(all.last_rise, p.last_rise);
    }
    all.rises += p.rises;
  }
  return all;
}

WindowStatistics::Summary WindowStatistics::summary() const noexcept
{
  const Piece all = whole();
  if (all.duration == 0.0) return {};
  const double mean = all.sum / all.duration;
  return {mean, std::sqrt(std::max(0.0, all.squares / all.duration - mean * mean)), all.least, all.largest,
          all.rises >= fewest_rises ? (all.last_rise - all.first_rise) / (all.rises - 1) : 0.0};
}

}  // namespace drill_rig_sim
