// SPDX-License-Identifier: BSD-3-Clause
// Text of normal_law.h for numbers of type V (math/vector_text.h). No include guard: it is another text for each V.

/// NormalForce.
struct Pressed
{
  V value, stiffness, damping;
};

/// F = max(0, k delta^e (1 + c_d delta')), delta >= 0, and its derivatives.
DRILL_LAW Pressed pressed(V stiffness, V exponent, V damping, V penetration, V rate)
{
  const V zero = all(0.0), one = all(1.0);
  const V factor = larger(mul_add(damping, rate, one), zero);
  const V slope = select_or_zero(factor > zero, stiffness * power_of(penetration, exponent - one));  // elastic force / delta
  return {slope * penetration * factor, exponent * slope * factor, slope * penetration * damping};
}
