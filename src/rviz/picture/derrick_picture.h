// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_DERRICK_PICTURE_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_DERRICK_PICTURE_H

#include "mesh_data.h"

namespace drill_rig_sim
{
/// Floor with its hole, four legs with braces, crown block. Sizes are those of a usual rig; only `crown_height` [m] is the
/// scene's.
MeshData derrick_mesh(double crown_height);

/// Travelling block and top drive, of which the shaft's end is the origin.
MeshData block_mesh();

/// Lines between crown and block: 2 `sheaves` of them, and the fast and the dead line beside. `block_height`: of the top drive's
/// shaft [m].
void add_lines(MeshData& lines, double crown_height, double block_height, int sheaves);

}  // namespace drill_rig_sim

#endif
