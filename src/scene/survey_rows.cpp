// SPDX-License-Identifier: BSD-3-Clause
#include "survey_rows.h"

#include <algorithm>
#include <locale>
#include <regex>
#include <sstream>

namespace drill_rig_sim
{
namespace
{
// what stands for no value in records and surveys; none of them is a depth or an angle
constexpr std::array<double, 7> nulls = {-999.0, -999.25, -9999.0, -9999.25, -99999.0, -99999.25, -999999.0};

// of typesetters: the minus sign, a short and a long dash
const std::array<std::string, 3> dashes = {"\xe2\x88\x92", "\xe2\x80\x93", "\xe2\x80\x94"};

bool is_empty_text(const std::string& cell)
{
  const std::string text = lowered(cell);
  if (std::find(dashes.begin(), dashes.end(), text) != dashes.end()) return true;
  return text.find_first_not_of('-') == std::string::npos || text == "null" || text == "n/a" || text == "na";
}

constexpr std::size_t longest_shown = 24;

// with the mark of a footnote or a unit behind the number: 2000.0*, 2000.01), 2000.0 m; of superscripts and daggers in UTF-8
bool has_mark(const std::string& cell)
{
  static const std::string mark =
      "([*+)]|[0-9a-zA-Z][)]|[([][0-9a-zA-Z][)\\]]|[a-df-h]|m|ft|\xc2\xb9|\xc2\xb2|\xc2\xb3|\xe2\x80\xa0|\xe2\x80\xa1)";
  static const std::regex form("[+-]?[0-9][0-9.,']*( ?" + mark + "){1,2}");
  return cell.size() <= longest_shown && std::regex_match(cell, form);
}

// 12,5 as 12.5; a comma beside a point, or two of them, stays and is wrong
std::string with_point(std::string cell)
{
  const std::size_t comma = cell.find(',');
  if (comma != std::string::npos && cell.find('.') == std::string::npos) cell[comma] = '.';
  return cell;
}
}  // namespace

std::string with_hyphen(const std::string& cell)
{
  for (const std::string& dash : dashes)
    if (cell.size() > dash.size() && cell.rfind(dash, 0) == 0 &&
        std::string("0123456789.,").find(cell[dash.size()]) != std::string::npos)
      return "-" + cell.substr(dash.size());
  return cell;
}

CellKind read_cell(const std::string& cell, bool decimal_commas, double& value)
{
  if (is_empty_text(cell)) return CellKind::missing;
  std::istringstream in(decimal_commas ? with_point(cell) : cell);
  in.imbue(std::locale::classic());
  if (!(in >> value) || in.peek() != std::istringstream::traits_type::eof()) return CellKind::wrong;
  return std::find(nulls.begin(), nulls.end(), value) != nulls.end() ? CellKind::missing : CellKind::number;
}

std::string north_remark(const std::string& north)
{
  return "azimuths refer to " + north + " north and are not converted: the well's north is " + north + " north";
}

std::string shown_cell(const std::string& cell)
{
  const std::string lower = lowered(cell);
  const bool like_number =
      lower.find_first_of("0123456789") != std::string::npos && lower.find_first_not_of("0123456789+-.,'e ") == std::string::npos;
  for (const char* word : {"nan", "inf", "infinity", "null", "n/a", "na", "-", "--", "nan(ind)", "1.#inf", "1.#ind", "1.#qnan",
                           "#n/a", "#value!", "#ref!", "#num!", "#div/0!", "#name?", "#null!"})
    if (lower == word || lower == std::string("-") + word || lower == std::string("+") + word) return "\"" + cell + "\"";
  if (cell.empty()) return "nothing";
  return (like_number && cell.size() <= longest_shown) || has_mark(cell) ? "\"" + cell + "\"" : "text";
}

std::string number_problem(const std::string& cell)
{
  return (has_mark(cell) ? "must be a number without a mark or a unit behind it (got " : "must be a finite number (got ") +
         shown_cell(cell) + ")";
}

}  // namespace drill_rig_sim
