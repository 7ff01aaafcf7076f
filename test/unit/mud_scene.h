// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_MUD_SCENE_H
#define DRILL_RIG_SIM_TEST_MUD_SCENE_H

#include <string>

#include "drill_rig_sim/scene/read_scene.h"

/// A scene of a mud with its flow curve and what a test puts beside it, and the refusal of such a scene.
namespace drill_rig_sim::mud_scene
{
const std::string rheology = ", rheology: {law: bingham, plastic_viscosity: 20 cP, yield_point: 15 lb/100ft2}";
const std::string nozzles = ", nozzles: [12, 12, 13]";

/// The mud's own keys stand at line 4.
inline std::string scene_text(const std::string& mud, const std::string& bit = nozzles, const std::string& end = "")
{
  return "name: m\nwell: {stations: [[0, 0, 0], [1000, 0, 0]], hole_depth: 1000, sections: [{to: 1000, diameter: 0.2159, "
         "friction: 0.2}]}\n"
         "formation: [{to_tvd: 5000, drillability: 1.0e-8}]\nmud: {density: 1200" +
         mud + "}\nstring:\n  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.2159" + bit +
         "}\n  - {name: p, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, "
         "linear_mass: 32}\n"
         "start: {bit_depth: 990}\n" +
         end;
}

/// What a text is refused with; "": it is not.
/// @param file  its name in the message
inline std::string refusal_of(const std::string& text, const std::string& file)
{
  try
  {
    parse_scene(text, file);
  }
  catch (const SceneError& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace drill_rig_sim::mud_scene

#endif
