// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/formation.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double slow_turning = 0.05;  // N_s [rad/s]
constexpr double gauge_share = 0.01;   // weight over side force at which half of the rate is left
constexpr double slope_offset = 1.0;   // [N]

// x^p, cheap for the exponent that scenes use most.
double power(double x, double p) noexcept
{
  return p == 1.0 ? x : std::pow(x, p);
}
}  // namespace

Formation::Formation(std::vector<FormationLayer> layers) : layers_(std::move(layers))
{
  if (layers_.empty()) throw std::invalid_argument("formation: there must be at least one layer");
  for (std::size_t i = 1; i < layers_.size(); ++i)
  {
    if (layers_[i].to_tvd > layers_[i - 1].to_tvd) continue;
    std::ostringstream text;
    text << "formation: layer " << i + 1 << " ends at tvd " << layers_[i].to_tvd << " m, it must end below the layer above ("
         << layers_[i - 1].to_tvd << " m)";
    throw std::invalid_argument(text.str());
  }
}

const FormationLayer& layer_at(const std::vector<FormationLayer>& layers, double tvd) noexcept
{
  for (const FormationLayer& layer : layers)
    if (tvd < layer.to_tvd) return layer;
  return layers.back();
}

Eigen::Vector3d bed_normal(const FormationLayer& layer) noexcept
{
  const double dip_azimuth = layer.strike + 0.5 * pi;
  const double lean = std::sin(layer.dip);
  return {lean * std::sin(dip_azimuth), lean * std::cos(dip_azimuth), std::cos(layer.dip)};
}

double drilling_coefficient(const FormationLayer& layer, double bit_speed) noexcept
{
  if (!(bit_speed > 0.0)) return 0.0;
  const double rate = layer.drillability * power(bit_speed, layer.speed_exponent);
  if (layer.speed_exponent >= 1.0) return rate;
  const double speed2 = bit_speed * bit_speed;
  return rate * speed2 / (speed2 + slow_turning * slow_turning);
}

double drilling_speed(double mean_speed, double bit_speed) noexcept
{
  constexpr double most = 5.0;
  return std::min(mean_speed, most * std::max(bit_speed, 0.0));
}

double on_axis_rop(const FormationLayer& layer, double bit_speed, double weight) noexcept
{
  const double excess = weight - layer.threshold;
  return excess > 0.0 ? drilling_coefficient(layer, bit_speed) * power(excess, layer.weight_exponent) : 0.0;
}

double on_axis_rop_slope(const FormationLayer& layer, double bit_speed, double weight) noexcept
{
  double excess = weight - layer.threshold;
  if (!(excess > 0.0)) return 0.0;
  const double alpha = layer.weight_exponent;
  if (alpha < 1.0) excess = std::max(excess, slope_offset);
  return drilling_coefficient(layer, bit_speed) * alpha * power(excess, alpha - 1.0);
}

Eigen::Vector3d cutting_direction(const FormationLayer& layer, const Eigen::Vector3d& bit_axis, double side_cutting,
                                  const Eigen::Vector3d& force_direction) noexcept
{
  const Eigen::Vector3d along = bit_axis * bit_axis.dot(force_direction);
  Eigen::Vector3d cut = along + side_cutting * (force_direction - along);
  if (layer.anisotropy == 0.0) return cut;
  const Eigen::Vector3d n = bed_normal(layer);
  return (1.0 - layer.anisotropy) * cut + layer.anisotropy * n.dot(cut) * n;
}

namespace
{
/// 1 where the bit's face presses, 0 where its gauge alone touches.
double pressing_share(double axial, const Eigen::Vector3d& across) noexcept
{
  return axial * axial / (axial * axial + gauge_share * gauge_share * across.squaredNorm());
}
}  // namespace

Eigen::Vector3d rock_breaking_velocity(const FormationLayer& layer, const Eigen::Vector3d& force, double bit_speed,
                                       const Eigen::Vector3d& bit_axis, double side_cutting) noexcept
{
  const double axial = force.dot(bit_axis);
  const double magnitude = force.norm();
  if (!(axial > 0.0)) return Eigen::Vector3d::Zero();
  const double pressing = pressing_share(axial, force - axial * bit_axis);
  const double rate = pressing * on_axis_rop(layer, bit_speed, magnitude);
  Eigen::Vector3d v = rate * cutting_direction(layer, bit_axis, side_cutting, force / magnitude);
  v -= std::min(v.dot(bit_axis), 0.0) * bit_axis;
  return v;
}

Eigen::Vector3d rock_breaking_direction(const FormationLayer& layer, const Eigen::Vector3d& force,
                                        const Eigen::Vector3d& bit_axis, double side_cutting,
                                        const Eigen::Vector3d& down) noexcept
{
  const Eigen::Vector3d cut = cutting_direction(layer, bit_axis, side_cutting, force);
  const double ahead = cut.dot(down), axial = force.dot(bit_axis);
  if (!(ahead > 0.0 && axial > 0.0)) return down;
  return down + (pressing_share(axial, force - axial * bit_axis) / ahead) * (cut - ahead * down);
}

}  // namespace drill_rig_sim
