// SPDX-License-Identifier: BSD-3-Clause
// Sweeps from both ends of a block-tridiagonal matrix to its middle: two chains of dependent arithmetic, one beside the other.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/block_sweeps.cpp"
#include "math/simd.h"

#include "math/block_sweeps.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// Substitution: a pair is two neighbouring numbers of a row of the one end and the two of the other, {a0, a1, b0, b1}, in a
// vector or two.
#if HWY_MAX_BYTES >= 32
using Two = hn::FixedTag<double, 2>;
using Four = hn::FixedTag<double, 4>;
using Pair = hn::Vec<Four>;

HWY_INLINE Pair load(const double* a, const double* b)
{
  return hn::Combine(Four(), hn::LoadU(Two(), b), hn::LoadU(Two(), a));
}
HWY_INLINE void store(Pair v, double* a, double* b)
{
  hn::StoreU(hn::LowerHalf(Two(), v), Two(), a);
  hn::StoreU(hn::UpperHalf(Two(), v), Two(), b);
}
/// {x0 + x1, y0 + y1} of both ends.
HWY_INLINE Pair sums(Pair x, Pair y)
{
  return hn::Add(hn::InterleaveLower(Four(), x, y), hn::InterleaveUpper(Four(), x, y));
}
HWY_INLINE Pair times(Pair x, Pair y)
{
  return hn::Mul(x, y);
}
HWY_INLINE Pair plus_product(Pair sum, Pair x, Pair y)
{
  return hn::MulAdd(x, y, sum);
}
HWY_INLINE Pair minus(Pair x, Pair y)
{
  return hn::Sub(x, y);
}
#else
using Two = hn::FixedTag<double, 2>;
using Half = hn::Vec<Two>;
struct Pair
{
  HWY_INLINE Pair() {}  // what the compiler would make is of another set of instructions
  HWY_INLINE Pair(Half first, Half second) : a(first), b(second) {}
  Half a, b;
};

HWY_INLINE Pair load(const double* a, const double* b)
{
  return {hn::LoadU(Two(), a), hn::LoadU(Two(), b)};
}
HWY_INLINE void store(Pair v, double* a, double* b)
{
  hn::StoreU(v.a, Two(), a);
  hn::StoreU(v.b, Two(), b);
}
HWY_INLINE Half sum(Half x, Half y)
{
  return hn::Add(hn::InterleaveLower(Two(), x, y), hn::InterleaveUpper(Two(), x, y));
}
HWY_INLINE Pair sums(Pair x, Pair y)
{
  return {sum(x.a, y.a), sum(x.b, y.b)};
}
HWY_INLINE Pair times(Pair x, Pair y)
{
  return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)};
}
HWY_INLINE Pair plus_product(Pair sum, Pair x, Pair y)
{
  return {hn::MulAdd(x.a, y.a, sum.a), hn::MulAdd(x.b, y.b, sum.b)};
}
HWY_INLINE Pair minus(Pair x, Pair y)
{
  return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)};
}
#endif

using Row = Pair[3];  // six numbers of both ends

constexpr double kZeros[36] = {};

/// Where a row's blocks lie; what is not there is zero.
template <class Number>
struct PlacesOf
{
  const double *lower, *w_before, *y_before;
  Number *diagonal, *upper;
  double* right;
};
using Places = PlacesOf<double>;

template <class Number>
HWY_INLINE PlacesOf<Number> places(const BlockRowsOf<Number>& rows, SweepRow at, double* right)
{
  const bool first = at.row - at.step < 0 || at.row - at.step >= rows.count;
  const bool down = at.step > 0;  // the matrix
  PlacesOf<Number> p;
  p.lower = first ? kZeros : down ? rows.lower + 36 * (at.row - 1) : rows.upper + 36 * at.row;
  p.w_before = first ? kZeros : down ? rows.upper + 36 * (at.row - 1) : rows.lower + 36 * at.row;
  p.y_before = first ? kZeros : right + 6 * (at.row - at.step);
  p.diagonal = rows.diagonal + 36 * at.row;
  p.upper = down ? rows.upper + 36 * at.row : rows.lower + 36 * (at.row - 1);
  p.right = right + 6 * at.row;
  return p;
}

