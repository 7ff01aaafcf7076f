// Vectors of three with a number of several nodes or elements in each component, and their way from and to rows of memory. Included by a
// source of batch kernels inside its namespace, once for each set of instructions (math/simd.h); no include guard, therefore.

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag()));

/// Of a batch that begins with `i`, those before `end`.
HWY_INLINE int lanes_from(int i, int end)
{
  return end - i < kLanes ? end - i : kLanes;
}

HWY_INLINE V all(double value)
{
  return hn::Set(Tag(), value);
}

HWY_INLINE V load(const double* from)
{
  return hn::LoadU(Tag(), from);
}

// what math/vector_text.h and the laws' texts want of a V
#undef DRILL_LAW
#define DRILL_LAW HWY_INLINE

HWY_INLINE V mul_add(V a, V b, V c)
{
  return hn::MulAdd(a, b, c);
}

HWY_INLINE V mul_sub(V a, V b, V c)
{
  return hn::MulSub(a, b, c);
}

HWY_INLINE V neg_mul_add(V a, V b, V c)
{
  return hn::NegMulAdd(a, b, c);
}

HWY_INLINE V minus(V a)
{
  return hn::Neg(a);
}

HWY_INLINE V sqrt_of(V a)
{
  return hn::Sqrt(a);
}

HWY_INLINE V larger(V a, V b)
{
  return hn::Max(a, b);
}

HWY_INLINE V select(Mask mask, V yes, V no)
{
  return hn::IfThenElse(mask, yes, no);
}

HWY_INLINE V select_or_zero(Mask mask, V yes)
{
  return hn::IfThenElseZero(mask, yes);
}

HWY_INLINE Mask both(Mask a, Mask b)
{
  return hn::And(a, b);
}

HWY_INLINE Mask opposite(Mask a)
{
  return hn::Not(a);
}

HWY_INLINE bool all_of(Mask mask)
{
  return hn::AllTrue(Tag(), mask);
}

#include "drill_rig_sim/math/vector_text.h"

/// Rows of memory, a node's or an element's each.
struct Rows
{
  double* row[kLanes];
};

/// `count` of them, `stride` bytes apart; the others are `spare`, which takes what is not used.
HWY_INLINE Rows rows(double* first, std::ptrdiff_t stride, int count, double* spare)
{
  Rows out;
  for (int k = 0; k < kLanes; ++k)
    out.row[k] = k < count ? reinterpret_cast<double*>(reinterpret_cast<char*>(first) + k * stride) : spare;
  return out;
}

/// The same to read from: the others are the last one.
HWY_INLINE Rows rows(const double* first, std::ptrdiff_t stride, int count)
{
  double* const from = const_cast<double*>(first);
  return rows(from, stride, count, reinterpret_cast<double*>(reinterpret_cast<char*>(from) + (count - 1) * stride));
}

struct V4
{
  V a, b, c, d;
};

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
using Tag4 = hn::CappedTag<double, 4>;
using Half = hn::Vec<Tag4>;

/// Four rows of four, turned about the diagonal.
HWY_INLINE void transpose(Half& a, Half& b, Half& c, Half& d)
{
  const Tag4 tag;
  const Half ab0 = hn::InterleaveLower(tag, a, b), ab1 = hn::InterleaveUpper(tag, a, b);
  const Half cd0 = hn::InterleaveLower(tag, c, d), cd1 = hn::InterleaveUpper(tag, c, d);
  a = hn::ConcatLowerLower(tag, cd0, ab0);
  b = hn::ConcatLowerLower(tag, cd1, ab1);
  c = hn::ConcatUpperUpper(tag, cd0, ab0);
  d = hn::ConcatUpperUpper(tag, cd1, ab1);
}
#endif

/// Puts numbers of a row down, in the place of what is there or added to it.
template <bool kAdd, class T, class Q>
HWY_INLINE void put(T tag, Q value, double* to)
{
  if constexpr (kAdd) value = value + hn::LoadU(tag, to);
  hn::StoreU(value, tag, to);
}

#if HWY_TARGET == HWY_AVX3
/// Four columns of the rows, from column `at` on.
HWY_INLINE V4 load4(const Rows& from, int at)
{
  const Tag4 t;
  Half a = hn::LoadU(t, from.row[0] + at), b = hn::LoadU(t, from.row[1] + at), c = hn::LoadU(t, from.row[2] + at), d = hn::LoadU(t, from.row[3] + at);
  Half e = hn::LoadU(t, from.row[4] + at), f = hn::LoadU(t, from.row[5] + at), g = hn::LoadU(t, from.row[6] + at), h = hn::LoadU(t, from.row[7] + at);
  transpose(a, b, c, d);
  transpose(e, f, g, h);
  const Tag tag;
  return {hn::Combine(tag, e, a), hn::Combine(tag, f, b), hn::Combine(tag, g, c), hn::Combine(tag, h, d)};
}

