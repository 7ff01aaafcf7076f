// SPDX-License-Identifier: BSD-3-Clause
// How long waves live: by the mud, and by walls that pipe at rest, turning or sliding lies on.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/wave_life.h"
#include "test_scenes.h"

namespace test_solve_wave_life
{
using namespace drill_rig_sim;

namespace
{
constexpr double bit_depth = 150.0, friction = 0.25;

/// Every node moves along its axis and turns [m/s, rad/s].
State moving(const RigAtRest& rig, double along, double about)
{
  State state = rig.state;
  for (NodeState& node : state.nodes)
  {
    node.rate.velocity = along * x_axis(node.orientation);
    node.rate.spin = about;
  }
  return state;
}

/// Sums over the string, f = mu w sin(i) the friction of the walls and r its lever: f/r [N/m], f r^2 [N m2], mass [kg], inertia
/// [kg m2].
struct Sums
{
  double over_lever = 0.0, times_lever = 0.0, mass = 0.0, inertia = 0.0;

  explicit Sums(const RigAtRest& rig)
  {
    const Mesh& mesh = rig.model->mesh();
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    {
      double weight = 0.0;
      for (const std::size_t e : {i - 1, i})
        if (e < mesh.elements.size()) weight += 0.5 * rig.model->element_weight(static_cast<int>(e), -1.0, 0.0, full_bore);
      const double lever = mesh.nodes[i].friction_radius > 0.0 ? mesh.nodes[i].friction_radius : mesh.nodes[i].contact_radius;
      const double f = friction * weight * x_axis(rig.state.nodes[i].orientation).head<2>().norm();
      over_lever += f / lever;
      times_lever += f * lever * lever;
      mass += mesh.nodes[i].mass;
      inertia += mesh.nodes[i].spin_inertia;
    }
  }
};

RigAtRest slanted_without_mud_damping()
{
  Scene scene = slanted_scene(bit_depth, friction);
  scene.mud.axial_damping = scene.mud.torsional_damping = 0.0;
  scene.string = {bit_part(0.2159), pipe_part(0, 9.5, tool_jointed_mass)};
  return build_at_rest(scene);
}
}  // namespace

TEST(WaveLife, ofTheMudIsTwiceMassOverDamping)
{
  Scene scene = vertical_scene(400.0, 290.0);
  scene.mud.axial_damping = 100.0;
  scene.mud.torsional_damping = 0.0;
  const RigAtRest rig = build_at_rest(scene);
  const WaveLife life(*rig.model);
  double length = 0.0;  // of the nodes' shares
  for (const MeshNode& node : rig.model->mesh().nodes) length += node.length;
  EXPECT_NEAR(life.in_mud().along, 2.0 * Sums(rig).mass / (100.0 * length), 1e-9);
  EXPECT_EQ(life.in_mud().about, 40.0) << "at most";
  const WaveLives now = life.now(rig.state);
  EXPECT_NEAR(now.along, life.in_mud().along, 1e-2 * now.along) << "a string that hangs feels no wall";
  EXPECT_NEAR(now.about, 40.0, 0.8);
}

// Pipe that turns fast resists a small motion along the hole by f/(r W) of it, and no further turning: 2 m r W/f.
TEST(WaveLife, turningPipeDampsWavesAlongIt)
{
  const RigAtRest rig = slanted_without_mud_damping();
  const WaveLife life(*rig.model);
  const Sums sums(rig);
  const double speed = 12.0;  // [rad/s]
  const WaveLives now = life.now(moving(rig, 0.0, speed));
  EXPECT_NEAR(1.0 / now.along, 1.0 / 40.0 + 0.5 * sums.over_lever / (speed * sums.mass), 0.01 / now.along);
  EXPECT_GT(now.about, 15.0);
}

// Pipe that slides fast along the hole resists turning by f r^2/v of it, and no further sliding.
TEST(WaveLife, trippedPipeDampsWavesAboutIt)
{
  const RigAtRest rig = slanted_without_mud_damping();
  const WaveLife life(*rig.model);
  const Sums sums(rig);
  const double speed = 0.8;  // [m/s]
  const WaveLives now = life.now(moving(rig, speed, 0.0));
  EXPECT_NEAR(1.0 / now.about, 1.0 / 40.0 + 0.5 * sums.times_lever / (speed * sums.inertia), 0.01 / now.about);
  EXPECT_GT(now.along, 20.0);
}

TEST(WaveLife, pipeAtRestOnItsWallDampsAll)
{
  const RigAtRest rig = slanted_without_mud_damping();
  const WaveLives now = WaveLife(*rig.model).now(moving(rig, 0.0, 0.0));
  EXPECT_LT(now.along, 0.2);
  EXPECT_LT(now.about, 0.2);
}
}  // namespace test_solve_wave_life
