// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_STEERABLE_SCENES_H
#define DRILL_RIG_SIM_TEST_STEERABLE_SCENES_H

#include "test_scenes.h"

/// Strings with a rotary steerable tool: parts of the collars' section.
namespace drill_rig_sim
{
inline PartSpec tool_part(double length)
{
  PartSpec tool = collar_part(1, length);
  tool.name = "steerable";
  tool.type = PartType::rotary_steerable;
  tool.length = length;
  tool.steerable.emplace();
  return tool;
}

/// Pushes with a force [N].
inline PartSpec pushing_part(double force = 15e3)
{
  PartSpec tool = tool_part(4.0);
  tool.steerable->bit_to_pads = 0.9;
  tool.steerable->pad_force = force;
  return tool;
}

/// Points by an angle [rad].
inline PartSpec pointing_part(double tilt = 1.0 * degree, double pivot = 1.0, double length = 2.7)
{
  PartSpec tool = tool_part(length);
  tool.steerable->bit_to_pivot = pivot;
  tool.steerable->tilt = tilt;
  return tool;
}

inline PartSpec blades_part(double diameter = 0.2139, const char* name = "blades")
{
  PartSpec blades = collar_part(1, 1.5);
  blades.name = name;
  blades.type = PartType::stabilizer;
  blades.length = 1.5;
  blades.stabilizer.emplace();
  blades.stabilizer->blade_diameter = diameter;
  return blades;
}

/// The scene with this tool above the bit.
inline Scene with_tool(Scene scene, const PartSpec& tool)
{
  scene.string = {bit_part(0.2159), tool, blades_part(), mwd_part(), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[0].bit->side_cutting = 0.03;
  scene.numerics.element_length = 4.75;
  return scene;
}

/// Full steering to a toolface [rad], from north in a vertical hole.
inline Setpoints steered(double toolface, double speed = 0.0)
{
  Setpoints out;
  out.steering = {toolface, 1.0};
  out.magnetic_steering = true;
  out.top_drive.speed = speed;
  return out;
}

}  // namespace drill_rig_sim

#endif
