// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_BETWEEN_H
#define DRILL_RIG_SIM_SRC_SIM_BETWEEN_H

#include "drill_rig_sim/string/mesh.h"

namespace drill_rig_sim
{
/// Place between two nodes.
struct Between
{
  int lower;
  double share;  // 0 at the lower node, 1 at the next one up
};

/// The place at an unstretched distance from the bit's face [m]; beyond the mesh's ends the share is below 0 or above 1.
Between find_between(const Mesh& mesh, double from_bit) noexcept;

}  // namespace drill_rig_sim

#endif
