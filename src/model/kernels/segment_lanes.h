// SPDX-License-Identifier: BSD-3-Clause
// A segment of the hole for each lane. Included inside the namespace of a source of batch kernels, behind math/lanes.h and
// well/locate_text.h, once for each set of instructions; no include guard, therefore.

struct Segments
{
  const HoleSegment* of[kLanes];
};

template <class Get>
HWY_INLINE ConstRows rows_of(const Segments& segments, Get get)
{
  ConstRows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = get(*segments.of[k]);
  return out;
}

HWY_INLINE V load(const Segments& from, double HoleSegment::*number)
{
  return load1(rows_of(from, [number](const HoleSegment& g) { return &(g.*number); }));
}

HWY_INLINE V3 load3(const Segments& from, Eigen::Vector3d HoleSegment::*vector)
{
  return load3(rows_of(from, [vector](const HoleSegment& g) { return (g.*vector).data(); }));
}

HWY_INLINE Cubic load_curve(const Segments& from)
{
  return {load3(from, &HoleSegment::c0), load3(from, &HoleSegment::c1), load3(from, &HoleSegment::c2),
          load3(from, &HoleSegment::c3)};
}

/// s at a depth.
HWY_INLINE V place_at(const Segments& from, V md)
{
  return (md - load(from, &HoleSegment::md)) / load(from, &HoleSegment::length);
}
