// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>

namespace drill_rig_sim
{
namespace
{
// so that what is divided by a number stays finite
constexpr double smallest = 1e-100;

// edits (insert, delete, replace) that turn a into b
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j)
    {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string unknown_key(const std::string& key, const std::vector<const char*>& known)
{
  const std::string shown = shortened(key);
  const char* nearest = nullptr;
  std::size_t least = 1 + std::max<std::size_t>(2, shown.size() / 3);
  for (const char* candidate : known)
  {
    const std::size_t distance = edit_distance(shown, candidate);
    if (distance < least)
    {
      least = distance;
      nearest = candidate;
    }
  }
  if (nearest) return std::string("unknown key; did you mean `") + nearest + "`?";
  return "unknown key, allowed: " + to_text(known);
}

bool plain_scalar(const YAML::Node& node)
{
  return node.IsScalar() && node.Tag() != "!";
}

// the whole of `text` as a decimal number, whatever the process's locale
bool parse_decimal(const std::string& text, double& value)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  return static_cast<bool>(in >> value) && in.peek() == std::istringstream::traits_type::eof();
}

bool is_infinite_or_nan(const std::string& text)
{
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string bare = lower.substr(std::min(lower.find_first_not_of("+-."), lower.size()));
  return bare == "nan" || bare == "inf" || bare == "infinity";
}

bool too_near_zero(double value)
{
  return value != 0.0 && std::abs(value) < smallest;
}

bool inside(double value, const Range& r)
{
  return (r.low_open ? value > r.low : value >= r.low) && (r.high_open ? value < r.high : value <= r.high);
}

// a number with its unit may be quoted: it is a text to YAML anyway
bool is_number(const YAML::Node& node, WrittenNumber& number)
{
  return node.IsScalar() && split_number(node.Scalar(), number) && (plain_scalar(node) || !number.unit.empty());
}

// of a key in `unit`, in the unit of the input
std::string range_text(const Range& allowed, const std::string& unit, const InputUnit& input)
{
  if (!input.name.empty())
  {
    const auto in_input = [&](double bound) { return input.from_key_unit(bound); };
    return to_text(Range{in_input(allowed.low), in_input(allowed.high), allowed.low_open, allowed.high_open}) + " " + input.name;
  }
  return to_text(allowed) + (unit.empty() || unit == "-" ? "" : " " + unit);
}
}  // namespace

int line_of(const YAML::Node& node)
{
  return node.Mark().line + 1;
}

std::string describe(const YAML::Node& node)
{
  if (node.IsMap()) return "a block";
  if (node.IsSequence()) return "a list";
  if (node.IsScalar()) return "text";
  return "nothing";
}

namespace
{
// of a key that a scene has: what stands elsewhere may be of any file and is not shown
std::string as_given(const YAML::Node& node)
{
  return node.IsScalar() ? '"' + shortened(node.Scalar()) + '"' : describe(node);
}

// where a number is needed, which has no quotes
std::string no_number(const YAML::Node& node)
{
  return as_given(node) + (node.IsScalar() && !plain_scalar(node) ? " in quotes" : "");
}
}  // namespace

std::string to_text(const Range& range)
{
  const std::string low = plain(range.low), high = plain(range.high);
  if (range.low_open) return "above " + low + ", up to " + high;
  if (range.high_open) return low + " to below " + high;
  return low + " to " + high;
}

std::string to_text(const std::vector<const char*>& words)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
  return text;
}

std::string join(const std::string& path, const std::string& key)
{
  return path.empty() ? key : path + "." + key;
}

std::string unit_with(const char* unit, const std::string& meant)
{
  const std::string text = unit, placeholder = "signal";
  return text.compare(0, placeholder.size(), placeholder) == 0 ? meant + text.substr(placeholder.size()) : text;
}

bool read_number(const YAML::Node& node, const std::string& path, const Range& allowed, const std::string& unit, double& value,
                 Problems& problems)
{
  WrittenNumber given;
  InputUnit input;
  if (!is_number(node, given))
  {
    const bool weird = plain_scalar(node) && is_infinite_or_nan(node.Scalar());
    problems.add(path, (weird ? "is not a finite number" : no_number(node) + " is not a number") +
                           ", allowed: " + range_text(allowed, unit, input));
    return false;
  }
  const std::string wrong_unit = find_input_unit(given, unit, input);
  if (!wrong_unit.empty())
  {
    problems.add(path, wrong_unit);
    return false;
  }
  const double read = given.unit.empty() ? given.value : static_cast<double>(input.in_key_unit(given.exact));
  const std::string shown = plain(given.value) + (input.name.empty() ? "" : " " + input.name);
  if (!inside(read, allowed))
  {
    problems.add(path, shown + " is out of range, allowed: " + range_text(allowed, unit, input));
    return false;
  }
  if (too_near_zero(read))
  {
    problems.add(path, shown + " is too close to 0, allowed: " + range_text(allowed, unit, input) + ", in size at least " +
                           plain(smallest) + (inside(0.0, allowed) ? " or 0" : ""));
    return false;
  }
  if (!input.name.empty()) problems.note_unit(path, unit, input);
  value = read;
  return true;
}

