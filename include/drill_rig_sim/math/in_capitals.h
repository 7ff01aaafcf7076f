// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_IN_CAPITALS_H
#define DRILL_RIG_SIM_MATH_IN_CAPITALS_H

#include <algorithm>
#include <cctype>
#include <string>

namespace drill_rig_sim
{
/// A word of letters as constants of messages are written.
inline std::string in_capitals(std::string word)
{
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

}  // namespace drill_rig_sim

#endif
