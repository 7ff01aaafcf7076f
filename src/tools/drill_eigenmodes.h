// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_EIGENMODES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_EIGENMODES_H

#include <vector>

#include "drill_rig_sim/solve/start.h"

/// Natural frequencies and shapes of a string about its equilibrium: K x = omega^2 M x.
///
/// K is the tangent of the frictionless statics (beams with what tension, weight and torque do to them, wall where it is touched,
/// rock under the bit), its symmetric part; M the mass of string, bit and of the mud that moves sideways with them. The upper end
/// is clamped: that of the string in place, tilt and turn, as by a stiff rig, or that of an assembly cut off below. Without:
/// friction, damping, the spin's gyroscopic moments. Where the string rests on the wall it stays on it. The lowest eigenvalues by
/// Lanczos' method with shift and inversion about 0 (Spectra; Ericsson and Ruhe, Math. Comp. 35 (1980), 1251-1268).
namespace drill_rig_sim
{
/// Which motions of the nodes are free: a long string has hundreds of lateral modes below its first axial one.
enum class ModeFamily
{
  axial,      ///< along the section normal alone
  torsional,  ///< about it
  lateral,    ///< across it, and tilting
  coupled     ///< all
};

/// Motion of a node in a mode: in the axes of its section normal n, downhole.
struct NodeShape
{
  double axial = 0.0;      ///< along n
  double high_side = 0.0;  ///< towards the high side; north where the hole is nearly vertical
  double right = 0.0;      ///< towards the right, looking downhole with the high side up
  double spin = 0.0;       ///< about n [rad per unit of the above]
};

struct Mode
{
  double eigenvalue = 0.0;                             ///< omega^2; below 0: the equilibrium is not stable [1/s2]
  double axial = 0.0, torsional = 0.0, lateral = 0.0;  ///< shares of the kinetic energy
  std::vector<NodeShape> shape;                        ///< from the bit up to the clamp; the largest number is 1

  /// [Hz]; 0 if unstable.
  double frequency() const noexcept;
};

/// The `count` modes of lowest eigenvalue, or as many as there are. `clamp`: node that is clamped, 1 or above; the nodes above it
/// play no part. Throws std::runtime_error with one line if the eigenvalues are not found.
std::vector<Mode> find_modes(const RigAtRest& rig, ModeFamily family, int clamp, int count);

/// The node nearest to a distance from the bit's face [m], the bit's own apart.
int node_at(const Mesh& mesh, double from_bit);

}  // namespace drill_rig_sim

#endif
