// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_LOSSES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_LOSSES_H

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_units.h"

namespace drill_rig_sim
{
/// Prints what the mud loses by section at the pump's largest flow; with a rheology of the mud also its curve, and the ECD at the
/// ends of the hole's sections and at the bit.
void print_losses(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, const Printed& printed);

}  // namespace drill_rig_sim

#endif
