// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/loss_table.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
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

}  // namespace drill_rig_sim
