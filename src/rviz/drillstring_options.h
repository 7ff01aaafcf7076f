// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_OPTIONS_H
#define DRILL_RIG_SIM_SRC_RVIZ_DRILLSTRING_OPTIONS_H

#include <cstddef>

#include "drill_rig_sim/math/shown_units.h"

namespace drill_rig_sim
{
enum class WallStyle
{
  cut_open,  ///< the side towards the eye is left out
  whole,     ///< seen through
  none
};

/// What the display's properties say.
struct DrillstringOptions
{
  std::size_t coloring = 3;           ///< index in colorings()
  double full_scale = 0.0;            ///< in the colouring's unit; 0: automatic
  double exaggeration = 0.0;          ///< of what lies across the hole; 0: as suits the camera
  UnitSystem units = UnitSystem::si;  ///< of legend, ruler and probe
  bool true_diameter = false;         ///< of the string
  int sides = 10;
  bool coarse =
      false;  ///< no property: the eye is so far away that tool joints are less than a pixel or two, and few faces are enough
  double force_scale = 0.0;  ///< of contact forces [m per kN/m]; 0: automatic
  double cased_to = -1.0;    ///< measured depth [m]; below 0: of the last section but one
  WallStyle wall = WallStyle::cut_open;
  bool string = true, blades = true, layers = true, forces = true, plan = true, stations = true, trail = true, ruler = true,
       parts = true, derrick = true, legend = true, faults = true;
};

}  // namespace drill_rig_sim

#endif
