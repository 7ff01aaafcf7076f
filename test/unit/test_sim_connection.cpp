// SPDX-License-Identifier: BSD-3-Clause
// A stand is added to the string in the slips, or taken away: depths stay, the hook load follows, nothing jumps.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drill_rig_sim/scene/scene_mesh.h"
#include "in_slips.h"
#include "sim_numbers.h"

namespace test_sim_connection
{
using namespace drill_rig_sim;

namespace
{
constexpr Level levels[] = {Level::beam3d, Level::hybrid, Level::axial_torsional, Level::rigid};
constexpr double stand = 3 * 9.5;                                              // [m]
constexpr double stand_weight = stand * tool_jointed_mass * standard_gravity;  // in air [N]

/// How much a rig's signals change from frame to frame.
class Jumps
{
public:
  explicit Jumps(const Simulator& rig) : last_(rig.truth()), seen_(rig.readings().bit_depth), hole_(rig.readings().hole_depth) {}

  void look(const Simulator& rig)
  {
    const Truth& m = rig.truth();
    raise(hook_load, m.hook_load - last_.hook_load);
    raise(torque, m.torque - last_.torque);
    raise(block_height, m.block_height - last_.block_height);
    raise(block_velocity, m.block_velocity - last_.block_velocity);
    raise(bit_depth, m.bit_depth - last_.bit_depth);
    raise(depths_seen, rig.readings().bit_depth - seen_);
    raise(depths_seen, rig.readings().hole_depth - hole_);
    last_ = m;
  }

