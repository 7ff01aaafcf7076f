// SPDX-License-Identifier: BSD-3-Clause
// Numbers of several nodes or elements from and to rows of memory, one row each. Part of math/lanes.h, which includes it where
// the vectors are known; no include guard, for the same reason.

/// Rows of memory to write to, a node's or an element's each; those that are not used go to a spare one.
struct Rows
{
  double* row[kLanes];
};

/// And to read from.
struct ConstRows
{
  const double* row[kLanes];
};

/// `count` rows of `numbers` each, one behind the other; the others are `spare`, which takes what is not used.
HWY_INLINE Rows rows(double* first, int numbers, int count, double* spare)
{
  Rows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = k < count ? first + k * numbers : spare;
  return out;
}

/// The same to read from: those behind the last are the last one.
HWY_INLINE ConstRows rows(const double* first, int numbers, int count)
{
  ConstRows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = first + (k < count ? k : count - 1) * numbers;
  return out;
}

/// Of `count` values in a row that part to which get(value) points.
template <class T, class Get>
HWY_INLINE ConstRows rows_of(const T* first, int count, Get get)
{
  ConstRows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = get(first[k < count ? k : count - 1]);
  return out;
}

template <class T, class Get>
HWY_INLINE Rows rows_to(T* first, int count, double* spare, Get get)
{
  Rows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = k < count ? get(first[k]) : spare;
  return out;
}

// Registers of two numbers, of which each other consists.
using Tag2 = hn::CappedTag<double, 2>;
using Pair = hn::Vec<Tag2>;
constexpr int kPairs = kLanes / 2;

#if HWY_TARGET == HWY_AVX3
HWY_INLINE V join(const Pair (&p)[kPairs])
{
  const hn::CappedTag<double, 4> half;
  return hn::Combine(Tag(), hn::Combine(half, p[3], p[2]), hn::Combine(half, p[1], p[0]));
}

HWY_INLINE void part(V v, Pair (&p)[kPairs])
{
  const hn::CappedTag<double, 4> half;
  const auto low = hn::LowerHalf(half, v), high = hn::UpperHalf(half, v);
  p[0] = hn::LowerHalf(Tag2(), low);
  p[1] = hn::UpperHalf(Tag2(), low);
  p[2] = hn::LowerHalf(Tag2(), high);
  p[3] = hn::UpperHalf(Tag2(), high);
}
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE V join(const Pair (&p)[kPairs])
{
  return hn::Combine(Tag(), p[1], p[0]);
}

HWY_INLINE void part(V v, Pair (&p)[kPairs])
{
  p[0] = hn::LowerHalf(Tag2(), v);
  p[1] = hn::UpperHalf(Tag2(), v);
}
#else
HWY_INLINE V join(const Pair (&p)[kPairs])
{
  return p[0];
}

HWY_INLINE void part(V v, Pair (&p)[kPairs])
{
  p[0] = v;
}
#endif

HWY_INLINE Pair pair_of(const double* low, const double* high)
{
  return hn::InterleaveLower(Tag2(), hn::Set(Tag2(), *low), hn::Set(Tag2(), *high));
}

/// The first number of each row.
HWY_INLINE V load1(const ConstRows& from)
{
  Pair x[kPairs];
  for (int k = 0; k < kPairs; ++k) x[k] = pair_of(from.row[2 * k], from.row[2 * k + 1]);
  return join(x);
}

/// The first three: no more is read.
HWY_INLINE V3 load3(const ConstRows& from)
{
  Pair x[kPairs], y[kPairs], z[kPairs];
  for (int k = 0; k < kPairs; ++k)
  {
    const double *low = from.row[2 * k], *high = from.row[2 * k + 1];
    const Pair a = hn::LoadU(Tag2(), low), b = hn::LoadU(Tag2(), high);
    x[k] = hn::InterleaveLower(Tag2(), a, b);
    y[k] = hn::InterleaveUpper(Tag2(), a, b);
    z[k] = pair_of(low + 2, high + 2);
  }
  return {join(x), join(y), join(z)};
}

HWY_INLINE void store1(V v, const Rows& to)
{
  HWY_ALIGN double numbers[kLanes];
  hn::Store(v, Tag(), numbers);
  for (int k = 0; k < kLanes; ++k) *to.row[k] = numbers[k];
}

/// From column `at` on.
HWY_INLINE void store2(V a, V b, const Rows& to, int at)
{
  Pair x[kPairs], y[kPairs];
  part(a, x);
  part(b, y);
  for (int k = 0; k < kPairs; ++k)
  {
    hn::StoreU(hn::InterleaveLower(Tag2(), x[k], y[k]), Tag2(), to.row[2 * k] + at);
    hn::StoreU(hn::InterleaveUpper(Tag2(), x[k], y[k]), Tag2(), to.row[2 * k + 1] + at);
  }
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
HWY_INLINE V4 load4(const ConstRows& from, int at)
{
  const Tag4 t;
  Half a = hn::LoadU(t, from.row[0] + at), b = hn::LoadU(t, from.row[1] + at);
  Half c = hn::LoadU(t, from.row[2] + at), d = hn::LoadU(t, from.row[3] + at);
  Half e = hn::LoadU(t, from.row[4] + at), f = hn::LoadU(t, from.row[5] + at);
  Half g = hn::LoadU(t, from.row[6] + at), h = hn::LoadU(t, from.row[7] + at);
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
HWY_INLINE V4 load4(const ConstRows& from, int at)
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
HWY_INLINE V4 load4(const ConstRows& from, int at)
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

/// The first three: no more is written.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE void store3(const V3& v, const Rows& to)
{
  const Tag4 t;
  const auto three = hn::FirstN(t, 3);
  const auto put_half = [&](Half x, Half y, Half z, int first)
  {
    Half spare = z;
    transpose(x, y, z, spare);
    hn::BlendedStore(x, three, t, to.row[first]);
    hn::BlendedStore(y, three, t, to.row[first + 1]);
    hn::BlendedStore(z, three, t, to.row[first + 2]);
    hn::BlendedStore(spare, three, t, to.row[first + 3]);
  };
  put_half(hn::LowerHalf(t, v.x), hn::LowerHalf(t, v.y), hn::LowerHalf(t, v.z), 0);
  put_half(hn::UpperHalf(t, v.x), hn::UpperHalf(t, v.y), hn::UpperHalf(t, v.z), 4);
}
#else
HWY_INLINE void store3(const V3& v, const Rows& to)
{
  store2(v.x, v.y, to, 0);
  HWY_ALIGN double z[kLanes];
  hn::Store(v.z, Tag(), z);
  for (int k = 0; k < kLanes; ++k) to.row[k][2] = z[k];
}
#endif

/// Rows of six: two of these take the middle columns twice.
HWY_INLINE V6 load6(const ConstRows& from)
{
  const V4 p = load4(from, 0), q = load4(from, 2);
  return {{p.a, p.b, p.c}, {p.d, q.c, q.d}};
}

HWY_INLINE void store6(const V6& v, const Rows& to)
{
  store4<false>(v.head.x, v.head.y, v.head.z, v.tail.x, to, 0);
  store2(v.tail.y, v.tail.z, to, 4);
}

HWY_INLINE Quaternion load_quaternion(const ConstRows& from)
{
  const V4 q = load4(from, 0);
  return {q.a, q.b, q.c, q.d};
}
