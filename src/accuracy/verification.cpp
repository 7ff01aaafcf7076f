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
  return found;
}

Verification::Verdict Verification::verdict(Output output) const
{
  const Finding found = finding(output);
  const bool wrong = !std::isnan(found.wrong_from);
  if (wrong && warned_from_ <= found.wrong_from + difference_window) return Verdict::warned;
  if (!found.known) return Verdict::unknown;
  return wrong ? Verdict::silent : Verdict::right;
}

Verification::Verdict Verification::verdict() const
{
  Verdict worst = Verdict::right;  // in the order of the kinds
  for (std::size_t i = 0; i < output_count; ++i)
    if (needed(static_cast<Output>(i))) worst = std::max(worst, verdict(static_cast<Output>(i)));
  return worst;
}

}  // namespace drill_rig_sim
