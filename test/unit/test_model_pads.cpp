// SPDX-License-Identifier: BSD-3-Clause
// The friction of a rotary steerable tool's pads on the wall: its torque, its share along the hole, where it pushes the tool.
#include <gtest/gtest.h>

#include "drill_rig_sim/well/directions.h"
#include "steerable_scenes.h"
#include "tangent_check.h"

namespace test_model_pads
{
using namespace drill_rig_sim;

namespace
{
constexpr double push = 15e3, friction = 0.25, hole_radius = 0.5 * 0.2159, sleeve = 1e-3;  // [N, -, m, m]

/// Off bottom of a vertical hole.
Scene pushing_scene(double friction_radius = 0.0)
{
  Scene scene = with_tool(vertical_scene(100.0, 60.0, friction), pushing_part(push));
  scene.string[1].friction_radius = friction_radius;
  return scene;
}

/// What the pads' node takes out of the string, mean over a second: torque, and tension [N m, N].
struct Taken
{
  double torque = 0.0, tension = 0.0;
};

Taken taken(Rig& rig)
{
  constexpr int steps = 200;
  const int i = rig.rest.model->mesh().pad_node;
  Taken sum;
  for (int k = 0; k < steps; ++k)
  {
    rig.run(tangent_step);
    const RigForces& forces = rig.stepper.find_forces(rig.rest.state);
    sum.torque += (forces.torque[i] - forces.torque[i - 1]) / steps;
    sum.tension += (forces.tension[i] - forces.tension[i - 1]) / steps;
  }
  return sum;
}

Taken taken_at(double speed, double block_velocity, double friction_radius = 0.0)
{
  Taken out;
  for (const double ratio : {1.0, 0.0})
  {
    Rig rig(pushing_scene(friction_radius));
    rig.setpoints = steered(0.0, speed);
    rig.setpoints.steering.ratio = ratio;
    rig.setpoints.winch = {block_velocity, false};
    rig.run(6.0);
    const Taken t = taken(rig);
    out.torque += ratio == 1.0 ? t.torque : -t.torque;
    out.tension += ratio == 1.0 ? t.tension : -t.tension;
  }
  return out;
}
}  // namespace

TEST(Pads, brakeATurningToolByTheirFriction)
{
  const Taken turning = taken_at(60.0 * rpm, 0.0);
  EXPECT_NEAR(turning.torque, friction * push * hole_radius, 0.01 * friction * push * hole_radius);
  EXPECT_NEAR(turning.tension, 0.0, 0.01 * friction * push);
}

TEST(Pads, holdAToolBackThatIsLowered)
{
  const Taken sliding = taken_at(0.0, -0.2);
  EXPECT_NEAR(sliding.tension, -friction * push, 0.01 * friction * push);
  EXPECT_NEAR(sliding.torque, 0.0, 0.01 * friction * push * hole_radius);
}

TEST(Pads, shareTheirFrictionByTheDirectionOfSliding)
{
  const double around = 20.0 * rpm * hole_radius, along = 0.15, speed = std::hypot(around, along);
  const Taken both = taken_at(20.0 * rpm, -along);
  EXPECT_NEAR(both.torque, friction * push * hole_radius * around / speed, 0.02 * friction * push * hole_radius);
  EXPECT_NEAR(both.tension, -friction * push * along / speed, 0.02 * friction * push);
}

TEST(Pads, onASleeveThatDoesNotTurnRubAlongTheHoleAlone)
{
  const Taken both = taken_at(60.0 * rpm, -0.15, sleeve);
  EXPECT_NEAR(both.torque, 0.0, 0.02 * friction * push * hole_radius);
  EXPECT_NEAR(both.tension, -friction * push, 0.02 * friction * push);
}

// The walls hold against the pads' force and against their friction, which pushes a turning tool to the right.
TEST(Pads, pushATurningToolToTheRight)
{
  for (const double speed : {0.0, 60.0 * rpm})
  {
    Rig rig(pushing_scene());
    rig.setpoints = steered(0.0, speed);
    rig.run(6.0);
    Vector3d wall = Vector3d::Zero();
    for (const Vector3d& f : rig.stepper.find_forces(rig.rest.state).wall) wall += f;
    for (const Vector3d& f : rig.stepper.find_forces(rig.rest.state).span_wall) wall += f;
    EXPECT_NEAR(-wall.y(), push, 0.05 * push) << "north";
    EXPECT_NEAR(-wall.x(), speed > 0.0 ? friction * push : 0.0, 0.05 * push) << "east is right of it, looking down";
  }
}

TEST(Pads, tangentIsExactSlippingAndSticking)
{
  Scene scene = with_tool(slanted_scene(60.0, 0.3), pushing_part(push));
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  Rig rig(scene);
  rig.setpoints = steered(1.0);
  rig.run(3.0);
  EXPECT_GT(rig.rest.state.pads.rest, 1.0) << "sticks";
  EXPECT_GT(rig.rest.state.pads.bristle.norm(), 0.0);
  expect_exact(rig);
  rig.setpoints = steered(1.0, 20.0 * rpm);
  rig.setpoints.winch = {-0.1, false};
  rig.run(6.0);
  EXPECT_EQ(rig.rest.state.pads.rest, 0.0) << "slips";
  expect_exact(rig);
}

TEST(Pads, forgetWhatTheyHeldOnceTheyPushNoMore)
{
  Rig rig(pushing_scene());
  rig.setpoints = steered(0.0);
  rig.run(2.0);
  EXPECT_GT(rig.rest.state.pads.rest, 0.0);
  rig.setpoints.steering.ratio = 0.0;
  rig.run(0.1);
  EXPECT_TRUE(rig.rest.state.pads.bristle.isZero());
  EXPECT_EQ(rig.rest.state.pads.rest, 0.0);
}
}  // namespace test_model_pads
