// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_KEY_TABLE_H
#define DRILL_RIG_SIM_SRC_SCENE_KEY_TABLE_H

#include <cstring>
#include <string>
#include <variant>
#include <vector>

#include "drill_rig_sim/math/units.h"

/// How the table of scene keys is written: one row per key. The reader and the reference both walk the same rows.
namespace drill_rig_sim
{
/// Allowed values, in the key's own unit.
struct Range
{
  double low = 0.0;
  double high = 0.0;
  bool low_open = false;   ///< `low` itself is not allowed
  bool high_open = false;  ///< `high` itself is not allowed
};

/// Of a key that is not a number.
constexpr Range none{};

constexpr Range between(double low, double high)
{
  return {low, high, false, false};
}
constexpr Range above(double low, double high)
{
  return {low, high, true, false};
}
constexpr Range below(double low, double high)
{
  return {low, high, false, true};
}

/// One word of a list, kept as an enumerator (or whatever set and get translate it to).
template <class Spec>
struct Choice
{
  std::vector<const char*> words;
  void (*set)(Spec&, int word);
  int (*get)(const Spec&);
};

/// A list of words, each at most once, kept as a sum of powers of two: the first word is 1.
template <class Spec>
struct WordSet
{
  std::vector<const char*> words;
  unsigned Spec::*member;
};

/// A whole number, or the word `fill`, kept as 0.
template <class Spec>
struct CountOrFill
{
  int Spec::*member;
};

/// true or false, kept as 1 or 0.
template <class Spec>
struct Flag
{
  double Spec::*member;
};

/// A number that lies deeper in the struct than in the file.
template <class Spec>
struct Inside
{
  double& (*ref)(Spec&);
};

/// A block or list with a table of its own.
struct Nested
{
};

template <class Spec>
using Field = std::variant<double Spec::*, int Spec::*, std::string Spec::*, Choice<Spec>, WordSet<Spec>, CountOrFill<Spec>,
                           Flag<Spec>, Inside<Spec>, Nested>;

/// Bits of the kinds (of string part, of bit law) that a row belongs to.
constexpr unsigned every_kind = ~0u;
/// As Key::required: each kind that may have the key must have it.
constexpr unsigned must = every_kind;
constexpr unsigned no_kind = 0u;

/// One row.
template <class Spec>
struct Key
{
  const char* name;
  const char* unit;
  Field<Spec> field;
  Range allowed;  ///< numbers only
  const char* meaning;
  unsigned required = no_kind;             ///< kinds that must have it
  unsigned kinds = every_kind;             ///< kinds that may have it
  const char* computed_default = nullptr;  ///< says how a default that depends on other keys comes about
};

/// A block of the scene file.
template <class Spec>
struct Table
{
  const char* block;    ///< its place, as messages and the reference name it
  const char* meaning;  ///< one sentence
  std::vector<Key<Spec>> keys;
};

/// What one unit of a key is in the unit of the struct: keys that end in _deg or _rpm hold radians or rad/s there.
inline double unit_of(const char* key)
{
  const std::size_t n = std::strlen(key);
  if (n > 4 && std::strcmp(key + n - 4, "_deg") == 0) return degree;
  if (n > 4 && std::strcmp(key + n - 4, "_rpm") == 0) return rpm;
  return 1.0;
}

/// "0 to 5", "above 0, up to 5", ...
std::string to_text(const Range& range);
/// "a, b or c"
std::string to_text(const std::vector<const char*>& words);

}  // namespace drill_rig_sim

#endif
