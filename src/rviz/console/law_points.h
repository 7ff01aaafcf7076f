// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LAW_POINTS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_LAW_POINTS_H

#include <string>

#include "units.h"

namespace drill_rig_sim::console
{
/// A set point of the package's laws, as ControllerStatus names it, and its box for the autodriller. The Python side has this
/// table as src/python/web/law_points.py, written by test/tool/test_tables.py.
struct LawPoint
{
  const char* name;
  const char* order;  // its name in an order to the autodriller (src/python/web/law_box.py)
  const char* label;
  Dimension dimension;
  double least, most;  // what an order may have [SI]
  double first;        // in the box before the first start [SI]; 0: none
  bool optional;       // no limit if it is left out
};

constexpr LawPoint law_points[] = {
    {"weight", "weight", "WOB", Dimension::force, 1e3, 1e6, 5e4, false},
    {"rop", "rop", "ROP", Dimension::penetration, 1e-4, 0.1, 0.01, false},
    {"pressure", "pressure", "differential pressure", Dimension::pressure, 1e4, 5e7, 0.0, true},
    {"torque", "torque", "torque over free", Dimension::torque, 10.0, 2e5, 0.0, true},
    {"rotary_speed", "rpm", "rotary speed", Dimension::rotation, 0.0, 40.0, 6.2832, false},
    {"flow", "flow", "flow", Dimension::flow, 0.0, 1.0, 0.03, false},
    {"to_depth", "to_depth", "to depth", Dimension::length, 0.0, 2e4, 0.0, false},
};

/// Null: there is none of this name.
inline const LawPoint* law_point(const std::string& name)
{
  for (const LawPoint& point : law_points)
    if (name == point.name) return &point;
  return nullptr;
}

}  // namespace drill_rig_sim::console

#endif
