// Text of the load on the wall of guided pipe (guided_string.h) for numbers of type V (math/vector_text.h). No include guard: it is another text for each V.

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
