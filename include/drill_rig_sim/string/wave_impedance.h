// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_WAVE_IMPEDANCE_H
#define DRILL_RIG_SIM_STRING_WAVE_IMPEDANCE_H

#include <cmath>

#include "drill_rig_sim/string/mesh.h"

namespace drill_rig_sim
{
/// Of a string as its mesh lumps it: torque over speed of a wave about it, zeta = sqrt(G J_p i') with the inertia i' per length
/// [N m s/rad].
inline double torsional_impedance(const BeamSection& section, const MeshNode& node) noexcept
{
  return std::sqrt(section.torsion * section.length * node.spin_inertia / node.length);
}

}  // namespace drill_rig_sim

#endif
