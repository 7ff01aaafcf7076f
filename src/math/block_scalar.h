// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_MATH_BLOCK_SCALAR_H
#define DRILL_RIG_SIM_SRC_MATH_BLOCK_SCALAR_H

#include <cmath>

// Plain arithmetic of single blocks, six by six and two by two, row-major. Nothing here may change a bit: the scalar kernel is
// what others are tested against.
namespace drill_rig_sim
{
constexpr int kWidth = 14;  // a row of [D | U | b], padded to an even number of doubles

using Work = double[6][kWidth];

/// work = [D - L W | U | b - L y], with W and y the eliminated row above.
inline void load(Work work, const double* diagonal, const double* upper, const double* b) noexcept
{
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c < 6; ++c) work[r][c] = diagonal[6 * r + c];
    for (int c = 0; c < 6; ++c) work[r][6 + c] = upper[6 * r + c];
    work[r][12] = b[r];
    work[r][13] = 0.0;
  }
}

inline void subtract_above(Work work, const double* lower, const double* above_w, const double* above_y) noexcept
{
  for (int r = 0; r < 6; ++r)
  {
    double sum[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    double right = 0.0;
    for (int k = 0; k < 6; ++k)
    {
      const double factor = lower[6 * r + k];
      for (int c = 0; c < 6; ++c) sum[c] += factor * above_w[6 * k + c];
      right += factor * above_y[k];
    }
    for (int c = 0; c < 6; ++c) work[r][c] -= sum[c];
    work[r][12] -= right;
  }
}

/// Leaves the factors of D in the left part of work, L below the diagonal and U above it, the pivots inverted, and D^-1 [U | b]
/// in the right.
inline bool eliminate(Work work) noexcept
{
  for (int p = 0; p < 6; ++p)
  {
    const double pivot = work[p][p];
    if (!(std::abs(pivot) > 1e-200)) return false;  // also catches NaN
    work[p][p] = 1.0 / pivot;
    for (int r = p + 1; r < 6; ++r)
    {
      const double factor = work[r][p] * work[p][p];
      work[r][p] = factor;
      for (int c = p + 1; c < kWidth; ++c) work[r][c] -= factor * work[p][c];
    }
  }
  for (int r = 5; r >= 0; --r)
  {
    for (int q = r + 1; q < 6; ++q)
      for (int c = 6; c < kWidth; ++c) work[r][c] -= work[r][q] * work[q][c];
    for (int c = 6; c < kWidth; ++c) work[r][c] *= work[r][r];
  }
  return true;
}

/// b = D^-1 b with the factors that eliminate() left.
inline void solve_block(const double* factors, double* b) noexcept
{
  for (int r = 1; r < 6; ++r)
    for (int c = 0; c < r; ++c) b[r] -= factors[6 * r + c] * b[c];
  for (int r = 5; r >= 0; --r)
  {
    for (int c = 5; c > r; --c) b[r] -= factors[6 * r + c] * b[c];  // the latest known last: the others need not wait for it
    b[r] *= factors[7 * r];
  }
}

/// b -= M x for a block M.
inline void subtract_product(const double* block, const double* x, double* b) noexcept
{
  for (int r = 0; r < 6; ++r)
  {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) sum += block[6 * r + c] * x[c];
    b[r] -= sum;
  }
}

/// b -= M x for a 2x2 block.
inline void subtract_small_product(const double* block, const double* x, double* b) noexcept
{
  const double first = block[0] * x[0] + block[1] * x[1];
  b[1] -= block[2] * x[0] + block[3] * x[1];
  b[0] -= first;
}

/// a = M^-1 a for the columns `c` of two rows `stride` apart.
inline void multiply_small(const double* inverse, double* a, int stride, int columns) noexcept
{
  for (int c = 0; c < columns; ++c)
  {
    const double first = a[c], second = a[stride + c];
    a[c] = inverse[0] * first + inverse[1] * second;
    a[stride + c] = inverse[2] * first + inverse[3] * second;
  }
}

inline bool invert_small(double* block) noexcept
{
  const double a = block[0], b = block[1], c = block[2], d = block[3];
  const double determinant = a * d - b * c;
  if (!(std::abs(determinant) > 1e-200)) return false;  // also catches NaN
  const double scale = 1.0 / determinant;
  block[0] = scale * d;
  block[1] = -scale * b;
  block[2] = -scale * c;
  block[3] = scale * a;
  return true;
}

/// D -= L W, the two rows of L six wide, of W two columns.
inline void subtract_six_above(double* small, const double* lower, const double* above_w) noexcept
{
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c)
      for (int k = 0; k < 6; ++k) small[2 * r + c] -= lower[6 * r + k] * above_w[6 * k + c];
}

/// D -= L W of small blocks.
inline void subtract_small_above(double* small, const double* lower, const double* above_w) noexcept
{
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) small[2 * r + c] -= lower[2 * r] * above_w[c] + lower[2 * r + 1] * above_w[2 + c];
}

}  // namespace drill_rig_sim

#endif
