// SPDX-License-Identifier: BSD-3-Clause
// Exponentials and powers for the laws' texts (math/vector_text.h); behind math/lanes.h, in sources that include
// <hwy/contrib/math/math-inl.h>. No include guard: it is included once for each set of instructions.

HWY_INLINE V exp_of(V a)
{
  return hn::Exp(Tag(), a);
}

/// Of an exponent of 1/2 only: that of Hertz' law less 1.
HWY_INLINE V power_of(V a, V)
{
  return hn::Sqrt(a);
}
