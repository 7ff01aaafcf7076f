// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_WALL_LOSS_H
#define DRILL_RIG_SIM_SIM_WALL_LOSS_H

#include <optional>

#include "drill_rig_sim/solve/start.h"

namespace drill_rig_sim
{
/// What a body that is stiff in a tight hole, a bent motor's, say, loses of its side forces by sinking into the wall, which is
/// softer under bodies than under gauge and blades: the same equilibrium with the wall as stiff as there under every part but
/// pipe.
struct WallLoss
{
  int part = 0;                                     ///< that is deepest for its clearance; index into the string
  double depth = 0.0;                               ///< of that part's deepest place [m]
  double from_bit = 0.0;                            ///< of that place [m]
  double side_force = 0.0, stiff_side_force = 0.0;  ///< wall on bit, normal [N]
  double contact = 0.0, stiff_contact = 0.0;        ///< normal forces of the whole string, summed [N]
  bool known = false;  ///< whether there is an equilibrium on the stiffer wall; else what is `stiff_` is not set
};

/// The loss at a scene's start, at rest without friction; none where no such body lies deeper than a twentieth of its clearance,
/// or where neither the bit's side force nor the sum changes by more than 5 % and 500 N. Solves a start with the stiffer wall
/// where a body is deep.
/// @param rig  build_at_rest() of the scene
std::optional<WallLoss> wall_loss(const RigAtRest& rig);

}  // namespace drill_rig_sim

#endif
