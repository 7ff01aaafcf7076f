// SPDX-License-Identifier: BSD-3-Clause
// A rotary steerable tool that points the bit: how the hole turns, its energy, its snapshots, and the levels at which it can.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/well/directions.h"
#include "in_source.h"
#include "playing.h"
#include "sim_numbers.h"
#include "steerable_scenes.h"

namespace test_sim_pointing
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double pivot = 0.8, blades_at = 1.0, upper_at = 7.0, play_of_blades = 2e-4;  // above the bit's face; all round [m]
constexpr double tilt = 0.45 * degree, weight = 40e3, side_cutting = 0.03;             // [rad, N, -]

PartSpec blades_of(double length, const char* name)
{
  PartSpec blades = blades_part(0.2159 - 2.0 * play_of_blades, name);
  blades.length = blades.joint_length = length;
  return blades;
}

/// Off the bottom of a hole that builds at 3 deg/30 m, by 10 deg at its bottom.
Scene building_scene()
{
  Scene scene = scene_in(build_and_hold(60.0, 0.1 * degree, 11.0 * degree, 1.0, 160.0), 160.0, 159.8, 0.2);
  PartSpec mwd = mwd_part();
  mwd.length = mwd.joint_length = upper_at - 0.15 - (blades_at + 0.15);
  mwd.mwd->sensor_offset = 2.0;
  scene.string = {bit_part(0.2159),
                  pointing_part(tilt, pivot, blades_at - 0.15 - 0.3),
                  blades_of(0.3, "blades"),
                  mwd,
                  blades_of(0.3, "upper_blades"),
                  pipe_part(0, 9.5, tool_jointed_mass)};
  scene.string[0].bit->side_cutting = side_cutting;
  scene.formation[0].drillability = 1e-7;
  scene.numerics.element_length = 4.75;
  return scene;
}

struct Curvature
{
  double three_points, beam;  ///< [rad/m]
};

/// Of the hole that this tool drills on and on. Three points, bit and blades at b and c above it, on a circle: the bit lies theta
/// a off the line through the blades, and e (1 + 2 b/d) for their play, the lower ones on the side to which the hole turns. And
/// the beam through them, relative to a hole of curvature k: the three-moment equation at the lower blades with kink, curvature,
/// play and weight w across; the bit drills along its axis, which leans by tau, and i_b of where the force F presses it, and
/// stays on its circle:
///   M c/(3 EI) = theta a/b - k c/2 + e/b + 2 e/d + w (b^3 + d^3)/(24 EI),   d = c - b
///   tau = theta (b - a)/b - k b/2 - e/b - M b/(6 EI) + w b^3/(24 EI),   F = M/b - w b/2,   tau (1 - i_b) + i_b F/W = 0
Curvature curvature_of(const BeamSection& s, double w)
{
  const double bit = 0.5 * 0.2159, a = pivot - bit, b = blades_at - bit, c = upper_at - bit, d = c - b, e = play_of_blades;
  const double turned = tilt * a / b + e / b + 2.0 * e / d, sag = w / (24.0 * s.bending);
  const auto off = [&](double k)
  {
    const double moment = 3.0 * s.bending / c * (turned - 0.5 * k * c + sag * (b * b * b + d * d * d));
    const double tau = tilt * (b - a) / b - 0.5 * k * b - e / b - moment * b / (6.0 * s.bending) + sag * b * b * b;
    return tau * (1.0 - side_cutting) + side_cutting * (moment / b - 0.5 * w * b) / weight;
  };
  const double at_0 = off(0.0), at_1 = off(1e-3);
  return {2.0 * turned / c, 1e-3 * at_0 / (at_0 - at_1)};
}
}  // namespace

