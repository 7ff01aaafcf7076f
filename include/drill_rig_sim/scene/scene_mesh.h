#ifndef DRILL_RIG_SIM_SCENE_SCENE_MESH_H
#define DRILL_RIG_SIM_SCENE_SCENE_MESH_H

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/string/mesh.h"

namespace drill_rig_sim
{
/// The mesh of a scene's string over `total_length`, bit's face to top-drive shaft [m]; string/mesh.h says what may be wrong.
inline Mesh build_mesh(const Scene& scene, double total_length)
{
  return build_mesh(scene.string, scene.contact, scene.mud, scene.numerics.element_length, total_length);
}

}  // namespace drill_rig_sim

#endif