template <bool kAdd>
HWY_INLINE void store4(V a, V b, V c, V d, const Rows& to, int at)
{
  const Tag4 t;
  Half a0 = hn::LowerHalf(t, a), b0 = hn::LowerHalf(t, b), c0 = hn::LowerHalf(t, c), d0 = hn::LowerHalf(t, d);
  Half a1 = hn::UpperHalf(t, a), b1 = hn::UpperHalf(t, b), c1 = hn::UpperHalf(t, c), d1 = hn::UpperHalf(t, d);
  transpose(a0, b0, c0, d0);
  transpose(a1, b1, c1, d1);
  put<kAdd>(t, a0, to.row[0] + at);
  put<kAdd>(t, b0, to.row[1] + at);
  put<kAdd>(t, c0, to.row[2] + at);
  put<kAdd>(t, d0, to.row[3] + at);
  put<kAdd>(t, a1, to.row[4] + at);
  put<kAdd>(t, b1, to.row[5] + at);
  put<kAdd>(t, c1, to.row[6] + at);
  put<kAdd>(t, d1, to.row[7] + at);
}
#elif HWY_TARGET == HWY_AVX2
/// Four columns of the rows, from column `at` on.
HWY_INLINE V4 load4(const Rows& from, int at)
{
  V a = load(from.row[0] + at), b = load(from.row[1] + at), c = load(from.row[2] + at), d = load(from.row[3] + at);
  transpose(a, b, c, d);
  return {a, b, c, d};
}

template <bool kAdd>
HWY_INLINE void store4(V a, V b, V c, V d, const Rows& to, int at)
{
  transpose(a, b, c, d);
  put<kAdd>(Tag(), a, to.row[0] + at);
  put<kAdd>(Tag(), b, to.row[1] + at);
  put<kAdd>(Tag(), c, to.row[2] + at);
  put<kAdd>(Tag(), d, to.row[3] + at);
}
#else
/// Four columns of the rows, from column `at` on.
HWY_INLINE V4 load4(const Rows& from, int at)
{
  const Tag t;
  const V a = load(from.row[0] + at), b = load(from.row[1] + at), c = load(from.row[0] + at + 2), d = load(from.row[1] + at + 2);
  return {hn::InterleaveLower(t, a, b), hn::InterleaveUpper(t, a, b), hn::InterleaveLower(t, c, d), hn::InterleaveUpper(t, c, d)};
}

template <bool kAdd>
HWY_INLINE void store4(V a, V b, V c, V d, const Rows& to, int at)
{
  const Tag t;
  put<kAdd>(t, hn::InterleaveLower(t, a, b), to.row[0] + at);
  put<kAdd>(t, hn::InterleaveLower(t, c, d), to.row[0] + at + 2);
  put<kAdd>(t, hn::InterleaveUpper(t, a, b), to.row[1] + at);
  put<kAdd>(t, hn::InterleaveUpper(t, c, d), to.row[1] + at + 2);
}
#endif

/// Rows of six, contiguous: two of these take the middle columns twice.
struct V6
{
  V3 head, tail;
};

HWY_INLINE V6 load6(const Rows& from)
{
  const V4 p = load4(from, 0), q = load4(from, 2);
  return {{p.a, p.b, p.c}, {p.d, q.c, q.d}};
}

/// From column `at` on.
HWY_INLINE void store6(const V3& head, const V3& tail, const Rows& to, int at)
{
  store4<false>(head.x, head.y, head.z, tail.x, to, at);
  store4<false>(head.z, tail.x, tail.y, tail.z, to, at + 2);
}

HWY_INLINE V6 mul_add(V a, const V6& b, const V6& c)
{
  return {mul_add(a, b.head, c.head), mul_add(a, b.tail, c.tail)};
}

// Of columns, those from `kind` on, the numbers of node or element i and what follows it.
HWY_INLINE V3 load3(const NumberColumns& from, int kind, int i)
{
  return {load(from[kind] + i), load(from[kind + 1] + i), load(from[kind + 2] + i)};
}

HWY_INLINE Quaternion load_quaternion(const NumberColumns& from, int kind, int i)
{
  return {load(from[kind] + i), load(from[kind + 1] + i), load(from[kind + 2] + i), load(from[kind + 3] + i)};
}

HWY_INLINE void store(V v, NumberColumns& to, int kind, int i)
{
  hn::StoreU(v, Tag(), to[kind] + i);
}

HWY_INLINE void store(const V3& v, NumberColumns& to, int kind, int i)
{
  store(v.x, to, kind, i);
  store(v.y, to, kind + 1, i);
  store(v.z, to, kind + 2, i);
}
