// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SURVEY_READING_H
#define DRILL_RIG_SIM_TEST_SURVEY_READING_H

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/survey_file.h"
#include "temporary_folder.h"

/// Surveys out of texts.
namespace drill_rig_sim::survey_reading
{
inline SurveyTable read(const std::string& text, const SurveyFormat& format = {})
{
  const TemporaryFolder folder;
  const std::string file = folder.file("survey.txt");
  std::ofstream(file) << text;
  return read_survey_file(file, format);
}

/// The first problem without the file's name, "accepted" if there is none
inline std::string refusal(const std::string& text, const SurveyFormat& format = {})
{
  try
  {
    read(text, format);
    return "accepted";
  }
  catch (const SceneError& error)
  {
    EXPECT_EQ(1u, error.problems().size()) << error.what();
    return error.problems().front().substr(error.problems().front().find("survey.txt") + 10);
  }
}

inline bool holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

inline void expect_station(const SurveyStation& station, double md, double inclination, double azimuth)
{
  EXPECT_NEAR(md, station.md, 1e-9);
  EXPECT_NEAR(inclination * degree, station.inclination, 1e-12);
  EXPECT_NEAR(azimuth * degree, station.azimuth, 1e-12);
}

}  // namespace drill_rig_sim::survey_reading

#endif
