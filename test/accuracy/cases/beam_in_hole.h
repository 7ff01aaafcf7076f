#ifndef DRILL_RIG_SIM_ACCURACY_BEAM_IN_HOLE_H
#define DRILL_RIG_SIM_ACCURACY_BEAM_IN_HOLE_H

#include <vector>

namespace drill_rig_sim
{
/// A straight Timoshenko beam-column in a planar hole, small displacements, linear but for contact: an independent check of
/// assemblies; knows no simulator. Coordinate s up from the bit, y(s) from the hole's axis towards its high side; the hole builds
/// at `build` for s < `curved` and is straight above. With N the compression and w the weight in mud per length, I the
/// inclination:
///   (EI (y'' + build))'' + (N y')' + N build + w sin I = contact forces,   y within the clearance at every node.
struct BeamInHole
{
  struct Piece
  {
    double length, bending, shear, weight;  ///< L [m], EI [N m2], K G A [N], w [N/m]
    double clearance;                       ///< of its upper end [m]
    double bend = 0.0;                      ///< the string below its upper end is tilted to the high side by this [rad]
  };
  std::vector<Piece> pieces;   ///< from the bit up; the bit itself has no clearance
  double inclination = 0.0;    ///< at the bit [rad]
  double build = 0.0;          ///< [rad/m]
  double curved = 0.0;         ///< [m]
  double weight_on_bit = 0.0;  ///< [N]

  /// Force of the bit on the wall, + towards the high side [N]. The top is clamped on the low side.
  double bit_side_force() const;
};

}  // namespace drill_rig_sim

#endif
