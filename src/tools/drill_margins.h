// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_MARGINS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_MARGINS_H

#include "drill_rig_sim/solve/start.h"
#include "drill_units.h"

namespace drill_rig_sim
{
/// Torque that turns the string at a scene's start against the friction of the wall, T = sum of mu N r over all contacts: kinetic
/// friction, the normal forces of the equilibrium without friction, nothing for the bit [N m].
/// @param rig  build_at_rest() of the scene
double turning_torque(const RigAtRest& rig);

/// Prints what the rig cannot do though each of its numbers is allowed, a line each: a top drive that cannot turn the string, a
/// winch that its limits stop at the start, and a weight on bit near the hook load of the string off bottom, which is all that
/// there is to set down.
void print_margins(const RigAtRest& rig, const Printed& printed);

/// Prints the operations that drill, before which neither the top drive nor a motor turns the bit; print_margins() does, where no
/// program turns it.
void print_bits_that_stand(const Scene& scene);

}  // namespace drill_rig_sim

#endif
