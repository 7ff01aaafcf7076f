// SPDX-License-Identifier: BSD-3-Clause
#include "survey_units.h"

#include <algorithm>
#include <vector>

namespace drill_rig_sim
{
namespace
{
const UnitFamily& lengths()
{
  static const UnitFamily* const family = &units_of_quantity("length");
  return *family;
}

const UnitFamily& angles()
{
  static const UnitFamily* const family = &units_of_quantity("angle");
  return *family;
}

// letters and signs only: "US ft" and "ft." are "usft" and "ft"
std::string compact(const std::string& spelling)
{
  std::string text;
  for (const char c : lowered(spelling))
    if (std::string(" ._-").find(c) == std::string::npos) text += c;
  return text;
}
}  // namespace

std::string lowered(std::string text)
{
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

const UnitName* length_unit(const std::string& spelling)
{
  const std::string text = compact(spelling);
  if (const UnitName* unit = find_unit(lengths(), text).unit) return unit;
  // the rotary table's names, from which depths are counted
  for (const std::string& datum :
       std::vector<std::string>{"brkb", "bkb", "rkb", "kb", "brt", "mdrt", "rte", "rt", "df", "ahbrt", "ahrt", "ahd", "md"})
  {
    if (text.size() <= datum.size() || text.compare(text.size() - datum.size(), datum.size(), datum) != 0) continue;
    if (const UnitName* unit = find_unit(lengths(), text.substr(0, text.size() - datum.size())).unit) return unit;
  }
  return nullptr;
}

const UnitName* angle_unit(const std::string& spelling)
{
  return find_unit(angles(), compact(spelling)).unit;
}

std::string why_no_unit(bool of_angle, const std::string& spelling)
{
  std::string text = compact(spelling);
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return std::string("()[]{}").find(c) != std::string::npos; }),
             text.end());
  const std::string choices = find_unit(of_angle ? angles() : lengths(), text).choices;
  return choices.empty() ? "is not known, allowed: " + survey_unit_names(of_angle) : "is ambiguous, allowed: " + choices;
}

std::string survey_unit_names(bool of_angle)
{
  return listed_units(of_angle ? angles() : lengths());
}

}  // namespace drill_rig_sim
