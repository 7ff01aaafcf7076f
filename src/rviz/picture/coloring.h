// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLORING_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_COLORING_H

#include <vector>

#include "color_scale.h"
#include "string_data.h"

namespace drill_rig_sim
{
/// What the string is coloured by.
struct Coloring
{
  const char* name;
  const char* unit;   ///< that legend and full scale are in
  double unit_size;   ///< one of it, in SI
  double share;       ///< of the values that lie within an automatic scale: SteadyRange::take
  double fixed_high;  ///< full scale where it is not automatic by default, in units; 0: automatic
  bool levels;        ///< two colours and no scale
};

/// All of them, in the order of the display's list.
const std::vector<Coloring>& colorings();

/// The values along the string, in the colouring's unit; `which`: index in colorings().
std::vector<double> values_of(std::size_t which, const StringData& data);

/// Of free and of guided nodes.
Color level_color(double guided) noexcept;

}  // namespace drill_rig_sim

#endif
