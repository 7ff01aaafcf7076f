// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/math/latin_letters.h"

#include <map>
#include <utility>

namespace drill_rig_sim
{
namespace
{
// clang-format off
// letters of two bytes, one after the other, and what stands for each of them
constexpr std::pair<const char*, const char*> letters[] = {
    {"ЪЬъь", ""}, {"ÀÁÂÃÄÅĀĂĄА", "A"}, {"àáâãäåāăąа", "a"}, {"Б", "B"}, {"б", "b"}, {"ÇĆĈĊČ", "C"}, {"çćĉċč", "c"},
    {"ĎĐД", "D"}, {"ďđд", "d"}, {"ÈÉÊËĒĔĖĘĚЁЕЭ", "E"}, {"èéêëēĕėęěеэё", "e"}, {"Ф", "F"}, {"ф", "f"},
    {"ĜĞĠĢГ", "G"}, {"ĝğġģг", "g"}, {"Ĥ", "H"}, {"ĥ", "h"}, {"ÌÍÎÏĨĪĬĮİИ", "I"}, {"ìíîïĩīĭįıи", "i"}, {"Ĵ", "J"},
    {"ĵ", "j"}, {"ĶК", "K"}, {"ķк", "k"}, {"ĹĻĽŁЛ", "L"}, {"ĺļľłл", "l"}, {"М", "M"}, {"м", "m"}, {"ÑŃŅŇН", "N"},
    {"ñńņňн", "n"}, {"ÒÓÔÕÖØŌŎŐО", "O"}, {"òóôõöøōŏőо", "o"}, {"П", "P"}, {"п", "p"}, {"ŔŖŘР", "R"}, {"ŕŗřр", "r"},
    {"ŚŜŞŠС", "S"}, {"śŝşšс", "s"}, {"ŢŤТ", "T"}, {"ţťт", "t"}, {"ÙÚÛÜŨŪŬŮŰŲУ", "U"}, {"ùúûüũūŭůűųу", "u"},
    {"В", "V"}, {"в", "v"}, {"Ŵ", "W"}, {"ŵ", "w"}, {"ÝŶŸЙЫ", "Y"}, {"ýÿŷйы", "y"}, {"ŹŻŽЗ", "Z"}, {"źżžз", "z"},
    {"Æ", "Ae"}, {"æ", "ae"}, {"Ч", "Ch"}, {"ч", "ch"}, {"Х", "Kh"}, {"х", "kh"}, {"Œ", "Oe"}, {"œ", "oe"},
    {"Ш", "Sh"}, {"ш", "sh"}, {"ß", "ss"}, {"Ц", "Ts"}, {"ц", "ts"}, {"Я", "Ya"}, {"я", "ya"}, {"Ю", "Yu"},
    {"ю", "yu"}, {"Ж", "Zh"}, {"ж", "zh"}, {"Щ", "Shch"}, {"щ", "shch"}};
// clang-format on

const std::map<std::string, std::string>& table()
{
  static const std::map<std::string, std::string> by_letter = []
  {
    std::map<std::string, std::string> all;
    for (const auto& [several, latin] : letters)
      for (const char* letter = several; *letter != '\0'; letter += 2) all[std::string(letter, 2)] = latin;
    return all;
  }();
  return by_letter;
}

bool begins_two_bytes(char c)
{
  return (static_cast<unsigned char>(c) & 0xe0) == 0xc0;
}
}  // namespace

std::string latin_letters(const std::string& text)
{
  std::string latin;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const auto letter = begins_two_bytes(text[i]) ? table().find(text.substr(i, 2)) : table().end();
    latin += letter == table().end() ? std::string(1, text[i]) : letter->second;
    if (letter != table().end()) ++i;
  }
  return latin;
}

}  // namespace drill_rig_sim
