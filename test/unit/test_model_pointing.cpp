// SPDX-License-Identifier: BSD-3-Clause
// A rotary steerable tool that points the bit: the beam between two touch points in closed form, a direction that turning leaves
// alone, exact tangents.
#include <gtest/gtest.h>

#include "drill_rig_sim/model/pointing.h"
#include "drill_rig_sim/well/directions.h"
#include "steerable_scenes.h"
#include "tangent_check.h"

namespace test_model_pointing
{
using namespace drill_rig_sim;

namespace
{
constexpr double tilt = 1.0 * degree, toolface = 70.0 * degree;

/// Held by gauge and two stabilisers without play, off bottom of a vertical hole without friction; the pipe above is soft.
Scene held_scene()
{
  Scene scene = vertical_scene(100.0, 95.0);
  PartSpec pipe = pipe_part(0, 9.5, tool_jointed_mass);
  pipe.stiffness = {5e8, 1e5, 7.7e4};
  scene.string = {
      bit_part(0.2159), pointing_part(tilt), blades_part(0.2158), collar_part(1, 5.0), blades_part(0.2158, "upper_blades"), pipe};
  scene.numerics.element_length = 1.0;
  return scene;
}

/// Heights above the bit's centre [m].
struct Places
{
  double pivot, blades, upper;
};

Places places_of(const Mesh& mesh)
{
  const double bit = mesh.bit_radius;
  return {1.0 - bit, 0.5 * (mesh.part_bottom[2] + mesh.part_top[2]) - bit, 0.5 * (mesh.part_bottom[4] + mesh.part_top[4]) - bit};
}

/// Moment at the lower blades by the three-moment equation: the kink, were the span over it cut there, would turn its end by
/// theta a/b.
double moment_at_blades(const Mesh& mesh)
{
  const Places at = places_of(mesh);
  const BeamSection& s = mesh.elements[0].section;
  const double a = at.pivot, b = at.blades, d = at.upper - b;
  return tilt * a / b / ((b + d) / (3.0 * s.bending) + (1.0 / b + 1.0 / d) / s.shear);
}

Vector3d towards(double angle)
{
  return {std::sin(angle), std::cos(angle), 0.0};
}
}  // namespace

TEST(Pointing, bitTiltAndSideForceAreThoseOfTheBeam)
{
  Rig rig(held_scene());
  rig.setpoints = steered(toolface);
  rig.run(8.0);
  const Mesh& mesh = rig.rest.model->mesh();
  const Places at = places_of(mesh);
  const BeamSection& s = mesh.elements[0].section;
  const double moment = moment_at_blades(mesh), force = moment / at.blades;
  const double tilted =
      tilt * (at.blades - at.pivot) / at.blades - moment * (at.blades / (6.0 * s.bending) - 1.0 / (at.blades * s.shear));
  const RigForces& forces = rig.stepper.find_forces(rig.rest.state);
  const Vector3d side = -forces.wall[0], leans = x_axis(rig.rest.state.nodes[0].orientation);
  EXPECT_NEAR(side.dot(towards(toolface)), force, 0.02 * force);
  EXPECT_NEAR(leans.dot(towards(toolface)), tilted, 0.02 * tilted);
  EXPECT_NEAR(side.dot(towards(toolface + 0.5 * pi)), 0.0, 0.005 * force);
  EXPECT_NEAR(leans.dot(towards(toolface + 0.5 * pi)), 0.0, 0.005 * tilted);
}

TEST(Pointing, turningLeavesTheDirectionAlone)
{
  constexpr double step = 0.01;
  Rig rig(held_scene());
  rig.setpoints = steered(toolface, 120.0 * rpm);
  const auto advance = [&](double seconds, const auto& see)
  {
    for (int k = 0; k < std::lround(seconds / step); ++k)
    {
      ASSERT_TRUE(rig.stepper.advance(rig.rest.state, step, rig.setpoints));
      see();
    }
  };
  advance(12.0, [] {});
  const double force = moment_at_blades(rig.rest.model->mesh()) / places_of(rig.rest.model->mesh()).blades;
  const double spun = rig.rest.state.nodes[0].spin_angle;
  double off_lean = 0.0, off_side = 0.0, off_force = 0.0;
  advance(3.0,
          [&]
          {
            const auto off = [](const Vector3d& v)
            { return std::abs(std::remainder(std::atan2(v.x(), v.y()) - toolface, 2.0 * pi)); };
            const Vector3d side = -rig.stepper.find_forces(rig.rest.state).wall[0];
            off_lean = std::max(off_lean, off(rig.rest.state.lean));
            off_side = std::max(off_side, off(side));
            off_force = std::max(off_force, std::abs(side.head<2>().norm() - force));
          });
  EXPECT_GT(rig.rest.state.nodes[0].spin_angle - spun, 5.9 * 2.0 * pi);
  EXPECT_LT(off_lean, 0.01 * degree);
  EXPECT_LT(off_side, 1.0 * degree);
  EXPECT_LT(off_force, 0.04 * force);
}

TEST(Pointing, withoutACommandTheToolIsStraight)
{
  Scene collar = held_scene();
  collar.string[1].type = PartType::collar;
  collar.string[1].steerable.reset();
  Rig straight(held_scene()), plain(collar);
  for (Rig* rig : {&straight, &plain})
  {
    rig->setpoints.top_drive.speed = 60.0 * rpm;
    rig->run(3.0);
    const NodeState& bit = rig->rest.state.nodes[0];
    EXPECT_LT(bit.position.head<2>().norm(), 1e-6);
    EXPECT_LT(x_axis(bit.orientation).head<2>().norm(), 1e-6);
  }
  EXPECT_EQ(straight.rest.state.lean.norm(), 0.0);
  EXPECT_NEAR(straight.rest.state.nodes[0].spin_angle, plain.rest.state.nodes[0].spin_angle, 1e-3);
}

TEST(Pointing, leansInTheTimeAndAsFarAsItIsTold)
{
  Rig rig(held_scene());
  rig.setpoints = steered(toolface);
  rig.run(0.4 * tilting_time);
  EXPECT_NEAR(rig.rest.state.lean.norm(), 0.4 * tilt, 1e-6 * tilt);
  rig.run(0.7 * tilting_time);
  EXPECT_NEAR(rig.rest.state.lean.dot(towards(toolface)), tilt, 1e-4 * tilt);
  rig.setpoints.steering = {toolface + pi, 0.5};  // over the straight
  rig.run(tilting_time);
  EXPECT_NEAR(rig.rest.state.lean.dot(towards(toolface)), 0.0, 1e-4 * tilt);
  rig.run(tilting_time);
  EXPECT_NEAR(rig.rest.state.lean.dot(towards(toolface)), -0.5 * tilt, 1e-4 * tilt);
}

TEST(Pointing, tangentIsExactTurningAndLeaning)
{
  Scene scene = with_tool(slanted_scene(60.0, 0.3), pointing_part(2.0 * degree));
  scene.numerics.structural_damping = 1e-3;
  Rig rig(scene);
  rig.setpoints = steered(toolface, 60.0 * rpm);
  rig.run(2.0);  // on its way
  expect_exact(rig);
  rig.run(6.0);
  EXPECT_GT(rig.rest.state.lean.norm(), 1.9 * degree);
  EXPECT_GT(rig.contacts(), 4);
  expect_exact(rig);
}
}  // namespace test_model_pointing
