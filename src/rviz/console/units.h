// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_UNITS_H
#define DRILL_RIG_SIM_SRC_RVIZ_CONSOLE_UNITS_H

#include "drill_rig_sim/math/shown_units.h"

/// The units of the console are those of the runner's commands.
namespace drill_rig_sim::console
{
using drill_rig_sim::Dimension;
using drill_rig_sim::si_name;
using drill_rig_sim::to_shown;
using drill_rig_sim::to_si;
using drill_rig_sim::Unit;
using drill_rig_sim::unit_of;
using drill_rig_sim::UnitSystem;
}  // namespace drill_rig_sim::console

#endif