void read_whole(const YAML::Node& node, const std::string& path, const Range& allowed, int& value, Problems& problems)
{
  double read = 0.0;
  if (!plain_scalar(node) || !parse_decimal(node.Scalar(), read) || read != std::floor(read))
  {
    problems.add(path, no_number(node) + " is not a whole number, allowed: " + to_text(allowed));
    return;
  }
  if (!inside(read, allowed))
  {
    problems.add(path, plain(read) + " is out of range, allowed: " + to_text(allowed));
    return;
  }
  value = static_cast<int>(read);
}

bool read_word(const YAML::Node& node, const std::string& path, const std::vector<const char*>& words, int& word,
               Problems& problems)
{
  for (std::size_t i = 0; node.IsScalar() && i < words.size(); ++i)
  {
    if (node.Scalar() != words[i]) continue;
    word = static_cast<int>(i);
    return true;
  }
  problems.add(path, as_given(node) + " is not known, allowed: " + to_text(words));
  return false;
}

bool read_kind(const YAML::Node& node, const std::string& path, const char* key, const std::vector<const char*>& words, int& word,
               Problems& problems)
{
  if (!node.IsMap() || !node[key].IsDefined())
  {
    problems.add(join(path, key), "is missing, allowed: " + to_text(words));
    return false;
  }
  return read_word(node[key], join(path, key), words, word, problems);
}

void read_word_set(const YAML::Node& node, const std::string& path, const std::vector<const char*>& words, unsigned& value,
                   Problems& problems)
{
  if (!node.IsSequence() || node.size() == 0)
  {
    problems.add(path, as_given(node) + " is given, allowed: a list with some of " + to_text(words));
    return;
  }
  unsigned found = 0;
  for (std::size_t i = 0; i < node.size(); ++i)
  {
    int word = 0;
    if (!read_word(node[i], item_key(path, i), words, word, problems)) return;
    if (found & (1u << word))
      problems.add(item_key(path, i), std::string(words[static_cast<std::size_t>(word)]) + " is listed twice, allowed: once");
    found |= 1u << word;
  }
  value = found;
}

bool read_text(const YAML::Node& node, const std::string& path, std::string& value, Problems& problems)
{
  if (!node.IsScalar() || node.Scalar().empty())
  {
    problems.add(path, describe(node) + " is given, allowed: a text");
    return false;
  }
  value = node.Scalar();
  return true;
}

void read_flag(const YAML::Node& node, const std::string& path, double& value, Problems& problems)
{
  int word = 0;
  if (!read_word(node, path, {"false", "true"}, word, problems)) return;
  value = word;
}

void read_count_or_fill(const YAML::Node& node, const std::string& path, const Range& allowed, int& value, Problems& problems)
{
  if (node.IsScalar() && node.Scalar() == "fill")
  {
    value = 0;
    return;
  }
  double read = 0.0;
  if (!plain_scalar(node) || !parse_decimal(node.Scalar(), read))
  {
    problems.add(path, "must be " + to_text(allowed) + ", or fill (got " + no_number(node) + ")");
    return;
  }
  read_whole(node, path, allowed, value, problems);
}

std::map<std::string, YAML::Node> read_entries(const YAML::Node& node, const std::string& path,
                                               const std::vector<const char*>& known, Problems& problems)
{
  std::map<std::string, YAML::Node> entries;
  if (!node.IsMap())
  {
    problems.add(path, describe(node) + " is given, allowed: a block with the keys " + to_text(known));
    return entries;
  }
  for (const auto& item : node)
  {
    if (!item.first.IsScalar())
    {
      problems.add_at(line_of(item.first), path, describe(item.first) + " is not a key, allowed: " + to_text(known));
      continue;
    }
    const std::string key = item.first.Scalar();
    const std::string full = join(path, shortened(key));
    const bool is_known = std::any_of(known.begin(), known.end(), [&](const char* k) { return key == k; });
    if (!is_known)
    {
      problems.note(full, line_of(item.first));
      problems.add(full, unknown_key(key, known));
    }
    else if (!entries.emplace(key, item.second).second)
    {
      problems.add_at(line_of(item.first), full, "is given twice, allowed: once");
    }
    else
    {
      problems.note(full, line_of(item.first));
    }
  }
  return entries;
}

}  // namespace drill_rig_sim
