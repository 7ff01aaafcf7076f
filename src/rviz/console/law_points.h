// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LAW_POINTS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LAW_POINTS_H

#include <string>

#include "units.h"

namespace drill_rig_sim::console
{
/// A set point of the package's laws, as ControllerStatus names it.
struct LawPoint
{
  const char* name;
  const char* order;  ///< its name in an order to the autodriller (src/python/web/law_box.py)
  const char* label;
  Dimension dimension;
};

constexpr LawPoint law_points[] = {{"weight", "weight", "WOB", Dimension::force},
                                   {"rop", "rop", "ROP", Dimension::penetration},
                                   {"pressure", "pressure", "differential pressure", Dimension::pressure},
                                   {"torque", "torque", "torque over free", Dimension::torque},
                                   {"rotary_speed", "rpm", "rotary speed", Dimension::rotation},
                                   {"flow", "flow", "flow", Dimension::flow},
                                   {"to_depth", "to_depth", "to depth", Dimension::length}};

/// Null: there is none of this name.
inline const LawPoint* law_point(const std::string& name)
{
  for (const LawPoint& point : law_points)
    if (name == point.name) return &point;
  return nullptr;
}

}  // namespace drill_rig_sim::console

#endif
