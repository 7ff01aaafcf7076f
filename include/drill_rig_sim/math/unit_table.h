#ifndef DRILL_RIG_SIM_MATH_UNIT_TABLE_H
#define DRILL_RIG_SIM_MATH_UNIT_TABLE_H

#include <string>
#include <vector>

/// THE table of units that input may be in: each by its quantity, with its factor to the SI unit.
namespace drill_rig_sim
{
/// Exact by definition: pound and foot by the international agreement of 1959, standard gravity by the 3rd CGPM (1901), the US gallon as
/// 231 cubic inches, the UK gallon by the Weights and Measures Act 1985 (all in NIST SP 811, appendix B). In long double, so that
/// `5 in` and `0.127 m` become the same double.
namespace exact
{
constexpr long double foot = 0.3048L;                     ///< [m]
constexpr long double inch = 0.0254L;                     ///< [m]
constexpr long double pound = 0.45359237L;                ///< [kg]
constexpr long double gravity = 9.80665L;                 ///< [m/s2]
constexpr long double pound_force = pound * gravity;      ///< [N]
constexpr long double psi = pound_force / (inch * inch);  ///< [Pa]
constexpr long double gallon = 231.0L * inch * inch * inch;  ///< US [m3]
constexpr long double uk_gallon = 4.54609e-3L;            ///< [m3]
constexpr long double barrel = 42.0L * gallon;            ///< of oil [m3]
constexpr long double turn = 6.28318530717958647692528676655900577L;  ///< [rad]
}  // namespace exact

/// One spelling of a unit.
struct UnitName
{
  const char* name;     ///< as plain_unit() spells it
  long double si;       ///< SI units in one of it
  bool listed = true;   ///< messages name it; the others are further spellings
};

/// The units of one quantity, the SI unit first.
struct UnitFamily
{
  const char* quantity;  ///< with its article: "a pressure"
  std::vector<UnitName> units;
};

/// All families. A spelling may belong to several (psi: a pressure, an energy per volume); the first is what messages call it.
const std::vector<UnitFamily>& unit_families();

/// A unit without what is only a habit of writing: "N m", "N-m", "N*m" and "N·m" are "N.m"; "m^3" and "m³" are "m3"; "N s/m per m" is
/// "N.s/m/m"; "°" is "deg".
std::string plain_unit(const std::string& spelling);

/// The unit of this plain spelling in a family; nullptr if it has none.
const UnitName* find_unit(const UnitFamily& family, const std::string& plain);

/// The first family that has a unit of this plain spelling; nullptr if none has.
const UnitFamily* family_of(const std::string& plain);

/// What a spelling may mean that is refused because it has several meanings (tonf, gal, mPa); empty for any other.
const std::vector<const char*>& meanings_of(const std::string& plain);

}  // namespace drill_rig_sim

#endif
