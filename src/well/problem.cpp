// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/problem.h"

#include <cstdio>

namespace drill_rig_sim
{
std::string plain(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string metres(double value)
{
  return plain(value) + " m";
}

std::string item_key(const std::string& list, std::size_t index, const std::string& key)
{
  return list + "[" + std::to_string(index) + "]" + (key.empty() ? "" : "." + key);
}

}  // namespace drill_rig_sim
