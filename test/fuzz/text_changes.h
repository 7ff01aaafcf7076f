// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FUZZ_TEXT_CHANGES_H
#define DRILL_RIG_SIM_TEST_FUZZ_TEXT_CHANGES_H

#include <cstddef>
#include <string>
#include <vector>

#include "random.h"

/// Changes to inputs that are text, whatever they mean.
namespace drill_rig_sim
{
namespace fuzz
{
/// A stretch of text.
struct Span
{
  std::size_t begin = 0, end = 0;
};

template <class T>
const T& any_of(const std::vector<T>& list, Random& random)
{
  return list[random.below(list.size())];
}

/// A letter, a digit or _.
bool is_word(char c);
/// Where the line that holds `from` ends.
std::size_t end_of_line(const std::string& text, std::size_t from);
void replace(std::string& text, const Span& span, const std::string& with);
/// `value` as text from which the same double is read back.
std::string spelled(double value);

/// Another number in place of one: mostly near it.
void scale_number(std::string& text, const Span& span, Random& random);
/// Any number of the text.
void change_number(std::string& text, Random& random);
/// A line twice, or gone.
void change_lines(std::string& text, Random& random);
/// The line that seed_of() reads.
void change_seed(std::string& text, Random& random);

}  // namespace fuzz
}  // namespace drill_rig_sim

#endif
