// SPDX-License-Identifier: BSD-3-Clause
#include "survey_words.h"

#include "drill_rig_sim/math/latin_letters.h"
#include "survey_rows.h"

namespace drill_rig_sim
{
const std::map<std::string, std::string>& norths()
{
  static const std::map<std::string, std::string> table = {{"true", "true"},
                                                           {"tn", "true"},
                                                           {"t", "true"},
                                                           {"g", "grid"},
                                                           {"grid", "grid"},
                                                           {"gn", "grid"},
                                                           {"mag", "magnetic"},
                                                           {"magnetic", "magnetic"},
                                                           {"mn", "magnetic"},
                                                           {"truenorth", "true"},
                                                           {"gridnorth", "grid"},
                                                           {"magneticnorth", "magnetic"},
                                                           {"magnetisch", "magnetic"},
                                                           {"magnetique", "magnetic"},
                                                           {"magnetico", "magnetic"},
                                                           {"magnitnyy", "magnetic"},
                                                           {"magnitnyj", "magnetic"},
                                                           {"magnitniy", "magnetic"},
                                                           {"magnetyczny", "magnetic"},
                                                           {"istinnyy", "true"},
                                                           {"istinnyj", "true"},
                                                           {"rechtweisend", "true"},
                                                           {"geographique", "true"},
                                                           {"geografico", "true"},
                                                           {"direktsionnyy", "grid"},
                                                           {"direktsionnyj", "grid"}};
  return table;
}

namespace
{
bool is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '%' || static_cast<unsigned char>(c) >= 0x80;
}
}  // namespace

Words name_words(const std::string& text)
{
  Words words(1);
  for (const char c : lowered(latin_letters(text)))
  {
    if (is_letter(c))
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string in_one(const Words& words, std::size_t count)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += words[i];
  return text;
}

const UnitName* unit_for(std::size_t quantity, const std::string& spelling)
{
  return is_angle(quantity) ? angle_unit(spelling) : length_unit(spelling);
}

std::string without_brackets(const std::string& text, Words& inside)
{
  std::string outside;
  bool in = false;
  for (const char c : text)
  {
    if (!in && (c == '(' || c == '[' || c == '{'))
    {
      in = true;
      inside.emplace_back();
      outside += ' ';
    }
    else if (in && (c == ')' || c == ']' || c == '}'))
      in = false;
    else
      (in ? inside.back() : outside) += c;
  }
  return outside;
}

}  // namespace drill_rig_sim
