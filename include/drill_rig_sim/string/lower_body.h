// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_LOWER_BODY_H
#define DRILL_RIG_SIM_STRING_LOWER_BODY_H

#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/well/turn_limit.h"

namespace drill_rig_sim
{
/// Largest length of the stiff body behind the bit, in bit diameters from the middle of the bit. It ends earlier at a motor's
/// bend or a pointing tool's pivot. Example: 50 kN in the middle of 3 m of a 6 3/4 in motor bend it by 3 mm, a tenth of its
/// clearance in a hole of 8 1/2 in.
constexpr double stiff_diameters = 14.0;

/// Largest curvature of the hole in which that body fits: equation (1) of turn_limit.h. Clearances are those of gauge pads,
/// sleeve, blades, tool joints and bodies in a hole of the bit's diameter.
TurnLimit turn_limit(const Mesh& mesh) noexcept;

}  // namespace drill_rig_sim

#endif
