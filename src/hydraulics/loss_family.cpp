// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/loss_family.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double between_tables = 2.0;  // factor
constexpr int knots = 8;                // of the critical flow, from table to table

Rheology scaled(const Rheology& mud, double factor) noexcept
{
  return {factor * mud.yield_stress, factor * mud.consistency, mud.index};
}
}  // namespace

LossFamily::LossFamily(const LossesByFactor& losses) : index_(losses.reference.index)
{
  factors_ = {losses.range.least};
  do factors_.push_back(between_tables * factors_.back());
  while (factors_.back() < losses.range.most);
  // the flow at which a table is looked up is s times its own
  const double largest = losses.largest * std::pow(between_tables, 1.0 / (2.0 - index_));
  for (const double factor : factors_)
  {
    const Rheology mud = scaled(losses.reference, factor);
    tables_.emplace_back(largest, [&](double flow) { return losses.loss(mud, flow); });
  }
  const int last = knots * (static_cast<int>(factors_.size()) - 1);
  for (int k = 0; k <= last; ++k)
  {
    const double factor = factors_.front() * std::pow(between_tables, static_cast<double>(k) / knots);
    critical_logs_.push_back(std::log(losses.critical_flow(scaled(losses.reference, factor))));
  }
  reference_critical_ = critical_flow(1.0);
}

double LossFamily::critical_flow(double factor) const noexcept
{
  const double place = knots * std::log2(factor / factors_.front()), last = static_cast<double>(critical_logs_.size() - 2);
  const double knot = std::floor(std::clamp(place, 0.0, last));
  const std::size_t i = static_cast<std::size_t>(knot);
  return std::exp(critical_logs_[i] + (place - knot) * (critical_logs_[i + 1] - critical_logs_[i]));
}

double LossFamily::scale_of(std::size_t table, double critical) const noexcept
{
  return std::exp(critical_logs_[knots * table]) / critical;
}

LossPlace LossFamily::place(double factor, double density) const noexcept
{
  const double f = std::clamp(factor / density, factors_.front(), factors_.back()), critical = critical_flow(f);
  LossPlace out;
  std::size_t i = 0;
  while (i + 2 < factors_.size() && factors_[i + 1] < f) ++i;
  out.lower = static_cast<int>(i);
  out.critical_flow = critical / reference_critical_;
  out.lower_speed = scale_of(i, critical);
  out.upper_speed = scale_of(i + 1, critical);
  const double lower = 1.0 / (out.lower_speed * out.lower_speed), upper = 1.0 / (out.upper_speed * out.upper_speed);
  const double at_rest = lower * factors_[i], weight = (f - at_rest) / (upper * factors_[i + 1] - at_rest);
  out.lower_share = density * (1.0 - weight) * lower;
  out.upper_share = density * weight * upper;
  return out;
}

LossTable::Value LossFamily::at(double flow, const LossPlace& place) const noexcept
{
  const auto i = static_cast<std::size_t>(place.lower);
  const LossTable::Value lower = tables_[i].at(place.lower_speed * flow), upper = tables_[i + 1].at(place.upper_speed * flow);
  return {place.lower_share * lower.loss + place.upper_share * upper.loss,
          place.lower_share * place.lower_speed * lower.slope + place.upper_share * place.upper_speed * upper.slope};
}

double LossFamily::creep(const LossPlace& place) const noexcept
{
  return tables_[static_cast<std::size_t>(place.lower)].creep() / std::min(place.lower_speed, place.upper_speed);
}

}  // namespace drill_rig_sim
