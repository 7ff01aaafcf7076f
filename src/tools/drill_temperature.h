// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_TEMPERATURE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_TEMPERATURE_H

#include "drill_rig_sim/sim/simulator.h"
#include "drill_units.h"

namespace drill_rig_sim
{
/// Prints what mud.temperature makes of the mud: temperatures at rest and after six hours at the pump's largest flow, the plastic
/// viscosity at the bit, stand-pipe pressure and ECD. Nothing without it.
void print_temperature(const Simulator& simulator, const Printed& printed);

}  // namespace drill_rig_sim

#endif
