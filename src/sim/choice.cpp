// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/choice.h"

#include <cstdio>

#include "drill_rig_sim/accuracy/refined.h"
#include "drill_rig_sim/scene/scene_mesh.h"

namespace drill_rig_sim
{
namespace
{
constexpr double two_joints = 20.0, quarter_joint = 2.4, eighth_joint = 1.2;  // [m]
constexpr double many_turns = 3.0;                                            // [rad]

std::string percent(double tolerance)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100.0 * tolerance);
  return text;
}

Choice choose_level(const Scene& scene)
{
  if (has_no_levels(scene.numerics.integrator)) return {Level::beam3d, "the integrator has no other level"};
  constexpr unsigned bending = need_direction | need_contact | need_buckling, turning = need_torque | need_bit_speed;
  const double tolerance = scene.numerics.tolerance;
  if (turned_above(scene.well, scene.start.bit_depth) > many_turns)
    return {Level::beam3d, "the hole turns by more than 3 rad in total, which amplifies errors of friction"};
  const bool in_the_middle = hangs_in_the_middle(scene);
  if (tolerance >= wide_tolerance && !(scene.needs & bending) && in_the_middle)
    return {Level::axial_torsional, "within " + percent(tolerance) + " bending is not needed"};
  if (tolerance >= wide_tolerance)
    return {Level::hybrid, "within " + percent(tolerance) + " bending is needed only near the bit"};
  if (in_the_middle) return {Level::hybrid, "the string hangs, and does not bend above the bottom-hole assembly"};
  if (tolerance >= middle_tolerance && !(scene.needs & (bending | turning)))
    return {Level::hybrid, "within " + percent(tolerance) + " neither bending nor torque and bit speed are needed"};
  return {Level::beam3d, "torque, bit speed or bending are needed within " + percent(tolerance) + " where pipe lies on its wall"};
}
}  // namespace

Choice choose(const Scene& scene)
{
  Choice choice = choose_level(scene);
  const double tolerance = scene.numerics.tolerance;
  choice.pushed_element_length = scene.numerics.pushed_element_length;
  choice.guided_element_length = scene.numerics.guided_element_length;
  const bool by_hand = choice.guided_element_length > 0.0 || scene.numerics.element_length > 0.0;
  if (tolerance >= wide_tolerance && !by_hand) choice.guided_element_length = two_joints;
  if (choice.level != Level::beam3d || tolerance >= middle_tolerance || choice.pushed_element_length > 0.0) return choice;
  choice.pushed_element_length = tolerance < narrow_tolerance ? eighth_joint : quarter_joint;
  if (pushed_length(scene) > 0.0) choice.reason += "; elements are short where friction pushes the pipe";
  return choice;
}

Scene with_choice(const Scene& scene)
{
  Scene chosen = scene;
  NumericsSpec& numerics = chosen.numerics;
  numerics.companion = chosen_companion(numerics);
  if (numerics.step == step_by_level)
    numerics.step = numerics.level == Level::automatic && varies_steps(numerics.integrator) ? 0.0 : default_step;
  if (numerics.level != Level::automatic) return chosen;
  const Choice choice = choose(scene);
  numerics.level = choice.level;
  numerics.pushed_element_length = choice.pushed_element_length;
  numerics.guided_element_length = choice.guided_element_length;
  return chosen;
}

}  // namespace drill_rig_sim
