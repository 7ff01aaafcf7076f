// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_PROBLEM_H
#define DRILL_RIG_SIM_WELL_PROBLEM_H

#include <string>
#include <utility>
#include <vector>

namespace drill_rig_sim
{
/// An invalid value of an input.
struct Problem
{
  std::string key;   ///< its place in the scene, as the scene file's keys name it: "well.sections[1].to"
  std::string text;  ///< one line: what is wrong, what is allowed

  Problem(std::string k, std::string t) : key(std::move(k)), text(std::move(t)) {}
};
using ProblemList = std::vector<Problem>;

/// A number as a person writes it: the fewest digits, at most six, that show it.
std::string plain(double value);
/// The same in metres, with the unit.
std::string metres(double value);
/// "list[index].key", "list[index]" without a key.
std::string item_key(const std::string& list, std::size_t index, const std::string& key = "");

}  // namespace drill_rig_sim

#endif
