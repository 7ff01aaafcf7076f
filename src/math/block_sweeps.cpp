// Sweeps from both ends of a block-tridiagonal matrix at once. A vector holds two neighbouring numbers of a row of the one end and the two
// of the other, {a0, a1, b0, b1}: two chains of dependent arithmetic run beside each other, every lane has work, and nothing is shuffled
// between the ends.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/block_sweeps.cpp"
#include "math/simd.h"

#include "math/block_sweeps.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

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
HWY_INLINE Pair all(double x) { return hn::Set(Four(), x); }
HWY_INLINE Pair evens(Pair v) { return hn::InterleaveLower(Four(), v, v); }
HWY_INLINE Pair odds(Pair v) { return hn::InterleaveUpper(Four(), v, v); }
/// {x0 + x1, y0 + y1} of both ends.
HWY_INLINE Pair sums(Pair x, Pair y) { return hn::Add(hn::InterleaveLower(Four(), x, y), hn::InterleaveUpper(Four(), x, y)); }
/// The evens of the one beside the odds of the other.
HWY_INLINE Pair even_odd(Pair even, Pair odd) { return hn::OddEven(odd, even); }
HWY_INLINE Pair times(Pair x, Pair y) { return hn::Mul(x, y); }
HWY_INLINE Pair plus_product(Pair sum, Pair x, Pair y) { return hn::MulAdd(x, y, sum); }
HWY_INLINE Pair minus_product(Pair sum, Pair x, Pair y) { return hn::NegMulAdd(x, y, sum); }
HWY_INLINE Pair minus(Pair x, Pair y) { return hn::Sub(x, y); }
HWY_INLINE Pair over(Pair x, Pair y) { return hn::Div(x, y); }
HWY_INLINE Pair smaller_size(Pair least, Pair x) { return hn::IfThenElse(hn::Lt(least, hn::Abs(x)), least, hn::Abs(x)); }  // keeps a NaN
HWY_INLINE bool all_above(Pair x, double bound) { return hn::AllTrue(Four(), hn::Gt(x, all(bound))); }
#else
using Two = hn::FixedTag<double, 2>;
using Half = hn::Vec<Two>;
struct Pair
{
  Half a, b;
};

HWY_INLINE Pair load(const double* a, const double* b) { return {hn::LoadU(Two(), a), hn::LoadU(Two(), b)}; }
HWY_INLINE void store(Pair v, double* a, double* b)
{
  hn::StoreU(v.a, Two(), a);
  hn::StoreU(v.b, Two(), b);
}
HWY_INLINE Pair all(double x) { return {hn::Set(Two(), x), hn::Set(Two(), x)}; }
HWY_INLINE Pair evens(Pair v) { return {hn::InterleaveLower(Two(), v.a, v.a), hn::InterleaveLower(Two(), v.b, v.b)}; }
HWY_INLINE Pair odds(Pair v) { return {hn::InterleaveUpper(Two(), v.a, v.a), hn::InterleaveUpper(Two(), v.b, v.b)}; }
HWY_INLINE Half sum(Half x, Half y) { return hn::Add(hn::InterleaveLower(Two(), x, y), hn::InterleaveUpper(Two(), x, y)); }
HWY_INLINE Pair sums(Pair x, Pair y) { return {sum(x.a, y.a), sum(x.b, y.b)}; }
HWY_INLINE Pair even_odd(Pair even, Pair odd) { return {hn::OddEven(odd.a, even.a), hn::OddEven(odd.b, even.b)}; }
HWY_INLINE Pair times(Pair x, Pair y) { return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)}; }
HWY_INLINE Pair plus_product(Pair sum, Pair x, Pair y) { return {hn::MulAdd(x.a, y.a, sum.a), hn::MulAdd(x.b, y.b, sum.b)}; }
HWY_INLINE Pair minus_product(Pair sum, Pair x, Pair y) { return {hn::NegMulAdd(x.a, y.a, sum.a), hn::NegMulAdd(x.b, y.b, sum.b)}; }
HWY_INLINE Pair minus(Pair x, Pair y) { return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)}; }
HWY_INLINE Pair over(Pair x, Pair y) { return {hn::Div(x.a, y.a), hn::Div(x.b, y.b)}; }
HWY_INLINE Half smaller_size(Half least, Half x) { return hn::IfThenElse(hn::Lt(least, hn::Abs(x)), least, hn::Abs(x)); }
HWY_INLINE Pair smaller_size(Pair least, Pair x) { return {smaller_size(least.a, x.a), smaller_size(least.b, x.b)}; }
HWY_INLINE bool all_above(Pair x, double bound)
{
  return hn::AllTrue(Two(), hn::Gt(x.a, hn::Set(Two(), bound))) && hn::AllTrue(Two(), hn::Gt(x.b, hn::Set(Two(), bound)));
}
#endif

