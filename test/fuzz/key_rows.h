// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_FUZZ_KEY_ROWS_H
#define DRILL_RIG_SIM_TEST_FUZZ_KEY_ROWS_H

#include <string>
#include <vector>

#include "random.h"
#include "scene_keys.h"

/// The table of scene keys, flattened for the mutator.
namespace drill_rig_sim
{
namespace fuzz
{
enum class ValueKind
{
  number,
  whole,
  word,  ///< one of `words`
  text,
  block  ///< a block or list: no value of its own
};

struct KeyRow
{
  int table = 0;  ///< rows of one table belong into one block
  std::string key;
  ValueKind kind = ValueKind::number;
  Range allowed;
  std::string unit;
  std::vector<std::string> words;
};

/// All rows of all tables.
const std::vector<KeyRow>& key_rows();

/// A value for the row as a scene file would spell it: inside the range, at its ends, just beyond, far beyond, or no such value.
std::string draw_value(const KeyRow& row, Random& random);

}  // namespace fuzz
}  // namespace drill_rig_sim

#endif
