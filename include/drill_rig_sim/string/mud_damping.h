// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_MUD_DAMPING_H
#define DRILL_RIG_SIM_STRING_MUD_DAMPING_H

#include <functional>

#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/string/mud.h"

namespace drill_rig_sim
{
/// Linear drag of the mud on a metre of string.
struct MudDamping
{
  double along = 0.0;   ///< [N s/m per m]
  double across = 0.0;  ///< [N s/m per m]
  double about = 0.0;   ///< against spin [N m s/rad per m]
};

/// What a Newtonian mud takes from waves of 1 Hz, and from swings of 5 Hz, of a tube in the middle of its hole. A wall that
/// swings along itself drags a shear layer with it: the force in phase with its speed is R = Re(mu k coth(k h)) per area, k = (1
/// + i) sqrt(rho w/(2 mu)), where a second wall stands still at a distance h, and Re(mu k tanh(k h)) where the mud swings alike
/// on both sides of a gap of 2 h (Stokes' second problem between plates; Landau and Lifshitz, Fluid Mechanics, section 24). In a
/// wide gap both are sqrt(rho mu w/2), in a narrow one the first is Couette's mu/h.
/// - along: pi D R_annulus + pi d R_bore
/// - about: the same on the levers D/2 and d/2, squared
/// - across: 2 pi D sqrt(rho mu w/2) (1 + (D/D_h)^3)/(1 - (D/D_h)^2)^2, the shear layers on tube and hole under the ideal fluid's
/// flow (Rogers,
///   Taylor and Pettigrew, ASME Pressure Vessels and Piping Conference, 1984); the bore's mud goes along. Singular for close
///   fits: D/D_h counts as sqrt(2/3) at most, as confinement() has it.
///
/// The frequencies are assumptions: what rings for long along and about a string has 0.2 to 2 Hz. Across it, pipe between two
/// tool joints swings at 3 to 7 Hz under 200 kN to 1 MN, and pipe that rolls on the wall at n turns a second at n D/(D_h - D): 2
/// Hz on its body and 6 Hz on its joints at 100 rpm, 5 in pipe in an 8 1/2 in hole. R goes with the root of the frequency. Steady
/// turning and tripping are braked by it too, though their shear layer fills the annulus: 0.2 N m a metre at 100 rpm.
/// @param outer, inner  D, d of the tube [m]
/// @param hole          D_h [m]
MudDamping mud_damping(const MudSpec& mud, double outer, double inner, double hole) noexcept;

/// Sets the drags of a mesh's nodes: those given in `mud` by the length of the node's share, the others by mud_damping() of the
/// elements beside it.
/// @param hole_diameter  of the hole at a distance above the bit's face, both [m]
void set_mud_damping(const MudSpec& mud, const std::function<double(double)>& hole_diameter, Mesh& mesh);

}  // namespace drill_rig_sim

#endif
