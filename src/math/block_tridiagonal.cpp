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

/// b -= M x for a 2x2 block.
void subtract_small_product(const double* block, const double* x, double* b) noexcept
{
  const double first = block[0] * x[0] + block[1] * x[1];
  b[1] -= block[2] * x[0] + block[3] * x[1];
  b[0] -= first;
}

/// a = M^-1 a for the columns `c` of two rows `stride` apart.
void multiply_small(const double* inverse, double* a, int stride, int columns) noexcept
{
  for (int c = 0; c < columns; ++c)
  {
    const double first = a[c], second = a[stride + c];
    a[c] = inverse[0] * first + inverse[1] * second;
    a[stride + c] = inverse[2] * first + inverse[3] * second;
  }
}

bool invert_small(double* block) noexcept
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
void subtract_six_above(double* small, const double* lower, const double* above_w) noexcept
{
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c)
      for (int k = 0; k < 6; ++k) small[2 * r + c] -= lower[6 * r + k] * above_w[6 * k + c];
}

/// D -= L W of small blocks.
void subtract_small_above(double* small, const double* lower, const double* above_w) noexcept
{
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < 2; ++c) small[2 * r + c] -= lower[2 * r] * above_w[c] + lower[2 * r + 1] * above_w[2 + c];
}
}  // namespace

void BlockTridiagonal::resize(int n)
{
  n_ = n;
  const auto rows = static_cast<std::size_t>(n);
  small_.assign(rows, 0);
  for (std::vector<double>* blocks : {&diagonal_, &upper_, &lower_}) blocks->resize(36 * rows);
  for (std::vector<double>* blocks : {&small_diagonal_, &small_upper_, &small_lower_}) blocks->resize(4 * rows);
}

void BlockTridiagonal::set_zero() noexcept
{
  for (std::vector<double>* blocks : {&diagonal_, &upper_, &lower_, &small_diagonal_, &small_upper_, &small_lower_})
    std::fill(blocks->begin(), blocks->end(), 0.0);
}

/// Leaves the factors of D' = D - L W in diagonal_, W = D'^-1 U in upper_, y = D'^-1 b' in b.
bool BlockTridiagonal::eliminate_six(int i, double* b) noexcept
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
  return true;
}

/// The same of a small row, with the inverse of D' instead of its factors.
bool BlockTridiagonal::eliminate_small(int i, double* b) noexcept
{
  double* d = small_diagonal_.data() + 4 * i;
  double* right = b + 6 * i;
  if (i > 0 && small(i - 1)) subtract_small_above(d, small_lower_.data() + 4 * (i - 1), small_upper_.data() + 4 * (i - 1));
  if (i > 0 && !small(i - 1)) subtract_six_above(d, lower_.data() + 36 * (i - 1), upper_.data() + 36 * (i - 1));
  if (!invert_small(d)) return false;
  substitute_downwards(i, b);
  std::fill(right + 2, right + 6, 0.0);
  if (i + 1 == n_) return true;
  if (small(i + 1)) multiply_small(d, small_upper_.data() + 4 * i, 2, 2);
  else multiply_small(d, upper_.data() + 36 * i, 6, 6);
  return true;
}

bool BlockTridiagonal::solve(double* b) noexcept
{
  for (int i = 0; i < n_; ++i)
    if (!(small(i) ? eliminate_small(i, b) : eliminate_six(i, b))) return false;
  substitute_upwards(b);
  return true;
}

/// y = D'^-1 (b - L y above).
void BlockTridiagonal::substitute_downwards(int i, double* b) const noexcept
{
  double* right = b + 6 * i;
  if (i > 0 && both_small(i - 1)) subtract_small_product(small_lower_.data() + 4 * (i - 1), right - 6, right);
  else if (i > 0) subtract_product(lower_.data() + 36 * (i - 1), right - 6, right);
  if (small(i)) multiply_small(small_diagonal_.data() + 4 * i, right, 1, 1);
  else solve_block(diagonal_.data() + 36 * i, right);
}

void BlockTridiagonal::solve_again(double* b) const noexcept
{
  for (int i = 0; i < n_; ++i) substitute_downwards(i, b);
  substitute_upwards(b);
}

/// x_i = y_i - W_i x_{i+1}.
void BlockTridiagonal::substitute_upwards(double* b) const noexcept
{
  for (int i = n_ - 2; i >= 0; --i)
  {
    if (both_small(i)) subtract_small_product(small_upper_.data() + 4 * i, b + 6 * (i + 1), b + 6 * i);
    else subtract_product(upper_.data() + 36 * i, b + 6 * (i + 1), b + 6 * i);
  }
}

void BlockTridiagonal::multiply(const double* x, double* y) noexcept
{
  using Vector = Eigen::Matrix<double, size, 1>;
  for (int i = 0; i < n_; ++i)
  {
    Eigen::Map<Vector> out(y + size * i);
    const Eigen::Map<const Vector> at(x + size * i);
    out.setZero();
    if (small(i)) out.head<2>() = small_diagonal(i) * at.head<2>();
    else out = diagonal(i) * at;
    if (i > 0 && both_small(i - 1)) out.head<2>() += small_lower(i - 1) * Eigen::Map<const Eigen::Vector2d>(x + size * (i - 1));
    else if (i > 0) out += lower(i - 1) * Eigen::Map<const Vector>(x + size * (i - 1));
    if (i + 1 < n_ && both_small(i)) out.head<2>() += small_upper(i) * Eigen::Map<const Eigen::Vector2d>(x + size * (i + 1));
    else if (i + 1 < n_) out += upper(i) * Eigen::Map<const Vector>(x + size * (i + 1));
  }
}

}  // namespace drill_rig_sim
