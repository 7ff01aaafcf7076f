// SPDX-License-Identifier: BSD-3-Clause
// Text of the guided string's laws (guided_string.h) for numbers of type V, behind contact/friction_text.h. V2: along the hole
// and about it. No include guard: it is another text for each V.

struct GuidedLoad
{
  V3 direction;      // P/|P|, less where it changes sides [-]
  V size, normal;    // Q, N [N]
  V normal_by_size;  // dN/dQ [-]
};

/// Q = sqrt(P^2 + q^2) - q, smooth where the load changes sides, and N = sqrt(Q^2 - F_c^2), at least Q/sqrt(1 + mu^2).
/// @param push  P [N]
/// @param held  F_c, by friction around the pipe [N]
DRILL_LAW GuidedLoad guided_load(const V3& push, V friction, V held)
{
  const V zero = all(0.0), one = all(1.0), smooth = all(1.0);  // q [N]
  const V smoothed = sqrt_of(mul_add(smooth, smooth, dot(push, push))), size = smoothed - smooth;
  const V square = size * size, least = square / mul_add(friction, friction, one), left = neg_mul_add(held, held, square);
  const V normal = sqrt_of(larger(left, least));
  const Mask bears = left > least;
  const V ratio = select(bears, size, normal) / select(bears, normal, size);
  return {(one / smoothed) * push, size, normal, select(normal > zero, ratio, one)};
}

/// P of the guided string only: tensions above and below by the elements' directions, and weight, across the hole.
DRILL_LAW V3 guided_push(const V3& tangent, V above, const V3& above_direction, V below, const V3& below_direction,
                         const V3& weight)
{
  return in_plane(tangent, mul_add(above, above_direction, mul_sub_from(below, below_direction, weight)));
}

/// The element between two guided nodes.
struct GuidedElement
{
  V axial, torsion, stretch, twist;  // EA/L, GJ/L; at the start of the step
};

/// Tension and torque. `closed`: how far the lower end has moved less the upper one, since then.
DRILL_LAW V2 guided_elastic(const GuidedElement& element, const V2& closed)
{
  return {element.axial * (element.stretch + closed.x), element.torsion * (element.twist + closed.y)};
}

/// And what structural damping over a time [s] adds at the rate of that.
DRILL_LAW V2 guided_damping(const GuidedElement& element, V time, const V2& closing)
{
  return {time * element.axial * closing.x, time * element.torsion * closing.y};
}

/// What moves, and the mud around it.
struct GuidedNode
{
  V mass, spin_inertia, mud_along, mud_about;
};

DRILL_LAW V2 guided_inertia(const GuidedNode& node, const V2& acceleration)
{
  return {node.mass * acceleration.x, node.spin_inertia * acceleration.y};
}

DRILL_LAW V2 guided_mud(const GuidedNode& node, const V2& rate)
{
  return {node.mud_along * rate.x, node.mud_about * rate.y};
}

/// Friction on the wall, at the rim.
struct GuidedFriction
{
  Rubbed<V2> rubbed;
  V2 velocity;
  Mask there, sticks;
};

/// @param before, moved, rate  bristle at the start of the step; move of the rim since then and its rate
DRILL_LAW GuidedFriction guided_friction(const Rubbing& law, V normal, const V2& before, const V2& moved, const V2& rate, V time)
{
  const V zero = all(0.0);
  const V2 none{zero, zero}, stretched = before + moved;
  const V2 trial = mul_add(law.stiffness, stretched, law.damping * rate);
  Rubbed<V2> r = rubbed(
      law, normal, trial, stretched, [&] { return rate; }, [&] { return before; }, time);
  const Mask there = both(normal > zero, law.kinetic > zero);
  r.force = choose(there, r.force, none);
  r.bristle = choose(there, r.bristle, none);
  return {r, rate, there, both(there, opposite(r.slipping))};
}

/// Slopes of a friction by the rim's move, row by row, and by the load on the wall.
struct GuidedSlopes
{
  V2 first_row, second_row, by_load;
};

DRILL_LAW GuidedSlopes guided_slopes(const Rubbing& law, const GuidedLoad& load, const GuidedFriction& f, V dv_du)
{
  const V zero = all(0.0);
  const V2 none{zero, zero};
  const RubbedSlopes by = slopes_of(law, load.normal, f.rubbed, f.velocity, dv_du);
  return {choose(f.there, by.first_row, none), choose(f.there, by.second_row, none),
          choose(f.there, load.normal_by_size * by.by_normal_force, none)};
}

/// The two rows of a node. `above`, `below`: tension and torque; `friction`: at the rim, with its lever; `weight`: along the
/// hole.
DRILL_LAW V2 guided_row(const GuidedNode& node, const V2& rate, const V2& acceleration, const V2& above, const V2& below,
                        V weight, const V2& friction, V lever)
{
  return guided_inertia(node, acceleration) + guided_mud(node, rate) + above - below -
         V2{weight + friction.x, lever * friction.y};
}

/// Their derivatives, row by row: by the node's own coordinates, by those of the node above and below.
struct GuidedBlocks
{
  V2 own_first, own_second, upper_first, upper_second, lower_first, lower_second;
};

/// @param above, below              EA/L and GJ/L of the elements, damping included; 0 where there is none
/// @param load_above, load_below    of the load on the wall by their tensions: direction of the load times direction of the
/// element
/// @param by_load                   of the rows by the load on the wall
DRILL_LAW GuidedBlocks guided_blocks(const GuidedNode& node, const GuidedSlopes& friction, V lever, const V2& above,
                                     const V2& below, V load_above, V load_below, const V2& by_load, V dv_du, V da_du)
{
  const V zero = all(0.0);
  const V2 own{mul_add(da_du, node.mass, dv_du * node.mud_along), mul_add(da_du, node.spin_inertia, dv_du * node.mud_about)};
  const V2 by_above = (load_above * above.x) * by_load, by_below = (load_below * below.x) * by_load;
  const V2 by_both = by_above + by_below;
  return {{own.x - friction.first_row.x + above.x + below.x + by_both.x, minus(lever * friction.first_row.y)},
          {by_both.y - lever * friction.second_row.x, own.y - lever * lever * friction.second_row.y + above.y + below.y},
          {minus(above.x) - by_above.x, zero},
          {minus(by_above.y), minus(above.y)},
          {minus(below.x) - by_below.x, zero},
          {minus(by_below.y), minus(below.y)}};
}
