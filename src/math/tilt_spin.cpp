// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/tilt_spin.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// The scalar functions of theta^2 and their slopes with respect to it.
struct Factors
{
  double m, m_slope;  // (1 - theta cot theta)/theta^2
  double k, k_slope;  // theta cot theta
  double h, h_slope;  // tan(theta/2)/theta
};

Factors factors_at(double square)
{
  Factors f;
  if (square < 1e-2)  // series: relative error below 1e-14
  {
    f.m = 1.0 / 3.0 + square * (1.0 / 45.0 + square * (2.0 / 945.0 + square * (1.0 / 4725.0 + square * (2.0 / 93555.0))));
    f.m_slope = 1.0 / 45.0 + square * (4.0 / 945.0 + square * (3.0 / 4725.0 + square * (8.0 / 93555.0)));
    f.h = 0.5 + square * (1.0 / 24.0 + square * (1.0 / 240.0 + square * (17.0 / 40320.0 + square * (31.0 / 725760.0))));
    f.h_slope = 1.0 / 24.0 + square * (1.0 / 120.0 + square * (17.0 / 13440.0 + square * (31.0 / 181440.0)));
  }
  else
  {
    const double theta = std::sqrt(square);
    const double cot = 1.0 / std::tan(theta);
    const double half = std::tan(0.5 * theta);
    const double k_by_theta = cot - theta * (1.0 + cot * cot);
    f.m = (1.0 - theta * cot) / square;
    f.m_slope = (-k_by_theta / (2.0 * theta) - f.m) / square;
    f.h = half / theta;
    f.h_slope = (0.5 * (1.0 + half * half) - f.h) / (2.0 * square);
  }
  f.k = 1.0 - f.m * square;
  f.k_slope = -f.m - f.m_slope * square;
  return f;
}
}  // namespace

TiltSpin TiltSpin::about(const Quaterniond& orientation) noexcept
{
  return {x_axis(orientation), orientation};
}

Quaterniond TiltSpin::orientation(const Vector3d& r) const noexcept
{
  return rotation_from_vector(tilt(r)) * rotation_from_vector(spin(r) * normal) * base;
}

Vector3d TiltSpin::rate(const Vector3d& r, const Vector3d& w) const noexcept
{
  const Vector3d t = tilt(r);
  const Factors f = factors_at(t.squaredNorm());
  const double along = normal.dot(w);
  const Vector3d tilt_rate = f.k * (w - along * normal) + f.m * t.dot(w) * t + along * normal.cross(t);
  return tilt_rate + (along - f.h * normal.dot(t.cross(w))) * normal;
}

Matrix3d TiltSpin::rate_by_velocity(const Vector3d& r) const noexcept
{
  const Vector3d t = tilt(r);
  const Factors f = factors_at(t.squaredNorm());
  const Vector3d side = normal.cross(t);
  Matrix3d out = f.m * t * t.transpose() + (side + (1.0 - f.k) * normal) * normal.transpose() - f.h * normal * side.transpose();
  out.diagonal().array() += f.k;
  return out;
}

Matrix3d TiltSpin::velocity_by_rate(const Vector3d& r) const noexcept
{
  return rate_by_velocity(r).inverse();
}

Matrix3d TiltSpin::rate_by_coordinates(const Vector3d& r, const Vector3d& w) const noexcept
{
  const Vector3d t = tilt(r);
  const Factors f = factors_at(t.squaredNorm());
  const double along = normal.dot(w);
  const double tw = t.dot(w);
  const Vector3d across = w - along * normal;
  const Vector3d side = normal.cross(t);
  Matrix3d by_tilt =
      2.0 * (f.k_slope * across + f.m_slope * tw * t) * t.transpose() + f.m * t * w.transpose() + along * skew(normal);
  by_tilt.diagonal().array() += f.m * tw;
  // n . (t x w) = t . (w x n)
  by_tilt -= normal * (f.h * w.cross(normal) + 2.0 * f.h_slope * side.dot(w) * t).transpose();
  return by_tilt - (by_tilt * normal) * normal.transpose();
}

}  // namespace drill_rig_sim
