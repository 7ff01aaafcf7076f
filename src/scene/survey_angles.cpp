// SPDX-License-Identifier: BSD-3-Clause
#include "survey_angles.h"

#include <algorithm>
#include <regex>
#include <utility>

namespace drill_rig_sim
{
namespace
{
// the signs of degrees, minutes and seconds as d, ' and "
std::string with_plain_signs(std::string cell, bool decimal_commas)
{
  for (const auto& [sign, plain] : {std::pair<std::string, const char*>{"\xc2\xb0", "d"},
                                    {"\xc2\xba", "d"},
                                    {"\xe2\x80\xb2", "'"},
                                    {"\xe2\x80\x99", "'"},
                                    {"\xe2\x80\xb3", "\""},
                                    {"\xe2\x80\x9d", "\""},
                                    {"''", "\""}})
    for (std::size_t at = cell.find(sign); at != std::string::npos; at = cell.find(sign)) cell.replace(at, sign.size(), plain);
  if (decimal_commas) std::replace(cell.begin(), cell.end(), ',', '.');
  return cell;
}

double number(const std::string& digits)
{
  return digits.empty() ? 0.0 : std::stod(digits);
}

// from north or south towards east or west
double azimuth_of(char first, char last, double angle)
{
  const double from_north = first == 'N' || first == 'n' ? angle : 180.0 - angle;
  return last == 'E' || last == 'e' ? from_north : 360.0 - from_north;
}
}  // namespace

bool read_degrees(const std::string& cell, bool decimal_commas, bool bearing, double& degrees)
{
  static const std::regex form(
      "([NS])? *([0-9]{1,3}(?:[.][0-9]+)?) *(d)? *(?:([0-9]{1,2}(?:[.][0-9]+)?) *')? *(?:([0-9]{1,2}(?:[.][0-9]+)?) *\")? "
      "*([EW])?",
      std::regex::icase);
  std::smatch part;
  const std::string text = with_plain_signs(cell, decimal_commas);
  if (text.size() > 40 || !std::regex_match(text, part, form)) return false;
  const double minutes = number(part[4]), seconds = number(part[5]);
  const bool has_parts = part[4].matched || part[5].matched;
  if (part[1].matched != part[6].matched || (part[1].matched && !bearing) || (!part[1].matched && !part[3].matched)) return false;
  if (has_parts && (!part[3].matched || part[2].str().find('.') != std::string::npos || minutes >= 60.0 || seconds >= 60.0))
    return false;
  const double angle = number(part[2]) + minutes / 60.0 + seconds / 3600.0;
  if (part[1].matched && angle > 90.0) return false;
  degrees = part[1].matched ? azimuth_of(part[1].str()[0], part[6].str()[0], angle) : angle;
  return true;
}

}  // namespace drill_rig_sim
