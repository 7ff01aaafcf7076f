// SPDX-License-Identifier: BSD-3-Clause
#include "in_source.h"

namespace drill_rig_sim
{
std::string in_source(const std::string& path)
{
  return path.empty() ? DRILL_RIG_SIM_SOURCE_DIR : DRILL_RIG_SIM_SOURCE_DIR "/" + path;
}
}  // namespace drill_rig_sim