using Row = Pair[3];   // six numbers of both ends
using Block = Row[6];

constexpr double kZeros[36] = {};

/// Where a row's blocks lie; what is not there is zero.
struct Places
{
  const double *lower, *w_before, *y_before;
  double *diagonal, *upper, *right;
};

HWY_INLINE Places places(const BlockRows& rows, SweepRow at, double* right)
{
  const bool first = at.row - at.step < 0 || at.row - at.step >= rows.count;
  double* const to_next = rows.upper + 36 * at.row;             // block (i, i + 1)
  double* const to_last = rows.lower + 36 * (at.row - 1);       // block (i, i - 1)
  const bool up = at.step > 0;
  Places p;
  p.lower = first ? kZeros : up ? to_last : to_next;
  p.w_before = first ? kZeros : up ? rows.upper + 36 * (at.row - 1) : rows.lower + 36 * at.row;
  p.y_before = first ? kZeros : right + 6 * (at.row - at.step);
  p.diagonal = rows.diagonal + 36 * at.row;
  p.upper = up ? to_next : to_last;
  p.right = right + 6 * at.row;
  return p;
}

HWY_INLINE void load_row(const double* a, const double* b, Row& out)
{
  for (int c = 0; c < 3; ++c) out[c] = load(a + 2 * c, b + 2 * c);
}

HWY_INLINE Pair number(const Row& row, int c) { return c % 2 == 0 ? evens(row[c / 2]) : odds(row[c / 2]); }

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

// Elimination: a line is a row of a block and the right side beside it, {m0 .. m5, b, -}, in one vector, two or four. Two chains of dependent
// arithmetic, of both ends, run beside each other.
constexpr int kLanes = HWY_MAX_BYTES >= 64 ? 8 : HWY_MAX_BYTES >= 32 ? 4 : 2;
constexpr int kParts = 8 / kLanes;
using Wide = hn::FixedTag<double, kLanes>;
using Vector = hn::Vec<Wide>;
using Line = Vector[kParts];

alignas(64) constexpr double kLaneNumbers[8] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};

/// Of one lane alone of a line's part.
HWY_INLINE hn::Mask<Wide> lane_of(int part, int lane)
{
  return hn::Eq(hn::Load(Wide(), kLaneNumbers + kLanes * part), hn::Set(Wide(), lane));
}
HWY_INLINE hn::Mask<Wide> lanes_below(int part, int lane)
{
  return hn::Lt(hn::Load(Wide(), kLaneNumbers + kLanes * part), hn::Set(Wide(), lane));
}

HWY_INLINE Vector every(double x) { return hn::Set(Wide(), x); }

/// Lane c of a line in all lanes.
HWY_INLINE Vector spread(const Line& line, int c)
{
  const Vector v = line[c / kLanes];
#if HWY_MAX_BYTES >= 64
  return Vector{_mm512_permutexvar_pd(_mm512_set1_epi64(c), v.raw)};
#elif HWY_MAX_BYTES >= 32
  switch (c % kLanes)
  {
    case 0: return Vector{_mm256_permute4x64_pd(v.raw, 0x00)};
    case 1: return Vector{_mm256_permute4x64_pd(v.raw, 0x55)};
    case 2: return Vector{_mm256_permute4x64_pd(v.raw, 0xaa)};
    default: return Vector{_mm256_permute4x64_pd(v.raw, 0xff)};
  }
#else
  return c % kLanes == 0 ? hn::InterleaveLower(Wide(), v, v) : hn::InterleaveUpper(Wide(), v, v);
#endif
}

/// {row, b, 0}
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
  hn::BlendedStore(line[0], lanes_below(0, 6), Wide(), row);
#elif HWY_MAX_BYTES >= 32
  hn::StoreU(line[0], Wide(), row);
  hn::StoreU(hn::LowerHalf(hn::FixedTag<double, 2>(), line[1]), hn::FixedTag<double, 2>(), row + 4);
#else
  for (int part = 0; part < 3; ++part) hn::StoreU(line[part], Wide(), row + 2 * part);
#endif
}

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

