#ifndef DRILL_RIG_SIM_STRING_LOWER_BODY_H
#define DRILL_RIG_SIM_STRING_LOWER_BODY_H

#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/well/turn_limit.h"

namespace drill_rig_sim
{
/// The stiff body that follows the bit ends at a motor's bend or a pointing tool's pivot, and so many bit diameters above the bit's middle at most: 50 kN on the
/// middle of 3 m of a 6 3/4 in motor bend it by 3 mm, a tenth of its clearance in a hole of 8 1/2 in.
constexpr double stiff_diameters = 14.0;

/// How fast that body lets the hole turn: equation (1) of turn_limit.h with the clearances of gauge pads, sleeve, blades, tool joints and bodies in a hole of
/// the bit's diameter.
TurnLimit turn_limit(const Mesh& mesh) noexcept;

}  // namespace drill_rig_sim

#endif
