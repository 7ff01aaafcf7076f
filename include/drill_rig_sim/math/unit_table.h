// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_UNIT_TABLE_H
#define DRILL_RIG_SIM_MATH_UNIT_TABLE_H

#include <string>
#include <vector>

/// THE table of units that input may be in: each by its quantity, with its factor to the SI unit. Numbers of scenes and settings,
/// surveys, maps, records, WITSML and LAS are read by it, in C++ and in Python.
namespace drill_rig_sim
{
/// Exact by definition: pound and foot by the international agreement of 1959, standard gravity by the 3rd CGPM (1901), the US
/// gallon as 231 cubic inches, the UK gallon by the Weights and Measures Act 1985 (all in NIST SP 811, appendix B). In long
/// double, so that `5 in` and `0.127 m` become the same double.
namespace exact
{
constexpr long double foot = 0.3048L;                                 ///< [m]
constexpr long double inch = 0.0254L;                                 ///< [m]
constexpr long double pound = 0.45359237L;                            ///< [kg]
constexpr long double gravity = 9.80665L;                             ///< [m/s2]
constexpr long double pound_force = pound * gravity;                  ///< [N]
constexpr long double psi = pound_force / (inch * inch);              ///< [Pa]
constexpr long double gallon = 231.0L * inch * inch * inch;           ///< US [m3]
constexpr long double uk_gallon = 4.54609e-3L;                        ///< [m3]
constexpr long double barrel = 42.0L * gallon;                        ///< of oil [m3]
constexpr long double turn = 6.28318530717958647692528676655900577L;  ///< [rad]
}  // namespace exact

/// A unit of a quantity.
struct UnitName
{
  const char* name;            ///< its symbol as plain_unit() spells it, which messages show
  long double si;              ///< SI units in one of it
  const char* spellings = "";  ///< further ones as folded_unit() spells them, between blanks
  bool listed = true;          ///< messages name it among what is allowed; the others are rare
  long double zero = 0.0L;     ///< its number at 0 of the SI unit: 32 of degF. SI = (number - zero) si
  double factor() const { return static_cast<double>(si); }
};

/// Spellings that may be several units of a quantity: they are refused.
struct AmbiguousUnit
{
  const char* spellings;  ///< as folded_unit() spells them, between blanks
  const char* allowed;    ///< what to write instead, for a message
};

/// The units of one quantity, the SI unit first.
struct UnitFamily
{
  const char* quantity;  ///< with its article: "a pressure"
  std::vector<UnitName> units;
  std::vector<AmbiguousUnit> ambiguous = {};
};

/// What a spelling is in a family: a unit, or what it may be of several, or neither.
struct FoundUnit
{
  const UnitName* unit = nullptr;
  std::string choices;  ///< what to write instead of an ambiguous spelling; else empty
  bool any() const { return unit != nullptr || !choices.empty(); }
};

/// All families. A spelling may belong to several (psi: a pressure, an energy per volume); the first is what messages call it.
const std::vector<UnitFamily>& unit_families();

/// The family of a quantity by its name without the article, "pressure". Throws std::out_of_range where there is none.
const UnitFamily& units_of_quantity(const std::string& quantity);

/// A unit without what is only a habit of writing: "N m", "N-m", "N*m" and "N·m" are "N.m"; "m^3" and "m³" are "m3"; "N s/m per
/// m" is "N.s/m/m"; "°" is "deg"; "gal[US]" of Energistics is "galUS".
std::string plain_unit(const std::string& spelling);

/// A plain_unit() in small letters, with single points between its parts: "KFT_LBS" is "kft.lbs".
std::string folded_unit(const std::string& plain);

/// A family's unit by its symbol or by another spelling, in small or capital letters. A small m that would stand for mega is
/// ambiguous (mPa, mN).
FoundUnit find_unit(const UnitFamily& family, const std::string& spelling);

/// The first family that has a unit of this symbol, else the first that knows the spelling; nullptr if none does.
const UnitFamily* family_of(const std::string& spelling);

/// The symbols that messages name, "m, mm, cm": each followed by `suffix`.
std::string listed_units(const UnitFamily& family, const std::string& suffix = "");

}  // namespace drill_rig_sim

#endif
