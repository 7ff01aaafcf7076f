// SPDX-License-Identifier: BSD-3-Clause
// Changes scene files as their table of keys suggests: most of what comes out parses, and much of it is accepted. Works on the
// text, so that one change leaves everything else as it was.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "key_rows.h"
#include "random.h"
#include "text_changes.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
/// `key: value` with a scalar value.
struct Pair
{
  Span key, value;
};

/// Where a plain scalar that begins at `from` ends.
std::size_t end_of_scalar(const std::string& text, std::size_t from)
{
  std::size_t end = std::min(text.find_first_of(",]}#\n", from), text.size());
  while (end > from && text[end - 1] == ' ') --end;
  return end;
}

std::vector<Pair> pairs_in(const std::string& text)
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < text.size();)
  {
    if (text[i] == '#') i = end_of_line(text, i);
    if (i >= text.size() || !is_word(text[i]))
    {
      ++i;
      continue;
    }
    Pair pair;
    pair.key.begin = i;
    while (i < text.size() && is_word(text[i])) ++i;
    pair.key.end = i;
    if (text.compare(i, 2, ": ") != 0) continue;
    pair.value.begin = std::min(text.find_first_not_of(' ', i + 1), text.size());
    pair.value.end = end_of_scalar(text, pair.value.begin);
    if (pair.value.begin < pair.value.end && std::strchr("[{", text[pair.value.begin]) == nullptr)
    {
      pairs.push_back(pair);
      i = pair.value.end;
    }
  }
  return pairs;
}

/// The rows that a key's name fits.
std::vector<const KeyRow*> rows_named(const std::string& key)
{
  std::vector<const KeyRow*> rows;
  for (const KeyRow& row : key_rows())
    if (row.key == key) rows.push_back(&row);
  return rows;
}

void change_value(std::string& text, Random& random)
{
  const std::vector<Pair> pairs = pairs_in(text);
  if (pairs.empty()) return;
  const Pair& pair = any_of(pairs, random);
  const auto rows = rows_named(text.substr(pair.key.begin, pair.key.end - pair.key.begin));
  if (rows.empty()) return replace(text, pair.value, spelled(random.wild(1.0)));
  const KeyRow& row = *any_of(rows, random);
  // values near the old one keep the checks between keys content
  if (row.kind == ValueKind::number && random.one_in(3)) return scale_number(text, pair.value, random);
  replace(text, pair.value, draw_value(row, random));
}

/// Adds a key of the same block beside one that is there.
void add_key(std::string& text, Random& random)
{
  const std::vector<Pair> pairs = pairs_in(text);
  if (pairs.empty()) return;
  const std::size_t place = any_of(pairs, random).key.begin;
  std::size_t word_end = place;
  while (is_word(text[word_end])) ++word_end;
  const auto rows = rows_named(text.substr(place, word_end - place));
  if (rows.empty()) return;
  const int table = any_of(rows, random)->table;
  std::vector<const KeyRow*> siblings;
  for (const KeyRow& row : key_rows())
    if (row.table == table) siblings.push_back(&row);
  const KeyRow& row = *any_of(siblings, random);
  const std::size_t line = text.find_last_of('\n', place) + 1;  // npos + 1 is 0
  const std::string before = text.substr(line, place - line);
  const bool in_braces = before.find('{') != std::string::npos;
  text.insert(place, row.key + ": " + draw_value(row, random) + (in_braces ? ", " : "\n" + std::string(before.size(), ' ')));
}

void remove_key(std::string& text, Random& random)
{
  const std::vector<Pair> pairs = pairs_in(text);
  if (pairs.empty()) return;
  const Pair& pair = any_of(pairs, random);
  std::size_t end = pair.value.end;
  while (end < text.size() && (text[end] == ',' || text[end] == ' ')) ++end;
  text.erase(pair.key.begin, end - pair.key.begin);
}

void change(std::string& text, Random& random)
{
  const std::size_t which = random.below(100);
  if (which < 55)
    change_value(text, random);
  else if (which < 70)
    change_number(text, random);
  else if (which < 82)
    add_key(text, random);
  else if (which < 89)
    remove_key(text, random);
  else if (which < 93)
    change_lines(text, random);
  else
    change_seed(text, random);
}
}  // namespace
}  // namespace fuzz
}  // namespace drill_rig_sim

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed)
{
  using namespace drill_rig_sim::fuzz;
  Random random(seed);
  if (random.one_in(16)) return LLVMFuzzerMutate(data, size, max_size);
  std::string text(reinterpret_cast<const char*>(data), size);
  do change(text, random);
  while (random.one_in(3));
  const std::size_t length = std::min(text.size(), max_size);
  std::memcpy(data, text.data(), length);
  return length;
}