  double hook_load = 0.0, torque = 0.0, block_height = 0.0, block_velocity = 0.0, bit_depth = 0.0;
  double depths_seen = 0.0;  // readings, away from the start's [m]

private:
  static void raise(double& most, double change) { most = std::max(most, std::abs(change)); }
  Truth last_;
  double seen_, hole_;
};

/// Connects with a look at every frame.
Jumps connect_watched(Simulator& rig, bool remove)
{
  Jumps jumps(rig);
  connect(rig, 0, remove, [&](const Simulator& now) { jumps.look(now); });
  return jumps;
}

/// Bounds: what smooth courses over 5 s and 38 s (the block at no more than 1.5 m/s) make in 10 ms, and the rest load of up to 1
/// kN.
void expect_smooth(const Jumps& jumps)
{
  EXPECT_LT(jumps.hook_load, 1.5 * 1.2 * stand_weight / 5.0 * slips_frame + 5.0);
  EXPECT_LT(jumps.torque, 5.0);
  EXPECT_LT(jumps.block_height, 1.01 * 2.0 * stand / 38.0 * slips_frame);
  EXPECT_LT(jumps.block_velocity, 1.01 * 2.0 * pi * stand / (38.0 * 38.0) * slips_frame);
  EXPECT_LT(jumps.bit_depth, 1e-6);
  EXPECT_LT(jumps.depths_seen, 1e-9);
}
}  // namespace

// Of the same bit depth the string above the rotary table is a stand longer: so much more hangs on the hook, in air.
TEST(Connection, addsAStand)
{
  for (const Level level : levels)
  {
    SCOPED_TRACE(static_cast<int>(level));
    Simulator rig(slips_scene(level));
    play_on(rig, 5.0);
    const Truth before = rig.truth();
    const std::string kind = rig.statistics().level;
    lay_into_slips(rig);
    const double in_slips = rig.truth().bit_depth, height = rig.truth().block_height, hook = rig.truth().hook_load;
    expect_smooth(connect_watched(rig, false));
    EXPECT_NEAR(rig.truth().bit_depth, in_slips, 1e-6);
    EXPECT_NEAR(rig.truth().block_height, height + stand, 1e-3);
    EXPECT_NEAR(rig.truth().hook_load, hook + stand_weight, 1000.0);
    EXPECT_EQ(rig.truth().stand_count, before.stand_count + 1);
    EXPECT_TRUE(rig.truth().in_slips);
    EXPECT_EQ(rig.statistics().level, kind);
    Jumps after(rig);
    play_on(rig, 5.0, [&](const Simulator& now) { after.look(now); });
    EXPECT_LT(after.hook_load, 100.0) << "the stand hangs at rest";
    EXPECT_LT(after.bit_depth, 1e-6);
    take_from_slips(rig);
    play_on(rig, 5.0);
    EXPECT_NEAR(rig.truth().hook_load, before.hook_load + stand_weight, 50.0);
    EXPECT_NEAR(rig.truth().bit_depth, before.bit_depth, 2e-2) << "lifted out of the slips";
    EXPECT_NEAR(rig.readings().bit_depth, rig.truth().bit_depth, 1e-3);
  }
}

TEST(Connection, takesAStandAway)
{
  for (const Level level : levels)
  {
    SCOPED_TRACE(static_cast<int>(level));
    Scene scene = slips_scene(level);
    scene.start.block_height = 36.0;
    Simulator rig(scene);
    play_on(rig, 5.0);
    const Truth before = rig.truth();
    lay_into_slips(rig);
    const double height = rig.truth().block_height;
    expect_smooth(connect_watched(rig, true));
    EXPECT_NEAR(rig.truth().block_height, height - stand, 1e-3);
    EXPECT_EQ(rig.truth().stand_count, before.stand_count - 1);
    take_from_slips(rig);
    play_on(rig, 5.0);
    EXPECT_NEAR(rig.truth().hook_load, before.hook_load - stand_weight, 50.0);
    EXPECT_NEAR(rig.readings().bit_depth, rig.truth().bit_depth, 1e-3);
  }
}

// 40 m into a wider hole: the mud resists pipe there as in a scene that starts with it there.
TEST(Connection, theMudsDragIsThatOfTheHoleAroundTheString)
{
  Scene scene = slips_scene(Level::beam3d);
  scene.mud = MudSpec();
  const double bit = scene.start.bit_depth, shoe = bit - 20.0;
  scene.well.sections.insert(scene.well.sections.begin(), scene.well.sections.front());
  scene.well.sections.front().to = shoe;
  scene.well.sections.front().diameter *= 1.5;
  const double length = bit + scene.start.block_height;
  const Mesh start = build_mesh(scene, length), pulled = build_mesh(scene, length, bit - 40.0);
  Scene above = scene;
  above.start.bit_depth = bit - 40.0;
  ASSERT_EQ(start.nodes.size(), pulled.nodes.size());
  EXPECT_LT(pulled.nodes[1].mud_across, 0.9 * start.nodes[1].mud_across);
  EXPECT_EQ(pulled.nodes[0].mud_across, build_mesh(above, length).nodes[0].mud_across);
  for (std::size_t k = 0; k < start.nodes.size(); ++k) EXPECT_EQ(start.nodes[k].from_bit, pulled.nodes[k].from_bit);
}

// The joint with the hole goes out with its stand.
TEST(Connection, aLeakGoesWithItsPipe)
{
  Scene scene = slips_scene(Level::axial_torsional);
  scene.start.block_height = 36.0 - stand;
  Simulator rig(scene);
  ASSERT_EQ(nullptr, rig.inject({FaultKind::washed_out_pipe, 10.0, 1e-4, Gauge::hook_load}));
  rig.command(WinchSetpoint{0.5, false});
  while (rig.truth().block_height < 36.0) ASSERT_EQ(play_frame(rig, nullptr, slips_frame), FrameStatus::running);
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 10.0);
  lay_into_slips(rig);
  EXPECT_EQ(1e-4, rig.save()->mechanics.faults.leak_area);
  connect(rig, 0, true);
  EXPECT_EQ(0.0, rig.save()->mechanics.faults.leak_area);
}

// Slacked off further than needed, so that the block leans on the pipe by 60 kN: nothing jumps all the same, and the string that
// comes out is the same.
TEST(Connection, beginsUnderTheWeightOfTheBlock)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  play_on(rig, 5.0);
  const Truth before = rig.truth();
  lay_into_slips(rig);
  bring_hook_to(rig, rig.truth().hook_load - 60e3);
  const Jumps jumps = connect_watched(rig, false);
  EXPECT_LT(jumps.hook_load, 1e3) << "1 cm/s of the block on its lines";
  EXPECT_LT(jumps.bit_depth, 5e-6) << "the crew takes the block's weight off the slips as it breaks out";
  EXPECT_LT(jumps.depths_seen, 1e-9);
  take_from_slips(rig);
  play_on(rig, 5.0);
  EXPECT_NEAR(rig.truth().hook_load, before.hook_load + stand_weight, 50.0);
}

