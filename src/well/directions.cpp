// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/directions.h"

#include <Eigen/Geometry>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
// Below this sine of the inclination an azimuth would be read from round-off.
constexpr double vertical_sine = 1e-12;

// The part of `wanted` perpendicular to the tangent, or that of `otherwise` where the two are parallel.
Eigen::Vector3d side(const Eigen::Vector3d& tangent, const Eigen::Vector3d& wanted, const Eigen::Vector3d& otherwise) noexcept
{
  const Eigen::Vector3d t = tangent.normalized();
  Eigen::Vector3d v = wanted - wanted.dot(t) * t;
  if (v.squaredNorm() < vertical_sine * vertical_sine) v = otherwise - otherwise.dot(t) * t;
  return v.normalized();
}

ToolfaceReference reference(const Eigen::Vector3d& tangent, bool magnetic) noexcept
{
  return {magnetic ? north_side(tangent) : high_side(tangent), magnetic};
}
}  // namespace

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept
{
  return 2.0 * std::atan2((b - a).norm(), (b + a).norm());
}

double sinc(double x) noexcept
{
  const double x2 = x * x;  // the series' next term is below round-off at the switch
  return x2 < 1e-4 ? 1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0)) : std::sin(x) / x;
}

Eigen::Vector3d chord_of_arc(const Eigen::Vector3d& t1, const Eigen::Vector3d& t2, double length) noexcept
{
  const Eigen::Vector3d sum = t2 + t1;
  const double dogleg = 2.0 * std::atan2((t2 - t1).norm(), sum.norm());
  return length * sinc(0.5 * dogleg) * sum.normalized();
}

Eigen::Vector3d tangent_from(double inclination, double azimuth) noexcept
{
  const double horizontal = std::sin(inclination);
  return {horizontal * std::sin(azimuth), horizontal * std::cos(azimuth), -std::cos(inclination)};
}

double inclination_of(const Eigen::Vector3d& tangent) noexcept
{
  return std::atan2(std::hypot(tangent.x(), tangent.y()), -tangent.z());
}

double azimuth_of(const Eigen::Vector3d& tangent) noexcept
{
  if (std::hypot(tangent.x(), tangent.y()) <= vertical_sine * std::abs(tangent.z())) return 0.0;
  const double azimuth = std::atan2(tangent.x(), tangent.y());
  if (azimuth >= 0.0) return azimuth;
  const double turned = azimuth + 2.0 * pi;
  return turned >= 2.0 * pi ? 0.0 : turned;  // a negative azimuth below round-off would become 2 pi
}

Eigen::Vector3d high_side(const Eigen::Vector3d& tangent) noexcept
{
  return side(tangent, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
}

Eigen::Vector3d north_side(const Eigen::Vector3d& tangent) noexcept
{
  return side(tangent, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
}

double angle_about(const Eigen::Vector3d& tangent, const Eigen::Vector3d& reference, const Eigen::Vector3d& vector) noexcept
{
  const double along = reference.dot(vector);
  const double across = tangent.cross(reference).dot(vector);
  return along == 0.0 && across == 0.0 ? 0.0 : std::atan2(across, along);
}

ToolfaceReference toolface_reference(const Eigen::Vector3d& tangent) noexcept
{
  return reference(tangent, inclination_of(tangent) < 5.0 * degree);
}

ToolfaceReference toolface_reference(const Eigen::Vector3d& tangent, bool was_magnetic) noexcept
{
  return reference(tangent, inclination_of(tangent) < (was_magnetic ? 6.0 : 4.0) * degree);
}

Eigen::Vector3d toolface_side(const Eigen::Vector3d& axis, const Eigen::Vector3d& hole) noexcept
{
  return toolface_reference(hole).magnetic ? north_side(axis) : high_side(axis);
}

}  // namespace drill_rig_sim
