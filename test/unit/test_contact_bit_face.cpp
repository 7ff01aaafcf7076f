// SPDX-License-Identifier: BSD-3-Clause
// Friction of the bit's face across the bottom: against the integral over the disc, its limits, tangents.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "drill_rig_sim/contact/bit_face.h"
#include "drill_rig_sim/math/units.h"

namespace test_contact_bit_face
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double resistance = 30e3, radius = 0.1556;
const Vector3d down = Vector3d(0.3, -0.2, -0.9).normalized(), sideways = down.cross(Vector3d::UnitX()).normalized();

/// Midpoint rule over radius and angle: pressure M/(pi a^2) against v + omega x r.
double over_the_disc(double v, double speed)
{
  const int rings = 400, sectors = 400;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < sectors; ++k)
    {
      const double r = radius * (i + 0.5) / rings, angle = 2.0 * pi * (k + 0.5) / sectors;
      const double along = v - speed * r * std::sin(angle), across = speed * r * std::cos(angle);
      sum += r * along / std::hypot(along, across);
    }
  return resistance / (pi * radius * radius) * sum * (radius / rings) * (2.0 * pi / sectors);
}

double friction(double v, double speed)
{
  return bit_face_friction(resistance, radius, v * sideways, speed, down).value.dot(sideways);
}
}  // namespace

TEST(BitFace, resistsAsADiscThatTurns)
{
  for (const double speed : {14.0, -14.0})
    for (const double v : {0.02, 0.3, 1.0, 2.0, 2.5, 4.0, 40.0})
    {
      const double disc = over_the_disc(v, speed);
      EXPECT_NEAR(friction(v, speed), disc, 0.02 * disc) << v;
    }
  // slow against the turning it is a damper, M/(omega a)
  EXPECT_NEAR(friction(1e-3, 14.0), resistance * 1e-3 / std::hypot(14.0 * radius, 0.01), 1e-6 * friction(1e-3, 14.0))
      << "creep counts as turning";
}

TEST(BitFace, doesNotResistWhatGoesAheadAndNeverMoreThanM)
{
  EXPECT_NEAR(bit_face_friction(resistance, radius, 0.4 * down, 14.0, down).value.norm(), 0.0, 1e-9);
  EXPECT_NEAR(friction(0.5, 0.0), resistance, 1e-6 * resistance);
  EXPECT_LT(friction(50.0, 14.0), resistance);
  EXPECT_EQ(friction(0.0, 0.0), 0.0);
}

TEST(BitFace, tangents)
{
  const Vector3d v = 0.8 * sideways + 0.3 * down.cross(sideways) + 0.1 * down;
  const auto at = [&](const Vector3d& dv, double dm, double dn)
  { return bit_face_friction(resistance + dm, radius, v + dv, 6.0 + dn, down).value; };
  const BitFaceFriction f = bit_face_friction(resistance, radius, v, 6.0, down);
  const double h = 1e-5;
  for (int k = 0; k < 3; ++k)
  {
    const Vector3d e = h * Vector3d::Unit(k);
    EXPECT_LT(((at(e, 0.0, 0.0) - at(-e, 0.0, 0.0)) / (2.0 * h) - f.by_velocity.col(k)).norm(), 1e-7 * f.by_velocity.norm());
  }
  EXPECT_LT(((at(Vector3d::Zero(), 0.0, h) - at(Vector3d::Zero(), 0.0, -h)) / (2.0 * h) - f.by_speed).norm(),
            1e-6 * f.by_speed.norm());
  EXPECT_LT((at(Vector3d::Zero(), 1.0, 0.0) - f.value - f.by_resistance).norm(), 1e-9);
}
}  // namespace test_contact_bit_face
