// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/block_tridiagonal.h"

#include <algorithm>

#include "math/block_scalar.h"
#include "math/block_small.h"
#include "math/block_sweeps.h"

namespace drill_rig_sim
{
namespace
{
constexpr int kSix = 36, kSmall = 4;  // numbers of a block

/// Of a row's blocks the one to the row before, and that to the next, for a sweep that goes this way.
template <class Number>
Number* to_last(const BlockRowsOf<Number>& rows, SweepRow at, int size) noexcept
{
  return at.step > 0 ? rows.lower + size * (at.row - 1) : rows.upper + size * at.row;
}

template <class Number>
Number* to_next(const BlockRowsOf<Number>& rows, SweepRow at, int size) noexcept
{
  return at.step > 0 ? rows.upper + size * at.row : rows.lower + size * (at.row - 1);
}

SweepRow previous(SweepRow at) noexcept
{
  return {at.row - at.step, at.step};
}

template <class Number>
bool is_first(const BlockRowsOf<Number>& rows, SweepRow at) noexcept
{
  return previous(at).row < 0 || previous(at).row >= rows.count;
}

bool eliminate_six(const BlockRows& rows, SweepRow at, double* b) noexcept
{
  alignas(64) Work work;
  double *diagonal = rows.diagonal + kSix * at.row, *upper = to_next(rows, at, kSix), *right = b + 6 * at.row;
  load(work, diagonal, upper, right);
  if (!is_first(rows, at)) subtract_above(work, to_last(rows, at, kSix), to_next(rows, previous(at), kSix), right - 6 * at.step);
  if (!eliminate(work)) return false;
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c < 6; ++c) diagonal[6 * r + c] = work[r][c];
    for (int c = 0; c < 6; ++c) upper[6 * r + c] = work[r][6 + c];
    right[r] = work[r][12];
  }
  return true;
}

/// Calls row(at) for the rows of one sweep after the other.
template <class Row>
void each(SweepRow a, SweepRow b, int count, Row&& row) noexcept
{
  const int sweeps = a.row == b.row ? 1 : 2;
  for (int sweep = 0; sweep < sweeps; ++sweep, a = b)
    for (int k = 0; k < count; ++k, a.row += a.step) row(a);
}

bool eliminate_rows(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  bool done = true;
  each(a, b, count, [&](SweepRow at) { done = done && eliminate_six(rows, at, right); });
  return done;
}

void substitute_rows_inwards(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  each(a, b, count,
       [&](SweepRow at)
       {
         double* here = right + 6 * at.row;
         if (!is_first(rows, at)) subtract_product(to_last(rows, at, kSix), here - 6 * at.step, here);
         solve_block(rows.diagonal + kSix * at.row, here);
       });
}

void substitute_rows_outwards(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  each(a, b, count,
       [&](SweepRow at)
       {
         double* here = right + 6 * at.row;
         subtract_product(to_last(rows, at, kSix), here - 6 * at.step, here);
       });
}

/// A function of two sweeps and a number of small rows, which goes on in both in turns, so that they wait together: general(at)
/// for the first and the last row, which may be beside rows of six, two(at, before) for the others. `right`: right side of
/// `rows`.
template <class Number, class General, class Two>
auto small_in_turns(const BlockRowsOf<Number>& rows, const double* right, General general, Two two) noexcept
{
  return [=](SweepRow a, SweepRow b, int count) noexcept
  {
    const bool alone = a.row == b.row;
    const auto both = [&]
    {
      general(a);
      if (!alone) general(b);
      a.row += a.step;
      b.row += b.step;
    };
    const auto row_before = [&](SweepRow at)
    { return SmallRow(to_next(rows, previous(at), kSmall), right + 6 * previous(at).row); };
    both();
    SmallRow before_a = count > 2 ? row_before(a) : SmallRow(rows.diagonal, right),
             before_b = count > 2 && !alone ? row_before(b) : before_a;
    for (int k = 2; k < count; ++k, a.row += a.step, b.row += b.step)
    {
      two(a, before_a);
      if (!alone) two(b, before_b);
    }
    if (count > 1) both();
  };
}

/// Rows of a sweep that are still to come.
struct Sweep
{
  SweepRow at;
  int left;

  void take(int rows) noexcept
  {
    at.row += rows * at.step;
    left -= rows;
  }
};
}  // namespace

const BlockSweeps scalar_sweeps = {false, eliminate_rows, substitute_rows_inwards, substitute_rows_outwards};

void BlockTridiagonal::resize(int n, Kernel kernel)
{
  n_ = n;
  sweeps_ = &block_sweeps(kernel);
  const auto rows = static_cast<std::size_t>(n);
  small_.assign(rows, 0);
  for (std::vector<double>* blocks : {&diagonal_, &upper_, &lower_}) blocks->resize(kSix * rows);
  for (std::vector<double>* blocks : {&small_diagonal_, &small_upper_, &small_lower_}) blocks->resize(kSmall * rows);
}

