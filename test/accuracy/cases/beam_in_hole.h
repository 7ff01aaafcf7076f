// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ACCURACY_BEAM_IN_HOLE_H
#define DRILL_RIG_SIM_ACCURACY_BEAM_IN_HOLE_H

#include <vector>

namespace drill_rig_sim
{
/// A straight Timoshenko beam-column in a planar hole, small displacements, linear but for contact: an independent check of
/// assemblies; knows no simulator. Coordinate s up from the bit, y(s) from the hole's axis towards its high side; the hole builds
/// at kappa(s). With N the compression and w the weight in mud per length, I the inclination:
///   (EI (y'' + kappa))'' + (N y')' + N kappa + w sin I = contact forces,   y within the clearance at every node.
struct BeamInHole
{
  struct Piece
  {
    double length, bending, shear, weight;  ///< L [m], EI [N m2], K G A [N], w [N/m]
    double clearance;                       ///< of its upper end [m]
    double bend = 0.0;                      ///< the string below its upper end is tilted to the high side by this [rad]
    double build = 0.0;                     ///< kappa of the hole beside it [rad/m]
  };
  std::vector<Piece> pieces;   ///< from the bit up; the bit itself has no clearance
  double inclination = 0.0;    ///< at the bit [rad]
  double weight_on_bit = 0.0;  ///< [N]

  struct Bit
  {
    double side_force;  ///< on the wall, + towards the high side [N]
    double tilt;        ///< from the hole's direction, + towards the high side [rad]
  };
  /// The top is clamped on the low side.
  Bit bit() const;
};

/// Directions of the hole that the assembly drills [rad], + towards the high side, one for each piece's length drilled; all
/// pieces have the same length, a metre of which is drilled in whole pieces. It drills where the bit points and, side_cutting
/// times as well, where it is pushed: tilt + side_cutting F/W. The hole that it starts in keeps its build.
std::vector<double> drilled_directions(BeamInHole beam, double side_cutting, int pieces);

}  // namespace drill_rig_sim

#endif
