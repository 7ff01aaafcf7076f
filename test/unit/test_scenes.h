// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SCENES_H
#define DRILL_RIG_SIM_TEST_SCENES_H

#include <cmath>
#include <utility>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

/// Small scenes built in code. Everything not set here is the scene's default.
namespace drill_rig_sim
{
/// Cross-section of 5 in drill pipe, and the area of its steel.
constexpr double pipe_outer = 0.127, pipe_inner = 0.1086;
constexpr double pipe_area = pi / 4.0 * (pipe_outer * pipe_outer - pipe_inner * pipe_inner);
constexpr double steel_density = 7850.0;
constexpr double plain_pipe_mass = steel_density * pipe_area;  ///< [kg/m], without tool joints
constexpr double tool_jointed_mass = 31.9;                     ///< [kg/m], with them

inline PartSpec bit_part(double diameter, double mass = 40.0)
{
  PartSpec bit;
  bit.name = "bit";
  bit.type = PartType::bit;
  bit.length = bit.joint_length = 0.3;
  bit.bit.emplace();
  bit.bit->mass = mass;
  bit.bit->diameter = diameter;
  return bit;
}

/// Drill pipe; joints 0 fills up to the surface.
inline PartSpec pipe_part(int joints, double joint_length, double linear_mass, double tool_joint = 0.168)
{
  PartSpec pipe;
  pipe.name = "pipe";
  pipe.type = PartType::pipe;
  pipe.joints = joints;
  pipe.joint_length = joint_length;
  pipe.outer_diameter = pipe_outer;
  pipe.inner_diameter = pipe_inner;
  pipe.linear_mass = linear_mass;
  pipe.pipe.emplace();
  pipe.pipe->tool_joint_diameter = tool_joint;
  return pipe;
}

inline PartSpec collar_part(int joints, double joint_length)
{
  PartSpec collar;
  collar.name = "collar";
  collar.type = PartType::collar;
  collar.joints = joints;
  collar.joint_length = joint_length;
  collar.outer_diameter = 0.165;
  collar.inner_diameter = 0.0714;
  collar.linear_mass = 136.0;
  return collar;
}

/// A survey tool of the collars' section, its sensor 4 m above its lower end.
inline PartSpec mwd_part()
{
  PartSpec tool = collar_part(1, 9.0);
  tool.name = "mwd";
  tool.type = PartType::mwd;
  tool.length = 9.0;
  tool.mwd.emplace();
  tool.mwd->sensor_offset = 4.0;
  return tool;
}

/// A mud motor with a bent housing, of the collars' section.
inline PartSpec motor_part(double bend = 1.25 * degree)
{
  PartSpec motor = collar_part(1, 8.3);
  motor.name = "motor";
  motor.type = PartType::mud_motor;
  motor.length = 8.3;
  motor.motor.emplace();
  motor.motor->bend = bend;
  motor.motor->bit_to_bend = 2.0;
  motor.motor->displacement_per_rev = 0.024;
  motor.motor->stall_torque = 9000.0;
  return motor;
}

/// A hole of 0.2159 m through `survey` down to `hole_depth`, one friction, drillable rock, a bit and tool-jointed pipe up to the
/// block. Free nodes, steps of 10 ms.
inline Scene scene_in(std::vector<SurveyStation> survey, double hole_depth, double bit_depth, double friction)
{
  Scene scene;
  scene.name = "test";
  scene.well.survey = std::move(survey);
  scene.well.hole_depth = hole_depth;
  scene.well.sections = {{hole_depth, 0.2159, friction}};
  FormationLayer rock;
  rock.to_tvd = 1e4;
  rock.drillability = 1.3e-7;
  scene.formation = {rock};
  scene.string = {bit_part(0.2159), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.mud.axial_damping = 0.0;  // tests' figures are of these, whatever the viscosity
  scene.mud.lateral_damping = 20.0;
  scene.mud.torsional_damping = 5e-4;
  scene.contact.static_ratio = 1.0;
  scene.contact.stribeck_speed = 0.05;
  scene.start.bit_depth = bit_depth;
  scene.start.block_height = 20.0;
  scene.numerics.level = Level::beam3d;
  scene.numerics.step = default_step;
  return scene;
}

inline Scene vertical_scene(double hole_depth, double bit_depth, double friction = 0.0)
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {hole_depth, 0.0, 0.0}}, hole_depth, bit_depth, friction);
  scene.numerics.element_length = 9.5;
  return scene;
}

/// A straight hole 20 deg from the vertical.
constexpr double slant = 20.0 * degree, slant_azimuth = 1.0;
inline Scene slanted_scene(double bit_depth, double friction)
{
  Scene scene = scene_in({{0.0, slant, slant_azimuth}, {200.0, slant, slant_azimuth}}, 200.0, bit_depth, friction);
  scene.numerics.element_length = 4.75;
  return scene;
}

/// Nothing takes energy out: no mud drag, no structural damping.
inline Scene without_damping(Scene scene)
{
  scene.mud.axial_damping = scene.mud.torsional_damping = scene.mud.drag_coefficient = 0.0;
  scene.numerics.structural_damping = 0.0;
  scene.rig.hoisting.rail_friction = scene.rig.hoisting.line_damping = 0.0;
  return scene;
}

/// A short vertical well with collars, `above` metres off bottom: drills with `quick` dynamics.
inline Scene drilling_scene(double above = 0.01, double friction = 0.25)
{
  Scene scene = vertical_scene(100.0, 100.0 - above, friction);
  scene.string = {bit_part(0.2159), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[0].bit->side_cutting = 0.1;
  scene.contact.static_ratio = 1.2;
  return scene;
}

/// The same with a bent motor on the bit.
inline Scene motor_drilling_scene(double above)
{
  Scene scene = drilling_scene(above);
  scene.string.insert(scene.string.begin() + 1, motor_part());
  return scene;
}

/// Stations every 30 m of a hole vertical to `kick_off`, then built at `rate` [rad/m] to `inclination`, held to `depth`.
inline std::vector<SurveyStation> build_and_hold(double kick_off, double rate, double inclination, double azimuth, double depth)
{
  std::vector<SurveyStation> survey{{0.0, 0.0, azimuth}};
  if (kick_off > 0.0) survey.push_back({kick_off, 0.0, azimuth});
  const double left = depth - kick_off;
  const double built = inclination / rate < left - 1e-6 ? inclination / rate : left;
  const int arcs = static_cast<int>(std::ceil(built / 30.0));
  for (int i = 1; i <= arcs; ++i) survey.push_back({kick_off + built * i / arcs, rate * built * i / arcs, azimuth});
  if (built < left) survey.push_back({depth, rate * built, azimuth});
  return survey;
}

}  // namespace drill_rig_sim

#endif
