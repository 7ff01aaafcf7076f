// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_TURN_LIMIT_H
#define DRILL_RIG_SIM_WELL_TURN_LIMIT_H

#include "drill_rig_sim/well/wellbore.h"

/// How fast a hole may turn: the stiff body that follows the bit has to lie in it.
///
/// The rock law (formation.h) contains forces, but no shapes. By that law, a bit with a side force much above its weight drills
/// sideways, and its hole turns by tens of degrees within the length of a bit. The body behind the bit could not enter such a
/// hole.
///
/// The body is straight and stiff, of length L from the bit's middle up. In a hole of the bit's diameter that turns evenly by
/// kappa [rad/m], the hole's axis lies beside the body's by
///   h(s) = psi s + kappa s^2/2,
/// psi the angle between bit and hole, s the distance above the bit's middle, where there is no clearance: h(0) = 0. The
/// clearances c(s) all round let |h(s)| <= c(s). The hole turns most where the upper end leans outwards, h(L) = c_L, and a place
/// s between inwards, h(s) = -c(s). Without psi:
///   kappa <= 2 (c(s) + c_L s/L)/(s (L - s))  for every s between 0 and L.   (1)
/// For an even clearance c the middle is nearly the worst: kappa <= 12 c/L^2. For a straight rod with clearance c at its bit end
/// too it is 16 c/L^2.
///
/// The limit holds for the whole turn over L, kappa L, not for each centimetre: a bit that starts with a tilt may drill a kink
/// that fits.
///
/// Not modelled: how much the body bends (lower_body.h says how long it may be for that), the bit's cutting shape, and a gauge
/// that has worn.
namespace drill_rig_sim
{
struct TurnLimit
{
  double length = 0.0;     ///< L [m]
  double curvature = 0.0;  ///< kappa by (1) [rad/m]

  /// By which the hole may turn over the body's length [rad].
  double angle() const noexcept { return length * curvature; }
};

/// What the body allows of the bottom's `way` [m or m/s, world axes]: once the newly drilled interval has turned by limit.angle()
/// against the hole a body's length above, or against the hole where it begins, what would turn it further is left out. A hole
/// that turns faster already, by its survey, may go on as it does. A way within the limit comes back as it is, to the last bit.
Eigen::Vector3d limited_way(const Wellbore& well, const TurnLimit& limit, const Eigen::Vector3d& way) noexcept;

/// How fast the hole would turn over the body's length if its bottom went the whole `way` [rad/m]; 0 where the body allows it.
double refused_turn(const Wellbore& well, const TurnLimit& limit, const Eigen::Vector3d& way) noexcept;

}  // namespace drill_rig_sim

#endif
