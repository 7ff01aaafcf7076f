// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"

#include <algorithm>
#include <iterator>

#include "drill_rig_sim/scene/read_scene.h"
#include "text_decoder.h"

namespace drill_rig_sim
{
namespace
{
// a hopeless file (a picture, say) need not scroll the screen away
constexpr std::size_t most_problems = 40;
// [characters] of a message; the text holds no more of the file than numbers and keys
constexpr std::size_t longest_key = 120, longest_text_of_problem = 600, longest_name = 40;

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

constexpr bool goes_on(char c)
{
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

struct Characters
{
  unsigned first, last;
};
// of two or three bytes: letters, marks of footnotes, dashes, fractions, arrows, signs of mathematics and ticks, without spaces
// and what has no sign of its own or changes the direction of the line
constexpr Characters shown_characters[] = {
    {0xa1, 0xac},     {0xae, 0x24f},    {0x391, 0x3a1},   {0x3a3, 0x52f},   {0x1e00, 0x1eff}, {0x2010, 0x2027}, {0x2030, 0x205e},
    {0x2070, 0x20c0}, {0x2100, 0x23ff}, {0x2460, 0x27bf}, {0x3001, 0x30ff}, {0x4e00, 0x9fff}, {0xac00, 0xd7a3}, {0xff01, 0xff5e}};

bool is_shown(const std::string& character)
{
  unsigned code = static_cast<unsigned char>(character.front()) & (character.size() == 2 ? 0x1fu : 0x0fu);
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (static_cast<unsigned char>(character[i]) & 0x3fu);
  return std::any_of(std::begin(shown_characters), std::end(shown_characters),
                     [&](const Characters& some) { return code >= some.first && code <= some.last; });
}

// what a broken file holds must not reach the one-line messages: control characters, line breaks, half of an UTF-8 sequence
std::string printable(const std::string& text)
{
  std::string out;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::string character = text.substr(at, std::max<std::size_t>(1, utf8_length(text, at)));
    const bool is_plain = character.size() == 1 && character[0] >= 0x20 && character[0] < 0x7f;
    const bool is_letter = (character.size() == 2 || character.size() == 3) && is_shown(character);
    out += is_plain || is_letter ? character : std::string(character.size(), '?');
    at += character.size();
  }
  return out;
}

std::string cut(const std::string& text, std::size_t longest)
{
  if (text.size() <= longest) return text;
  while (longest > 0 && goes_on(text[longest])) --longest;  // between two characters
  return text.substr(0, longest) + "...";
}
}  // namespace

std::string one_line(const std::string& file)
{
  std::string out;
  for (const char c : file) out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  return out;
}

SceneError::SceneError(std::vector<std::string> problems) : std::runtime_error(joined(problems)), problems_(std::move(problems))
{
}

void Problems::add_at(int line, const std::string& path, const std::string& text)
{
  if (problems_.size() == most_problems) problems_.push_back(file_ + ": and more problems");
  if (problems_.size() > most_problems) return;
  const std::string where = is_from_outside(path) ? "setting" : one_line(file_) + (line > 0 ? ":" + std::to_string(line) : "");
  const std::string key = path.empty() ? "" : cut(printable(path), longest_key) + ": ";
  problems_.push_back(where + ": " + key + cut(printable(text), longest_text_of_problem));
}

void Problems::add_in_input_unit(const std::string& path, const std::string& text)
{
  std::string shown = text;
  for (const GivenUnit& given : units_[path]) shown = in_input_unit(shown, given.key_unit, given.unit);
  add(path, shown);
}

void Problems::fail(int line, const std::string& path, const std::string& text)
{
  add_at(line, path, text);
  throw SceneError(problems_);
}

void Problems::raise() const
{
  if (!problems_.empty()) throw SceneError(problems_);
}

int Problems::line_of(std::string path) const
{
  while (true)
  {
    const auto found = lines_.find(path);
    if (found != lines_.end()) return found->second;
    if (path.empty()) return 1;
    const std::size_t end = path.find_last_of(".[");
    path.resize(end == std::string::npos ? 0 : end);
  }
}

std::string shortened(const std::string& text)
{
  return cut(text, longest_name);
}

}  // namespace drill_rig_sim
