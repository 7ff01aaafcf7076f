// SPDX-License-Identifier: BSD-3-Clause
// The crew zeroes the weight on its way down after a connection, so that the weight that is shown afterwards is the bit's.
#include <gtest/gtest.h>

#include "in_slips.h"

namespace test_sim_crew_zero
{
using namespace drill_rig_sim;

namespace
{
/// Soft rock, and mud in which waves die.
Scene with_crew(Scene scene)
{
  scene.string = drilling_scene().string;
  scene.mud.axial_damping = 10.0;
  scene.mud.torsional_damping = 0.1;
  scene.connections = Connections::automatic;
  scene.numerics.level = Level::axial_torsional;
  scene.numerics.step = 0.0;
  scene.formation[0].drillability = 2e-6;
  scene.instruments.hook_load.place = HookLoadPlace::block;
  scene.rig.hoisting.connection_time = 20.0;
  return scene;
}

/// Zeroes the weight off bottom, and drills until a stand was added.
void play_until_added(Simulator& rig, double flow, double feed)
{
  TopDriveSetpoint drive;
  drive.speed = 10.0;
  rig.command(drive);
  rig.command(PumpSetpoint{flow});
  play_on(rig, 120.0);
  rig.command(WinchSetpoint{-0.02, false});
  play_on(rig, 10.0);
  ASSERT_TRUE(rig.tare());
  rig.command(WinchSetpoint{-feed, false});
  const int stands = rig.truth().stand_count;
  while (rig.truth().stand_count == stands || rig.truth().crew != CrewTask::none)
  {
    ASSERT_LT(rig.truth().time, 2e3);
    ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running) << rig.failure();
  }
}

/// Shown less true weight on bit, the mean of 10 s [N].
double error_of_weight(Simulator& rig)
{
  double sum = 0.0;
  int frames = 0;
  play_on(rig, 10.0,
          [&](const Simulator& now)
          {
            sum += now.truth().surface_wob - now.truth().wob;
            ++frames;
          });
  return sum / frames;
}
}  // namespace

// The pumped mud lifts the string; in a deep well its pressure takes a minute to come.
TEST(CrewZero, waitsForTheMudsPressure)
{
  const Scene scene = with_crew(vertical_scene(4000.0, 3998.0, 0.25));
  Simulator rig(scene);
  play_until_added(rig, 0.04, 0.02);
  play_on(rig, 30.0);
  ASSERT_GT(rig.truth().wob, 500.0);
  EXPECT_NEAR(error_of_weight(rig), 0.0, 2.5e3);
}

// Of pipe that rotates, the drag along the hole grows with its speed along it.
TEST(CrewZero, goesAsSlowlyAsItDrills)
{
  const auto survey = build_and_hold(300.0, 0.1 * degree, 60.0 * degree, 0.0, 2000.0);
  const Scene scene = with_crew(scene_in(survey, 2000.0, 1998.0, 0.3));
  Simulator rig(scene);
  play_until_added(rig, 0.02, 0.02);
  play_on(rig, 60.0);
  ASSERT_GT(rig.truth().wob, 500.0);
  EXPECT_NEAR(error_of_weight(rig), 0.0, 4e3);
}
}  // namespace test_sim_crew_zero
