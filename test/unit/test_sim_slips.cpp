// SPDX-License-Identifier: BSD-3-Clause
// The slips bear the string, let it go upwards, hold it in spin; weight goes from the hook to them and back.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "in_slips.h"
#include "sim_numbers.h"

namespace test_sim_slips
{
using namespace drill_rig_sim;

namespace
{
constexpr Level levels[] = {Level::beam3d, Level::hybrid, Level::axial_torsional, Level::rigid};

double load_on_slips(const Simulator& rig)
{
  return slips_load(rig.save()->mechanics);
}
}  // namespace

// Without friction nothing but hook and slips bears the string: what one loses the other takes. The bit sinks by what the slips
// give, F/k.
TEST(Slips, takeWhatTheHookLoses)
{
  for (const Level level : levels)
  {
    SCOPED_TRACE(static_cast<int>(level));
    Simulator rig(slips_scene(level));
    play_on(rig, 5.0);
    const double hook = rig.truth().hook_load, depth = rig.truth().bit_depth, seen = rig.readings().bit_depth;
    lay_into_slips(rig);
    EXPECT_TRUE(rig.truth().in_slips);
    EXPECT_EQ(rig.readings().in_slips, true);
    const double borne = load_on_slips(rig);
    EXPECT_NEAR(rig.truth().hook_load + borne, hook, 50.0);
    EXPECT_NEAR(rig.truth().hook_load, block_weight(rig) + weight_above_slips(rig), 1000.0);
    EXPECT_GT(borne, 60e3);
    EXPECT_NEAR(rig.truth().bit_depth - depth, borne / slips_stiffness, 2e-6);
    EXPECT_NEAR(rig.readings().bit_depth, seen, 1e-5) << "held while the slips bear the string";
    take_from_slips(rig);
    play_on(rig, 5.0);
    EXPECT_NEAR(rig.truth().hook_load, hook, 50.0);
  }
}

// The block picks up 10 cm with the slips set: the string goes with it, and comes back to rest where it was.
TEST(Slips, letThePipeGoUpwards)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  lay_into_slips(rig);
  const double hook = rig.truth().hook_load + load_on_slips(rig), depth = rig.truth().bit_depth;
  rig.command(WinchSetpoint{0.02, false});
  play_on(rig, 6.0);
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 15.0);
  EXPECT_EQ(load_on_slips(rig), 0.0);
  EXPECT_NEAR(rig.truth().hook_load, hook, 50.0);
  EXPECT_LT(rig.truth().bit_depth, depth - 0.08);
  bring_hook_to(rig, block_weight(rig) + weight_above_slips(rig));
  EXPECT_NEAR(rig.truth().bit_depth, depth, 1e-5);
}

// Torque that was wound up below them stays there, and the drive above is locked.
TEST(Slips, holdTheStringInSpin)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  lay_into_slips(rig);
  TopDriveSetpoint drive;
  drive.speed = 1.0;
  const CommandResult result = rig.command(drive);
  EXPECT_EQ(result.outcome, CommandResult::Outcome::refused);
  EXPECT_STREQ(result.reason, "the string is in the slips: the top drive is locked, allowed: at rest");
  drive.mode = TopDriveMode::torque;
  drive.speed = 0.0;
  drive.torque = 100.0;
  EXPECT_EQ(rig.command(drive).outcome, CommandResult::Outcome::refused);
  drive.torque = 0.0;
  EXPECT_EQ(rig.command(drive).outcome, CommandResult::Outcome::accepted);
  EXPECT_EQ(rig.command(PumpSetpoint{0.01}).outcome, CommandResult::Outcome::accepted) << "the pump may run";
}

// Slack off and pick up: what springs, line and string hold is what winch and gravity have given, but for what mud and steel
// took.
TEST(Slips, closeTheEnergyBalance)
{
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    Simulator rig(slips_scene(level));
    rig.balance_energy();
    lay_into_slips(rig);
    EXPECT_LT(std::abs(rig.energy().residual()), 0.01 * std::abs(rig.energy().winch)) << static_cast<int>(level);
    EXPECT_GT(rig.energy().last.stuck_point, 0.5 * 60e3 * 60e3 / slips_stiffness);
    const double before = rig.energy().residual();
    take_from_slips(rig);
    play_on(rig, 3.0);
    EXPECT_LT(std::abs(rig.energy().residual() - before), 1.0) << static_cast<int>(level);
  }
}

TEST(Slips, refuseWhatWouldDropOrBreakTheString)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  EXPECT_STREQ(rig.set_slips(false), "slips: the slips are not set");
  rig.command(WinchSetpoint{0.1, false});
  play_on(rig, 1.0);
  EXPECT_STREQ(rig.set_slips(true), "slips: the block moves, allowed: at rest");
  rig.command(WinchSetpoint{0.0, true});
  TopDriveSetpoint drive;
  drive.speed = 5.0;
  rig.command(drive);
  play_on(rig, 3.0);
  EXPECT_STREQ(rig.set_slips(true), "slips: the top drive turns, allowed: at rest");
  EXPECT_FALSE(rig.truth().in_slips);
  rig.command(TopDriveSetpoint());
  play_on(rig, 5.0);
  lay_into_slips(rig);
  EXPECT_STREQ(rig.set_slips(true), "slips: the slips are already set");
  EXPECT_STREQ(rig.set_slips(false), "slips: the slips carry the string, allowed: up to 5 kN, pick up first");
  EXPECT_TRUE(rig.truth().in_slips);

  Scene scene = slips_scene(Level::beam3d);
  scene.numerics.integrator = IntegratorKind::ida;
  Simulator reference(scene);
  EXPECT_STREQ(reference.set_slips(true), "slips: not available with the reference (ida), allowed: the other integrators");
}

// A frame of variable steps that ends within a stride is where the slips are set.
TEST(Slips, areSetWithinAStride)
{
  Scene scene = slips_scene(Level::axial_torsional);
  scene.numerics.step = 0.0;
  Simulator rig(scene);
  const double hook = rig.truth().hook_load;
  lay_into_slips(rig);
  play_on(rig, 2.0);
  EXPECT_NEAR(rig.truth().hook_load + load_on_slips(rig), hook, 50.0);
  const auto saved = rig.save();
  play_on(rig, 3.0);
  const std::vector<double> then = numbers_of(rig.truth());
  rig.restore(*saved);
  play_on(rig, 3.0);
  EXPECT_TRUE(bit_identical(numbers_of(rig.truth()), then));
}
}  // namespace test_sim_slips
