// SPDX-License-Identifier: BSD-3-Clause
// What a driller meets of block, lines and sheaves: bounce that dies, the dead line's reading, slack line, stops that hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "playing.h"
#include "swing.h"
#include "test_scenes.h"

namespace test_sim_hoisting
{
using namespace drill_rig_sim;

namespace
{
/// Bit 2 m off the bottom of 400 m.
Scene hanging_scene()
{
  return vertical_scene(400.0, 398.0);
}
}  // namespace

// Lowered at 0.3 m/s and stopped: the rail takes 4 R of the lines' force a cycle of some 0.2 s, so 2 s later the load stands
// still; and the dead line, whose sheaves do not turn any more, swings with it and not by their friction.
TEST(Hoisting, aStopFromThreeTenthsComesToRest)
{
  Scene scene = hanging_scene();
  scene.rig.hoisting.line_damping = 0.0;  // the rail alone
  Simulator rig(scene);
  rig.command(WinchSetpoint{-0.3, false});
  play(rig, 3.0);
  rig.command(WinchSetpoint{0.0, false});
  play(rig, 0.7);
  Swing load, dead;
  play(rig, 1.0,
       [&](const Truth& t)
       {
         load(t.hook_load);
         dead(t.dead_line_hook_load);
       });
  EXPECT_LT(dead.half(), 1.2 * load.half() + 1.0);
  play(rig, 1.0);
  Swing late;
  play(rig, 1.0, [&](const Truth& t) { late(t.hook_load); });
  EXPECT_LT(late.half(), 500.0);
}

// Sheaves keep the friction of their last motion: 10 lines of e = 0.98 read 9.3 % more after lowering and 8.8 % less after
// raising.
TEST(Hoisting, theDeadLineRemembersWhichWayItMoved)
{
  Simulator rig(hanging_scene());
  for (const double way : {-0.1, 0.1, -0.1})
  {
    rig.command(WinchSetpoint{way, false});
    play(rig, 2.0);
    rig.command(WinchSetpoint{0.0, false});
    play(rig, 3.0);
    const Truth& t = rig.truth();
    EXPECT_NEAR(t.dead_line_hook_load / t.hook_load, way < 0.0 ? 1.0933314 : 1.0933314 * 0.8337478, 1e-6);
  }
}

// Raised and lowered at the same speed the lines carry twice the rail's friction more: 2 * 0.03 * 17.5 t.
TEST(Hoisting, railFrictionIsBetweenUpAndDown)
{
  double load[2] = {0.0, 0.0};
  for (const int up : {0, 1})
  {
    Simulator rig(hanging_scene());
    rig.command(WinchSetpoint{up ? 0.05 : -0.05, false});
    play(rig, 20.0);
    play(rig, 10.0, [&](const Truth& t) { load[up] += t.hook_load / 1000.0; });
  }
  EXPECT_NEAR(load[1] - load[0], 2.0 * 0.03 * standard_gravity * 17500.0, 300.0) << "in a vertical hole, but for the mud's drag";
}

TEST(Hoisting, aSlackLineCarriesNothingAndIsFlagged)
{
  Simulator rig(hanging_scene());
  EXPECT_FALSE(rig.truth().slack_line);
  rig.command(WinchSetpoint{-0.5, false});
  play(rig, 15.0);
  EXPECT_TRUE(rig.truth().slack_line);
  EXPECT_EQ(rig.truth().hook_load, 0.0);
  EXPECT_EQ(rig.truth().dead_line_hook_load, 0.0);
}

// Stuck and pulled below the crown stop, then free: the block shoots up and the stop, 2 cm beyond, holds it within 2 cm.
TEST(Hoisting, aFreedStringDoesNotTakeTheBlockPastItsStop)
{
  Scene scene = hanging_scene();
  scene.rig.hoisting.highest_block_height = scene.start.block_height + 0.25;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(150.0));
  rig.command(WinchSetpoint{0.05, false});
  play(rig, 20.0);
  EXPECT_GT(rig.truth().hook_load, 1000e3);
  rig.free_pipe();
  double highest = 0.0;
  bool stopped = false;
  play(rig, 5.0,
       [&](const Truth& t)
       {
         highest = std::max(highest, t.block_height);
         stopped = stopped || t.stop_reached;
       });
  EXPECT_TRUE(stopped);
  EXPECT_LT(highest, scene.rig.hoisting.highest_block_height + stop_clearance + 0.02);
}

TEST(Hoisting, theWinchStandsAtItsStopAndSaysSo)
{
  for (const double way : {0.2, -0.2})
  {
    Scene scene = hanging_scene();
    scene.rig.hoisting.lowest_block_height = scene.start.block_height - 0.5;
    scene.rig.hoisting.highest_block_height = scene.start.block_height + 0.5;
    Simulator rig(scene);
    const double hanging = rig.truth().hook_load;
    rig.command(WinchSetpoint{way, false});
    play(rig, 1.0);
    EXPECT_FALSE(rig.truth().stop_reached);
    play(rig, 5.0);
    EXPECT_TRUE(rig.truth().stop_reached);
    EXPECT_NEAR(rig.truth().block_height, scene.start.block_height + std::copysign(0.5, way), 0.01);
    // what hangs, hangs in the lines: the block does not lean on the stop
    const double friction = scene.rig.hoisting.rail_friction * standard_gravity * scene.rig.hoisting.block_mass;
    EXPECT_NEAR(rig.truth().hook_load, hanging, 1.01 * friction);
    rig.command(WinchSetpoint{-way, false});
    play(rig, 1.0);
    EXPECT_FALSE(rig.truth().stop_reached) << "the other way is free";
  }
}
}  // namespace test_sim_hoisting
