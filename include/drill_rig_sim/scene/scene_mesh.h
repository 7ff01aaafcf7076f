// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SCENE_MESH_H
#define DRILL_RIG_SIM_SCENE_SCENE_MESH_H

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/string/mesh.h"

namespace drill_rig_sim
{
/// Tolerances (numerics.tolerance) below which a mesh or a level does no more.
constexpr double wide_tolerance = 0.05, middle_tolerance = 0.02, narrow_tolerance = 0.005;

/// Longest elements of a scene's string: `numerics.element_length` where it is given; else half a joint (4.75 m; for a tolerance
/// of 5 % or more a joint, below 2 % a third, 3.17 m, below 0.5 % a quarter, 2.38 m) from the bit up to 45 m (a stand and a half,
/// for the string goes down) above the place where the survey first inclines by more than 3 deg, or where friction below would
/// push the pipe that slides down, if that is higher, and a joint (9.5 m) above that, and throughout for level axial_torsional;
/// within 45 m of the bit, where an assembly bends between what it leans on, a quarter (2.38 m), or as above where the string
/// hangs in the middle of its hole. Where pipe lies on the wall its elements have to carry the bending between two contacts, or
/// it gives way below its buckling load and whirls falsely; so it does where it is pushed; where it hangs, joints do as well.
/// Chosen by the operations matrix (test/accuracy/run
/// --operations, --variants and --auto). Where friction pushes the pipe and `numerics.pushed_element_length` is given, elements
/// are that short; guided pipe that it does not push has elements of `numerics.guided_element_length`, if that is given, of two
/// joints at most, and of one below heavier pipe, which is there to push it; else, in level hybrid, of a joint.
ElementLengths element_lengths(const Scene& scene) noexcept;

/// How far above the bit's face the string's nodes are free, those above are guided [m]: infinity for level beam3d, less than 0
/// for axial_torsional and rigid. For hybrid `numerics.free_length` where it is given, else the bottom-hole assembly and two
/// stands: what is below the first drill pipe of more than two stands, of which walls are thinner than heavy-weight pipe's (a
/// bore over 0.7 of its outer diameter), or below the last part.
double free_length(const Scene& scene) noexcept;

/// The hole down to `depth` [m] nowhere inclines by more than 3 deg, nor bends by more than 1.5 deg/30 m.
bool hangs(const WellSpec& well, double depth) noexcept;

/// By how much the survey turns between its stations above `depth` [m], all turns counted up [rad].
double turned_above(const WellSpec& well, double depth) noexcept;

/// Friction torque of a string that turns with its bit at `depth` and is pulled against every bend of its hole [N m]: the sum of
/// mu r T |dtheta|, T the weight below in mud (the soft string's side force of a bend: Johancsik, Friesen, Dawson, J. Petroleum
/// Technology 36 (1984), SPE 11380). Free pipe cuts the corners within its clearance and rubs less: guided pipe is wrong by up to
/// this.
double torque_of_bends(const Scene& scene, double depth) noexcept;

/// The string hangs in the middle of its hole: hangs(), no mud motor bends it, and torque_of_bends() is within the tolerance of 5
/// kN m.
bool hangs_in_the_middle(const Scene& scene) noexcept;

/// How far above the bit's face friction pushes pipe that slides down with nothing on the bit (by the soft string), and 45 m
/// more; 0: nowhere [m].
double pushed_length(const Scene& scene) noexcept;

/// What stretch and twist of a rigid string are smaller by than those of its pipe (level rigid): so stiff that its waves are over
/// at once, and not so stiff that tensions drown in rounding.
constexpr double rigid_stiffness = 100.0;

/// The mesh of a scene's string over `total_length`, bit's face to top-drive shaft [m], stiffened for level rigid; string/mesh.h
/// says what may be wrong. Its elements are those of the start; the mud's drag is that of the hole around a string with its bit
/// at `bit_depth` [m MD].
Mesh build_mesh(const Scene& scene, double total_length, double bit_depth);
inline Mesh build_mesh(const Scene& scene, double total_length)
{
  return build_mesh(scene, total_length, scene.start.bit_depth);
}

/// The circuit of its mud.
MudCircuit mud_circuit(const Scene& scene, const Mesh& mesh);

}  // namespace drill_rig_sim

#endif
