// SPDX-License-Identifier: BSD-3-Clause
// Prints the keys and words of a scene file, a quoted entry a line: a dictionary for libFuzzer's own mutations.
#include <cstdio>
#include <set>
#include <string>

#include "key_rows.h"

int main()
{
  std::set<std::string> entries;
  for (const drill_rig_sim::fuzz::KeyRow& row : drill_rig_sim::fuzz::key_rows())
  {
    entries.insert(row.key + ": ");
    entries.insert(row.words.begin(), row.words.end());
  }
  for (const std::string& entry : entries) std::printf("\"%s\"\n", entry.c_str());
}
