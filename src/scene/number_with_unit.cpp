// SPDX-License-Identifier: BSD-3-Clause
#include "number_with_unit.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/ends_with.h"
#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/well/problem.h"
#include "problems.h"

namespace drill_rig_sim
{
namespace
{
/// The units of a key: a family, each of its units followed by `suffix`.
struct KeyUnits
{
  const UnitFamily* family = nullptr;  // none: its own unit is the only one
  std::string suffix;
};

// a gauge's drift is in units of its signal per second, or per square root of a second
KeyUnits units_of(const std::string& key_unit)
{
  if (const UnitFamily* family = family_of(key_unit)) return {family, ""};
  for (const std::string suffix : {"/s^0.5", "/s"})
  {
    if (!ends_with(key_unit, suffix)) continue;
    if (const UnitFamily* family = family_of(key_unit.substr(0, key_unit.size() - suffix.size()))) return {family, suffix};
  }
  return {};
}

FoundUnit find_in(const KeyUnits& units, const std::string& written)
{
  if (!units.family) return {};
  if (units.suffix.empty()) return find_unit(*units.family, written);
  return ends_with(written, units.suffix) ? find_unit(*units.family, written.substr(0, written.size() - units.suffix.size()))
                                          : FoundUnit();
}

std::string allowed_units(const KeyUnits& units, const std::string& key_unit)
{
  if (key_unit.empty() || key_unit == "-") return "a number without a unit";
  return units.family ? listed_units(*units.family, units.suffix) : "a number without a unit, which is in " + key_unit;
}

// What is wrong with a unit that the key does not take.
std::string refusal(const KeyUnits& units, const std::string& written, const std::string& key_unit)
{
  const std::string allowed = "; allowed: " + allowed_units(units, key_unit);
  const UnitFamily* other = family_of(written);
  return (other ? written + " is " + other->quantity : "unknown unit \"" + shortened(written) + '"') + allowed;
}

// a number of a message, which has six figures; the first one, if it is what was given, is shown as it was
std::string shown_in(const InputUnit& unit, double in_key_unit, bool is_first)
{
  const double number = unit.from_key_unit(in_key_unit);
  return plain(is_first && std::abs(number - unit.number) <= 1e-5 * std::abs(unit.number) ? unit.number : number);
}

bool may_begin_a_unit(const std::string& text)
{
  return std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '%' || text[0] == '"' || text[0] == '\'' ||
         static_cast<unsigned char>(text[0]) >= 0x80 || text.compare(0, 2, "1/") == 0;
}
// 8\u00bd in becomes 8 1/2 in
std::string with_plain_fraction(std::string text)
{
  static const std::vector<std::pair<std::string, std::string>> fractions = {
      {"\u00bd", " 1/2"}, {"\u00bc", " 1/4"}, {"\u00be", " 3/4"}, {"\u215b", " 1/8"},
      {"\u215c", " 3/8"}, {"\u215d", " 5/8"}, {"\u215e", " 7/8"}, {"\u2044", "/"}};
  for (const auto& [sign, plain] : fractions)
  {
    const std::size_t at = text.find(sign);
    if (at != std::string::npos) text.replace(at, sign.size(), plain);
  }
  return text;
}

// takes the fraction of 8-1/2 in, 8 1/2 in or 12/32 in from where a whole number ends, and adds it to the number or replaces it
void take_fraction(const std::string& text, std::size_t& end, WrittenNumber& number)
{
  const std::string unit = " *[A-Za-z\"'\x80-\xff].*";
  static const std::regex added("[ -]+([0-9]{1,2})/([1-9][0-9]?)" + unit), whole("([0-9]{1,2})/([1-9][0-9]?)" + unit);
  std::smatch part;
  const std::size_t begin = text.find_first_not_of(' ');
  const std::string rest = text.substr(end), all = text.substr(std::min(begin, text.size()));
  const bool is_added = std::regex_match(rest, part, added);
  if (text.find_first_not_of("0123456789", begin) != end || !(is_added || std::regex_match(all, part, whole))) return;
  const long double fraction = std::stold(part[1]) / std::stold(part[2]);
  end = static_cast<std::size_t>(part.position(2) + part.length(2)) + (is_added ? end : begin);
  number.exact = fraction + (is_added ? number.exact : 0.0L);
  number.value = static_cast<double>(fraction) + (is_added ? number.value : 0.0);
}
}  // namespace

bool split_number(const std::string& written, WrittenNumber& number)
{
  const std::string text = with_plain_fraction(written);
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  if (!(in >> number.value)) return false;
  number.unit.clear();
  if (in.peek() == std::istringstream::traits_type::eof()) return true;
  auto end = static_cast<std::size_t>(in.tellg());
  std::istringstream digits(text.substr(0, end));
  digits.imbue(std::locale::classic());
  if (!(digits >> number.exact)) return false;
  take_fraction(text, end, number);
  const std::size_t first = text.find_first_not_of(' ', end);
  if (first == std::string::npos || !may_begin_a_unit(text.substr(first))) return false;
  number.unit = plain_unit(text.substr(first, text.find_last_not_of(' ') - first + 1));
  return true;
}

std::string find_input_unit(const WrittenNumber& number, const std::string& key_unit, InputUnit& unit)
{
  const std::string& written = number.unit;
  unit = {};
  unit.number = number.value;
  if (written.empty()) return "";
  const std::string own = plain_unit(key_unit);
  const KeyUnits units = units_of(own);
  const FoundUnit found = find_in(units, written);
  if (!found.choices.empty())
    return written + " is ambiguous; allowed: " + found.choices + (units.suffix.empty() ? "" : ", each with " + units.suffix);
  if (!found.unit && written != own) return refusal(units, written, key_unit);
  unit.name = written;
  if (!found.unit || written == own) return "";
  const UnitName& of_key = *find_in(units, own).unit;
  unit.factor = found.unit->si / of_key.si;
  unit.zero = found.unit->zero - of_key.zero / unit.factor;
  return "";
}

std::string in_input_unit(const std::string& message, const std::string& key_unit, const InputUnit& unit)
{
  if (unit.name.empty() || unit.name == plain_unit(key_unit)) return message;
  static const std::regex number("-?[0-9][0-9.]*(e[-+]?[0-9]+)?");
  const std::regex numbers_of_unit("(-?[0-9][0-9.]*(e[-+]?[0-9]+)?( to (below )?))?-?[0-9][0-9.]*(e[-+]?[0-9]+)? " + key_unit +
                                   "(?![A-Za-z0-9/^])");
  std::string out;
  bool is_first = true;
  auto at = message.begin();
  for (std::sregex_iterator found(message.begin(), message.end(), numbers_of_unit), none; found != none; ++found)
  {
    out.append(at, message.begin() + found->position());
    std::string part = found->str().substr(0, found->str().size() - key_unit.size());
    for (std::sregex_iterator each(part.begin(), part.end(), number); each != none; ++each)
    {
      WrittenNumber given;
      split_number(each->str(), given);
      out += each->prefix().str() + shown_in(unit, given.value, is_first);
      is_first = false;
    }
    out += " " + unit.name;
    at = message.begin() + found->position() + found->length();
  }
  return out.append(at, message.end());
}

}  // namespace drill_rig_sim
