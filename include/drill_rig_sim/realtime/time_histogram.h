// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REALTIME_TIME_HISTOGRAM_H
#define DRILL_RIG_SIM_REALTIME_TIME_HISTOGRAM_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace drill_rig_sim
{
/// Preferred numbers (R10 of ISO 3) from 1 us to 8 s [ns].
constexpr std::array<std::int64_t, 70> preferred_times() noexcept
{
  constexpr std::array<std::int64_t, 10> decade{1000, 1250, 1600, 2000, 2500, 3150, 4000, 5000, 6300, 8000};
  std::array<std::int64_t, 70> all{};
  std::int64_t factor = 1;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = factor * decade[i % decade.size()];
    if (i % decade.size() == decade.size() - 1) factor *= 10;
  }
  return all;
}

/// How long something took, time and again: counts between preferred times, so that 1, 2, 5, 10 ms are
/// exact bounds and a percentile is at most a quarter too long. A plain value: counting neither locks nor allocates.
class TimeHistogram
{
public:
  /// Counts a time of `duration` [ns] beside the time there was for it [ns].
  void add(std::int64_t duration, std::int64_t allowed) noexcept
  {
    ++counts_[bin_of(duration)];
    ++number_;
    if (duration < allowed) ++within_;
    longest_ = std::max(longest_, duration);
  }

  std::uint64_t number() const noexcept { return number_; }
  double longest() const noexcept { return 1e-9 * static_cast<double>(longest_); }  ///< [s]

  /// Times below `bound` [ns]; exact where that is one of the bounds, else of the bound before it.
  std::uint64_t below(std::int64_t bound) const noexcept
  {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bounds.size() && bounds[i] <= bound; ++i) sum += counts_[i];
    return sum;
  }
  /// Share of the times below the bound [ns], or below what was allowed; 1 where nothing was counted.
  double share_below(std::int64_t bound) const noexcept { return share(below(bound)); }
  double share_within() const noexcept { return share(within_); }

  /// Of all times this share is no longer [s]: the upper bound of the bin in which that is reached, or the longest. 0 where
  /// nothing was counted.
  double percentile(double wanted) const noexcept
  {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      sum += counts_[i];
      if (static_cast<double>(sum) >= wanted * static_cast<double>(number_))
        return std::min(1e-9 * static_cast<double>(bounds[i]), longest());
    }
    return longest();
  }

private:
  static constexpr std::array<std::int64_t, 70> bounds = preferred_times();

  static std::size_t bin_of(std::int64_t duration) noexcept
  {
    return static_cast<std::size_t>(std::upper_bound(bounds.begin(), bounds.end(), duration) - bounds.begin());
  }
  double share(std::uint64_t part) const noexcept
  {
    return number_ == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(number_);
  }

  std::array<std::uint64_t, bounds.size() + 1> counts_{};  // below each bound; last: no shorter than all
  std::uint64_t number_ = 0, within_ = 0;
  std::int64_t longest_ = 0;  // [ns]
};

}  // namespace drill_rig_sim

#endif
