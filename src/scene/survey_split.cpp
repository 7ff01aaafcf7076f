// SPDX-License-Identifier: BSD-3-Clause
#include "survey_split.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t most_columns = 256;  // what stands beyond is not looked at
constexpr const char* blanks = " \t\r";

// A cell's text: what is in quotes holds blanks and delimiters too, two quotes are one; one within a cell means seconds.
Cells cells_of(const std::string& line, char delimiter)
{
  Cells cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[i++];
    else if (c == '"' && (quoted || trimmed(cells.back()).empty()))
      quoted = !quoted;
    else if (c != delimiter || quoted)
      cells.back() += c;
    else if (cells.size() == most_columns)
      break;
    else
      cells.emplace_back();
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

bool is_bracket(char c)
{
  return c == '(' || c == '[';
}

// words parted by blanks; a unit in brackets belongs to the word before it
Cells words_between_blanks(const std::string& line)
{
  Cells words;
  for (const std::string& word : cells_of(line, ' '))
  {
    if (word.empty()) continue;
    const bool of_word = !words.empty() && is_bracket(word[0]) && !is_bracket(words.back()[0]);
    if (of_word)
      words.back() += " " + word;
    else
      words.push_back(word);
  }
  return words;
}

// a text and where it stands in its line, in signs from the line's begin
struct Placed
{
  std::string text;
  long begin, end;
};

bool is_blank(char c)
{
  return std::string_view(blanks).find(c) != std::string_view::npos;
}

// texts separated by this number of blanks or more
std::vector<Placed> placed_texts(const std::string& line, long apart)
{
  std::vector<Placed> found;
  long place = 0, last = -apart;
  for (const char c : line)
  {
    const bool continues = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // of a sign of several bytes
    if (!is_blank(c))
    {
      if (found.empty() || place - last > apart)
        found.push_back({"", place, place});
      else if (place - last > 1)
        found.back().text += ' ';
      found.back().text += c;
      found.back().end = last = place;
    }
    if (!continues) ++place;
  }
  return found;
}

// how far two texts stand apart, less where they overlap more
long distance(const Placed& one, const Placed& other)
{
  return std::max(one.begin, other.begin) - std::min(one.end, other.end);
}
}  // namespace

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Cells split(const std::string& line, char delimiter)
{
  return delimiter == ' ' ? words_between_blanks(trimmed(line)) : cells_of(line, delimiter);
}

Cells names_by_place(const std::vector<std::string>& lines, const std::string& row)
{
  const std::vector<Placed> cells = placed_texts(row, 1);
  constexpr std::size_t fewest = 3;
  const auto begins_number = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.'; };
  if (cells.size() < fewest || !begins_number(cells.front().text.front())) return {};
  Cells names(cells.size());
  for (const std::string& line : lines)
  {
    const std::vector<Placed> texts = placed_texts(line, 2);
    const Cells words = words_between_blanks(trimmed(line));
    if (texts.size() < cells.size() && words.size() == cells.size())
    {
      // names so long that one blank parts them: a word for each column
      for (std::size_t k = 0; k < words.size(); ++k) names[k] += (names[k].empty() ? "" : " ") + words[k];
      continue;
    }
    for (const Placed& name : texts)
    {
      const auto below = std::min_element(
          cells.begin(), cells.end(), [&](const Placed& a, const Placed& b) { return distance(name, a) < distance(name, b); });
      std::string& all = names[static_cast<std::size_t>(below - cells.begin())];
      all += (all.empty() ? "" : " ") + name.text;
    }
  }
  return names;
}

std::optional<std::size_t> place_left_out(const std::string& line, const std::string& other)
{
  if ((line + other).find('\t') != std::string::npos) return std::nullopt;
  const std::vector<Placed> cells = placed_texts(line, 1), others = placed_texts(other, 1);
  if (cells.size() != others.size()) return std::nullopt;
  std::size_t i = 0;
  while (i < cells.size() && distance(cells[i], others[i]) <= 0) ++i;
  if (i == 0 || i + 1 >= cells.size()) return std::nullopt;
  const auto left_out = [i](const std::vector<Placed>& a, const std::vector<Placed>& b)
  { return b[i].begin > a[i - 1].end + 1 && b[i].end < a[i].begin - 1 && distance(a[i], b[i + 1]) <= 0; };
  return left_out(cells, others) || left_out(others, cells) ? std::optional<std::size_t>(i) : std::nullopt;
}

}  // namespace drill_rig_sim