HWY_INLINE void load_row(const double* a, const double* b, Row& out)
{
  for (int c = 0; c < 3; ++c) out[c] = load(a + 2 * c, b + 2 * c);
}

/// M x, the rows of M as they lie at a and b.
HWY_INLINE void multiply(const double* a, const double* b, const Row& x, Row& out)
{
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r)
  {
    Pair sum[2];
#pragma GCC unroll 2
    for (int k = 0; k < 2; ++k)
    {
      Row row;
      load_row(a + 6 * (2 * r + k), b + 6 * (2 * r + k), row);
      sum[k] = plus_product(plus_product(times(row[0], x[0]), row[1], x[1]), row[2], x[2]);
    }
    out[r] = sums(sum[0], sum[1]);
  }
}

// Elimination: a line is a row of a block and a number of the right side beside it, {m0 .. m5, b, -}, in one vector, two or four.
constexpr int kLanes = HWY_MAX_BYTES >= 64 ? 8 : HWY_MAX_BYTES >= 32 ? 4 : 2;
constexpr int kParts = 8 / kLanes;
using Wide = hn::FixedTag<double, kLanes>;
using Vector = hn::Vec<Wide>;
using Line = Vector[kParts];

alignas(64) constexpr double kLaneNumbers[8] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};

/// Lanes of a line's part: one alone, and those below one.
HWY_INLINE hn::Mask<Wide> lane_of(int part, int lane)
{
  return hn::Eq(hn::Load(Wide(), kLaneNumbers + kLanes * part), hn::Set(Wide(), lane));
}
HWY_INLINE hn::Mask<Wide> lanes_below(int part, int lane)
{
  return hn::Lt(hn::Load(Wide(), kLaneNumbers + kLanes * part), hn::Set(Wide(), lane));
}

HWY_INLINE Vector every(double x)
{
  return hn::Set(Wide(), x);
}

/// Lane c of a line in all lanes.
HWY_INLINE Vector spread(const Line& line, int c)
{
  const Vector v = line[c / kLanes];
#if HWY_MAX_BYTES >= 64
  return Vector{_mm512_permutexvar_pd(_mm512_set1_epi64(c), v.raw)};
#elif HWY_MAX_BYTES >= 32
  switch (c % kLanes)
  {
    case 0:
      return Vector{_mm256_permute4x64_pd(v.raw, 0x00)};
    case 1:
      return Vector{_mm256_permute4x64_pd(v.raw, 0x55)};
    case 2:
      return Vector{_mm256_permute4x64_pd(v.raw, 0xaa)};
    default:
      return Vector{_mm256_permute4x64_pd(v.raw, 0xff)};
  }
#else
  return c % kLanes == 0 ? hn::InterleaveLower(Wide(), v, v) : hn::InterleaveUpper(Wide(), v, v);
#endif
}

/// {row, b, -}
HWY_INLINE void load_line(const double* row, double b, Line& out)
{
#if HWY_MAX_BYTES >= 64
  out[0] = hn::IfThenElse(lane_of(0, 6), every(b), hn::MaskedLoad(lanes_below(0, 6), Wide(), row));
#elif HWY_MAX_BYTES >= 32
  out[0] = hn::LoadU(Wide(), row);
  out[1] = hn::Combine(Wide(), hn::Set(hn::FixedTag<double, 2>(), b), hn::LoadU(hn::FixedTag<double, 2>(), row + 4));
#else
  for (int part = 0; part < 3; ++part) out[part] = hn::LoadU(Wide(), row + 2 * part);
  out[3] = every(b);
#endif
}