// 12 m at 120 rpm and 40 kN; the dogleg of the last 5 m.
TEST(Pointing, theHoleTurnsAsTheGeometryOfItsTouchPointsSays)
{
  Simulator rig(building_scene());
  TopDriveSetpoint drive;
  drive.speed = 120.0 * rpm;
  rig.command(drive);
  rig.command(PumpSetpoint{0.02});
  rig.command(SteeringSetpoint{0.0, 1.0});
  WeightFeed feed;
  Vector3d from = Vector3d::Zero(), to = from;
  double depth = 0.0, wob = 0.0;
  int frames = 0;
  for (int k = 0; k < 60000 && rig.truth().hole_depth < 172.0; ++k)
  {
    const Truth& now = rig.truth();
    rig.command(WinchSetpoint{feed.velocity(now.wob, weight, 1e6, 0.1, frame), false});
    ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
    to = tangent_from(now.bit_inclination, now.bit_azimuth);
    if (now.hole_depth < 167.0) from = to, depth = now.hole_depth;
    wob += now.hole_depth < 167.0 ? 0.0 : now.wob;
    frames += now.hole_depth < 167.0 ? 0 : 1;
  }
  ASSERT_GT(rig.truth().hole_depth, 172.0);
  EXPECT_NEAR(wob / frames, weight, 0.05 * weight);
  const double curvature = std::acos(from.dot(to)) / (rig.truth().hole_depth - depth), in_air = 136.0,
               mud = 1.0 - 1150.0 / steel_density;
  const Curvature expected =
      curvature_of(tube_section(1.0, 0.165, 0.0714, 206e9, 0.3), in_air * mud * standard_gravity * std::sin(10.6 * degree));
  EXPECT_NEAR(curvature, expected.beam, 0.04 * expected.beam);
  EXPECT_NEAR(curvature, expected.three_points, 0.1 * expected.three_points);
  EXPECT_LT(std::abs(std::sin(10.0 * degree) * std::remainder(azimuth_of(to) - azimuth_of(from), 2.0 * pi)),
            0.2 * std::acos(from.dot(to)));
}

TEST(Pointing, itsActuatorsWorkIsBooked)
{
  for (const double speed : {0.0, 60.0 * rpm})
  {
    Scene scene = with_tool(slanted_scene(95.0, 0.25), pointing_part());
    scene.numerics.step = 1e-3;
    Simulator rig(scene);
    TopDriveSetpoint drive;
    drive.speed = speed;
    rig.command(drive);
    play(rig, 4.0);
    rig.balance_energy();
    rig.command(SteeringSetpoint{1.0, 1.0});
    play(rig, 8.0);
    EXPECT_GT(rig.energy().steering, 10.0);
    EXPECT_LT(rig.energy().closure(), 0.005) << speed;
  }
}

TEST(Pointing, aSnapshotHoldsTheLean)
{
  Simulator rig(with_tool(slanted_scene(95.0, 0.25), pointing_part()));
  rig.command(SteeringSetpoint{1.0, 1.0});
  play(rig, 2.0);
  const auto saved = rig.save();
  play(rig, 2.0);
  const std::vector<double> once = numbers_of(*rig.save());
  ASSERT_TRUE(rig.restore(*saved));
  play(rig, 2.0);
  EXPECT_TRUE(bit_identical(once, numbers_of(*rig.save())));
}

TEST(Pointing, needsFreeNodes)
{
  Scene scene = with_tool(slanted_scene(95.0, 0.25), pointing_part());
  scene.numerics.level = Level::hybrid;
  scene.numerics.free_length = 0.9;
  const ProblemList problems = scene_problems(scene);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ("numerics.free_length: 0.9 m ends below the pivot of a tool that points the bit, allowed: 0 or from 1 m on",
            problems[0].key + ": " + problems[0].text);
  std::swap(scene.numerics.free_length, scene.program.emplace_back().free_length);
  scene.numerics.free_length = 20.0;
  const ProblemList of_program = scene_problems(scene);
  ASSERT_EQ(of_program.size(), 1u);
  EXPECT_EQ("program[0].free_length: " + problems[0].text, of_program[0].key + ": " + of_program[0].text);
}

// Above the assembly the string may be guided; guided altogether it does not lean, and says that it does not represent the hole's
// direction.
TEST(Pointing, leansAtEveryLevelThatHasFreeNodes)
{
  const auto pressed = [](Level level)
  {
    Scene scene = with_tool(vertical_scene(100.0, 95.0), pointing_part());
    scene.numerics.level = level;
    Simulator rig(scene);
    rig.command(SteeringSetpoint{1.0, 1.0});
    play(rig, 8.0);
    StringProfile profile;
    rig.profile(profile);
    return profile.contact_force[0];
  };
  const double free = pressed(Level::beam3d);
  EXPECT_GT(free, 500.0);
  EXPECT_NEAR(pressed(Level::hybrid), free, 0.05 * free);
  EXPECT_LT(pressed(Level::axial_torsional), 0.05 * free);
}

// Pads that are tilted by more than they give way: the bit sticks, and what holds it lets go within less than a tenth of a
// millisecond.
TEST(Pointing, drillsOnWithABitThatJamsOnItsPads)
{
  Simulator rig(read_scene(in_source("test/scenes/jamming_pads.yaml")));
  ScenePlayer player(rig.scene());
  RunGoal goal;
  goal.duration = 45.0;
  EXPECT_EQ(RunEnd::duration, run(rig, player, goal, frame)) << rig.failure();
}
}  // namespace test_sim_pointing
