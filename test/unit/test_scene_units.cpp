// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a scene with their units: the scene is that of the same numbers in SI, and a unit that is wrong is refused in one
// line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "in_source.h"
#include "scene/scene_keys.h"
#include "scene/yaml_reader.h"

namespace drill_rig_sim::test_scene_units
{
namespace
{
using Settings = std::vector<std::string>;
const std::string quick = in_source("config/scenes/quick.yaml");

/// The one line that the scene with these settings is refused by.
std::string refusal(const Settings& settings, const std::string& file = quick)
{
  try
  {
    read_scene(file, settings);
  }
  catch (const SceneError& e)
  {
    EXPECT_EQ(1u, e.problems().size()) << e.what();
    return e.what();
  }
  return "accepted";
}

/// Calls look(unit, range, suffix factor, name) for each number of a table.
template <class Spec, class Look>
void each_number(const Table<Spec>& table, const Look& look)
{
  for (const Key<Spec>& key : table.keys)
    if (std::get_if<double Spec::*>(&key.field) || std::get_if<Inside<Spec>>(&key.field))
      look(std::string(key.unit), key.allowed, table.block + std::string(".") + key.name);
}

template <class Look>
void each_number(const Look& look)
{
  const auto all = [&](const auto&... tables) { (each_number(tables, look), ...); };
  all(well_keys, tie_in_keys, section_keys, layer_keys, mud_keys, part_keys, part_contact_keys, bit_bottom_keys, bit_torque_keys,
      hoisting_keys, top_drive_keys, soft_torque_keys, z_torque_keys, mud_pump_keys, heave_keys, contact_keys, trajectory_keys,
      start_keys, numerics_keys, mwd_keys, toolface_keys, dynamics_keys, hook_load_keys, pressure_keys, sensor_keys, program_keys,
      operation_keys);
}

/// The symbol and the further spellings that may follow a number: without those that begin with one (1000 lbf).
std::vector<std::string> spellings_of(const UnitName& unit)
{
  std::istringstream words(unit.spellings);
  std::vector<std::string> found = {unit.name};
  for (std::string word; words >> word;)
    if (!std::isdigit(static_cast<unsigned char>(word[0])) && word[0] != '/') found.push_back(word);
  return found;
}
}  // namespace

TEST(SceneUnits, AnOilfieldSceneIsItsTwinInSI)
{
  const Scene oilfield = read_scene(in_source("config/scenes/oilfield.yaml"));
  EXPECT_EQ(scene_hash(read_scene(in_source("test/scenes/oilfield_in_si.yaml"))), scene_hash(oilfield));
  EXPECT_EQ(0.2159, oilfield.string[0].bit->diameter);
  EXPECT_EQ(457.2, oilfield.well.hole_depth);
  EXPECT_EQ(90.0 * rpm, oilfield.program[0].top_drive_speed);
}

TEST(SceneUnits, SettingsMayCarryThem)
{
  const auto same = [](const std::string& with_unit, const std::string& si)
  { EXPECT_EQ(scene_hash(read_scene(quick, {si})), scene_hash(read_scene(quick, {with_unit}))) << with_unit; };
  same("mud.density=10 ppg", "mud.density=1198.2642731689663");
  same("mud.density=10ppg", "mud.density=1198.2642731689663");
  same("mud.density=\"1.1 g/cm3\"", "mud.density=1100");
  same("mud.density=1.1 kg/L", "mud.density=1100");
  same("start.bit_depth=327 ft", "start.bit_depth=99.6696");
  same("start.bit_depth=3.27e2 ft", "start.bit_depth=99.6696");
  same("string[0].diameter=8 in", "string[0].diameter=0.2032");
  same("rig.top_drive.max_torque=30 kft-lbf", "rig.top_drive.max_torque=40674.538449942012");
  same("rig.top_drive.max_torque=40 kN m", "rig.top_drive.max_torque=40000");
  same("rig.top_drive.max_speed_rpm=220 rpm", "rig.top_drive.max_speed_rpm=220");
  same("instruments.mwd.period=0.5 min", "instruments.mwd.period=30");
  same("contact.stiffness=5e7 N/m^e", "contact.stiffness=5e7");
  same("well.stations=[[0 ft, 0 deg, 0], [100 m, 0 rad, 0 deg]]", "well.stations=[[0, 0, 0], [100, 0, 0]]");
  same("instruments.surface.hook_load.drift=2 kN/s^0.5", "instruments.surface.hook_load.drift=2000");
  same("instruments.surface.flow.noise=3 L/s", "instruments.surface.flow.noise=0.003");
  same("program=[{at: 1 min, fault: pack_off, fault_depth: 50 m, fault_magnitude: 20 kN}]",
       "program=[{at: 60, fault: pack_off, fault_depth: 50, fault_magnitude: 20000}]");
  same("program=[{at: 1, fault: sensor_bias, fault_target: stand_pipe_pressure, fault_magnitude: 2 bar}]",
       "program=[{at: 1, fault: sensor_bias, fault_target: stand_pipe_pressure, fault_magnitude: 2e5}]");
  same("program=[{at: 1, fault: sensor_drift, fault_target: hook_load, fault_magnitude: 2 kN/s}]",
       "program=[{at: 1, fault: sensor_drift, fault_target: hook_load, fault_magnitude: 2000}]");
  same("program=[{at: 1 min, fault: washed_out_hole, fault_depth: 50 m, fault_magnitude: 2 in}]",
       "program=[{at: 60, fault: washed_out_hole, fault_depth: 50, fault_magnitude: 0.0508}]");
  same("operations=[{do: drill, weight: 4 kN, distance: 1 m}]", "operations=[{do: drill, weight: 4000, distance: 1}]");
}

TEST(SceneUnits, AsDrillersWriteThem)
{
  const auto same = [](const std::string& with_unit, const std::string& si)
  { EXPECT_EQ(scene_hash(read_scene(quick, {si})), scene_hash(read_scene(quick, {with_unit}))) << with_unit; };
  for (const char* diameter :
       {"7-7/8 in", "7 7/8 in", "7 7/8in", "7-7/8\"", "7.875\"", "7.875 inches", "0.65625 feet", "7\u215e\"", "7 \u215e in",
        "7  7/8 IN", "7 7\u20448\u201d", "7.875\u201d", "7.875\u2033", "7.875''", "63/8 in", "0.65625\u2019", "0.65625 \u2032"})
    same(std::string("string[0].diameter=") + diameter, "string[0].diameter=0.200025");
  same("string[0].length=\u00be ft", "string[0].length=9 in");
  same("rig.top_drive.max_torque=40 kNm", "rig.top_drive.max_torque=40000");
  same("rig.top_drive.max_torque=30 klb-ft", "rig.top_drive.max_torque=40674.538449942012");
  same("mud.density=1.1 g/cc", "mud.density=1100");
  same("mud.density=10 PPG", "mud.density=10 ppg");
  same("start.bit_depth=327 Feet", "start.bit_depth=99.6696");
  same("rig.top_drive.max_torque=30 kft_lbs", "rig.top_drive.max_torque=40674.538449942012");
  same("rig.mud_pump.max_flow=800 gal/min", "rig.mud_pump.max_flow=800 gpm");
  same("instruments.mwd.period=30 sec", "instruments.mwd.period=30");
  EXPECT_EQ("setting: mud.density: lb/gal is ambiguous; allowed: ppg", refusal({"mud.density=9 lb/gal"}));
  EXPECT_NE(std::string::npos, refusal({"string[0].diameter=7-7/8"}).find("is not a number")) << "of no unit";
  for (const char* text : {"7/8", "8\u00bd", "0.5\u00bd in", "\u00bd\u00bd in"})
    EXPECT_NE("accepted", refusal({std::string("string[0].diameter=") + text})) << text;
  EXPECT_NE(std::string::npos, refusal({"string[0].diameter=7.5 7/8 in"}).find("is not a number"));
}

// YAML reads `19.5 #/ft` as 19.5, in kg/m.
TEST(SceneUnits, AUnitThatIsACommentIsRefused)
{
  EXPECT_EQ("setting: string[1].linear_mass: YAML reads # as the start of a comment; write lb/ instead of #/",
            refusal({"string[1].linear_mass=19.5 #/ft"}));
  const std::string file = std::string(::testing::TempDir()) + "test_scene_units_comment.yaml";
  std::ofstream(file) << "name: x  # 19.5 #/ft is no comment here\nmud:\n  density: 9 #/gal\n";
  EXPECT_NE(std::string::npos,
            refusal({}, file).find(":3: YAML: YAML reads # as the start of a comment; write lb/ instead of #/"));
}

TEST(SceneUnits, KeysInDegreesAndRpmTakeOtherUnits)
{
  const Scene scene = read_scene(quick, {"instruments.mwd.noise_deg=0.01 rad", "rig.top_drive.max_speed_rpm=12.5 rad/s",
                                         "program=[{at: 0, top_drive_speed_rpm: 1.5 rev/s}]", "formation[0].dip_deg=0.1 rev"});
  EXPECT_NEAR(0.01, scene.instruments.mwd.noise, 1e-17);
  EXPECT_NEAR(12.5, scene.rig.top_drive.max_speed, 1e-14);
  EXPECT_NEAR(3.0 * pi, scene.program[0].top_drive_speed, 1e-14);
  EXPECT_NEAR(0.2 * pi, scene.formation[0].dip, 1e-15);
}

/// Of every number of a scene, in every unit of its quantity.
TEST(SceneUnits, EveryNumberTakesEveryUnitOfItsQuantity)
{
  int numbers = 0, without_units = 0;
  each_number(
      [&](const std::string& key_unit, const Range& allowed, const std::string& name)
      {
        ++numbers;
        const std::string unit = unit_with(key_unit.c_str(), "Pa");
        const UnitFamily* family = family_of(plain_unit(unit));
        if (!family)
        {
          ++without_units;
          const bool known =
              unit.empty() || unit == "-" || unit == "m/s; N; rad/s" || unit == "N/m^e" || unit == "m, rad" || unit == "Pa/s^0.5";
          EXPECT_TRUE(known) << name << " is in " << unit << ", which the table of units lacks";
          return;
        }
        const double value = std::isfinite(allowed.high) ? 0.75 * allowed.high + 0.25 * allowed.low : 1.0;
        for (const UnitName& given : family->units)
        {
          const UnitName& own = *find_unit(*family, plain_unit(unit)).unit;
          const long double in_unit = (value - own.zero) * own.si / given.si + given.zero;
          for (const std::string& spelling : spellings_of(given))
          {
            char text[80];
            std::snprintf(text, sizeof text, "%.21Lg %s", in_unit, spelling.c_str());
            Problems problems("x");
            double read = 0.0;
            EXPECT_TRUE(read_number(YAML::Load(text), "key", allowed, unit, read, problems)) << name << ": " << text;
            EXPECT_NEAR(value, read, 1e-15 * std::abs(value)) << name << ": " << text;
          }
        }
      });
  EXPECT_GT(numbers, 150);
  EXPECT_LT(without_units, 55);
}

TEST(SceneUnits, AUnitOfAnotherQuantityIsRefusedWithTheAllowedOnes)
{
  EXPECT_EQ("setting: mud.density: psi is a pressure; allowed: kg/m3, g/cm3, ppg, lbm/ft3", refusal({"mud.density=9 psi"}));
  EXPECT_EQ("setting: start.weight_on_bit: lbm is a mass; allowed: N, daN, kN, MN, kgf, tf, lbf, klbf, tonfUS, tonfUK",
            refusal({"start.weight_on_bit=20 lbm"}));
  EXPECT_EQ("setting: rig.top_drive.max_speed_rpm: m/s is a speed; allowed: rad/s, rpm, deg/s, rev/s",
            refusal({"rig.top_drive.max_speed_rpm=3 m/s"}));
  EXPECT_EQ("setting: well.stations[1]: ft is a length; allowed: rad, deg, rev, gon",
            refusal({"well.stations=[[0, 0, 0], [100 m, 0 ft, 0 deg]]"}));
  EXPECT_EQ(
      "setting: program[0].fault_magnitude: kN is a force; allowed: Pa, kPa, MPa, GPa, bar, atm, kgf/cm2, psi, ksi, lbf/100ft2",
      refusal({"program=[{at: 1, fault: sensor_bias, fault_target: stand_pipe_pressure, fault_magnitude: 2 kN}]"}));
  EXPECT_EQ("setting: mud.density: unknown unit \"baume\"; allowed: kg/m3, g/cm3, ppg, lbm/ft3",
            refusal({"mud.density=9 baume"}));
}

// what follows the first wrong number of a long list is likely wrong for the same reason
TEST(SceneUnits, AWrongUnitOfStationsIsOneLine)
{
  EXPECT_EQ("setting: well.stations[0]: grad is ambiguous; allowed: gon or deg",
            refusal({"well.stations=[[0 m, 0 grad, 0 grad], [100 m, 3 grad, 0 grad], [200 m, 6 grad, 0 grad]]"}));
  EXPECT_EQ("setting: well.stations[1]: 361 is out of range, allowed: -360 to 360 deg",
            refusal({"well.stations=[[0, 0, 0], [100, 3, 361], [200, 6, 362]]"}));
}

TEST(SceneUnits, ANumberThatHasNoUnitTakesNone)
{
  EXPECT_EQ("setting: well.sections[0].friction: m is a length; allowed: a number without a unit",
            refusal({"well.sections[0].friction=0.2 m"}));
  EXPECT_EQ("setting: well.sections[0].friction: unknown unit \"%\"; allowed: a number without a unit",
            refusal({"well.sections[0].friction=20 %"}));
  EXPECT_EQ("setting: contact.stiffness: N/m is a force per length; allowed: a number without a unit, which is in N/m^e",
            refusal({"contact.stiffness=5e7 N/m"}));
  EXPECT_NE(std::string::npos, refusal({"rig.hoisting.sheaves=5 m"}).find("is not a whole number"));
}

TEST(SceneUnits, AnAmbiguousUnitIsRefusedWithItsMeanings)
{
  EXPECT_EQ("setting: start.weight_on_bit: tonf is ambiguous; allowed: tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf (tf)",
            refusal({"start.weight_on_bit=1 tonf"}));
  EXPECT_EQ("setting: rig.hoisting.block_mass: ton is ambiguous; allowed: t, tonUS or tonUK",
            refusal({"rig.hoisting.block_mass=20 ton"}));
  EXPECT_EQ("setting: rig.mud_pump.relief_pressure: mPa is ambiguous; allowed: MPa or Pa",
            refusal({"rig.mud_pump.relief_pressure=35 mPa"}));
  EXPECT_EQ("setting: rig.mud_pump.stroke_volume: gal is ambiguous; allowed: galUS or galUK",
            refusal({"rig.mud_pump.stroke_volume=4 gal"}));
  EXPECT_EQ(
      "setting: instruments.surface.hook_load.drift: tonf/s^0.5 is ambiguous; allowed: tonfUS (2000 lbf), tonfUK (2240 lbf) or "
      "1000 kgf (tf), each with /s^0.5",
      refusal({"instruments.surface.hook_load.drift=1 tonf/s^0.5"}));
  EXPECT_EQ("setting: mud.density: sg is ambiguous; allowed: g/cm3", refusal({"mud.density=1.2 sg"}));
  EXPECT_EQ("setting: mud.density: gal is a volume; allowed: kg/m3, g/cm3, ppg, lbm/ft3", refusal({"mud.density=9 gal"}));
  EXPECT_NEAR(0.0158987294928, read_scene(quick, {"rig.mud_pump.stroke_volume=0.1 bbl"}).rig.mud_pump.stroke_volume, 1e-12)
      << "42 US gallons";
}

TEST(SceneUnits, WhatIsOutOfRangeIsShownInTheUnitOfTheInput)
{
  EXPECT_EQ("setting: mud.density: 60 ppg is out of range, allowed: 0 to 25.0362 ppg", refusal({"mud.density=60 ppg"}));
  EXPECT_EQ("setting: start.block_height: -3 ft is out of range, allowed: 0 to 656.168 ft",
            refusal({"start.block_height=-3 ft"}));
  EXPECT_EQ("setting: rig.top_drive.max_speed_rpm: 200 rad/s is out of range, allowed: 0.10472 to 104.72 rad/s",
            refusal({"rig.top_drive.max_speed_rpm=200 rad/s"}));
  EXPECT_EQ("setting: mud.density: 6000 is out of range, allowed: 0 to 3000 kg/m3", refusal({"mud.density=6000"}));
}

// Checks between keys compare SI numbers; the line about a key is in the unit of its input.
TEST(SceneUnits, ChecksBetweenKeysSpeakTheUnitOfTheInput)
{
  EXPECT_EQ("setting: start.bit_depth: 600 ft is below the hole's bottom, allowed: up to 328.084 ft",
            refusal({"start.bit_depth=600 ft"}));
  EXPECT_EQ(
      "setting: start.bit_depth: 410 ft is below the hole's bottom, allowed: up to 328.084 ft; well.hole_depth and "
      "well.project: straight or curvature extend it",
      refusal({"start.bit_depth=410 ft"}));
  EXPECT_EQ("setting: start.block_height: 200 ft is outside the block's travel, allowed: 3.28084 to 131.234 ft",
            refusal({"start.block_height=200 ft"}));
  EXPECT_EQ("setting: start.weight_on_bit: 5 klbf with the bit off bottom, allowed: 0, or bit_depth equal to hole_depth",
            refusal({"start.weight_on_bit=5 klbf"}));
  EXPECT_EQ("setting: program[0].flow: 2000 gpm is beyond the rig's limit, allowed: up to 951.019 gpm",
            refusal({"program=[{at: 0, flow: 2000 gpm}]"}));
  EXPECT_EQ("setting: program[0].fault_magnitude: allowed is above 0, up to 3.28084 ft",
            refusal({"program=[{at: 1, fault: washed_out_hole, fault_depth: 50, fault_magnitude: 5 ft}]"}));
  EXPECT_EQ(
      "setting: well.stations[2]: md 328.02 ft is too close to the station before it, 328 ft, allowed: 0.0328084 ft or more "
      "between stations",
      refusal({"well.stations=[[0 ft, 0 deg, 0 deg], [328 ft, 0 deg, 0 deg], [328.02 ft, 0 deg, 0 deg]]"}));
  EXPECT_EQ("setting: start.bit_depth: 400 m is below the hole's bottom, allowed: up to 100 m", refusal({"start.bit_depth=400"}));
}

TEST(SceneUnits, WhatIsNoNumberStaysNone)
{
  for (const char* text : {"1,5", "1.5.2", "5 /m", "five ft", "ft", "1e999 m", "'1100'", "5 5", "\"5\""})
    EXPECT_NE(std::string::npos, refusal({std::string("mud.density=") + text}).find("is not a number, allowed: 0 to 3000 kg/m3"))
        << text;
}
}  // namespace drill_rig_sim::test_scene_units
