// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_LONE_BIT_H
#define DRILL_RIG_SIM_TEST_LONE_BIT_H

#include <functional>
#include <memory>
#include <utility>

#include "drill_rig_sim/solve/start.h"
#include "test_scenes.h"

/// A bit as the one thing that moves, so that every motion has a closed form: it hangs in a wide vertical hole on a single
/// element of pipe, and every other node has inertia beyond measure. Nothing damps but what a test adds.
namespace drill_rig_sim
{
inline Scene lone_bit_scene()
{
  Scene scene = without_damping(vertical_scene(100.0, 10.0));
  scene.mud.lateral_damping = 0.0;
  scene.contact.assembly_stiffness = 5e7;  // a bit that comes a millimetre into the wall
  scene.string = {bit_part(0.1), pipe_part(0, 1e5, plain_pipe_mass, pipe_outer)};
  scene.string[0].bit->squeeze_film_damping = 0.0;
  scene.start.block_height = 2.0;
  scene.numerics.element_length = 250.0;
  return scene;
}

/// Next to no weight hangs on the pipe: tension does not hold the bit in place.
inline Scene weightless(Scene scene)
{
  scene.string[0].bit->mass = 1e-4;
  for (std::size_t i = 1; i < scene.string.size(); ++i) scene.string[i].linear_mass = 1e-4;
  return scene;
}

/// The scene's rig at rest, then with the bit's node and the pipe as `change` makes them. Weight stays what it was: inertia alone
/// changes.
inline RigAtRest lone_bit(const Scene& scene, const std::function<void(MeshNode& bit, BeamSection& pipe)>& change)
{
  RigAtRest rig = build_at_rest(scene);
  Mesh mesh = rig.model->mesh();
  change(mesh.nodes[0], mesh.elements[0].section);
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
    mesh.nodes[i].mass = mesh.nodes[i].spin_inertia = mesh.nodes[i].tilt_inertia = 1e18;
  rig.model = std::make_shared<Model>(scene, std::move(mesh));
  return rig;
}

}  // namespace drill_rig_sim

#endif
