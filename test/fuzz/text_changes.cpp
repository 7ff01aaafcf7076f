// SPDX-License-Identifier: BSD-3-Clause
#include "text_changes.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
/// Numbers wherever they stand.
std::vector<Span> numbers_in(const std::string& text)
{
  std::vector<Span> numbers;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool starts =
        (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '-') && (i == 0 || !is_word(text[i - 1]));
    if (!starts) continue;
    char* end = nullptr;
    std::strtod(text.c_str() + i, &end);
    const std::size_t stop = static_cast<std::size_t>(end - text.c_str());
    if (stop == i) continue;
    numbers.push_back({i, stop});
    i = stop;
  }
  return numbers;
}
}  // namespace

bool is_word(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::size_t end_of_line(const std::string& text, std::size_t from)
{
  return std::min(text.find('\n', from), text.size());
}

void replace(std::string& text, const Span& span, const std::string& with)
{
  text.replace(span.begin, span.end - span.begin, with);
}

std::string spelled(double value)
{
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0.0 ? ".inf" : "-.inf";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

void scale_number(std::string& text, const Span& span, Random& random)
{
  const double old = std::strtod(text.c_str() + span.begin, nullptr);
  replace(text, span, spelled(random.one_in(10) ? random.wild(old) : old * random.between(0.7, 1.4)));
}

void change_number(std::string& text, Random& random)
{
  const std::vector<Span> numbers = numbers_in(text);
  if (!numbers.empty()) scale_number(text, any_of(numbers, random), random);
}

void change_lines(std::string& text, Random& random)
{
  if (text.empty()) return;
  const std::size_t place = random.below(text.size());
  const std::size_t begin = text.find_last_of('\n', place) + 1;
  const std::size_t end = std::min(end_of_line(text, place) + 1, text.size());
  if (begin >= end) return;
  if (random.one_in(2))
    text.erase(begin, end - begin);
  else
    text.insert(begin, text.substr(begin, end - begin));
}

void change_seed(std::string& text, Random& random)
{
  const std::size_t old = text.rfind("# ", 0) == 0 ? end_of_line(text, 0) : 0;
  text.replace(0, old, "# " + std::to_string(random.below(1000000)) + (old == 0 ? "\n" : ""));
}

}  // namespace fuzz
}  // namespace drill_rig_sim
