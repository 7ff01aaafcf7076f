#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNITS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_UNITS_H

#include <string>

namespace drill_rig_sim
{
/// A unit of a survey's lengths or angles.
struct SurveyUnit
{
  const char* name;
  double factor;  ///< to m or rad
};

/// By a header's, a map's or WITSML's spelling ("feet", "mRKB", "dega"), in small or capital letters; nullptr if there is none.
const SurveyUnit* length_unit(const std::string& spelling);
const SurveyUnit* angle_unit(const std::string& spelling);
/// Their names, for messages.
constexpr const char* length_unit_names = "m, ft or ftUS";
constexpr const char* angle_unit_names = "deg, rad or gon";

/// In small letters (ASCII).
std::string lowered(std::string text);

}  // namespace drill_rig_sim

#endif
