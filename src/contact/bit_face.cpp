// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/bit_face.h"

#include <cmath>

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

BitFaceFriction bit_face_friction(double resistance, double radius, const Vector3d& velocity, double speed,
                                  const Vector3d& down) noexcept
{
  constexpr double creep = 0.01;  // [m/s]
  const Matrix3d across = Matrix3d::Identity() - down * down.transpose();
  const Vector3d v = across * velocity;
  const double slide2 = v.squaredNorm(), turn2 = speed * speed * radius * radius + creep * creep;
  const double q = slide2 * slide2 + turn2 * turn2;
  const double root = 1.0 / std::sqrt(std::sqrt(q));  // q^(-1/4)

  BitFaceFriction out;
  out.by_resistance = root * v;
  out.value = resistance * out.by_resistance;
  out.by_velocity = resistance * root * (across - (slide2 / q) * v * v.transpose());
  out.by_speed = -(resistance * root / q * turn2 * speed * radius * radius) * v;
  return out;
}

}  // namespace drill_rig_sim
