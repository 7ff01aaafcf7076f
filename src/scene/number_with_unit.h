// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_NUMBER_WITH_UNIT_H
#define DRILL_RIG_SIM_SRC_SCENE_NUMBER_WITH_UNIT_H

#include <string>

/// Numbers of a scene as a person writes them, with their unit where they have one: `0.127`, `5 in`, `30klbf`.
namespace drill_rig_sim
{
/// A number as it stands in the text.
struct WrittenNumber
{
  double value = 0.0;
  long double exact = 0.0L;  ///< the same, closer to its decimal digits
  std::string unit;          ///< as plain_unit() spells it; empty: none is given
};

/// The unit of a key's number.
struct InputUnit
{
  std::string name;           ///< empty: the key's own unit
  long double factor = 1.0L;  ///< units of the key in it
  long double zero = 0.0L;    ///< its number at 0 of the key's unit: 32 of degF for a key in degC
  double number = 0.0;        ///< as it is given, in this unit
  long double in_key_unit(long double given) const { return (given - zero) * factor; }
  double from_key_unit(double value) const { return static_cast<double>(value / factor + zero); }
};

/// Splits a text into a decimal number and what may be a unit, whatever the process's locale; false if it is no such text.
bool split_number(const std::string& text, WrittenNumber& number);

/// The unit of a number for a key whose own unit is `key_unit`, as the table of keys spells it. Returns what is wrong, with the
/// allowed units, or "".
std::string find_input_unit(const WrittenNumber& number, const std::string& key_unit, InputUnit& unit);

/// A message about a key in its own unit, with all its numbers of this unit in the unit of the input.
std::string in_input_unit(const std::string& message, const std::string& key_unit, const InputUnit& unit);

}  // namespace drill_rig_sim

#endif