// Pipe in, the same pipe out: the string is what it was, and hangs as it did.
TEST(Connection, thereAndBackIsNothing)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  lay_into_slips(rig);
  const Truth before = rig.truth();
  const double length = rig.save()->string.length;
  connect(rig, 0, false);
  connect(rig, 0, true);
  play_on(rig, 2.0);
  EXPECT_NEAR(rig.save()->string.length, length, 1e-9);
  EXPECT_NEAR(rig.truth().hook_load, before.hook_load, 1000.0);
  EXPECT_NEAR(rig.truth().block_height, before.block_height, 1e-3);
  EXPECT_NEAR(rig.truth().bit_depth, before.bit_depth, 1e-6);
  connect(rig, 2, false);
  EXPECT_NEAR(rig.save()->string.length, length + 19.0, 1e-9);
}

// Weight and stretch of the pipe that comes, and what rings above the slips, are counted as handled.
TEST(Connection, closesTheEnergyBalance)
{
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    Simulator rig(slips_scene(level));
    rig.balance_energy();
    lay_into_slips(rig);
    const EnergyAccounts before = rig.energy();
    connect(rig, 0, false);
    const EnergyAccounts after = rig.energy();
    EXPECT_NEAR(after.residual(), before.residual(), 0.1) << static_cast<int>(level);
    EXPECT_NEAR(after.handled, after.stored() - before.stored(), 5.0) << "nothing else has moved";
    EXPECT_LT(after.handled, -500.0) << "the line is shorter";
    take_from_slips(rig);
    play_on(rig, 3.0);
    EXPECT_NEAR(rig.energy().residual(), before.residual(), 1.0) << static_cast<int>(level);
  }
}

TEST(Connection, isRefusedWithALine)
{
  Simulator rig(slips_scene(Level::axial_torsional));
  EXPECT_STREQ(rig.make_connection(0, false), "connection: the slips are not set");
  play_on(rig, 2.0);
  ASSERT_EQ(rig.set_slips(true), nullptr);
  rig.command(PumpSetpoint{0.02});
  play_on(rig, 1.0);
  EXPECT_STREQ(rig.make_connection(0, false), "connection: the pump runs, allowed: off");
  rig.command(PumpSetpoint{0.0});
  play_on(rig, 10.0);
  EXPECT_STREQ(
      rig.make_connection(0, false),
      "connection: the hook carries more than block and pipe above the slips, allowed: up to 10 kN more, slack off first");
  bring_hook_to(rig, 5e3);
  EXPECT_STREQ(rig.make_connection(0, false),
               "connection: the block rests on the pipe, allowed: only on its lines, pick up first");
  bring_hook_to(rig, block_weight(rig) + weight_above_slips(rig));
  EXPECT_STREQ(rig.make_connection(4, false), "connection: the block would rise above highest_block_height");
  EXPECT_STREQ(rig.make_connection(1, true), "connection: the block would go below lowest_block_height");
  EXPECT_STREQ(rig.make_connection(50, true), "connection: the string has fewer joints than are to be removed");
  rig.command(WinchSetpoint{-0.001, false});
  EXPECT_STREQ(rig.make_connection(0, false), "connection: the block moves, allowed: at rest");
  rig.command(WinchSetpoint{0.0, true});
  play_on(rig, 1.0);
  ASSERT_EQ(rig.make_connection(0, false), nullptr);
  EXPECT_STREQ(rig.make_connection(0, false), "connection: a connection is already under way");
  EXPECT_STREQ(rig.set_slips(false), "slips: the connection is broken out, it must be made up first");
  EXPECT_STREQ(rig.command(PumpSetpoint{0.01}).reason, "the connection is broken out: the pump is locked, allowed: 0");
  EXPECT_STREQ(rig.command(WinchSetpoint{0.1, false}).reason,
               "the connection is broken out: the crew moves the block until it is made up");

  Scene scene = slips_scene(Level::axial_torsional);
  scene.start.block_height = 20.0;
  Simulator high(scene);
  lay_into_slips(high);
  EXPECT_STREQ(high.make_connection(1, false),
               "connection: the slips hold another joint than the one to break out, move the block there first");
}

