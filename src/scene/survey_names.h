// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_NAMES_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_NAMES_H

#include <cstddef>
#include <map>
#include <string>

namespace drill_rig_sim
{
/// What a column with a usual name holds.
struct SurveyName
{
  std::size_t quantity;  ///< of SurveyQuantity
  bool weak = false;     ///< "Depth", "Dir": only where no other column is
};

/// The usual names of a survey's columns in English, German, French, Spanish, Portuguese, Italian, Dutch, Norwegian, Danish,
/// Polish and Russian: the words of each in one, in small Latin letters (name_words()).
const std::map<std::string, SurveyName>& survey_names();

}  // namespace drill_rig_sim

#endif
