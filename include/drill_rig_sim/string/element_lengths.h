#ifndef DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H
#define DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H

namespace drill_rig_sim
{
/// How long a string's elements are at most: joints that begin below `change` are cut to `lower`, those above it to `upper`, and those below
/// `pushed_change` to `pushed`, if that is shorter.
struct ElementLengths
{
  double lower = 9.5;   ///< [m]
  double upper = 9.5;   ///< [m]
  double change = 0.0;  ///< distance from the bit's face [m]
  double pushed = 9.5;  ///< [m]
  double pushed_change = 0.0;  ///< distance from the bit's face [m]

  /// Of a joint whose lower end is `from_bit` above the bit's face [m].
  double at(double from_bit) const noexcept
  {
    const double length = from_bit < change ? lower : upper;
    return from_bit < pushed_change && pushed < length ? pushed : length;
  }
};

/// `length` everywhere [m].
constexpr ElementLengths uniform_elements(double length) noexcept
{
  return {length, length, 0.0, length, 0.0};
}

}  // namespace drill_rig_sim

#endif
