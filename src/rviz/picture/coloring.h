// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLORING_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLORING_H

#include <vector>

#include "color_scale.h"
#include "drill_rig_sim/math/shown_units.h"
#include "string_data.h"

namespace drill_rig_sim
{
/// What the string is coloured by.
struct Coloring
{
  const char* name;
  Dimension dimension;
  const char* remark;  ///< in the place of a unit; "": none
  double least_scale;  ///< of an automatic scale: what is smaller is rounding, as contact in a vertical hole [SI]
  double share;        ///< of the values that lie within an automatic scale: SteadyRange::take
  double fixed_high;   ///< full scale where it is not automatic by default, in units; 0: automatic
  bool levels;         ///< two colours and no scale
};

/// All of them, in the order of the display's list.
const std::vector<Coloring>& colorings();

/// The values along the string, in the colouring's unit; `which`: index in colorings().
std::vector<double> values_of(std::size_t which, const StringData& data, UnitSystem units = UnitSystem::si);

/// A scale that is at least as wide as the colouring's least, in the units shown: a side that is smaller is left out.
ColorScale at_least(const ColorScale& scale, const Coloring& coloring, UnitSystem units);

/// Of free and of guided nodes.
Color level_color(double guided) noexcept;

}  // namespace drill_rig_sim

#endif
