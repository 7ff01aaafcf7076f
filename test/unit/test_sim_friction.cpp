// SPDX-License-Identifier: BSD-3-Clause
// A pipe in a hole 20 deg from the vertical, held by the winch and let go over a second: true sticking, or sliding by Coulomb's
// law.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/sim/simulator.h"
#include "test_scenes.h"

namespace test_sim_friction
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
/// Ten joints of pipe on a thin wire: once slack, the wire can only push with its buckling load, some 10 N against 30 kN of pipe.
/// The wire runs through frictionless hole, over the kink at the table.
Scene pipe_on_a_wire(double kinetic, double static_ratio)
{
  Scene scene = slanted_scene(130.0, kinetic);
  scene.well.sections = {{25.0, 0.2159, 0.0}, {200.0, 0.2159, kinetic}};
  scene.contact.static_ratio = static_ratio;
  PartSpec wire = pipe_part(0, 9.5, 0.05, 0.01);
  wire.name = "wire";
  wire.outer_diameter = 0.01;
  wire.inner_diameter = 0.0;
  scene.string = {bit_part(0.2), pipe_part(10, 9.5, tool_jointed_mass), wire};
  // the film's damping acts across the bit's axis: at metres per second the tilted bit would glide on it like a ski, and lift
  scene.string[0].bit->squeeze_film_damping = 0.0;
  // sideways the mud would weigh three times what the wire does
  scene.mud.added_mass = scene.mud.drag_coefficient = 0.0;
  // along it the surge of pipe that slides at metres per second would lift wire and pipe
  scene.rig.mud_pump.pressure_coefficient = 0.0;
  scene.rig.hoisting.max_speed = 20.0;
  scene.rig.hoisting.rail_friction = scene.rig.hoisting.line_damping = 0.0;  // the block is to run ahead of the pipe
  return scene;
}

/// Of the bit along the hole [m].
double along_hole(const Truth& m)
{
  return m.bit_position.dot(
      Vector3d(std::sin(slant) * std::sin(slant_azimuth), std::sin(slant) * std::cos(slant_azimuth), -std::cos(slant)));
}

/// At the block [N].
double wire_tension(const Simulator& rig)
{
  StringProfile profile;
  rig.profile(profile);
  return profile.tension.back();
}

void run(Simulator& rig, double seconds)
{
  const double frame = rig.scene().numerics.step;
  for (int k = 0; k < std::lround(seconds / frame); ++k) ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
}

/// Creep in 600 s after the elastic set; `held` is the hook load of the string before.
void expect_sticks(double kinetic, double static_ratio)
{
  Scene scene = pipe_on_a_wire(kinetic, static_ratio);
  scene.numerics.step = 0.02;
  Simulator rig(scene);
  const Truth& m = rig.truth();
  const double held = m.hook_load_string, start = along_hole(m);
  EXPECT_GT(held, 20e3);
  run(rig, 2.0);
  rig.command(WinchSetpoint{-0.1, false});  // a decimetre of slack beyond the 4 cm that the wire was stretched by
  run(rig, 1.0);
  rig.command(WinchSetpoint{0.0, true});
  run(rig, 10.0);
  EXPECT_LT(std::abs(wire_tension(rig)), 0.01 * held) << "the wire is slack";
  const double set = along_hole(m);
  // elastic: pipe compressed by its own weight along the hole (0.2 mm) and bristles bent (0.1 mm each under 0.9 kN), less than 2
  // mm
  EXPECT_LT(std::abs(set - start), 2e-3);
  double furthest = 0.0;
  for (int k = 0; k < 600; ++k)
  {
    run(rig, 1.0);
    furthest = std::max(furthest, std::abs(along_hole(m) - set));
  }
  EXPECT_LT(furthest, 1e-3);
  EXPECT_LT(furthest, 1e-5) << "does not creep at all, in fact";
}
}  // namespace

// cot 20 deg = 2.75 < 3.0, so friction can hold the pipe's weight.
TEST(Friction, holdsThePipeWithoutCreep)
{
  expect_sticks(3.0, 1.0);
}

// Static friction 3.0 holds what the kinetic one, 2.5, would not.
TEST(Friction, staticFrictionHoldsWhatKineticWouldNot)
{
  expect_sticks(2.5, 1.2);
}

// mu 0.5: acceleration g (cos I - mu sin I) (1 - mud/steel). The mud has no drag in this scene, nor added mass along the
// pipe. Seen: 0.3 %.
TEST(Friction, pipeSlidesByCoulombsLaw)
{
  for (double mu : {0.5, 0.2, 1.5})
  {
    Scene scene = pipe_on_a_wire(mu, 1.0);
    scene.numerics.step = 0.002;
    const double expected =
        standard_gravity * (std::cos(slant) - mu * std::sin(slant)) * (1.0 - scene.mud.density / steel_density);
    scene.rig.hoisting.max_acceleration = expected + 0.2;  // the block runs ahead, but leaves the wire little slack to bunch up
    Simulator rig(scene);
    const Truth& m = rig.truth();
    run(rig, 1.0);
    rig.command(WinchSetpoint{-20.0, false});
    run(rig, 0.4);
    EXPECT_LT(std::abs(wire_tension(rig)), 200.0) << "the wire is slack";
    // speed gained over half a second: a mean over many periods of the pipe's ringing (0.1 s and shorter)
    const double speed = m.bit_velocity.norm(), begin = m.time, place = along_hole(m);
    run(rig, 0.5);
    const double measured = (m.bit_velocity.norm() - speed) / (m.time - begin);
    EXPECT_NEAR(measured, expected, 0.01 * expected) << "mu " << mu;
    EXPECT_GT(along_hole(m) - place, 0.3);
  }
}
}  // namespace test_sim_friction
