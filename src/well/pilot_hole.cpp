// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/pilot_hole.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double ahead = 0.3;  // a bend of R is cut by 0.3^2/(2 R), a tenth of a millimetre [m]
}

FormationLayer ring_of(FormationLayer layer, double diameter_ratio, bool by_width) noexcept
{
  const double q = diameter_ratio;
  layer.ring.share = by_width ? 1.0 - q : 1.0 - q * q;
  layer.ring.lever = by_width ? 1.0 + q : (1.0 + q + q * q) / (1.0 + q);
  layer.drillability /= std::pow(layer.ring.share, layer.weight_exponent);
  layer.threshold *= layer.ring.share;
  return layer;
}

PilotHole::PilotHole(const WellSpec& well) : end_(well.pilot_depth)
{
  if (end_ > 0.0) axis_.emplace(well.survey);
}

Eigen::Vector3d PilotHole::direction(const Eigen::Vector3d& position, double depth) const noexcept
{
  return (axis_->at(depth + ahead).position - position).normalized();
}

}  // namespace drill_rig_sim
