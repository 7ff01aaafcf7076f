// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H
#define DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H

namespace drill_rig_sim
{
/// Longest elements of a string. A joint that begins below `change` has `lower`, a joint above it `upper`. Below `pushed_change`
/// it has `pushed`, below `by_bit_change` it has `by_bit`, if that is shorter. Above `guided_change` it has `guided`, if that is
/// longer: two joints that fit in this length are one element. In the last part, both joints must be of one stand, because
/// connections break the string at the ends of stands.
struct ElementLengths
{
  double lower = 9.5;          ///< [m]
  double upper = 9.5;          ///< [m]
  double change = 0.0;         ///< distance from the bit's face [m]
  double pushed = 9.5;         ///< [m]
  double pushed_change = 0.0;  ///< distance from the bit's face [m]
  double by_bit = 9.5;         ///< [m]
  double by_bit_change = 0.0;  ///< distance from the bit's face [m]
  double guided = 0.0;         ///< [m]
  double guided_change = 0.0;  ///< distance from the bit's face [m]
  int stand = 1;               ///< joints of the last part in a stand
  double start_length = 0.0;  ///< of the string as it is first built, bit's face to top-drive shaft: stands are counted down from
                              ///< its uppermost joint [m]

  /// Of a joint whose lower end is `from_bit` above the bit's face [m].
  double at(double from_bit) const noexcept
  {
    double length = from_bit < change ? lower : upper;
    if (from_bit < by_bit_change && by_bit < length) length = by_bit;
    if (from_bit < pushed_change && pushed < length) length = pushed;
    return from_bit >= guided_change && guided > length ? guided : length;
  }
};

/// `length` everywhere [m].
constexpr ElementLengths uniform_elements(double length) noexcept
{
  return {length, length, 0.0, length, 0.0, length, 0.0, 0.0, 0.0, 1, 0.0};
}

}  // namespace drill_rig_sim

#endif
