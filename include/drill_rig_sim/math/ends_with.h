// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_ENDS_WITH_H
#define DRILL_RIG_SIM_MATH_ENDS_WITH_H

#include <string>

namespace drill_rig_sim
{
inline bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), std::string::npos, end) == 0;
}

}  // namespace drill_rig_sim

#endif
