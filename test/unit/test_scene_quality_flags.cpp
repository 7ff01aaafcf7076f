// SPDX-License-Identifier: BSD-3-Clause
// Columns that mark values as good or bad: their names, and what their cells say.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drill_rig_sim/scene/quality_flags.h"

namespace drill_rig_sim::test_scene_quality_flags
{
namespace
{
// a letter for each cell: g, b, d, o; "?" behind them: unclear
std::string meanings(FlagSense sense, const std::vector<std::string>& cells)
{
  const FlagCells found = flag_cells(sense, cells);
  std::string text;
  for (const FlagMeaning meaning : found.meanings) text += "gbdo"[static_cast<std::size_t>(meaning)];
  return text + (found.unclear ? "?" : "");
}

std::string sense_and_rest(const std::string& name)
{
  const FlagName found = flag_name(name);
  const char* const senses[] = {"none", "status", "quality", "good", "bad"};
  return senses[static_cast<std::size_t>(found.sense)] + std::string(found.of.empty() ? "" : " " + found.of);
}
}  // namespace

TEST(QualityFlags, Names)
{
  for (const auto& [name, read] : std::vector<std::pair<std::string, std::string>>{{"QC", "quality"},
                                                                                   {"Data Quality", "quality"},
                                                                                   {"Survey QC Status", "quality"},
                                                                                   {"HKLD_QC", "quality hkld"},
                                                                                   {"Hook Load Quality", "quality hookload"},
                                                                                   {"HookLoadQC", "quality hookload"},
                                                                                   {"Status", "status"},
                                                                                   {"Survey Status", "status"},
                                                                                   {"Comments", "status"},
                                                                                   {"Slips Status", "status slips"},
                                                                                   {"Is Valid", "good"},
                                                                                   {"QC Pass", "good"},
                                                                                   {"Use (Y/N)", "good"},
                                                                                   {"Rejected", "bad"},
                                                                                   {"Bad Data", "bad"},
                                                                                   {"MD (m)", "none"},
                                                                                   {"QC Date", "quality date"},
                                                                                   {"", "none"}})
    EXPECT_EQ(read, sense_and_rest(name)) << name;
}

TEST(QualityFlags, Words)
{
  EXPECT_EQ("gbbbb", meanings(FlagSense::quality, {"Good", "BAD", "questionable", "Suspect", "Fail - dip"}));
  EXPECT_EQ("gbggbb", meanings(FlagSense::quality, {"OK", "not ok", "not bad", "no error", "Out of range", "not valid"}));
  EXPECT_EQ("gddbo", meanings(FlagSense::quality, {"Definitive", "Interpolated", "Tie-in", "Superseded", "B-7"}));
  EXPECT_EQ("bg", meanings(FlagSense::quality, {"BAD", ""})) << "only the bad ones are marked";
  EXPECT_EQ("go", meanings(FlagSense::quality, {"GOOD", ""}));
  EXPECT_EQ("oo?", meanings(FlagSense::quality, {"I", "II"}));
  EXPECT_EQ("oo?", meanings(FlagSense::quality, {"x", ""}));
  EXPECT_EQ("o", meanings(FlagSense::quality, {"raw"})) << "the same everywhere";
}

// What a rig does stands in such columns too.
TEST(QualityFlags, Status)
{
  EXPECT_EQ("oob", meanings(FlagSense::status, {"Drilling", "Wait on bad weather", "BAD"}));
  EXPECT_EQ("obb", meanings(FlagSense::status, {"Bad hole", "Bad data", "Rejected: high dip"}));
  EXPECT_EQ("ob", meanings(FlagSense::status, {"MWD", "DO NOT USE"}));
  EXPECT_EQ("gb", meanings(FlagSense::status, {"Good", "Bad Mag"})) << "a column of quality";
  EXPECT_EQ("oo?", meanings(FlagSense::status, {"In slips", "Drilling"}));
  EXPECT_EQ("oooo?", meanings(FlagSense::status, {"1", "4", "7", "999"})) << "codes of what the rig does";
}

TEST(QualityFlags, Letters)
{
  EXPECT_EQ("gb", meanings(FlagSense::quality, {"P", "F"}));
  EXPECT_EQ("gbb", meanings(FlagSense::quality, {"G", "B", "Q"}));
  EXPECT_EQ("gb", meanings(FlagSense::quality, {"a", "r"}));
  EXPECT_EQ("ooo?", meanings(FlagSense::quality, {"A", "B", "C"})) << "grades";
}

TEST(QualityFlags, Numbers)
{
  EXPECT_EQ("oo?", meanings(FlagSense::quality, {"0", "1"}));
  EXPECT_EQ("gb", meanings(FlagSense::quality, {"1", "999"}));
  EXPECT_EQ("gb", meanings(FlagSense::quality, {"0", "-999.25"}));
  EXPECT_EQ("oob", meanings(FlagSense::quality, {"0", "1", "9999"}));
  EXPECT_EQ("gbbg", meanings(FlagSense::quality, {"192", "0", "64", "216"})) << "codes of OPC";
  EXPECT_EQ("gb", meanings(FlagSense::good_if_true, {"1", "0"}));
  EXPECT_EQ("bg", meanings(FlagSense::bad_if_true, {"TRUE", "FALSE"}));
  EXPECT_EQ("gb", meanings(FlagSense::good_if_true, {"Y", "N"}));
  EXPECT_EQ("oo?", meanings(FlagSense::quality, {"Y", "N"}));
}
}  // namespace drill_rig_sim::test_scene_quality_flags