// Pipe that lies on its wall sticks the firmer the longer it rests: the connection counts, for the string goes on resting in the
// slips.
TEST(Connection, letsFrictionGrow)
{
  Scene scene = slips_scene(Level::axial_torsional, 0.3);
  scene.well.survey = build_and_hold(60.0, 4.0 * degree / 30.0, 30.0 * degree, 0.0, 300.0);
  scene.contact.growth.per_fold = 0.03;
  Simulator rig(scene);
  lay_into_slips(rig);
  connect(rig, 0, false);
  const auto state = rig.save();
  int rested = 0;
  for (const NodeState& node : state->mechanics.nodes) rested += node.rest > connection_duration(scene.rig.hoisting, stand) - 1.0;
  EXPECT_GT(rested, 8);
}

// Saved while the block runs, and after: both go on as they did, whatever string the rig had meanwhile.
TEST(Connection, isInSnapshots)
{
  for (const double step : {0.01, 0.0})
  {
    Scene scene = slips_scene(Level::hybrid);
    scene.numerics.step = step;
    Simulator rig(scene);
    lay_into_slips(rig);
    const auto short_string = rig.save();
    ASSERT_EQ(rig.make_connection(0, false), nullptr);
    play_on(rig, 8.0);
    const auto under_way = rig.save();
    play_on(rig, 44.0);
    const auto after = rig.save();
    play_on(rig, 2.0);
    const std::vector<double> end = numbers_of(rig.truth());
    ASSERT_TRUE(rig.restore(*under_way));
    play_on(rig, 46.0);
    EXPECT_TRUE(bit_identical(numbers_of(rig.truth()), end));
    ASSERT_TRUE(rig.restore(*short_string));
    play_on(rig, 1.0);
    ASSERT_TRUE(rig.restore(*after));
    play_on(rig, 2.0);
    EXPECT_TRUE(bit_identical(numbers_of(rig.truth()), end));
    Simulator other(scene);
    ASSERT_TRUE(other.restore(*after));
    play_on(other, 2.0);
    EXPECT_TRUE(bit_identical(numbers_of(other.truth()), end));
  }
}

// The lines of config/README.md, and one that cannot be.
TEST(Connection, byAProgram)
{
  Scene scene = slips_scene(Level::rigid);
  const auto line = [&scene](double at) -> ProgramStep&
  {
    scene.program.emplace_back();
    scene.program.back().at = at;
    return scene.program.back();
  };
  line(0.0).slips = 1.0;
  line(1.0).block_velocity = -0.01;
  line(1.75).brake = 1.0;
  line(8.0).connection = 3.0;
  line(60.0).block_velocity = 0.01;
  line(65.0).slips = 0.0;
  line(66.0).slips = 1.0;
  Simulator rig(scene);
  const double length = rig.save()->string.length;
  ScenePlayer program(scene);
  FrameStatus status = FrameStatus::running;
  while (status == FrameStatus::running && rig.truth().time < 70.0) status = play_frame(rig, &program, slips_frame);
  EXPECT_NEAR(rig.save()->string.length, length + stand, 1e-9);
  EXPECT_NEAR(rig.truth().time, 66.0, 0.02);
  EXPECT_STREQ(rig.failure(), "slips: the block moves, allowed: at rest");
}

// The block's cycloid: as far as it shall, at rest at both ends, within the winch's limits.
TEST(Connection, runsTheBlockWithinItsLimits)
{
  HoistingSpec spec;
  spec.connection_time = 20.0;
  EXPECT_DOUBLE_EQ(connection_duration(spec, 9.5), 10.0 + 2.0 * 9.5 / 1.5);
  spec.connection_time = 180.0;
  EXPECT_DOUBLE_EQ(connection_duration(spec, -28.5), 180.0);
  for (const double time : {8.0, 20.0, 180.0})
  {
    spec.connection_time = time;
    ConnectionState connection;
    connection.under_way = true;
    connection.travel = 28.5;
    const double duration = connection_duration(spec, connection.travel), h = 1e-4;
    EXPECT_EQ(block_run(spec, connection).travel, 0.0);
    double before = 0.0, last_speed = 0.0;
    for (connection.elapsed = h; connection.elapsed < duration; connection.elapsed += h)
    {
      const BlockRun now = block_run(spec, connection);
      EXPECT_NEAR(now.travel - before, h * 0.5 * (now.speed + last_speed), 1e-9);
      EXPECT_LE(now.speed, spec.max_speed + 1e-9);
      EXPECT_LE(std::abs(now.speed - last_speed), spec.max_acceleration * h * 1.001);
      before = now.travel;
      last_speed = now.speed;
    }
    EXPECT_NEAR(before, 28.5, 1e-9);
  }
}
}  // namespace test_sim_connection
