// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_ROTATION_H
#define DRILL_RIG_SIM_MATH_ROTATION_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace drill_rig_sim
{
/// The matrix of the cross product: skew(a) b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a)
{
  Eigen::Matrix3d s;
  s << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return s;
}

/// Quaternion of the rotation vector `r` [rad]; exact for any size, without division by zero at 0.
inline Eigen::Quaterniond rotation_from_vector(const Eigen::Vector3d& r)
{
  const double square = r.squaredNorm();
  if (square < 1e-4)  // series to order 6: relative error below 1e-17 for |r| < 0.01
  {
    const double factor = 0.5 - square * (1.0 / 48.0 - square * (1.0 / 3840.0));
    const double w = 1.0 - square * (1.0 / 8.0 - square * (1.0 / 384.0 - square / 46080.0));
    return Eigen::Quaterniond(w, factor * r.x(), factor * r.y(), factor * r.z());
  }
  const double angle = std::sqrt(square);
  const double factor = std::sin(0.5 * angle) / angle;
  return Eigen::Quaterniond(std::cos(0.5 * angle), factor * r.x(), factor * r.y(), factor * r.z());
}

/// The body's x axis in world axes: first column of the rotation matrix.
inline Eigen::Vector3d x_axis(const Eigen::Quaterniond& q)
{
  return Eigen::Vector3d(1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()), 2.0 * (q.x() * q.y() + q.w() * q.z()),
                         2.0 * (q.x() * q.z() - q.w() * q.y()));
}

/// The body's y axis in world axes: second column of the rotation matrix.
inline Eigen::Vector3d y_axis(const Eigen::Quaterniond& q)
{
  return Eigen::Vector3d(2.0 * (q.x() * q.y() - q.w() * q.z()), 1.0 - 2.0 * (q.x() * q.x() + q.z() * q.z()),
                         2.0 * (q.y() * q.z() + q.w() * q.x()));
}

/// The smallest rotation that takes the direction of `from` to that of `to`, neither of them zero: with c the cosine of the angle
/// between the unit vectors a and b, (w, v) = (s/2, a x b / s), s = sqrt(2 (1 + c)); a half turn is about any axis across. As
/// Eigen's FromTwoVectors, but for the singular value decomposition by which that finds the half turn's axis: it takes four
/// seconds to compile.
inline Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) noexcept
{
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double c = b.dot(a);
  Eigen::Quaterniond turn;
  if (c < -1.0 + 1e-12)
  {
    turn.w() = 0.0;
    turn.vec() = a.unitOrthogonal();
    return turn;
  }
  const double s = std::sqrt((1.0 + c) * 2.0);
  turn.w() = s * 0.5;
  turn.vec() = a.cross(b) * (1.0 / s);
  return turn;
}
/// `q` after the smallest rotation that points its x axis along `axis`.
inline Eigen::Quaterniond pointed_along(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis) noexcept
{
  return (shortest_turn(x_axis(q), axis) * q).normalized();
}

/// Twist about x that takes section `from` to section `to` when the tilt between their normals is undone by the shortest
/// rotation (swing-twist decomposition); in (-pi, pi], exact for any number of turns that both have made together.
inline double twist_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to)
{
  double w = from.w() * to.w() + from.x() * to.x() + from.y() * to.y() + from.z() * to.z();
  double x = from.w() * to.x() - from.x() * to.w() - from.y() * to.z() + from.z() * to.y();
  if (w < 0.0)
  {
    w = -w;
    x = -x;
  }
  if (std::abs(x) < 0.01 * w)  // atan's series: relative error below 1e-17
  {
    const double t = x / w;
    const double s = t * t;
    return 2.0 * t * (1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s / 9.0))));
  }
  return 2.0 * std::atan2(x, w);
}

}  // namespace drill_rig_sim

#endif
