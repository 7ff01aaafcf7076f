// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_DRIVE_TUNING_H
#define DRILL_RIG_SIM_RIG_DRIVE_TUNING_H

#include "drill_rig_sim/rig/top_drive.h"
#include "drill_rig_sim/string/mesh.h"

/// What SOFT_TORQUE and Z_TORQUE need to know of a string.
namespace drill_rig_sim
{
/// Torsional wave impedance of the pipe at the string's top, zeta = sqrt(G J_p rho J_p), as the mesh lumps it [N m s/rad]. Of 5
/// in x 4.276 in pipe 296, 5 1/2 in x 121.4 mm 401 (without tool joints).
double torsional_impedance(const Mesh& mesh);

/// The string's slowest torsional oscillation, held at the top, free at the bit, without friction [rad/s]: that of stick-slip. Of
/// lumped inertias K x = w^2 M x, by bisection on how many pivots of K - w^2 M are negative (Sturm).
double slowest_torsion(const Mesh& mesh);

/// The drive with what its impedances leave at 0 tuned to the string:
/// SOFT_TORQUE: P = 2 zeta, I = J' w^2, J' the inertia left of the rotor, w the slowest torsion: what mass and integral do
/// cancels there; Z_TORQUE:    P = zeta, I = zeta w / 8: absorbs from there up, until J' weighs. Both as if the slowest torsion
/// were 1 Hz at most: a short string that oscillates faster is not what they are for, and I would be stiff enough to make the
/// rotor ring on its own.
TopDriveSpec tuned(TopDriveSpec drive, const Mesh& mesh);

}  // namespace drill_rig_sim

#endif