/// The inverse of a block in place, by Gauss and Jordan, pivots down the diagonal, times the right sides too.
HWY_INLINE void pivot_on(Line (&d)[6], int p, hn::Mask<Wide>& sound)
{
  const Vector pivot = spread(d[p], p);
  sound = hn::And(sound, hn::Gt(hn::Abs(pivot), every(1e-200)));
  const Vector inverse = hn::Div(every(1.0), pivot);
  for (int part = 0; part < kParts; ++part)
  {
    d[p][part] = hn::Mul(d[p][part], inverse);
    if (p / kLanes == part) d[p][part] = hn::IfThenElse(lane_of(part, p), inverse, d[p][part]);
  }
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r)
  {
    if (r == p) continue;
    const Vector factor = spread(d[r], p);
    d[r][p / kLanes] = hn::IfThenZeroElse(lane_of(p / kLanes, p), d[r][p / kLanes]);
    for (int part = 0; part < kParts; ++part) d[r][part] = hn::NegMulAdd(factor, d[p][part], d[r][part]);
  }
}

/// What a row hands on to the next: lines of W and y.
using Done = Line[6];

template <int ends>
HWY_INLINE void eliminate_one(const Places (&at)[ends], Done (&w)[ends], hn::Mask<Wide>& sound)
{
  Line d[ends][6];
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r)
#pragma GCC unroll 2
    for (int e = 0; e < ends; ++e)
    {
      load_line(at[e].diagonal + 6 * r, at[e].right[r], d[e][r]);
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        for (int part = 0; part < kParts; ++part) d[e][r][part] = hn::NegMulAdd(every(at[e].lower[6 * r + k]), w[e][k][part], d[e][r][part]);
    }
#pragma GCC unroll 6
  for (int p = 0; p < 6; ++p)
#pragma GCC unroll 2
    for (int e = 0; e < ends; ++e) pivot_on(d[e], p, sound);
#pragma GCC unroll 2
  for (int e = 0; e < ends; ++e)
  {
    Line u[6];
    for (int k = 0; k < 6; ++k) load_line(at[e].upper + 6 * k, 0.0, u[k]);
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r)
    {
      store_line(d[e][r], at[e].diagonal + 6 * r);
      at[e].right[r] = right_of(d[e][r]);
    }
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r)
    {
      for (int part = 0; part < kParts; ++part)
        w[e][r][part] = 6 / kLanes == part ? hn::IfThenElseZero(lane_of(part, 6), d[e][r][part]) : hn::Zero(Wide());
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        for (int part = 0; part < (kLanes == 2 ? 3 : kParts); ++part)
          w[e][r][part] = hn::MulAdd(every(at[e].diagonal[6 * r + k]), u[k][part], w[e][r][part]);
      store_line(w[e][r], at[e].upper + 6 * r);
    }
  }
}

HWY_INLINE void load_done(const Places& at, Done& w)
{
  for (int k = 0; k < 6; ++k) load_line(at.w_before + 6 * k, at.y_before[k], w[k]);
}

bool eliminate(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  hn::Mask<Wide> sound = hn::Eq(every(0.0), every(0.0));
  Done w[2];
  load_done(places(rows, a, right), w[0]);
  load_done(places(rows, b, right), w[1]);
  if (a.row == b.row)
  {
    Done alone[1];
    load_done(places(rows, a, right), alone[0]);
    for (int k = 0; k < count; ++k, a.row += a.step)
    {
      const Places at[1] = {places(rows, a, right)};
      eliminate_one<1>(at, alone, sound);
    }
    return hn::AllTrue(Wide(), sound);
  }
  for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
  {
    const Places at[2] = {places(rows, a, right), places(rows, b, right)};
    eliminate_one<2>(at, w, sound);
  }
  return hn::AllTrue(Wide(), sound);
}

void substitute_inwards(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
{
  for (int k = 0; k < count; ++k, a.row += a.step, b.row += b.step)
  {
    const Places at = places(rows, a, right), bt = places(rows, b, right);
    Row y, product;
    load_row(at.y_before, bt.y_before, y);
    multiply(at.lower, bt.lower, y, product);
    for (int c = 0; c < 3; ++c) y[c] = minus(load(at.right + 2 * c, bt.right + 2 * c), product[c]);
    multiply(at.diagonal, bt.diagonal, y, product);
    for (int c = 0; c < 3; ++c) store(product[c], at.right + 2 * c, bt.right + 2 * c);
  }
}

void substitute_outwards(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept
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