HWY_INLINE void store_line(const Line& line, double* row)
{
#if HWY_MAX_BYTES >= 64
  hn::StoreU(hn::LowerHalf(hn::FixedTag<double, 4>(), line[0]), hn::FixedTag<double, 4>(), row);
  const auto upper = hn::UpperHalf(hn::FixedTag<double, 4>(), line[0]);
  hn::StoreU(hn::LowerHalf(hn::FixedTag<double, 2>(), upper), hn::FixedTag<double, 2>(), row + 4);
#elif HWY_MAX_BYTES >= 32
  hn::StoreU(line[0], Wide(), row);
  hn::StoreU(hn::LowerHalf(hn::FixedTag<double, 2>(), line[1]), hn::FixedTag<double, 2>(), row + 4);
#else
  for (int part = 0; part < 3; ++part) hn::StoreU(line[part], Wide(), row + 2 * part);
#endif
}

/// Lane 6 of a line.
HWY_INLINE double right_of(const Line& line)
{
#if HWY_MAX_BYTES >= 64
  return hn::GetLane(hn::UpperHalf(hn::FixedTag<double, 2>(), hn::UpperHalf(hn::FixedTag<double, 4>(), line[0])));
#elif HWY_MAX_BYTES >= 32
  return hn::GetLane(hn::UpperHalf(hn::FixedTag<double, 2>(), line[1]));
#else
  return hn::GetLane(line[3]);
#endif
}

/// Lines of a block.
using Lines = Line[6];

HWY_INLINE Vector inverse_of(Vector pivot, hn::Mask<Wide>& sound)
{
  sound = hn::And(sound, hn::Gt(hn::Abs(pivot), every(1e-200)));  // not so for NaN
  return hn::Div(every(1.0), pivot);
}

/// One pivot of Gauss and Jordan, down the diagonal: of D, towards its inverse in place, and of the lines beside it, from [U | b]
/// towards D^-1 [U | b]. `inverse`: of the pivot, and after it of the next, which is found ahead of its line: divisions make the
/// longest chain.
HWY_INLINE void pivot_on(Lines& d, Lines& u, int p, Vector& inverse, hn::Mask<Wide>& sound)
{
  Vector next = inverse;
  if (p < 5)
    next = inverse_of(hn::NegMulAdd(hn::Mul(spread(d[p + 1], p), spread(d[p], p + 1)), inverse, spread(d[p + 1], p + 1)), sound);
  const hn::Mask<Wide> in_column = lane_of(p / kLanes, p);
  for (int part = 0; part < kParts; ++part)
  {
    d[p][part] = hn::Mul(d[p][part], inverse);
    u[p][part] = hn::Mul(u[p][part], inverse);
  }
  d[p][p / kLanes] = hn::IfThenElse(in_column, inverse, d[p][p / kLanes]);
#pragma GCC unroll 6
  for (int k = 1; k < 6; ++k)
  {
    const int r = (p + k) % 6;
    const Vector factor = spread(d[r], p);
    d[r][p / kLanes] = hn::IfThenZeroElse(in_column, d[r][p / kLanes]);
    for (int part = 0; part < kParts; ++part)
    {
      if (part * kLanes < 6) d[r][part] = hn::NegMulAdd(factor, d[p][part], d[r][part]);
      u[r][part] = hn::NegMulAdd(factor, u[p][part], u[r][part]);
    }
  }
  inverse = next;
}

/// `w`: [W | y] of the rows before, and then of these.
template <int ends>
HWY_INLINE void eliminate_one(const Places (&at)[ends], Lines (&w)[ends], hn::Mask<Wide>& sound)
{
  Lines d[ends];
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r)
#pragma GCC unroll 2
    for (int e = 0; e < ends; ++e)
    {
      load_line(at[e].diagonal + 6 * r, at[e].right[r], d[e][r]);
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        for (int part = 0; part < kParts; ++part)
          d[e][r][part] = hn::NegMulAdd(every(at[e].lower[6 * r + k]), w[e][k][part], d[e][r][part]);
    }
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r)
#pragma GCC unroll 2
    for (int e = 0; e < ends; ++e)
    {
      load_line(at[e].upper + 6 * r, 0.0, w[e][r]);
      w[e][r][6 / kLanes] = hn::IfThenElse(lane_of(6 / kLanes, 6), d[e][r][6 / kLanes], w[e][r][6 / kLanes]);
    }
  Vector inverse[ends];
  for (int e = 0; e < ends; ++e) inverse[e] = inverse_of(spread(d[e][0], 0), sound);
