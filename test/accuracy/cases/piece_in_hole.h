// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_PIECE_IN_HOLE_H
#define DRILL_RIG_SIM_ACCURACY_PIECE_IN_HOLE_H

#include <Eigen/Core>
#include <memory>

#include "drill_rig_sim/solve/statics.h"
#include "drill_rig_sim/model/model.h"

namespace drill_rig_sim
{
/// A piece of string in its hole, far below the rig: the mesh's last node is held inside the hole instead of at the block, so
/// that statics can push and hold it there.
struct PieceInHole
{
  std::shared_ptr<const Model> model;
  State state;
  RigForces forces;  ///< in the last equilibrium

  int top() const { return model->top(); }
  /// Force that compresses the piece, mean over its elements [N].
  double compression() const;
  /// Moves the held end by `distance` [m] down the hole and finds the new equilibrium without friction. False: none found.
  bool push(double distance);
  bool settle();
};

/// Lays `scene`'s string, cut to `length` metres above the bit's face, along the hole's low side with the bit's face at measured
/// depth `bit_depth`; sections without twist, y axes to the high side. The held end points along the hole.
PieceInHole lay_in_hole(const Scene& scene, double length, double bit_depth);

}  // namespace drill_rig_sim

#endif
