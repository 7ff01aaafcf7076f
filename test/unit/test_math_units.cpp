// SPDX-License-Identifier: BSD-3-Clause
// The table of units against figures of NIST SP 811, appendix B, and the spellings of a unit.
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/shown_units.h"
#include "drill_rig_sim/math/unit_table.h"

namespace drill_rig_sim::test_math_units
{
namespace
{
struct Figure
{
  const char* quantity;
  const char* unit;
  double si;
};

// Seven figures as SP 811 gives them, or by hand from those; what is exact stands in full.
const std::vector<Figure> figures = {
    {"a length", "mm", 0.001},
    {"a length", "cm", 0.01},
    {"a length", "km", 1000.0},
    {"a length", "ft", 0.3048},
    {"a length", "in", 0.0254},
    {"a mass", "g", 0.001},
    {"a mass", "t", 1000.0},
    {"a mass", "lbm", 0.45359237},
    {"a mass", "klbm", 453.59237},
    {"a mass", "tonUS", 907.18474},
    {"a mass", "tonUK", 1016.0469088},
    {"a mass", "lb", 0.45359237},
    {"a mass", "klb", 453.59237},
    {"a time", "ms", 0.001},
    {"a time", "min", 60.0},
    {"a time", "h", 3600.0},
    {"a time", "hr", 3600.0},
    {"a time", "d", 86400.0},
    {"an angle", "deg", 0.01745329252},
    {"an angle", "rev", 6.283185307},
    {"a force", "daN", 10.0},
    {"a force", "kN", 1e3},
    {"a force", "MN", 1e6},
    {"a force", "kdaN", 1e4},
    {"a force", "kgf", 9.80665},
    {"a force", "kkgf", 9806.65},
    {"a force", "tf", 9806.65},
    {"a force", "lbf", 4.4482216152605},
    {"a force", "klbf", 4448.2216152605},
    {"a force", "kip", 4448.2216152605},
    {"a force", "tonfUS", 8896.443230521},
    {"a force", "tonfUK", 9964.01641818352},
    {"a torque", "daN.m", 10.0},
    {"a torque", "kN.m", 1e3},
    {"a torque", "kgf.m", 9.80665},
    {"a torque", "lbf.in", 0.1129848290},
    {"a torque", "ft.lbf", 1.355817948},
    {"a torque", "kft.lbf", 1355.817948},
    {"a torque", "lbf.ft", 1.355817948},
    {"a torque", "klbf.ft", 1355.817948},
    {"a torque", "ft.lb", 1.355817948},
    {"a torque", "kft.lb", 1355.817948},
    {"a pressure", "kPa", 1e3},
    {"a pressure", "MPa", 1e6},
    {"a pressure", "GPa", 1e9},
    {"a pressure", "bar", 1e5},
    {"a pressure", "atm", 101325.0},
    {"a pressure", "kgf/cm2", 98066.5},
    {"a pressure", "psi", 6894.757293},
    {"a pressure", "ksi", 6894757.293},
    {"a pressure", "kpsi", 6894757.293},
    {"a pressure", "lbf/100ft2", 0.4788025898},
    {"a pressure", "lb/100ft2", 0.4788025898},
    {"a pressure", "lb/100 ft2", 0.4788025898},
    {"a pressure", "lbf/100 ft\u00b2", 0.4788025898},
    {"a pressure", "lb/100 sq ft", 0.4788025898},
    {"an energy per volume", "MJ/m3", 1e6},
    {"an energy per volume", "Pa", 1.0},
    {"an energy per volume", "MPa", 1e6},
    {"an energy per volume", "psi", 6894.757293},
    {"an energy per volume", "ksi", 6894757.293},
    {"a density", "g/cm3", 1000.0},
    {"a density", "kg/L", 1000.0},
    {"a density", "ppg", 119.8264273},
    {"a density", "lbm/galUS", 119.8264273},
    {"a density", "lbm/ft3", 16.01846337},
    {"a density", "lb/ft3", 16.01846337},
    {"a consistency", "mPa.s^n", 0.001},
    {"a consistency", "lbf.s^n/100ft2", 0.4788025898},
    {"a consistency", "lbf s^n/100 ft2", 0.4788025898},
    {"a viscosity", "mPa.s", 0.001},
    {"a viscosity", "cP", 0.001},
    {"a speed", "m/min", 0.01666666667},
    {"a speed", "m/h", 2.777777778e-4},
    {"a speed", "m/hr", 2.777777778e-4},
    {"a speed", "ft/s", 0.3048},
    {"a speed", "ft/min", 0.00508},
    {"a speed", "ft/h", 8.466666667e-5},
    {"a speed", "ft/hr", 8.466666667e-5},
    {"an angular speed", "rpm", 0.1047197551},
    {"an angular speed", "rev/min", 0.1047197551},
    {"an angular speed", "deg/s", 0.01745329252},
    {"an angular speed", "rev/s", 6.283185307},
    {"an acceleration", "ft/s2", 0.3048},
    {"an angular acceleration", "rpm/s", 0.1047197551},
    {"an angular acceleration", "deg/s2", 0.01745329252},
    {"a flow", "m3/min", 0.01666666667},
    {"a flow", "m3/h", 2.777777778e-4},
    {"a flow", "L/s", 0.001},
    {"a flow", "L/min", 1.666666667e-5},
    {"a flow", "gpm", 6.30901964e-5},
    {"a flow", "galUS/min", 6.30901964e-5},
    {"a flow", "galUK/min", 7.576816667e-5},
    {"a flow", "bbl/min", 2.649788249e-3},
    {"a change of flow", "L/s2", 0.001},
    {"a change of flow", "L/min/s", 1.666666667e-5},
    {"a change of flow", "gpm/s", 6.30901964e-5},
    {"a volume", "L", 0.001},
    {"a volume", "galUS", 3.785411784e-3},
    {"a volume", "galUK", 4.54609e-3},
    {"a volume", "bbl", 0.1589872949},
    {"a volume", "ft3", 0.02831684659},
    {"a volume", "in3", 1.6387064e-5},
    {"a volume per turn", "L/rev", 0.001},
    {"a volume per turn", "galUS/rev", 3.785411784e-3},
    {"a volume per turn", "galUK/rev", 4.54609e-3},
    {"an area", "cm2", 1e-4},
    {"an area", "mm2", 1e-6},
    {"an area", "in2", 6.4516e-4},
    {"a frequency", "Hz", 1.0},
    {"a frequency", "1/min", 0.01666666667},
    {"a power", "kW", 1e3},
    {"a power", "MW", 1e6},
    {"a power", "hp", 745.6998716},
    {"a mass per length", "lbm/ft", 1.488163944},
    {"a mass per length", "lb/ft", 1.488163944},
    {"a mass per length", "ppf", 1.488163944},
    {"a force per length", "kN/m", 1e3},
    {"a force per length", "MN/m", 1e6},
    {"a force per length", "lbf/ft", 14.59390294},
    {"a force per length", "klbf/ft", 14593.90294},
    {"a force per length", "lbf/in", 175.1268352},
    {"a bending stiffness", "kN.m2", 1e3},
    {"a bending stiffness", "lbf.ft2", 0.4132533107},
    {"a bending stiffness", "lbf.in2", 2.869814656e-3},
    {"a moment of inertia", "lbm.ft2", 0.04214011009},
    {"a moment of inertia per length", "lbm.ft2/ft", 0.1382549544},
    {"a torsional stiffness", "kN.m/rad", 1e3},
    {"a torsional stiffness", "ft.lbf/rad", 1.355817948},
    {"a torsional stiffness", "ft.lbf/deg", 77.68264619},
    {"a torsional damping", "N.m/rpm", 9.549296586},
    {"a torsional damping", "ft.lbf.s/rad", 1.355817948},
    {"a torsional damping", "ft.lbf/rpm", 12.94710771},
    {"a torsional damping per length", "ft.lbf.s/rad/ft", 4.448221615},
    {"a damping", "kN.s/m", 1e3},
    {"a damping", "lbf.s/ft", 14.59390294},
    {"a damping per length", "N.s/m2", 1.0},
    {"a damping per length", "lbf.s/ft2", 47.88025898},
    {"a time per length", "s/ft", 3.280839895},
    {"a pressure per flow squared", "psi/gpm2", 1.732188792e12},
    {"a length", "ftUS", 0.3048006096},
    {"a length", "yd", 0.9144},
    {"a time", "us", 1e-6},
    {"an angle", "gon", 0.01570796327},
    {"a force", "Mgf", 9806.65},
    {"a force", "gf", 9.80665e-3},
    {"a force", "dyne", 1e-5},
    {"a force", "kdyne", 1e-2},
    {"a force", "ozf", 0.2780138510},
    {"a torque", "kdaN.m", 1e4},
    {"a torque", "MN.m", 1e6},
    {"a torque", "dN.m", 0.1},
    {"a torque", "kkgf.m", 9806.65},
    {"a torque", "tonfUS.ft", 2711.635897},
    {"a pressure", "lbf/ft2", 47.88025898},
    {"a pressure", "hPa", 100.0},
    {"a pressure", "hbar", 1e7},
    {"a pressure", "kgf/m2", 9.80665},
    {"a pressure", "kgf/mm2", 9806650.0},
    {"a pressure", "mmHg", 133.322387415},
    {"a pressure", "inHg", 3386.388640341},
    {"a pressure", "mH2O", 9806.65},
    {"a pressure", "inH2O", 249.08891},
    {"a speed", "cm/s", 0.01},
    {"a speed", "mm/s", 0.001},
    {"a speed", "km/h", 0.2777777778},
    {"a speed", "m/d", 1.157407407e-5},
    {"a speed", "ft/d", 3.527777778e-6},
    {"a speed", "kft/h", 0.08466666667},
    {"a speed", "in/s", 0.0254},
    {"a speed", "in/min", 4.233333333e-4},
    {"an angular speed", "rev/h", 1.745329252e-3},
    {"an angular speed", "deg/min", 2.908882087e-4},
    {"an angular speed", "deg/h", 4.848136811e-6},
    {"a flow", "m3/d", 1.157407407e-5},
    {"a flow", "L/h", 2.777777778e-7},
    {"a flow", "cm3/s", 1e-6},
    {"a flow", "cm3/min", 1.666666667e-8},
    {"a flow", "galUS/s", 3.785411784e-3},
    {"a flow", "galUS/h", 1.051503273e-6},
    {"a flow", "galUS/d", 4.381263639e-8},
    {"a flow", "galUK/h", 1.262802778e-6},
    {"a flow", "bbl/h", 4.416313747e-5},
    {"a flow", "bbl/d", 1.840130728e-6},
    {"a flow", "kbbl/d", 1.840130728e-3},
    {"a flow", "ft3/s", 0.02831684659},
    {"a flow", "ft3/min", 4.719474432e-4},
    {"a flow", "ft3/h", 7.865790720e-6},
    // further spellings
    {"a length", "feet", 0.3048},
    {"a length", "foot", 0.3048},
    {"a length", "'", 0.3048},
    {"a length", "inch", 0.0254},
    {"a length", "inches", 0.0254},
    {"a length", "\"", 0.0254},
    {"a mass", "lbs", 0.45359237},
    {"a mass per length", "lbs/ft", 1.488163944},
    {"a force", "kips", 4448.2216152605},
    {"a time", "sec", 1.0},
    {"a time", "seconds", 1.0},
    {"a time", "minutes", 60.0},
    {"a time", "hour", 3600.0},
    {"a time", "hours", 3600.0},
    {"a time", "days", 86400.0},
    {"an angle", "degree", 0.01745329252},
    {"an angle", "degrees", 0.01745329252},
    {"a torque", "ft.lbs", 1.355817948},
    {"a torque", "lb.ft", 1.355817948},
    {"a torque", "klb.ft", 1355.817948},
    {"a torque", "Nm", 1.0},
    {"a torque", "daNm", 10.0},
    {"a torque", "kNm", 1e3},
    {"a density", "kg/l", 1000.0},
    {"a density", "g/cc", 1000.0},
    {"a density", "pcf", 16.01846337},
    {"a flow", "l/s", 0.001},
    {"a flow", "l/min", 1.666666667e-5},
    {"a flow", "lpm", 1.666666667e-5},
    {"a flow", "bpm", 2.649788249e-3},
    {"a volume", "l", 0.001},
    {"a temperature", "degF", 0.5555555556},
    {"a temperature", "K", 1.0},
    {"a temperature gradient", "K/km", 1e-3},
    {"a temperature gradient", "K/100m", 1e-2},
    {"a temperature gradient", "degF/ft", 1.822688831},
    {"a temperature gradient", "degF/100ft", 0.01822688831},
};

std::vector<std::string> words_of(const char* text)
{
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}
}  // namespace

TEST(Units, EachIsWhatItsDefinitionSays)
{
  std::set<std::string> tested;
  for (const Figure& figure : figures)
  {
    const std::string name = std::string(figure.quantity) + ": " + figure.unit;
    const UnitName* found = nullptr;
    for (const UnitFamily& family : unit_families())
      if (std::string(family.quantity) == figure.quantity) found = find_unit(family, figure.unit).unit;
    ASSERT_NE(found, nullptr) << name;
    EXPECT_NEAR(1.0, static_cast<double>(found->si) / figure.si, 5e-10) << name;
    tested.insert(name);
  }
  for (const UnitFamily& family : unit_families())
  {
    EXPECT_EQ(1.0L, family.units.front().si) << family.quantity;
    for (std::size_t i = 1; i < family.units.size(); ++i)
      EXPECT_EQ(1u, tested.count(std::string(family.quantity) + ": " + family.units[i].name))
          << family.units[i].name << " is not tested";
  }
}

TEST(Units, WhatIsShownIsOfTheTable)
{
  for (int k = 0; k < static_cast<int>(Dimension::count); ++k)
    for (const UnitSystem system : {UnitSystem::si, UnitSystem::oilfield})
    {
      const Unit& shown = unit_of(static_cast<Dimension>(k), system);
      const std::string name = plain_unit(shown.name);
      if (name.empty() || name == "%" || name.rfind("deg/", 0) == 0) continue;
      ASSERT_NE(nullptr, family_of(name)) << name;
      EXPECT_NEAR(1.0, shown.per_si * find_unit(*family_of(name), name).unit->factor(), 1e-14) << name;
    }
}

TEST(Units, AreSpelledInSeveralWays)
{
  for (const char* spelling : {"ft.lbf", "ft lbf", "ft-lbf", "ft*lbf", "ft\u00b7lbf"}) EXPECT_EQ("ft.lbf", plain_unit(spelling));
  for (const char* spelling : {"m3/s", "m^3/s", "m\u00b3/s"}) EXPECT_EQ("m3/s", plain_unit(spelling));
  EXPECT_EQ("N.s/m/m", plain_unit("N s/m per m"));
  EXPECT_EQ("deg", plain_unit("\u00b0"));
  EXPECT_EQ("galUS/min", plain_unit("gal[US]/min"));
  EXPECT_EQ("N/m^e", plain_unit("N/m^e"));
  EXPECT_EQ("psi/s^0.5", plain_unit("psi/s^0.5"));
}

TEST(Units, CaseAndSignsBetweenThePartsDoNotCount)
{
  const UnitFamily torque = units_of_quantity("torque");
  for (const char* spelling : {"kft.lbf", "KFT_LBS", "kft-lb", "K-FT-LB", "klbf.ft", "1000 ft lbf", "kip-ft"})
  {
    ASSERT_NE(nullptr, find_unit(torque, spelling).unit) << spelling;
    EXPECT_STREQ("kft.lbf", find_unit(torque, spelling).unit->name) << spelling;
  }
  EXPECT_STREQ("ft/h", find_unit(units_of_quantity("speed"), "ft_per_hr").unit->name);
  EXPECT_STREQ("m3", find_unit(units_of_quantity("volume"), "M**3").unit->name);
  EXPECT_STREQ("mPa.s", find_unit(units_of_quantity("viscosity"), "mPa.s").unit->name);
  EXPECT_STREQ("MPa", find_unit(units_of_quantity("pressure"), "MPA").unit->name);
}

TEST(Units, ASpellingOfSeveralMeaningsIsNoUnit)
{
  const std::vector<std::pair<const char*, const char*>> refused = {{"force", "tonf"},
                                                                    {"force", "TONS"},
                                                                    {"force", "mN"},
                                                                    {"force", "mn"},
                                                                    {"force", "mgf"},
                                                                    {"force", "Mlbf"},
                                                                    {"mass", "ton"},
                                                                    {"torque", "tonf.ft"},
                                                                    {"torque", "mN.m"},
                                                                    {"volume", "gal"},
                                                                    {"volume per turn", "gal/rev"},
                                                                    {"pressure", "mPa"},
                                                                    {"pressure", "mpa"},
                                                                    {"power", "mW"},
                                                                    {"density", "sg"},
                                                                    {"density", "SG"},
                                                                    {"density", "lb/gal"},
                                                                    {"density", "lbm/gal"},
                                                                    {"angle", "grad"}};
  for (const auto& [quantity, spelling] : refused)
  {
    EXPECT_EQ(nullptr, find_unit(units_of_quantity(quantity), spelling).unit) << spelling;
    EXPECT_NE("", find_unit(units_of_quantity(quantity), spelling).choices) << spelling;
  }
  EXPECT_EQ("MPa or Pa", find_unit(units_of_quantity("pressure"), "mPa").choices);
  EXPECT_TRUE(find_unit(units_of_quantity("pressure"), "psi").choices.empty());
  EXPECT_NE(nullptr, family_of("bbl")) << "42 US gallons";
  EXPECT_STREQ("a frequency", family_of("Hz")->quantity) << "its symbol goes before the spelling of another quantity";
}

TEST(Units, ASpellingIsOneUnitOfAQuantity)
{
  for (const UnitFamily& family : unit_families())
  {
    std::set<std::string> spellings;
    const auto add = [&](const std::string& spelling)
    { EXPECT_TRUE(spellings.insert(spelling).second) << family.quantity << ": " << spelling; };
    for (const UnitName& unit : family.units)
    {
      EXPECT_EQ(unit.name, plain_unit(unit.name)) << "would never be found";
      EXPECT_EQ(&unit, find_unit(family, unit.name).unit) << unit.name;
      add(folded_unit(unit.name));
      for (const std::string& spelling : words_of(unit.spellings))
      {
        EXPECT_EQ(spelling, folded_unit(plain_unit(spelling))) << "would never be found";
        add(spelling);
      }
    }
    for (const AmbiguousUnit& one : family.ambiguous)
      for (const std::string& spelling : words_of(one.spellings)) add(spelling);
  }
}
}  // namespace drill_rig_sim::test_math_units
