// SPDX-License-Identifier: BSD-3-Clause
#include "survey_digits.h"

#include <algorithm>
#include <regex>

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t longest = 32;  // [bytes] of a number; a longer cell is none

/// How numbers write groups of digits: `sure` fits where the decimal sign is beyond doubt, `any` what else is then in groups.
struct Style
{
  std::regex sure, any;
  char group;
  const char* name;
};

const std::string first_group = "[+-]?[1-9][0-9]{0,2}";

const Style& decimal_points()
{
  static const Style style{std::regex(first_group + "((,[0-9]{3})+\\.[0-9]*|(,[0-9]{3}){2,})"),
                           std::regex(first_group + "(,[0-9]{3})+(\\.[0-9]*)?"), ',', "commas"};
  return style;
}

const Style& decimal_commas()
{
  static const Style style{std::regex(first_group + "((\\.[0-9]{3})+,[0-9]*|(\\.[0-9]{3}){2,})"),
                           std::regex(first_group + "(\\.[0-9]{3})+(,[0-9]*)?"), '.', "points"};
  return style;
}

bool fits(const std::string& cell, const std::regex& form)
{
  return cell.size() <= longest && std::regex_match(cell, form);
}

// of any width: no-break, narrow and thin blanks and the typographic apostrophe are UTF-8
void take_blanks(SurveyRows& survey)
{
  static const std::string blank = "( |'|\xc2\xa0|\xe2\x80\xaf|\xe2\x80\x89|\xe2\x80\x99)";
  static const std::regex form(first_group + "(" + blank + "[0-9]{3})+([.,][0-9]*)?"), blanks(blank);
  for (SurveyRow& row : survey.rows)
    for (std::string& cell : row.cells)
      if (fits(cell, form)) cell = std::regex_replace(cell, blanks, "");
}

struct CellPlace
{
  int line = 0;  // 0: there is none
  std::string cell;
};

CellPlace first_sure(const SurveyRows& survey, const Style& style)
{
  for (const SurveyRow& row : survey.rows)
    for (const std::string& cell : row.cells)
      if (fits(cell, style.sure)) return {row.line, cell};
  return {};
}

bool is_whole(const std::string& cell)
{
  return cell.find_first_not_of("0123456789") == std::string::npos && cell.find_first_of("123456789") != std::string::npos;
}

// Whole lengths in groups, 1,234, beside numbers with the decimal sign; no angle has four digits. Points group only where another
// length shows that lengths have no three decimals.
CellPlace first_whole(const SurveyRows& survey, const Style& style, char decimal)
{
  CellPlace first;
  bool sign = false, other_length = style.group == ',';
  for (const SurveyRow& row : survey.rows)
    for (std::size_t i = 0; i < survey_quantities; ++i)
    {
      const std::string& cell = row.cells[i];
      const bool has_sign = cell.find(decimal) != std::string::npos;
      sign = sign || has_sign;
      if (cell.find(style.group) == std::string::npos)
      {
        other_length = other_length || (!is_angle(i) && (has_sign || is_whole(cell)));
        continue;
      }
      if (is_angle(i) || !fits(cell, style.any)) return {};
      if (first.line == 0) first = {row.line, cell};
    }
  return sign && other_length ? first : CellPlace();
}

void take_signs(const Style& style, const CellPlace& first, SurveyRows& survey)
{
  for (SurveyRow& row : survey.rows)
    for (std::string& cell : row.cells)
      if (fits(cell, style.any)) cell.erase(std::remove(cell.begin(), cell.end(), style.group), cell.end());
  survey.remarks.push_back(std::string("its numbers have ") + style.name + " between groups of digits (first: line " +
                           std::to_string(first.line) + ": " + first.cell + ")");
}
}  // namespace

void take_groups(char delimiter, SurveyRows& survey, Problems& problems)
{
  take_blanks(survey);
  CellPlace point = first_sure(survey, decimal_points());
  CellPlace comma = delimiter == ',' ? CellPlace() : first_sure(survey, decimal_commas());
  if (point.line > 0 && comma.line > 0)
  {
    const CellPlace &first = point.line < comma.line ? point : comma, &second = point.line < comma.line ? comma : point;
    return problems.add_at(second.line, "",
                           second.cell + " has another decimal sign than " + first.cell + " (line " + std::to_string(first.line) +
                               "), needed: one decimal sign in all numbers");
  }
  if (point.line == 0 && comma.line == 0) point = first_whole(survey, decimal_points(), '.');
  if (point.line == 0 && comma.line == 0 && delimiter != ',') comma = first_whole(survey, decimal_commas(), ',');
  if (point.line > 0) survey.decimal_commas = false;
  if (point.line > 0) take_signs(decimal_points(), point, survey);
  if (comma.line > 0) take_signs(decimal_commas(), comma, survey);
}

}  // namespace drill_rig_sim
