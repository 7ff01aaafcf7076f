#include "drill_rig_sim/math/block_tridiagonal.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr int kWidth = 14;  // a row of [D | U | b], padded to an even number of doubles

using Work = double[6][kWidth];

/// work = [D - L W | U | b - L y], with W and y the eliminated row above.
void load(Work work, const double* diagonal, const double* upper, const double* b) noexcept
{
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c < 6; ++c) work[r][c] = diagonal[6 * r + c];
    for (int c = 0; c < 6; ++c) work[r][6 + c] = upper[6 * r + c];
    work[r][12] = b[r];
    work[r][13] = 0.0;
  }
}

void subtract_above(Work work, const double* lower, const double* above_w, const double* above_y) noexcept
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

/// Leaves the factors of D in the left part of work, L below the diagonal and U above it, the pivots inverted, and D^-1 [U | b] in the right.
bool eliminate(Work work) noexcept
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
void solve_block(const double* factors, double* b) noexcept
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
void subtract_product(const double* block, const double* x, double* b) noexcept
{
  for (int r = 0; r < 6; ++r)
  {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) sum += block[6 * r + c] * x[c];
    b[r] -= sum;
  }
}
}  // namespace

void BlockTridiagonal::resize(int n)
{
  n_ = n;
  diagonal_.resize(36 * n);
  upper_.resize(36 * n);
  lower_.resize(36 * n);
}

void BlockTridiagonal::set_zero() noexcept
{
  std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
  std::fill(upper_.begin(), upper_.end(), 0.0);
  std::fill(lower_.begin(), lower_.end(), 0.0);
}

bool BlockTridiagonal::solve(double* b) noexcept
{
  // downward sweep: diagonal_ becomes the factors of D', upper_ becomes W = D'^-1 U, b becomes y = D'^-1 b'
  for (int i = 0; i < n_; ++i)
  {
    alignas(64) Work work;
    load(work, diagonal_.data() + 36 * i, upper_.data() + 36 * i, b + 6 * i);
    if (i > 0) subtract_above(work, lower_.data() + 36 * (i - 1), upper_.data() + 36 * (i - 1), b + 6 * (i - 1));
    if (!eliminate(work)) return false;
    for (int r = 0; r < 6; ++r)
    {
      for (int c = 0; c < 6; ++c) diagonal_[36 * i + 6 * r + c] = work[r][c];
      for (int c = 0; c < 6; ++c) upper_[36 * i + 6 * r + c] = work[r][6 + c];
      b[6 * i + r] = work[r][12];
    }
  }
  substitute_upwards(b);
  return true;
}

void BlockTridiagonal::solve_again(double* b) const noexcept
{
  for (int i = 0; i < n_; ++i)
  {
    if (i > 0) subtract_product(lower_.data() + 36 * (i - 1), b + 6 * (i - 1), b + 6 * i);
    solve_block(diagonal_.data() + 36 * i, b + 6 * i);
  }
  substitute_upwards(b);
}

/// x_i = y_i - W_i x_{i+1}.
void BlockTridiagonal::substitute_upwards(double* b) const noexcept
{
  for (int i = n_ - 2; i >= 0; --i) subtract_product(upper_.data() + 36 * i, b + 6 * (i + 1), b + 6 * i);
}

void BlockTridiagonal::multiply(const double* x, double* y) noexcept
{
  using Vector = Eigen::Matrix<double, size, 1>;
  for (int i = 0; i < n_; ++i)
  {
    Eigen::Map<Vector> out(y + size * i);
    out = diagonal(i) * Eigen::Map<const Vector>(x + size * i);
    if (i > 0) out += lower(i - 1) * Eigen::Map<const Vector>(x + size * (i - 1));
    if (i + 1 < n_) out += upper(i) * Eigen::Map<const Vector>(x + size * (i + 1));
  }
}

}  // namespace drill_rig_sim
