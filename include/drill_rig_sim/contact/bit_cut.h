// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_BIT_CUT_H
#define DRILL_RIG_SIM_CONTACT_BIT_CUT_H

#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/well/formation.h"

/// Regenerative law of a drag bit: weight and torque follow from the depth of cut that its blades find now, and that is what the
/// blade before left: the rock remembers the vibration of one blade's pass and feeds it to the next.
///
/// With u the height of the bit down the hole and n blades alike, t_n the time since the blade ahead was where this one is,
///   delta = u(t) - u(t - t_n),   phi(t) - phi(t - t_n) = 2 pi/n,   depth of cut per turn d = n delta,
///   W = W_c + W_f,  W_c = zeta epsilon a d,   T = a W_c/(2 zeta) + mu gamma (a/2) W_f.
/// In steady drilling d = 2 pi v/N, so that the mean law v = K N (W - F_0) is its mean with 1/K = 2 pi a zeta epsilon and W_f =
/// F_0: the scene's drillability and threshold are its one input, and the weight's stiffness is W_c = n/(2 pi K) delta. If
/// delta < 0, the bit is above the rock, and there is no contact. Sources: Richard, Germay, Detournay, A simplified model to
/// explore the root cause of stick-slip vibrations in drilling systems with drag bits, J. Sound Vib. 305 (2007), 432-456;
/// Besselink, van de Wouw, Nijmeijer, J. Comput. Nonlinear Dyn. 6 (2011), 021006.
///
/// They let the flats carry W_f while the bit goes down, nothing while it goes up, and anything between while it rests. Here that
/// is an elastic flat that yields: its load follows the height by the stiffness W_f/d_f within 0 and the limit W_f min(1,
/// delta/d_f), d_f = 0.1 mm. A bit that turns back cuts nothing and stands on the rock ahead of where it has cut farthest.
namespace drill_rig_sim
{
/// The law in one rock.
struct BitCutLaw
{
  double stiffness = 0.0;  ///< of all cutters' weight by the depth of cut of one blade, n/(2 pi K) [N/m]
  double flats = 0.0;      ///< W_f [N]
};

/// Height over which the flats take up their load, d_f [m].
constexpr double flats_height = 1e-4;

BitCutLaw bit_cut_law(const BitTorqueSpec& spec, const FormationLayer& rock) noexcept;

/// Weight on cutters and flats, and its slopes by the depth at a fixed height (as the ground under the blade falls) and by the
/// height at a fixed depth.
struct CutWeight
{
  double cutters = 0.0;           ///< W_c >= 0 [N]
  double flats = 0.0;             ///< of the flats, 0 to W_f; the next step's start, once this one is accepted [N]
  double cutters_by_depth = 0.0;  ///< [N/m]
  double flats_by_depth = 0.0;    ///< [N/m]
  double flats_by_height = 0.0;   ///< [N/m]

  double weight() const noexcept { return cutters + flats; }
};

/// @param depth  delta, height less the ground's [m]
/// @param sunk   how far the bit has come down since the start of the step [m]
/// @param flats  load of the flats at the start of the step [N]
CutWeight cut_weight(const BitCutLaw& law, double depth, double sunk, double flats) noexcept;

/// The same of a bit that has been let down on its rock: the flats carry what they can at this depth.
CutWeight resting_cut_weight(const BitCutLaw& law, double depth) noexcept;

/// Torque per weight on the cutters, epsilon a^2/2 2 pi K or a/(2 zeta), and on the flats, mu gamma a/2, up to `wear_weight` [m].
struct CutArms
{
  double cutters = 0.0;
  double flats = 0.0;
};

CutArms cut_arms(const BitTorqueSpec& spec, double diameter, const FormationLayer& rock) noexcept;

}  // namespace drill_rig_sim

#endif
