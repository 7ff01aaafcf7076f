// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_MATH_BLOCK_SMALL_H
#define DRILL_RIG_SIM_SRC_MATH_BLOCK_SMALL_H

#include <cmath>

/// A sweep over neighbouring block rows of two unknowns, one row at a time. Names as of BlockSweeps: diagonal block D, L to the
/// row before, W = D'^-1 U, right side b, y. Blocks are row-major.
namespace drill_rig_sim
{
/// What a sweep over small rows keeps of the row before: W, and y or x.
struct SmallRow
{
  double w00, w01, w10, w11, first, second;

  SmallRow(const double* w, const double* b) noexcept : w00(w[0]), w01(w[1]), w10(w[2]), w11(w[3]), first(b[0]), second(b[1]) {}
};

/// In place of D the inverse of D' = D - L W of the row before, of U its W, of b its y. False at a pivot that vanishes or is not
/// finite.
inline bool eliminate_two(SmallRow& before, const double* lower, double* d, double* upper, double* b) noexcept
{
  const double l00 = lower[0], l01 = lower[1], l10 = lower[2], l11 = lower[3];
  const double d00 = d[0] - (l00 * before.w00 + l01 * before.w10), d01 = d[1] - (l00 * before.w01 + l01 * before.w11);
  const double d10 = d[2] - (l10 * before.w00 + l11 * before.w10), d11 = d[3] - (l10 * before.w01 + l11 * before.w11);
  const double r0 = b[0] - (l00 * before.first + l01 * before.second), r1 = b[1] - (l10 * before.first + l11 * before.second);
  const double determinant = d00 * d11 - d01 * d10, scale = 1.0 / determinant;
  const double u00 = upper[0], u01 = upper[1], u10 = upper[2], u11 = upper[3];
  // the division is the longest wait: all else is done beside it
  upper[0] = before.w00 = scale * (d11 * u00 - d01 * u10);
  upper[1] = before.w01 = scale * (d11 * u01 - d01 * u11);
  upper[2] = before.w10 = scale * (d00 * u10 - d10 * u00);
  upper[3] = before.w11 = scale * (d00 * u11 - d10 * u01);
  b[0] = before.first = scale * (d11 * r0 - d01 * r1);
  b[1] = before.second = scale * (d00 * r1 - d10 * r0);
  b[2] = b[3] = b[4] = b[5] = 0.0;
  d[0] = scale * d11;
  d[1] = -scale * d01;
  d[2] = -scale * d10;
  d[3] = scale * d00;
  return std::abs(determinant) > 1e-200;  // also catches NaN
}

/// y = D^-1 (b - L y of the row before) with the inverse of D.
inline void substitute_two(SmallRow& before, const double* lower, const double* inverse, double* b) noexcept
{
  const double r0 = b[0] - (lower[0] * before.first + lower[1] * before.second);
  const double r1 = b[1] - (lower[2] * before.first + lower[3] * before.second);
  b[0] = before.first = inverse[0] * r0 + inverse[1] * r1;
  b[1] = before.second = inverse[2] * r0 + inverse[3] * r1;
}

/// x = y - W x of the row before.
inline void subtract_two(SmallRow& before, const double* w, double* b) noexcept
{
  const double first = b[0] - (w[0] * before.first + w[1] * before.second);
  b[1] = before.second = b[1] - (w[2] * before.first + w[3] * before.second);
  b[0] = before.first = first;
}
}  // namespace drill_rig_sim

#endif
