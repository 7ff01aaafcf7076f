// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_SHARED_UNITS_H
#define DRILL_RIG_SIM_SRC_RVIZ_SHARED_UNITS_H

#include "drill_rig_sim/math/shown_units.h"

namespace drill_rig_sim
{
/// Units that the driller's console of this process was set to last, which the displays follow; SI before. For the thread of the
/// user interface.
inline UnitSystem& console_units()
{
  static UnitSystem units = UnitSystem::si;
  return units;
}

}  // namespace drill_rig_sim

#endif
