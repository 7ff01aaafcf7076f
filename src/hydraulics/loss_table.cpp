// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/loss_table.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr int intervals = 128;

/// Slope at a node between two secants of one spacing: their harmonic mean, 0 where they disagree.
double middle_slope(double before, double after) noexcept
{
  return before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
}
}  // namespace

LossTable::LossTable(double largest, const std::function<double(double)>& loss)
    : largest_(largest), loss_(intervals + 1, 0.0), slope_(intervals + 1, 0.0)
{
  for (std::size_t i = 1; i <= intervals; ++i) loss_[i] = loss(largest * std::pow(static_cast<double>(i) / intervals, 2));
  for (std::size_t i = 1; i < intervals; ++i) slope_[i] = middle_slope(loss_[i] - loss_[i - 1], loss_[i + 1] - loss_[i]);
  // the secants' parabola
  slope_[intervals] = 1.5 * (loss_[intervals] - loss_[intervals - 1]) - 0.5 * (loss_[intervals - 1] - loss_[intervals - 2]);
}

double LossTable::creep() const noexcept
{
  return largest_ / (intervals * intervals);
}

LossTable::Value LossTable::at_positive(double flow) const noexcept
{
  const double place = intervals * std::sqrt(flow / largest_);
  if (place <= 1.0) return {loss_[1] * flow / creep(), loss_[1] / creep()};
  const double per_flow = 0.5 * place / flow;  // d place/d flow
  if (place >= intervals)
  {
    const double by_flow = slope_[intervals] * 0.5 * intervals / largest_;
    return {loss_[intervals] + by_flow * (flow - largest_), by_flow};
  }
  const auto i = static_cast<std::size_t>(place);
  const double t = place - static_cast<double>(i), rest = 1.0 - t;
  const double rise = loss_[i + 1] - loss_[i], lower = slope_[i], upper = slope_[i + 1];
  const double loss = loss_[i] + rise * t * t * (3.0 - 2.0 * t) + t * rest * (lower * rest - upper * t);
  const double slope = 6.0 * rise * t * rest + lower * rest * (1.0 - 3.0 * t) + upper * t * (3.0 * t - 2.0);
  return {loss, slope * per_flow};
}

LossTable::Value LossTable::at(double flow) const noexcept
{
  if (flow >= 0.0) return at_positive(flow);
  const Value mirrored = at_positive(-flow);
  return {-mirrored.loss, mirrored.slope};
}

}  // namespace drill_rig_sim
