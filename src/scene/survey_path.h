// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_PATH_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_PATH_H

#include <string>

#include "survey_words.h"

/// Tables that hold a plan beside the drilled well: `Plan MD`, `Actual MD`.
namespace drill_rig_sim
{
/// Of which path a column or a row is.
enum class SurveyPath
{
  unsaid,
  planned,
  actual
};

/// Takes the words for a path (plan, actual) out of a name.
Words without_path(const Words& words, SurveyPath& path);
/// The path that all words of a cell say: `Plan`, `Actual survey`.
SurveyPath path_of_cell(const std::string& cell);
/// The path that a line above a table names: `Data Type: Plan`, `Definitive survey`; "" where it names none, or both.
std::string path_of_title(const std::string& line);
/// "planned" or "actual".
const char* path_word(SurveyPath path);

}  // namespace drill_rig_sim

#endif
