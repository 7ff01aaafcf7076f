// SPDX-License-Identifier: BSD-3-Clause
// Vectors of three with a number of several nodes or elements in each component, and their way from and to rows of memory.
// Included by a source of batch kernels inside its namespace, once for each set of instructions (math/simd.h); no include guard,
// therefore.

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

HWY_INLINE V smaller(V a, V b)
{
  return hn::Min(a, b);
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
// behind it
#include "drill_rig_sim/math/matrix_text.h"

// from and to rows of memory
#include "math/lane_rows.h"

// Of columns the numbers of node or element i and what follows it.
HWY_INLINE V load(const Column& from, int i)
{
  return load(from.data() + i);
}

HWY_INLINE V3 load3(const Columns<3>& from, int i)
{
  return {load(from.part[0], i), load(from.part[1], i), load(from.part[2], i)};
}

HWY_INLINE V6 load6(const Columns<6>& from, int i)
{
  return {{load(from.part[0], i), load(from.part[1], i), load(from.part[2], i)},
          {load(from.part[3], i), load(from.part[4], i), load(from.part[5], i)}};
}

HWY_INLINE Quaternion load_quaternion(const Columns<4>& from, int i)
{
  return {load(from.part[0], i), load(from.part[1], i), load(from.part[2], i), load(from.part[3], i)};
}

HWY_INLINE void store(V v, Column& to, int i)
{
  hn::StoreU(v, Tag(), to.data() + i);
}

HWY_INLINE void store(const V3& v, Columns<3>& to, int i)
{
  store(v.x, to.part[0], i);
  store(v.y, to.part[1], i);
  store(v.z, to.part[2], i);
}

HWY_INLINE void store(const V6& v, Columns<6>& to, int i)
{
  store(v.head.x, to.part[0], i);
  store(v.head.y, to.part[1], i);
  store(v.head.z, to.part[2], i);
  store(v.tail.x, to.part[3], i);
  store(v.tail.y, to.part[4], i);
  store(v.tail.z, to.part[5], i);
}

HWY_INLINE void store(const Quaternion& q, Columns<4>& to, int i)
{
  store(q.x, to.part[0], i);
  store(q.y, to.part[1], i);
  store(q.z, to.part[2], i);
  store(q.w, to.part[3], i);
}
