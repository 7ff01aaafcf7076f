// SPDX-License-Identifier: BSD-3-Clause
// Text of the mud's drag on a node (model/forces/mud_drag.h) for numbers of type V, behind rig/rigid_body_text.h. No include
// guard: it is another text for each V.

/// Coefficients of a node.
struct MudDrag
{
  V across;     // [N s/m]
  V along;      // along the string, less what acts across it [N s/m]
  V about;      // [N m s/rad]
  V quadratic;  // across the string [N s2/m2]
};

/// @param n  the string's direction at the start of the step, with every method
DRILL_LAW V6 mud_force(const MudDrag& drag, const V3& n, const V6& rate)
{
  const V along = dot(n, rate.head);
  const V3 sideways = mul_sub_from(along, n, rate.head);
  const V by_speed = drag.quadratic * norm(sideways);
  return {mul_add(drag.across, rate.head, mul_add(drag.along * along, n, by_speed * sideways)),
          (drag.about * dot(n, rate.tail)) * n};
}

/// Slope of its force by the node's increment, with `other` added: of |v| v, v across the string, |v| (1 - n n^T) + v v^T/|v|.
DRILL_LAW M3 mud_slope(const MudDrag& drag, const V3& n, const V6& rate, V dv_du, const AlongAndAcross& other)
{
  const V3 sideways = in_plane(n, rate.head);
  const V speed = norm(sideways), by_speed = drag.quadratic * speed, zero = all(0.0);
  const AlongAndAcross slope = other + AlongAndAcross{dv_du * (drag.along - by_speed), dv_du * (drag.across + by_speed)};
  M3 out = dyads(slope.nn * n, n, (dv_du * drag.quadratic / larger(speed, all(1e-300))) * sideways, sideways);
  add_skew({zero, zero, zero}, slope.one, out);
  return out;
}

/// And of its moment.
DRILL_LAW AlongAndAcross mud_turning_slope(const MudDrag& drag, V dv_du)
{
  return {dv_du * drag.about, all(0.0)};
}