void BlockTridiagonal::set_zero() noexcept
{
  for (std::vector<double>* blocks : {&diagonal_, &upper_, &lower_, &small_diagonal_, &small_upper_, &small_lower_})
    std::fill(blocks->begin(), blocks->end(), 0.0);
}

/// The row that is solved last: the middle one of the rows of six, for they cost most.
int BlockTridiagonal::middle() const noexcept
{
  if (!sweeps_->both_ends) return n_ - 1;
  const auto large = std::count(small_.begin(), small_.end(), 0);
  if (large == 0) return n_ / 2;
  int i = 0;
  for (auto before = large / 2; before > 0 || small(i); ++i) before -= !small(i);
  return i;
}

/// Two sweeps beside each other, by runs of rows of a kind: small_rows(a, b, count) and six_rows(a, b, count) go on from both,
/// or, where a and b are the same, from one.
template <class SmallRows, class SixRows>
void BlockTridiagonal::sweep(SweepRow first, int left_first, SweepRow second, int left_second, SmallRows&& small_rows,
                             SixRows&& six_rows) const noexcept
{
  Sweep a{first, left_first}, b{second, left_second};
  const auto run = [this](Sweep s, bool of_small)
  {
    int count = 0;
    for (; s.left > 0 && small(s.at.row) == of_small; s.take(1)) ++count;
    return count;
  };
  while (a.left > 0 || b.left > 0)
  {
    int of_a = run(a, true), of_b = run(b, true);
    const bool is_small = of_a > 0 || of_b > 0;
    if (!is_small)
    {
      of_a = run(a, false);
      of_b = run(b, false);
    }
    const int count = of_a > 0 && of_b > 0 ? std::min(of_a, of_b) : std::max(of_a, of_b);
    const SweepRow from_a = of_a > 0 ? a.at : b.at, from_b = of_b > 0 ? b.at : a.at;
    is_small ? small_rows(from_a, from_b, count) : six_rows(from_a, from_b, count);
    if (of_a > 0) a.take(count);
    if (of_b > 0) b.take(count);
  }
}

[[gnu::always_inline]] inline BlockRows BlockTridiagonal::six() noexcept
{
  return {n_, diagonal_.data(), upper_.data(), lower_.data()};
}

[[gnu::always_inline]] inline SolvedRows BlockTridiagonal::six() const noexcept
{
  return {n_, diagonal_.data(), upper_.data(), lower_.data()};
}

[[gnu::always_inline]] inline BlockRows BlockTridiagonal::twos() noexcept
{
  return {n_, small_diagonal_.data(), small_upper_.data(), small_lower_.data()};
}

[[gnu::always_inline]] inline SolvedRows BlockTridiagonal::twos() const noexcept
{
  return {n_, small_diagonal_.data(), small_upper_.data(), small_lower_.data()};
}

/// D -= L W of the row before, in a small row.
[[gnu::always_inline]] inline void BlockTridiagonal::subtract_from_small(SweepRow at) noexcept
{
  if (is_first(six(), at)) return;
  double* d = small_diagonal_.data() + kSmall * at.row;
  if (small(at.row - at.step))
    subtract_small_above(d, to_last(twos(), at, kSmall), to_next(twos(), previous(at), kSmall));
  else
    subtract_six_above(d, to_last(six(), at, kSix), to_next(six(), previous(at), kSix));
}

/// b -= L y of the row before.
[[gnu::always_inline]] inline void BlockTridiagonal::subtract_from_right(SweepRow at, double* b) const noexcept
{
  if (is_first(six(), at)) return;
  double *right = b + 6 * at.row, *last = right - 6 * at.step;
  if (small(at.row) && small(at.row - at.step))
    subtract_small_product(to_last(twos(), at, kSmall), last, right);
  else
    subtract_product(to_last(six(), at, kSix), last, right);
}

[[gnu::always_inline]] inline void BlockTridiagonal::substitute_small(SweepRow at, double* b) const noexcept
{
  subtract_from_right(at, b);
  multiply_small(small_diagonal_.data() + kSmall * at.row, b + 6 * at.row, 1, 1);
}

/// As BlockSweeps::eliminate(), with the inverse of D' in place of D.
[[gnu::always_inline]] inline bool BlockTridiagonal::eliminate_small(SweepRow at, double* b) noexcept
{
  double* d = small_diagonal_.data() + kSmall * at.row;
  subtract_from_small(at);
  if (!invert_small(d)) return false;
  substitute_small(at, b);
  std::fill(b + 6 * at.row + 2, b + 6 * at.row + 6, 0.0);
  if (small(at.row + at.step))
    multiply_small(d, to_next(twos(), at, kSmall), 2, 2);
  else
    multiply_small(d, to_next(six(), at, kSix), 6, 6);
  return true;
}

