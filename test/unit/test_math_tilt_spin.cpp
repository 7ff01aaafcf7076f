// SPDX-License-Identifier: BSD-3-Clause
// Tilt and spin: the chart's rates against the rotations themselves.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/tilt_spin.h"

namespace test_math_tilt_spin
{
using namespace drill_rig_sim;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Spatial rotation vector that takes `from` to `to`, for small differences.
Vector3d between(const Quaterniond& from, const Quaterniond& to)
{
  const Quaterniond d = to * from.conjugate();
  return 2.0 * Vector3d(d.x(), d.y(), d.z()) * (d.w() < 0.0 ? -1.0 : 1.0);
}

TiltSpin some_chart()
{
  return TiltSpin::about(Quaterniond(0.3, -0.5, 0.7, 0.2).normalized());
}

Vector3d coordinates(const TiltSpin& chart, double tilt, double spin)
{
  const Vector3d across =
      chart.normal.unitOrthogonal() * std::cos(0.7) + chart.normal.cross(chart.normal.unitOrthogonal()) * std::sin(0.7);
  return tilt * across + spin * chart.normal;
}
}  // namespace

TEST(TiltSpin, TakesTheNormalByTheTiltAloneAndTurnsAboutItByTheSpin)
{
  const TiltSpin chart = some_chart();
  const Vector3d r = coordinates(chart, 0.3, 12345.6);
  const Quaterniond q = chart.orientation(r);
  EXPECT_LT((x_axis(q) - rotation_from_vector(chart.tilt(r)) * chart.normal).norm(), 1e-12);
  EXPECT_LT(between(rotation_from_vector(chart.tilt(r)) * rotation_from_vector(12345.6 * chart.normal) * chart.base, q).norm(),
            1e-9);
  EXPECT_NEAR(chart.spin(r), 12345.6, 1e-11);
}

TEST(TiltSpin, RatesAreThoseOfTheRotation)
{
  const TiltSpin chart = some_chart();
  const Vector3d w(1.3, -0.4, 2.2);
  for (const double tilt : {0.0, 1e-3, 0.0999, 0.1001, 0.5, 1.2})
  {
    const Vector3d r = coordinates(chart, tilt, 3.0);
    const double h = 1e-5;  // central difference: error 1e-10 times the third derivative
    const Vector3d rate = chart.rate(r, w);
    const Vector3d turned = between(chart.orientation(r - h * rate), chart.orientation(r + h * rate));
    EXPECT_LT((turned / (2.0 * h) - w).norm(), 1e-8) << tilt;
    EXPECT_LT((chart.rate_by_velocity(r) * w - rate).norm(), 1e-14) << tilt;
    EXPECT_LT((chart.velocity_by_rate(r) * rate - w).norm(), 1e-13) << tilt;
  }
}

TEST(TiltSpin, DerivativeOfTheRateByFiniteDifferences)
{
  const TiltSpin chart = some_chart();
  const Vector3d w(1.3, -0.4, 2.2);
  for (const double tilt : {0.0, 1e-3, 0.0999, 0.1001, 0.5, 1.2})
  {
    const Vector3d r = coordinates(chart, tilt, 3.0);
    const Matrix3d d = chart.rate_by_coordinates(r, w);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3d step = 1e-5 * Vector3d::Unit(k);
      const Vector3d by_differences = (chart.rate(r + step, w) - chart.rate(r - step, w)) / 2e-5;
      EXPECT_LT((d.col(k) - by_differences).norm(), 1e-8) << tilt << " " << k;
    }
  }
}

TEST(TiltSpin, SeriesMeetsTheClosedForm)
{
  const TiltSpin chart = some_chart();
  const Vector3d w(1.3, -0.4, 2.2);
  const Vector3d below = coordinates(chart, 0.1 * (1.0 - 1e-13), 0.0), above = coordinates(chart, 0.1 * (1.0 + 1e-13), 0.0);
  EXPECT_LT((chart.rate(below, w) - chart.rate(above, w)).norm(), 1e-13);
  EXPECT_LT((chart.rate_by_velocity(below) - chart.rate_by_velocity(above)).norm(), 1e-13);
  EXPECT_LT((chart.rate_by_coordinates(below, w) - chart.rate_by_coordinates(above, w)).norm(), 1e-12);
}
}  // namespace test_math_tilt_spin