#pragma GCC unroll 6
  for (int p = 0; p < 6; ++p)
#pragma GCC unroll 2
    for (int e = 0; e < ends; ++e) pivot_on(d[e], w[e], p, inverse[e], sound);
#pragma GCC unroll 2
  for (int e = 0; e < ends; ++e)
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r)
    {
      store_line(d[e][r], at[e].diagonal + 6 * r);
      store_line(w[e][r], at[e].upper + 6 * r);
      at[e].right[r] = right_of(w[e][r]);
    }
}

HWY_INLINE void load_before(const Places& at, Lines& w)
{
  for (int k = 0; k < 6; ++k) load_line(at.w_before + 6 * k, at.y_before[k], w[k]);
}

/// From one end. With half the registers that is a function of its own: otherwise blocks of both ends would share them.
#if HWY_MAX_BYTES >= 64
HWY_INLINE
#else
HWY_NOINLINE
#endif
void eliminate_alone(const Places& at, Lines (&w)[1], hn::Mask<Wide>& sound)
{
  const Places one[1] = {at};
  eliminate_one<1>(one, w, sound);
}

bool eliminate(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  hn::Mask<Wide> sound = hn::Eq(every(0.0), every(0.0));
  const bool alone = a.row == b.row;
  if (kLanes == 8 && !alone)  // there are registers for two
  {
    Lines w[2];
    load_before(places(rows, a, right), w[0]);
    load_before(places(rows, b, right), w[1]);
    for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
    {
      const Places at[2] = {places(rows, a, right), places(rows, b, right)};
      eliminate_one<2>(at, w, sound);
    }
    return hn::AllTrue(Wide(), sound);
  }
  Lines of_a[1], of_b[1];
  load_before(places(rows, a, right), of_a[0]);
  load_before(places(rows, b, right), of_b[0]);
  for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
  {
    eliminate_alone(places(rows, a, right), of_a, sound);
    if (!alone) eliminate_alone(places(rows, b, right), of_b, sound);
  }
  return hn::AllTrue(Wide(), sound);
}

void substitute_inwards(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
  {
    const auto at = places(rows, a, right), bt = places(rows, b, right);
    Row y, product;
    load_row(at.y_before, bt.y_before, y);
    multiply(at.lower, bt.lower, y, product);
    for (int c = 0; c < 3; ++c) y[c] = minus(load(at.right + 2 * c, bt.right + 2 * c), product[c]);
    multiply(at.diagonal, bt.diagonal, y, product);
    for (int c = 0; c < 3; ++c) store(product[c], at.right + 2 * c, bt.right + 2 * c);
  }
}

void substitute_outwards(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  const auto w_of = [&rows](SweepRow at) { return at.step < 0 ? rows.upper + 36 * at.row : rows.lower + 36 * (at.row - 1); };
  Row x;
  load_row(right + 6 * (a.row - a.step), right + 6 * (b.row - b.step), x);
  for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
  {
    double *const at = right + 6 * a.row, *const bt = right + 6 * b.row;
    Row product;
    multiply(w_of(a), w_of(b), x, product);
    for (int c = 0; c < 3; ++c) x[c] = minus(load(at + 2 * c, bt + 2 * c), product[c]);
    for (int c = 0; c < 3; ++c) store(x[c], at + 2 * c, bt + 2 * c);
  }
}

constexpr BlockSweeps sweeps = {true, eliminate, substitute_inwards, substitute_outwards};

}  // namespace drill_rig_sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const BlockSweeps& block_sweeps(Kernel kernel) noexcept
{
  return *DRILL_RIG_SIM_TABLE(kernel, &scalar_sweeps, sweeps);
}
}  // namespace drill_rig_sim
#endif
