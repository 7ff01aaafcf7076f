// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_ONE_LANE_H
#define DRILL_RIG_SIM_MATH_ONE_LANE_H

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

/// The texts of the laws (math/vector_text.h) for V = double.
namespace drill_rig_sim::one_lane
{
using V = double;
using Mask = bool;

constexpr V all(double value) noexcept
{
  return value;
}

constexpr V mul_add(V a, V b, V c) noexcept
{
  return a * b + c;
}

constexpr V mul_sub(V a, V b, V c) noexcept
{
  return a * b - c;
}

constexpr V neg_mul_add(V a, V b, V c) noexcept
{
  return c - a * b;
}

constexpr V minus(V a) noexcept
{
  return -a;
}

inline V sqrt_of(V a) noexcept
{
  return std::sqrt(a);
}

inline V exp_of(V a) noexcept
{
  return std::exp(a);
}

/// The usual exponent deserves better than pow().
inline V power_of(V a, V exponent) noexcept
{
  return exponent == 0.5 ? std::sqrt(a) : std::pow(a, exponent);
}

constexpr V larger(V a, V b) noexcept
{
  return a > b ? a : b;
}

constexpr V smaller(V a, V b) noexcept
{
  return a < b ? a : b;
}

constexpr V select(Mask mask, V yes, V no) noexcept
{
  return mask ? yes : no;
}

constexpr V select_or_zero(Mask mask, V yes) noexcept
{
  return mask ? yes : 0.0;
}

constexpr Mask both(Mask a, Mask b) noexcept
{
  return a && b;
}

constexpr Mask opposite(Mask a) noexcept
{
  return !a;
}

constexpr bool all_of(Mask mask) noexcept
{
  return mask;
}

#define DRILL_LAW inline
#include "drill_rig_sim/math/vector_text.h"
// behind it
#include "drill_rig_sim/math/matrix_text.h"

inline V3 from(const Eigen::Vector3d& v) noexcept
{
  return {v.x(), v.y(), v.z()};
}

inline Eigen::Vector3d to_eigen(const V3& v) noexcept
{
  return {v.x, v.y, v.z};
}

inline V2 from(const Eigen::Vector2d& v) noexcept
{
  return {v.x(), v.y()};
}

inline Eigen::Vector2d to_eigen(const V2& v) noexcept
{
  return {v.x, v.y};
}

inline V6 from(const Eigen::Matrix<double, 6, 1>& v) noexcept
{
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

inline Eigen::Matrix<double, 6, 1> to_eigen(const V6& v) noexcept
{
  Eigen::Matrix<double, 6, 1> out;
  out << v.head.x, v.head.y, v.head.z, v.tail.x, v.tail.y, v.tail.z;
  return out;
}

inline Eigen::Matrix3d to_eigen(const M3& m) noexcept
{
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = m.m[i][j];
  return out;
}
}  // namespace drill_rig_sim::one_lane

#endif
