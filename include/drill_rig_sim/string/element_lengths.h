#ifndef DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H
#define DRILL_RIG_SIM_STRING_ELEMENT_LENGTHS_H

namespace drill_rig_sim
{
/// How long a string's elements are at most: joints that begin below `change` are cut to `lower`, those above it to `upper`.
struct ElementLengths
{
  double lower = 9.5;   ///< [m]
  double upper = 9.5;   ///< [m]
  double change = 0.0;  ///< distance from the bit's face [m]

  /// Of a joint whose lower end is `from_bit` above the bit's face [m].
  double at(double from_bit) const noexcept { return from_bit < change ? lower : upper; }
};

/// `length` everywhere [m].
constexpr ElementLengths uniform_elements(double length) noexcept
{
  return {length, length, 0.0};
}

}  // namespace drill_rig_sim

#endif
