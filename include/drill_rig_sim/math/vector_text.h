// SPDX-License-Identifier: BSD-3-Clause
// Vectors whose components are numbers of a type V, so that one text of a law serves a double and the lanes of a register: the
// sources of batch kernels include it through math/lanes.h inside their namespace, one_lane.h for V = double. No include guard:
// it is another text for each V.
//
// What a V has: + - * /, comparisons that give a Mask, all(double), and mul_add (a b + c), mul_sub (a b - c), neg_mul_add (c - a
// b), minus, sqrt_of, exp_of, power_of, larger, smaller, select, select_or_zero, both, opposite, all_of.

struct V3
{
  V x, y, z;
};

DRILL_LAW V3 operator+(const V3& a, const V3& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

DRILL_LAW V3 operator-(const V3& a, const V3& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

DRILL_LAW V3 operator*(V a, const V3& b)
{
  return {a * b.x, a * b.y, a * b.z};
}

DRILL_LAW V3 operator-(const V3& a)
{
  return {minus(a.x), minus(a.y), minus(a.z)};
}

DRILL_LAW V dot(const V3& a, const V3& b)
{
  return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z));
}

DRILL_LAW V3 cross(const V3& a, const V3& b)
{
  return {mul_sub(a.y, b.z, a.z * b.y), mul_sub(a.z, b.x, a.x * b.z), mul_sub(a.x, b.y, a.y * b.x)};
}

/// a b + c
DRILL_LAW V3 mul_add(V a, const V3& b, const V3& c)
{
  return {mul_add(a, b.x, c.x), mul_add(a, b.y, c.y), mul_add(a, b.z, c.z)};
}

/// c - a b
DRILL_LAW V3 mul_sub_from(V a, const V3& b, const V3& c)
{
  return {neg_mul_add(a, b.x, c.x), neg_mul_add(a, b.y, c.y), neg_mul_add(a, b.z, c.z)};
}

DRILL_LAW V3 choose(Mask mask, const V3& yes, const V3& no)
{
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

/// Orientation; w last, as Eigen keeps it.
struct Quaternion
{
  V x, y, z, w;
};

DRILL_LAW Quaternion operator*(const Quaternion& a, const Quaternion& b)
{
  return {mul_add(a.w, b.x, mul_add(a.x, b.w, mul_sub(a.y, b.z, a.z * b.y))),
          mul_add(a.w, b.y, mul_add(a.y, b.w, mul_sub(a.z, b.x, a.x * b.z))),
          mul_add(a.w, b.z, mul_add(a.z, b.w, mul_sub(a.x, b.y, a.y * b.x))),
          neg_mul_add(a.x, b.x, neg_mul_add(a.y, b.y, mul_sub(a.w, b.w, a.z * b.z)))};
}

DRILL_LAW V3 x_axis(const Quaternion& q)
{
  const V two = all(2.0);
  return {neg_mul_add(two, mul_add(q.y, q.y, q.z * q.z), all(1.0)), two * mul_add(q.x, q.y, q.w * q.z),
          two * mul_sub(q.x, q.z, q.w * q.y)};
}

/// Two directions: along and around.
struct V2
{
  V x, y;
};

DRILL_LAW V2 operator+(const V2& a, const V2& b)
{
  return {a.x + b.x, a.y + b.y};
}

DRILL_LAW V2 operator-(const V2& a, const V2& b)
{
  return {a.x - b.x, a.y - b.y};
}

DRILL_LAW V2 operator*(V a, const V2& b)
{
  return {a * b.x, a * b.y};
}

DRILL_LAW V2 operator-(const V2& a)
{
  return {minus(a.x), minus(a.y)};
}

/// a b + c
DRILL_LAW V2 mul_add(V a, const V2& b, const V2& c)
{
  return {mul_add(a, b.x, c.x), mul_add(a, b.y, c.y)};
}

DRILL_LAW V2 choose(Mask mask, const V2& yes, const V2& no)
{
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}

DRILL_LAW V norm(const V2& v)
{
  return sqrt_of(mul_add(v.x, v.x, v.y * v.y));
}

DRILL_LAW V norm(const V3& v)
{
  return sqrt_of(dot(v, v));
}

/// v without its part along the unit vector n.
DRILL_LAW V3 in_plane(const V3& n, const V3& v)
{
  return mul_sub_from(dot(n, v), n, v);
}

/// Six numbers of a node: displacement and rotation, or force and moment.
struct V6
{
  V3 head, tail;
};

DRILL_LAW V6 operator+(const V6& a, const V6& b)
{
  return {a.head + b.head, a.tail + b.tail};
}

/// a b + c
DRILL_LAW V6 mul_add(V a, const V6& b, const V6& c)
{
  return {mul_add(a, b.head, c.head), mul_add(a, b.tail, c.tail)};
}
