// SPDX-License-Identifier: BSD-3-Clause
// Matrices of 3 x 3 as sums of dyads, for numbers of type V; behind math/vector_text.h. No include guard: it is another text for
// each V.

struct M3
{
  V m[3][3];
};

/// a b^T + c d^T
DRILL_LAW M3 dyads(const V3& a, const V3& b, const V3& c, const V3& d)
{
  const auto row = [&](V p, V q, V* out)
  {
    out[0] = mul_add(p, b.x, q * d.x);
    out[1] = mul_add(p, b.y, q * d.y);
    out[2] = mul_add(p, b.z, q * d.z);
  };
  M3 out;
  row(a.x, c.x, out.m[0]);
  row(a.y, c.y, out.m[1]);
  row(a.z, c.z, out.m[2]);
  return out;
}

/// Adds a b^T.
DRILL_LAW void add_dyad(const V3& a, const V3& b, M3& out)
{
  const auto row = [&](V p, V* to)
  {
    to[0] = mul_add(p, b.x, to[0]);
    to[1] = mul_add(p, b.y, to[1]);
    to[2] = mul_add(p, b.z, to[2]);
  };
  row(a.x, out.m[0]);
  row(a.y, out.m[1]);
  row(a.z, out.m[2]);
}

/// Adds skew(v) + `diagonal` 1.
DRILL_LAW void add_skew(const V3& v, V diagonal, M3& out)
{
  out.m[0][0] = out.m[0][0] + diagonal;
  out.m[1][1] = out.m[1][1] + diagonal;
  out.m[2][2] = out.m[2][2] + diagonal;
  out.m[1][0] = out.m[1][0] + v.z;
  out.m[0][1] = out.m[0][1] - v.z;
  out.m[0][2] = out.m[0][2] + v.y;
  out.m[2][0] = out.m[2][0] - v.y;
  out.m[2][1] = out.m[2][1] + v.x;
  out.m[1][2] = out.m[1][2] - v.x;
}

DRILL_LAW M3 operator+(const M3& a, const M3& b)
{
  M3 out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.m[i][j] = a.m[i][j] + b.m[i][j];
  return out;
}
