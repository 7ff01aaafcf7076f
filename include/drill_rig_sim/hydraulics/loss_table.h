// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_LOSS_TABLE_H
#define DRILL_RIG_SIM_HYDRAULICS_LOSS_TABLE_H

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace drill_rig_sim
{
/// A pressure loss against a flow or a speed, worked out once and interpolated in a frame: odd, without a jump, growing.
///
/// Nodes lie at largest (i/n)^2; between them a cubic of the square root whose slopes keep it growing (Fritsch and Butland, SIAM
/// J. Sci. Stat. Comput. 5 (1984) 300-304). Within 0.2 % of the law above a hundredth of the largest flow. Below the first node,
/// a ten-thousandth of the largest flow, it is a straight line to 0. This replaces the yield stress by a slow creep. Above the
/// largest flow, the last slope continues.
class LossTable
{
public:
  struct Value
  {
    double loss = 0.0;   ///< [Pa]
    double slope = 0.0;  ///< by the flow, > 0 where there is any loss
  };

  LossTable() = default;
  /// @param largest  flow or speed, > 0
  /// @param loss     of a flow > 0, growing [Pa]
  LossTable(double largest, const std::function<double(double)>& loss);

  bool empty() const noexcept { return loss_.empty(); }
  /// Flow of the first node.
  double creep() const noexcept { return largest_ / (intervals * intervals); }
  /// At a flow of any sign. Not of an empty table.
  Value at(double flow) const noexcept
  {
    const Value here = at_positive(std::abs(flow));
    return {flow < 0.0 ? -here.loss : here.loss, here.slope};
  }

private:
  static constexpr int intervals = 128;

  Value at_positive(double flow) const noexcept
  {
    const double place = intervals * std::sqrt(flow / largest_);
    if (place <= 1.0) return {loss_[1] * flow / creep(), loss_[1] / creep()};
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
    return {loss, slope * (0.5 * place / flow)};  // d place/d flow
  }

  double largest_ = 0.0;
  std::vector<double> loss_;   ///< at the nodes [Pa]
  std::vector<double> slope_;  ///< there, by the node's number [Pa]
};

/// Root > 0 of a function that falls with q > 0 and is positive at 0, by Newton's method kept between its bounds.
/// @param value     {function, its slope < 0} at q
/// @param guess     > 0
/// @param smallest  change of q that is none. After a change d the next one is d^2 f''/(2 f'), at most d^2/(2 q) of losses that
///                  grow like q^2 or less: it is left out where ten times that is none
template <class Function>
double falling_root(const Function& value, double guess, double smallest) noexcept
{
  constexpr int most_rounds = 100;
  double low = 0.0, high = 0.0, q = guess;  // high 0: not known yet
  for (int k = 0; k < most_rounds; ++k)
  {
    const LossTable::Value now = value(q);
    (now.loss > 0.0 ? low : high) = q;
    double next = now.slope < 0.0 ? q - now.loss / now.slope : 2.0 * q;
    const double change = next - q;
    if (std::abs(change) <= smallest || (next > low && 5.0 * change * change <= smallest * q)) return next > 0.0 ? next : q;
    if (high > 0.0 && !(next > low && next < high)) next = 0.5 * (low + high);
    if (high == 0.0 && !(next > low && next < 100.0 * q)) next = 2.0 * q;
    q = next;
  }
  return q;
}

/// The same of a function of any sign at 0.
/// @param guess  of any sign
template <class Function>
double signed_root(const Function& value, double guess, double smallest) noexcept
{
  const double at_rest = value(0.0).loss;
  if (at_rest == 0.0) return 0.0;
  const double sign = at_rest > 0.0 ? 1.0 : -1.0;
  const auto mirrored = [&](double q)
  {
    const LossTable::Value v = value(sign * q);
    return LossTable::Value{sign * v.loss, v.slope};
  };
  return sign * falling_root(mirrored, std::max(sign * guess, smallest), smallest);
}

}  // namespace drill_rig_sim

#endif
