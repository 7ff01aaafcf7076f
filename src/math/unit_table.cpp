#include "drill_rig_sim/math/unit_table.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace drill_rig_sim
{
namespace
{
constexpr bool other_spelling = false;
constexpr long double minute = 60.0L, hour = 3600.0L, day = 86400.0L;
constexpr long double litre = 1e-3L;
constexpr long double deg = exact::turn / 360.0L, rev_per_minute = exact::turn / 60.0L;
constexpr long double pound_foot = exact::pound_force * exact::foot;    // [N m]
constexpr long double pound_per_gallon = exact::pound / exact::gallon;  // [kg/m3]
constexpr long double short_ton = 2000.0L, long_ton = 2240.0L;          // in pounds

// clang-format off
std::vector<UnitFamily> all_families()
{
  using exact::barrel, exact::foot, exact::gallon, exact::gravity, exact::inch, exact::pound, exact::pound_force, exact::psi, exact::turn, exact::uk_gallon;
  return {
  {"a length", {{"m", 1.0L}, {"mm", 1e-3L}, {"cm", 1e-2L}, {"km", 1e3L}, {"ft", foot}, {"in", inch},
               {"feet", foot, other_spelling}, {"foot", foot, other_spelling}, {"inch", inch, other_spelling}, {"inches", inch, other_spelling},
               {"'", foot, other_spelling}, {"\"", inch, other_spelling}}},
  {"a mass", {{"kg", 1.0L}, {"g", 1e-3L}, {"t", 1e3L}, {"lbm", pound}, {"klbm", 1e3L * pound}, {"tonUS", short_ton * pound}, {"tonUK", long_ton * pound},
              {"lb", pound, other_spelling}, {"lbs", pound, other_spelling}, {"klb", 1e3L * pound, other_spelling}}},
  {"a time", {{"s", 1.0L}, {"ms", 1e-3L}, {"min", minute}, {"h", hour}, {"d", day}, {"hr", hour, other_spelling},
             {"sec", 1.0L, other_spelling}, {"seconds", 1.0L, other_spelling}, {"minutes", minute, other_spelling}, {"hour", hour, other_spelling},
             {"hours", hour, other_spelling}, {"days", day, other_spelling}}},
  {"an angle", {{"rad", 1.0L}, {"deg", deg}, {"rev", turn}, {"degree", deg, other_spelling}, {"degrees", deg, other_spelling}}},
  {"a force", {{"N", 1.0L}, {"daN", 10.0L}, {"kN", 1e3L}, {"MN", 1e6L}, {"kgf", gravity}, {"tf", 1e3L * gravity}, {"lbf", pound_force}, {"klbf", 1e3L * pound_force},
               {"tonfUS", short_ton * pound_force}, {"tonfUK", long_ton * pound_force},
               {"kdaN", 1e4L, other_spelling}, {"kkgf", 1e3L * gravity, other_spelling}, {"kip", 1e3L * pound_force, other_spelling},
               {"kips", 1e3L * pound_force, other_spelling}}},
  {"a torque", {{"N.m", 1.0L}, {"daN.m", 10.0L}, {"kN.m", 1e3L}, {"kgf.m", gravity}, {"lbf.in", pound_force * inch}, {"ft.lbf", pound_foot}, {"kft.lbf", 1e3L * pound_foot},
                {"lbf.ft", pound_foot, other_spelling}, {"klbf.ft", 1e3L * pound_foot, other_spelling},
                {"ft.lb", pound_foot, other_spelling}, {"kft.lb", 1e3L * pound_foot, other_spelling},
                {"ft.lbs", pound_foot, other_spelling}, {"lb.ft", pound_foot, other_spelling}, {"klb.ft", 1e3L * pound_foot, other_spelling},
                {"Nm", 1.0L, other_spelling}, {"daNm", 10.0L, other_spelling}, {"kNm", 1e3L, other_spelling}}},
  {"a pressure", {{"Pa", 1.0L}, {"kPa", 1e3L}, {"MPa", 1e6L}, {"GPa", 1e9L}, {"bar", 1e5L}, {"atm", 101325.0L}, {"kgf/cm2", 1e4L * gravity}, {"psi", psi}, {"ksi", 1e3L * psi},
                  {"lbf/100ft2", pound_force / (100.0L * foot * foot)},
                  {"kpsi", 1e3L * psi, other_spelling}, {"lb/100ft2", pound_force / (100.0L * foot * foot), other_spelling}}},
  {"an energy per volume", {{"J/m3", 1.0L}, {"MJ/m3", 1e6L}, {"Pa", 1.0L}, {"MPa", 1e6L}, {"psi", psi}, {"ksi", 1e3L * psi}}},
  {"a density", {{"kg/m3", 1.0L}, {"g/cm3", 1e3L}, {"ppg", pound_per_gallon}, {"lbm/ft3", pound / (foot * foot * foot)},
                 {"kg/L", 1e3L, other_spelling}, {"lb/ft3", pound / (foot * foot * foot), other_spelling}, {"lbm/galUS", pound_per_gallon, other_spelling},
                 {"kg/l", 1e3L, other_spelling}, {"g/cc", 1e3L, other_spelling}, {"pcf", pound / (foot * foot * foot), other_spelling}}},
  {"a viscosity", {{"Pa.s", 1.0L}, {"mPa.s", 1e-3L}, {"cP", 1e-3L}}},
  {"a speed", {{"m/s", 1.0L}, {"m/min", 1.0L / minute}, {"m/h", 1.0L / hour}, {"ft/s", foot}, {"ft/min", foot / minute}, {"ft/h", foot / hour},
               {"m/hr", 1.0L / hour, other_spelling}, {"ft/hr", foot / hour, other_spelling}}},
  {"an angular speed", {{"rad/s", 1.0L}, {"rpm", rev_per_minute}, {"deg/s", deg}, {"rev/s", turn}, {"rev/min", rev_per_minute, other_spelling}}},
  {"an angular acceleration", {{"rad/s2", 1.0L}, {"rpm/s", rev_per_minute}, {"deg/s2", deg}}},
  {"an acceleration", {{"m/s2", 1.0L}, {"ft/s2", foot}}},
  {"a flow", {{"m3/s", 1.0L}, {"m3/min", 1.0L / minute}, {"m3/h", 1.0L / hour}, {"L/s", litre}, {"L/min", litre / minute}, {"gpm", gallon / minute}, {"bbl/min", barrel / minute},
              {"galUS/min", gallon / minute, other_spelling}, {"galUK/min", uk_gallon / minute},
              {"l/s", litre, other_spelling}, {"l/min", litre / minute, other_spelling}, {"lpm", litre / minute, other_spelling}, {"bpm", barrel / minute, other_spelling}}},
  {"a change of flow", {{"m3/s2", 1.0L}, {"L/s2", litre}, {"L/min/s", litre / minute}, {"gpm/s", gallon / minute}}},
  {"a volume", {{"m3", 1.0L}, {"L", litre}, {"galUS", gallon}, {"galUK", uk_gallon}, {"bbl", barrel}, {"ft3", foot * foot * foot}, {"in3", inch * inch * inch}, {"l", litre, other_spelling}}},
  {"a volume per turn", {{"m3/rev", 1.0L}, {"L/rev", litre}, {"galUS/rev", gallon}, {"galUK/rev", uk_gallon}}},
  {"an area", {{"m2", 1.0L}, {"cm2", 1e-4L}, {"mm2", 1e-6L}, {"in2", inch * inch}}},
  {"a frequency", {{"1/s", 1.0L}, {"Hz", 1.0L}, {"1/min", 1.0L / minute}}},
  {"a power", {{"W", 1.0L}, {"kW", 1e3L}, {"MW", 1e6L}, {"hp", 550.0L * pound_foot}}},
  {"a mass per length", {{"kg/m", 1.0L}, {"lbm/ft", pound / foot}, {"lb/ft", pound / foot, other_spelling}, {"lbs/ft", pound / foot, other_spelling}, {"ppf", pound / foot, other_spelling}}},
  {"a force per length", {{"N/m", 1.0L}, {"kN/m", 1e3L}, {"MN/m", 1e6L}, {"lbf/ft", pound_force / foot}, {"klbf/ft", 1e3L * pound_force / foot}, {"lbf/in", pound_force / inch}}},
  {"a bending stiffness", {{"N.m2", 1.0L}, {"kN.m2", 1e3L}, {"lbf.ft2", pound_foot * foot}, {"lbf.in2", pound_force * inch * inch}}},
  {"a moment of inertia", {{"kg.m2", 1.0L}, {"lbm.ft2", pound * foot * foot}}},
  {"a moment of inertia per length", {{"kg.m2/m", 1.0L}, {"lbm.ft2/ft", pound * foot}}},
  {"a torsional stiffness", {{"N.m/rad", 1.0L}, {"kN.m/rad", 1e3L}, {"ft.lbf/rad", pound_foot}, {"ft.lbf/deg", pound_foot / deg}}},
  {"a torsional damping", {{"N.m.s/rad", 1.0L}, {"N.m/rpm", 1.0L / rev_per_minute}, {"ft.lbf.s/rad", pound_foot}, {"ft.lbf/rpm", pound_foot / rev_per_minute}}},
  {"a torsional damping per length", {{"N.m.s/rad/m", 1.0L}, {"ft.lbf.s/rad/ft", pound_force}}},
  {"a damping", {{"N.s/m", 1.0L}, {"kN.s/m", 1e3L}, {"lbf.s/ft", pound_force / foot}}},
  {"a damping per length", {{"N.s/m/m", 1.0L}, {"N.s/m2", 1.0L}, {"lbf.s/ft2", pound_force / (foot * foot)}}},
  {"a time per length", {{"s/m", 1.0L}, {"s/ft", 1.0L / foot}}},
  {"a pressure per flow squared", {{"Pa.s2/m6", 1.0L}, {"psi/gpm2", psi * minute * minute / (gallon * gallon)}}},
  };
}
// clang-format on

const std::map<std::string, std::vector<const char*>> several_meanings = {
    {"tonf", {"tonfUS", "tonfUK", "tf"}},
    {"ton", {"t", "tonUS", "tonUK"}},
    {"gal", {"galUS", "galUK"}},
    {"gal/min", {"gpm", "galUK/min"}},
    {"gal/rev", {"galUS/rev", "galUK/rev"}},
    {"mPa", {"MPa", "Pa"}},
    {"lb/gal", {"ppg"}},  // of the US gallon; a sixth less of the UK one
    {"lbm/gal", {"ppg"}},
    {"SG", {"g/cm3"}},
    {"sg", {"g/cm3"}},  // of water at 4 deg C, 60 deg F or 20 deg C
};

void replace_all(std::string& text, const std::string& what, const std::string& by)
{
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}
}  // namespace

const std::vector<UnitFamily>& unit_families()
{
  static const std::vector<UnitFamily> families = all_families();
  return families;
}

std::string plain_unit(const std::string& spelling)
{
  std::string text = spelling;
  replace_all(text, " per ", "/");
  replace_all(text, "\u00b2", "2");
  replace_all(text, "\u00b3", "3");
  replace_all(text, "\u00b0", "deg");
  for (const char* product : {" ", "-", "*", "\u00b7", "\u22c5"}) replace_all(text, product, ".");
  for (std::size_t at = text.find('^'); at != std::string::npos; at = text.find('^', at + 1))
  {
    // an exponent of two figures or a fraction is no habit of writing
    const bool one_figure = at + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 1])) && (at + 2 == text.size() || text[at + 2] == '/');
    if (one_figure) text.erase(at, 1);
  }
  return text;
}

const UnitName* find_unit(const UnitFamily& family, const std::string& plain)
{
  const auto found = std::find_if(family.units.begin(), family.units.end(), [&](const UnitName& unit) { return plain == unit.name; });
  return found == family.units.end() ? nullptr : &*found;
}

const UnitFamily* family_of(const std::string& plain)
{
  const std::vector<UnitFamily>& families = unit_families();
  const auto found = std::find_if(families.begin(), families.end(), [&](const UnitFamily& family) { return find_unit(family, plain) != nullptr; });
  return found == families.end() ? nullptr : &*found;
}

const std::vector<const char*>& meanings_of(const std::string& plain)
{
  static const std::vector<const char*> one_meaning;
  const auto found = several_meanings.find(plain);
  return found == several_meanings.end() ? one_meaning : found->second;
}

}  // namespace drill_rig_sim
