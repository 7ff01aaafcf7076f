// SPDX-License-Identifier: BSD-3-Clause
#include "survey_path.h"

#include <set>

namespace drill_rig_sim
{
namespace
{
SurveyPath path_of_word(const std::string& word)
{
  static const std::set<std::string> planned = {"plan",   "planned",  "proposal",  "proposed",  "wellplan",
                                                "design", "designed", "prognosis", "prognosed", "target"},
                                     actual = {"actual", "actuals", "act", "asdrilled", "drilled", "surveyed", "definitive"};
  return planned.count(word) > 0 ? SurveyPath::planned : actual.count(word) > 0 ? SurveyPath::actual : SurveyPath::unsaid;
}
}  // namespace

Words without_path(const Words& words, SurveyPath& path)
{
  Words rest;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const SurveyPath said = path_of_word(words[i]);
    const bool as_drilled = words[i] == "as" && i + 1 < words.size() && words[i + 1] == "drilled";
    if (said != SurveyPath::unsaid) path = said;
    if (said == SurveyPath::unsaid && !as_drilled) rest.push_back(words[i]);
  }
  return rest;
}

SurveyPath path_of_cell(const std::string& cell)
{
  SurveyPath path = SurveyPath::unsaid;
  for (const std::string& word : without_path(name_words(cell), path))
    if (word != "well" && word != "survey" && word != "path" && word != "trajectory" && word != "data") return SurveyPath::unsaid;
  return path;
}

std::string path_of_title(const std::string& line)
{
  // wells and wellbores have designs and targets too; a survey's program and a comparison name both paths
  static const std::set<std::string> of_wells = {"design", "designed", "target"},
                                     neither = {"program", "programme", "vs", "versus", "against", "deviation", "view"};
  constexpr std::size_t most_words = 6;  // longer lines are sentences
  const Words words = name_words(line);
  if (words.size() > most_words) return "";
  bool is_planned = false, is_actual = false;
  for (const std::string& word : words)
  {
    if (neither.count(word) > 0) return "";
    const SurveyPath path = of_wells.count(word) > 0 ? SurveyPath::unsaid : path_of_word(word);
    is_planned = is_planned || path == SurveyPath::planned;
    is_actual = is_actual || path == SurveyPath::actual;
  }
  if (is_planned == is_actual) return "";
  return path_word(is_planned ? SurveyPath::planned : SurveyPath::actual);
}

const char* path_word(SurveyPath path)
{
  return path == SurveyPath::planned ? "planned" : "actual";
}

}  // namespace drill_rig_sim
