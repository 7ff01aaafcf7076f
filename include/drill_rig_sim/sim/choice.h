// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_CHOICE_H
#define DRILL_RIG_SIM_SIM_CHOICE_H

#include <string>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Result of `numerics.level: auto`: the keys that it replaces, and the reason.
struct Choice
{
  Level level = Level::beam3d;
  std::string reason;                  ///< one line
  double pushed_element_length = 0.0;  ///< [m]
  double guided_element_length = 0.0;  ///< [m]
};

/// The cheapest level and mesh that keep the outputs in `needs` within the tolerance, by rules derived from the operations
/// matrix
/// (98 cells of a minute, errors over the outputs' ranges; test/accuracy/README.md, levels):
/// - beam3d in a hole that turns by more than 3 rad in all: turns multiply friction (exp(mu theta), the capstan), and with it
/// guided pipe's errors.
/// - From 5 % on, without needs of bending (direction, contact, buckling), in a hole that hangs the string (hangs()) without a
/// mud motor: axial_torsional. Where the
///   hole bends, stiff and stabilised assemblies bear on it harder than their weight does: torque would be 6 to 11 % low.
/// - From 5 % on, or in a hole that hangs the string without a mud motor, or from 2 % on without torque and bit speed among
///   the needs: hybrid. Where pipe begins to turn on the low side of a hole, guided pipe is 1 to 3 % off in these two.
/// - Else beam3d; below 2 %, with quarter joints where friction pushes the pipe, and below 0.5 % eighths.
/// From 5 % on two joints of a stand of guided pipe that nothing pushes, neither friction nor heavier pipe above it, are one
/// element. What is given by hand of step, element_length, pushed_element_length, guided_element_length and free_length stays.
/// With a method that works only with free nodes, the level is beam3d.
Choice choose(const Scene& scene);

/// The scene with that choice made in its keys, where its level is auto, and with a step and a companion (chosen_companion())
/// where it gives none.
Scene with_choice(const Scene& scene);

}  // namespace drill_rig_sim

#endif