bool BlockTridiagonal::eliminate_middle(double* b) noexcept
{
  const SweepRow down{middle_, 1}, up{middle_, -1};
  double* right = b + 6 * middle_;
  if (small(middle_))
  {
    subtract_from_small(down);
    subtract_from_small(up);
    if (!invert_small(small_diagonal_.data() + kSmall * middle_)) return false;
    substitute_middle(b);
    std::fill(right + 2, right + 6, 0.0);
    return true;
  }
  alignas(64) Work work;
  double* diagonal = diagonal_.data() + kSix * middle_;
  load(work, diagonal, diagonal, right);  // what stands for U is not used
  for (const SweepRow at : {down, up})
    if (!is_first(six(), at))
      subtract_above(work, to_last(six(), at, kSix), to_next(six(), previous(at), kSix), right - 6 * at.step);
  if (!eliminate(work)) return false;
  for (int r = 0; r < 6; ++r)
  {
    for (int c = 0; c < 6; ++c) diagonal[6 * r + c] = work[r][c];
    right[r] = work[r][12];
  }
  return true;
}

void BlockTridiagonal::substitute_middle(double* b) const noexcept
{
  subtract_from_right({middle_, 1}, b);
  subtract_from_right({middle_, -1}, b);
  if (small(middle_))
    multiply_small(small_diagonal_.data() + kSmall * middle_, b + 6 * middle_, 1, 1);
  else
    solve_block(diagonal_.data() + kSix * middle_, b + 6 * middle_);
}

void BlockTridiagonal::substitute_outwards(double* b) const noexcept
{
  sweep(
      {middle_ - 1, -1}, middle_, {middle_ + 1, 1}, n_ - 1 - middle_,
      small_in_turns(
          twos(), b, [&](SweepRow at) { subtract_from_right(at, b); },
          [rows = twos(), b](SweepRow at, SmallRow& before) { subtract_two(before, to_last(rows, at, kSmall), b + 6 * at.row); }),
      [&](SweepRow first, SweepRow second, int count) { sweeps_->substitute_outwards(six(), first, second, count, b); });
}

bool BlockTridiagonal::solve(double* b) noexcept
{
  if (n_ == 0) return true;
  middle_ = middle();
  bool done = true;
  sweep({0, 1}, middle_, {n_ - 1, -1}, n_ - 1 - middle_,
        small_in_turns(
            twos(), b, [&](SweepRow at) { done = done && eliminate_small(at, b); },
            [&done, rows = twos(), b](SweepRow at, SmallRow& before)
            {
              done &= eliminate_two(before, to_last(rows, at, kSmall), rows.diagonal + kSmall * at.row, to_next(rows, at, kSmall),
                                    b + 6 * at.row);
            }),
        [&](SweepRow first, SweepRow second, int count) { done = done && sweeps_->eliminate(six(), first, second, count, b); });
  if (!done || !eliminate_middle(b)) return false;
  substitute_outwards(b);
  return true;
}

void BlockTridiagonal::solve_again(double* b) const noexcept
{
  if (n_ == 0) return;
  sweep({0, 1}, middle_, {n_ - 1, -1}, n_ - 1 - middle_,
        small_in_turns(
            twos(), b, [&](SweepRow at) { substitute_small(at, b); },
            [rows = twos(), b](SweepRow at, SmallRow& before)
            { substitute_two(before, to_last(rows, at, kSmall), rows.diagonal + kSmall * at.row, b + 6 * at.row); }),
        [&](SweepRow first, SweepRow second, int count) { sweeps_->substitute_inwards(six(), first, second, count, b); });
  substitute_middle(b);
  substitute_outwards(b);
}

void BlockTridiagonal::multiply(const double* x, double* y) noexcept
{
  using Vector = Eigen::Matrix<double, size, 1>;
  for (int i = 0; i < n_; ++i)
  {
    Eigen::Map<Vector> out(y + size * i);
    const Eigen::Map<const Vector> at(x + size * i);
    out.setZero();
    if (small(i))
      out.head<2>() = small_diagonal(i) * at.head<2>();
    else
      out = diagonal(i) * at;
    if (i > 0 && both_small(i - 1))
      out.head<2>() += small_lower(i - 1) * Eigen::Map<const Eigen::Vector2d>(x + size * (i - 1));
    else if (i > 0)
      out += lower(i - 1) * Eigen::Map<const Vector>(x + size * (i - 1));
    if (i + 1 < n_ && both_small(i))
      out.head<2>() += small_upper(i) * Eigen::Map<const Eigen::Vector2d>(x + size * (i + 1));
    else if (i + 1 < n_)
      out += upper(i) * Eigen::Map<const Vector>(x + size * (i + 1));
  }
}

}  // namespace drill_rig_sim
