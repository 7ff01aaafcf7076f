// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SURVEY_FORMAT_H
#define DRILL_RIG_SIM_SCENE_SURVEY_FORMAT_H

#include <string>

namespace drill_rig_sim
{
/// A column of a survey's table.
struct SurveyColumn
{
  std::string column;  ///< its name in the header; empty: by the usual spellings
  std::string unit;    ///< of a length or an angle (math/unit_table.h); empty: as the header says
};

/// A column of a survey's table that marks stations as good or bad.
struct SurveyQuality
{
  std::string column;  ///< its name in the header; empty: by the usual names and words
  std::string good;    ///< its cells of good stations, between blanks
};

/// How a survey's file is to be read, where its header does not define it.
struct SurveyFormat
{
  SurveyColumn md, inclination, azimuth;
  SurveyColumn north, east, tvd;  ///< of the first station, from the rotary table
  std::string delimiter;          ///< , or ; or tab or space; empty: by the header
  double pass_over = 0.0;  ///< 1: stations without a value and those that equal the one before are passed over, and reported
  SurveyQuality quality;
  bool plan = false;  ///< it is a plan: of a table with a plan and a drilled well the plan is read, else the drilled well
};

/// Reads a format from a YAML file, keys as those of a scene's well.survey. Throws SceneError.
SurveyFormat read_survey_format(const std::string& file);

/// The format that a command line or a service asks for: `columns` is such a file, empty: as the header says. Throws SceneError.
SurveyFormat survey_format(const std::string& columns, bool pass_over, bool plan = false);

}  // namespace drill_rig_sim

#endif
