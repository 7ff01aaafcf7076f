// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/accuracy/verification.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double own_of_difference = 1.0 / 3.0;  // of the finest run's error, over what the finer two differ by
constexpr double known_to = 1.0 / 3.0;           // of the error that is to be determined
constexpr double rounding = 1e-6;                // of sums of frames [s]

bool is_right_in_statistics(const Verification::Finding& found, double tolerance) noexcept
{
  if (std::isnan(found.parted_from) || !found.statistics_known) return false;
  const StatisticDifferences& off = found.statistics;
  return std::max({off.mean, off.deviation, off.extremes, off.period}) <= tolerance;
}
}  // namespace

Verification::Verification(double tolerance, unsigned needs) : tolerance_(tolerance), needs_(needs)
{
  for (std::size_t i = 0; i < output_count; ++i)
    rows_[i].to_finest = rows_[i].between_finer = OutputDifference(static_cast<Output>(i));
}

void Verification::add(const Outputs& run, const Outputs& finer, const Outputs& finest, bool warned, const Outputs& measured,
                       double time, double duration)
{
  for (std::size_t i = 0; i < output_count; ++i)
  {
    Row& row = rows_[i];
    row.to_finest.add(run[i], finest[i], duration);
    row.between_finer.add(finer[i], finest[i], duration);
    row.sum += run[i] * duration;
    row.finest_sum += finest[i] * duration;
  }
  if (warned && std::isnan(warned_from_)) warned_from_ = time;
  time_ += duration;
  since_window_ += duration;
  if (since_window_ > difference_window - rounding) end_window(measured, time);
}

void Verification::end_window(const Outputs& measured, double time)
{
  since_window_ = 0.0;
  ends_.push_back(time);
  for (std::size_t i = 0; i < output_count; ++i)
  {
    Row& row = rows_[i];
    row.measured.push_back(measured[i]);
    row.off.push_back(row.to_finest.absolute());
    row.own.push_back(own_of_difference * row.between_finer.absolute());
    row.off_over.push_back(row.to_finest.statistics());
    row.own_over.push_back(row.between_finer.statistics());
  }
}

Verification::Finding Verification::finding(Output output) const
{
  const Row& row = rows_[static_cast<std::size_t>(output)];
  Finding found;
  found.scale = row.to_finest.scale();
  found.mean = time_ > 0.0 ? row.sum / time_ : 0.0;
  found.finest_mean = time_ > 0.0 ? row.finest_sum / time_ : 0.0;
  found.measured = row.measured;
  find_instants(row, found);
  const double from = parted_from();
  if (has_parted(row, found, from)) find_statistics(row, from, found);
  return found;
}

void Verification::find_instants(const Row& row, Finding& found) const
{
  for (std::size_t k = 0; k < ends_.size(); ++k)
  {
    found.off.push_back(row.off[k] / found.scale);
    const double off = found.off.back(), own = row.own[k] / found.scale;
    found.own = std::max(found.own, own);
    if (off > found.worst)
    {
      found.worst = off;
      found.worst_until = ends_[k];
    }
    if (off <= tolerance_ || !std::isnan(found.wrong_from)) continue;
    found.wrong_from = std::max(ends_[k] - difference_window, 0.0);
    found.known = own <= known_to * off;
  }
  if (std::isnan(found.wrong_from)) found.known = found.own <= known_to * tolerance_;
}

double Verification::parted_from() const
{
  for (std::size_t k = 0; k < ends_.size(); ++k)
    for (std::size_t i = 0; i < output_count; ++i)
      if (needed(static_cast<Output>(i)) && rows_[i].off[k] > tolerance_ * rows_[i].to_finest.scale())
        return std::max(ends_[k] - difference_window, 0.0);
  return none;
}

std::size_t Verification::first_over(double from) const
{
  const auto whole = [&](double end) { return end - from > statistics_window - rounding; };
  return static_cast<std::size_t>(std::find_if(ends_.begin(), ends_.end(), whole) - ends_.begin());
}

/// A period is there where both runs have one.
bool Verification::swings(const StatisticDifferences& over) noexcept
{
  return !std::isnan(over.period);
}

bool Verification::has_parted(const Row& row, const Finding& found, double from) const
{
  const std::size_t first = std::isnan(from) ? ends_.size() : first_over(from);
  if (first == ends_.size() || std::isnan(found.wrong_from)) return false;
  constexpr std::ptrdiff_t windows = static_cast<std::ptrdiff_t>(statistics_window / difference_window);
  double squares = 0.0;
  for (auto off = found.off.end() - windows; off != found.off.end(); ++off) squares += *off * *off;
  return std::sqrt(squares / windows) > tolerance_ &&
         std::all_of(row.off_over.begin() + static_cast<std::ptrdiff_t>(first), row.off_over.end(), swings);
}

void Verification::find_statistics(const Row& row, double from, Finding& found) const
{
  found.parted_from = from;
  StatisticDifferences& most = found.statistics = StatisticDifferences();
  for (std::size_t k = first_over(from); k < ends_.size(); ++k)
  {
    const StatisticDifferences &off = row.off_over[k], &own = row.own_over[k];
    const double scale = found.scale;
    most = {std::max(most.mean, off.mean / scale), std::max(most.deviation, off.deviation / scale),
            std::max(most.extremes, off.extremes / scale), std::max(most.period, off.period)};
    const double own_largest =
        own_of_difference * std::max({own.mean / scale, own.deviation / scale, own.extremes / scale, own.period});
    if (!swings(own) || own_largest > known_to * tolerance_) found.statistics_known = false;
  }
}

Verification::Verdict Verification::verdict(Output output) const
{
  const Finding found = finding(output);
  const bool wrong = !std::isnan(found.wrong_from);
  if (wrong && warned_from_ <= found.wrong_from + difference_window) return Verdict::warned;
  if (is_right_in_statistics(found, tolerance_)) return Verdict::right;
  if (!found.known) return Verdict::unknown;
  return wrong ? Verdict::missed : Verdict::right;
}

Verification::Verdict Verification::verdict() const
{
  Verdict worst = Verdict::right;  // in the order of the kinds
  for (std::size_t i = 0; i < output_count; ++i)
    if (needed(static_cast<Output>(i))) worst = std::max(worst, verdict(static_cast<Output>(i)));
  return worst;
}

}  // namespace drill_rig_sim
