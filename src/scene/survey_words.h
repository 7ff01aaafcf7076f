// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SCENE_SURVEY_WORDS_H
#define DRILL_RIG_SIM_SRC_SCENE_SURVEY_WORDS_H

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "survey_units.h"

/// The words of a survey's header.
namespace drill_rig_sim
{
using Words = std::vector<std::string>;

/// Words that say from which north an azimuth counts, with that north: "true", "grid" or "magnetic".
const std::map<std::string, std::string>& norths();
/// The words of a text in small Latin letters; signs part them.
Words name_words(const std::string& text);
/// The first `count` of them in one.
std::string in_one(const Words& words, std::size_t count);
/// The unit of a quantity (SurveyQuantity) by its spelling; null where it has none.
const UnitName* unit_for(std::size_t quantity, const std::string& spelling);
/// Takes (...), [...] and {...} out of a text.
std::string without_brackets(const std::string& text, Words& inside);

}  // namespace drill_rig_sim

#endif
