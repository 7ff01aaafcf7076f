// SPDX-License-Identifier: BSD-3-Clause
// Text of a hole's curve (hole_segment.h) and of its point closest to another (Wellbore::locate()) for numbers of type V
// (math/vector_text.h); symbols as there. No include guard: it is another text for each V.

/// c(s)
struct Cubic
{
  V3 c0, c1, c2, c3;
};

DRILL_LAW V3 centre_of(const Cubic& g, V s)
{
  return mul_add(s, mul_add(s, mul_add(s, g.c3, g.c2), g.c1), g.c0);
}

/// c'(s)
DRILL_LAW V3 slope_of(const Cubic& g, V s)
{
  return mul_add(s, mul_add(all(2.0), g.c2, (all(3.0) * s) * g.c3), g.c1);
}

/// Where the point's cross section meets a segment's curve, extended beyond its ends.
struct Foot
{
  V s;
  V3 centre, first, second;  // c, c', c'' by s
  V decline;                 // -f'(s) = |c'|^2 - (r_D - c) . c''
};

/// A step of Newton's method from foot.s, whose curve it leaves in the foot. Beyond the centre of curvature f' changes sign; a
/// tenth of |c'|^2 keeps the step bounded and downhill.
DRILL_LAW V newton_step(const Cubic& g, const V3& point, Foot& foot)
{
  foot.second = mul_add(all(6.0) * foot.s, g.c3, all(2.0) * g.c2);
  foot.first = slope_of(g, foot.s);
  foot.centre = centre_of(g, foot.s);
  const V3 offset = point - foot.centre;
  const V speed2 = dot(foot.first, foot.first);
  foot.decline = larger(speed2 - dot(offset, foot.second), all(0.1) * speed2);
  return dot(offset, foot.first) / foot.decline;
}

/// The last step is so short that Taylor's first term takes the foot along.
DRILL_LAW void take_along(V step, Foot& foot)
{
  foot.centre = mul_add(step, foot.first, foot.centre);
  foot.first = mul_add(step, foot.second, foot.first);
}

/// What is linear in s.
struct HoleNumbers
{
  V md, length, radius, radius_change, friction, friction_change, section, section_change;
};

/// ClosestPoint. A foot beside its segment, as far from the hole or at a kink: the hole goes on as it ends, not to a radius below
/// zero.
struct Closest
{
  V md;
  V3 tangent, slope, gradient;
  V radius, radius_slope, friction, section;
};

DRILL_LAW Closest closest_of(const HoleNumbers& g, const Foot& foot)
{
  const V zero = all(0.0), one = all(1.0), inverse_length = one / g.length, share = smaller(larger(foot.s, zero), one);
  return {mul_add(foot.s, g.length, g.md),
          (one / norm(foot.first)) * foot.first,
          inverse_length * foot.first,
          (g.length / foot.decline) * foot.first,
          mul_add(share, g.radius_change, g.radius),
          select_or_zero(share == foot.s, g.radius_change * inverse_length),
          mul_add(share, g.friction_change, g.friction),
          mul_add(share, g.section_change, g.section)};
}
