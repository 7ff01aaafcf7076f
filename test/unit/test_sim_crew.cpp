// SPDX-License-Identifier: BSD-3-Clause
// connections: auto. The crew drills on by stands, and trips.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene_problems.h"
#include "in_slips.h"
#include "sim_numbers.h"

namespace test_sim_crew
{
using namespace drill_rig_sim;

namespace
{
constexpr double stand = 3 * 9.5;  // [m]

Scene with_crew(Scene scene)
{
  scene.connections = Connections::automatic;
  scene.numerics.step = 0.0;
  return scene;
}

/// 5 cm off bottom, in rock that a block fed at 5 cm/s drills.
Scene soft_rock(Level level)
{
  Scene scene = with_crew(slips_scene(level, 0.2));
  scene.start.bit_depth = 205.0;
  scene.well.hole_depth = scene.well.survey.back().md = scene.well.sections.back().to = 205.05;
  scene.formation[0].drillability = 2e-6;
  scene.mud.axial_damping = 10.0;
  scene.mud.torsional_damping = 0.1;
  return scene;
}

template <class Until>
void play_until(Simulator& rig, double frame, double most, const Until& until)
{
  const double end = rig.truth().time + most;
  while (!until(rig.truth()))
  {
    ASSERT_LT(rig.truth().time, end) << text_of(rig.truth().crew);
    ASSERT_EQ(play_frame(rig, nullptr, frame), FrameStatus::running) << rig.failure();
  }
}

/// The operations that a rig goes through.
struct Log
{
  std::vector<CrewTask> operations;
  void note(CrewTask operation)
  {
    if (operations.empty() || operations.back() != operation) operations.push_back(operation);
  }
};
}  // namespace

// The block goes by what the hook carries too much, seen once a frame.
TEST(Crew, addsAStandWhateverTheFramesLength)
{
  for (const double frame : {0.05, 1.0, 2.0})
  {
    Simulator rig(soft_rock(Level::axial_torsional));
    const int stands = rig.truth().stand_count;
    turn_and_feed(rig, 0.05);
    play_until(rig, frame, 2e4, [&](const Truth& m) { return m.stand_count == stands + 1 && m.crew == CrewTask::none; });
    EXPECT_EQ(rig.truth().stand_count, stands + 1) << frame;
  }
}

// What the crew sees of the hook comes as late as its set points act, and it stops the block as much earlier.
TEST(Crew, addsAStandWhateverTheDeadTimes)
{
  for (const double late : {0.25, 1.0, 2.0})
  {
    Scene scene = soft_rock(Level::axial_torsional);
    scene.rig.plc_latency = scene.rig.hoisting.latency = late;
    Simulator rig(scene);
    const int stands = rig.truth().stand_count;
    turn_and_feed(rig, 0.05);
    double slacked = 0.0, lowest = 1e9;
    play_until(rig, slips_frame, 2e4,
               [&](const Truth& m)
               {
                 if (m.crew == CrewTask::slacking) slacked += slips_frame;
                 lowest = std::min(lowest, m.block_height);
                 return m.stand_count == stands + 1 && m.crew == CrewTask::none;
               });
    EXPECT_EQ(rig.truth().stand_count, stands + 1) << late;
    EXPECT_LT(slacked, 120.0) << late;
    EXPECT_GT(lowest, scene.rig.hoisting.lowest_block_height) << late;
  }
}

// Ten stands: the hole is ten stands deeper, the string ten stands longer, what was asked of drive and pump is in force again,
// and the depths that the driller reads are the true ones but for the string's stretch, of which a tenth of a millimetre a stand
// is new.
TEST(Crew, drillsTenStands)
{
  Simulator rig(soft_rock(Level::axial_torsional));
  const int stands = rig.truth().stand_count;
  const double length = rig.save()->string.length;
  turn_and_feed(rig, 0.05);
  double most_jump = 0.0, before = rig.truth().hole_depth, error = 0.0, first = 0.0;
  play_until(rig, slips_frame, 2e4,
             [&](const Truth& m)
             {
               most_jump = std::max(most_jump, std::abs(m.hole_depth - before));
               before = m.hole_depth;
               if (first == 0.0 && m.crew != CrewTask::none) first = m.hole_depth;
               error = std::max(error, std::abs(rig.readings().hole_depth - m.hole_depth));
               return m.stand_count == stands + 10 && m.crew == CrewTask::none;
             });
  EXPECT_NEAR(rig.save()->string.length, length + 10 * stand, 1e-6);
  EXPECT_NEAR(rig.truth().hole_depth, first + 9 * stand, 0.1);
  EXPECT_LT(most_jump, 2e-3);
  EXPECT_LT(error, 0.05);
  EXPECT_EQ(rig.truth().setpoints.top_drive.speed, 10.0);
  EXPECT_EQ(rig.truth().setpoints.pump.flow, 0.02);
  EXPECT_EQ(rig.truth().setpoints.winch.block_velocity, -0.05);
  play_on(rig, 30.0);
  EXPECT_TRUE(rig.truth().on_bottom);
}

// One connection in its parts, in their order. The weight on bit that the surface knows is right again after it: the crew tares.
TEST(Crew, goesThroughItsOperations)
{
  Simulator rig(soft_rock(Level::beam3d));
  rig.command(WinchSetpoint{-0.02, false});
  turn_and_feed(rig, 0.02);
  play_on(rig, 1.0);
  ASSERT_TRUE(rig.tare());
  Log log;
  bool pumps_in_slips = false, turns_in_slips = false;
  int stands = rig.truth().stand_count;
  play_until(rig, slips_frame, 2e3,
             [&](const Truth& m)
             {
               log.note(m.crew);
               pumps_in_slips |= m.crew == CrewTask::connecting && m.flow > 0.0;
               turns_in_slips |= m.in_slips && std::abs(m.top_drive_speed) > 0.02;
               return m.stand_count > stands && m.crew == CrewTask::none;
             });
  const std::vector<CrewTask> all = {CrewTask::none,     CrewTask::stopping,   CrewTask::lifting,    CrewTask::quieting,
                                     CrewTask::slacking, CrewTask::connecting, CrewTask::picking_up, CrewTask::restarting,
                                     CrewTask::lowering, CrewTask::none};
  EXPECT_EQ(log.operations, all);
  EXPECT_FALSE(pumps_in_slips);
  EXPECT_FALSE(turns_in_slips);
  play_on(rig, 15.0);
  double wob = 0.0, seen = 0.0;
  play_on(rig, 5.0,
          [&](const Simulator& now)
          {
            wob += now.truth().wob;
            seen += now.truth().surface_wob;
          });
  EXPECT_GT(wob, 0.0);
  EXPECT_NEAR(seen, wob, 0.1 * wob + 500 * 500.0);
}

// What is commanded while the crew is at work acts afterwards, and slips and connections by hand are refused meanwhile.
TEST(Crew, handsBackWhatIsAskedLast)
{
  Simulator rig(soft_rock(Level::rigid));
  turn_and_feed(rig, 0.05);
  play_until(rig, slips_frame, 1e3, [](const Truth& m) { return m.crew == CrewTask::connecting; });
  EXPECT_STREQ(rig.set_slips(false), "slips: the crew is making a connection");
  EXPECT_STREQ(rig.make_connection(1, false), "connection: the crew is already making one");
  EXPECT_EQ(rig.command(WinchSetpoint{-0.01, false}).outcome, CommandResult::Outcome::accepted);
  EXPECT_EQ(rig.command(PumpSetpoint{0.03}).outcome, CommandResult::Outcome::accepted);
  EXPECT_EQ(rig.truth().flow, 0.0);
  play_until(rig, slips_frame, 1e3, [](const Truth& m) { return m.crew == CrewTask::none; });
  EXPECT_EQ(rig.truth().setpoints.winch.block_velocity, -0.01);
  EXPECT_NEAR(rig.truth().flow, 0.03, 1e-3);
}

// A trip out of 3 km and in again. Without friction the hook carries block, string in mud and the stretch in air, closed form,
// whenever the block runs; the depth read is the tally's, and at the end all is where it was.
TEST(Crew, tripsOutOfThreeKilometresAndIn)
{
  Scene scene = slips_scene(Level::rigid);
  scene.well.hole_depth = scene.well.survey.back().md = scene.well.sections.back().to = 3010.0;
  scene.start.bit_depth = 3000.0;
  scene.mud.axial_damping = scene.rig.mud_pump.pressure_coefficient = 0.0;  // the string alone is weighed
  scene.rig.hoisting.line_damping = 0.1;
  scene.connections = Connections::automatic;
  scene.numerics.step = 0.05;
  scene.numerics.guided_element_length = 19.0;
  Simulator rig(scene);
  const int stands = rig.truth().stand_count;
  const double length = rig.save()->string.length, collars = 2 * 9.4 * 136.0, bit = 40.0;
  double worst = 0.0, depth_error = 0.0;
  const auto weigh = [&](const Truth& m)
  {
    depth_error = std::max(depth_error, std::abs(rig.readings().bit_depth - m.bit_depth));
    if (m.crew != CrewTask::none) return;
    const double pipe = (m.bit_depth - 0.3 - 2 * 9.4) * tool_jointed_mass;
    const double expected = standard_gravity * ((bit + collars + pipe) * (1.0 - scene.mud.density / steel_density) +
                                                tool_jointed_mass * m.block_height);
    worst = std::max(worst, std::abs(m.hook_load_string - expected));
  };
  rig.command(WinchSetpoint{1.0, false});
  const int last = stands - 100;
  play_until(rig, 0.05, 2e4, [&](const Truth& m) { return m.stand_count == last && m.crew == CrewTask::none; });
  rig.command(WinchSetpoint{0.0, true});
  play_until(rig, 0.05, 30.0, [&, start = rig.truth().time](const Truth& m) { return m.time > start + 25.0; });
  EXPECT_NEAR(rig.save()->string.length, length - 100 * stand, 1e-6);
  weigh(rig.truth());
  EXPECT_LT(worst, 50.0);
  EXPECT_LT(rig.truth().bit_depth, 3000.0 - 99 * stand);
  rig.command(WinchSetpoint{-1.0, false});
  play_until(rig, 0.05, 3e4,
             [&](const Truth& m)
             {
               depth_error = std::max(depth_error, std::abs(rig.readings().bit_depth - m.bit_depth));
               return m.stand_count == stands && m.crew == CrewTask::none;
             });
  rig.command(WinchSetpoint{0.0, true});
  play_until(rig, 0.05, 30.0, [&, start = rig.truth().time](const Truth& m) { return m.time > start + 25.0; });
  weigh(rig.truth());
  EXPECT_LT(worst, 50.0);
  EXPECT_NEAR(rig.save()->string.length, length, 1e-6);
  EXPECT_LT(depth_error, 0.02);
  EXPECT_NEAR(rig.truth().bit_depth + rig.truth().block_height, 3000.0 + scene.start.block_height, 0.01)
      << "the string is what it was";
}

TEST(Crew, needsRoomAndPipe)
{
  Scene scene = soft_rock(Level::rigid);
  EXPECT_TRUE(scene_problems(scene).empty()) << scene_problems(scene).front().text;
  scene.rig.hoisting.highest_block_height = 25.0;
  ASSERT_EQ(scene_problems(scene).size(), 1u);
  EXPECT_EQ(scene_problems(scene).front().text, "auto: the block travels 24 m, needed for a stand: 30 m");
  scene = soft_rock(Level::beam3d);
  scene.numerics.step = 0.01;
  scene.numerics.integrator = IntegratorKind::ida;
  ASSERT_FALSE(scene_problems(scene).empty());
  EXPECT_EQ(scene_problems(scene).front().text, "auto: not available with the reference (ida)");
}

// As operations, with `connections: off`: the crew comes for them, and for nothing else.
TEST(Crew, comesForAnOperation)
{
  Scene scene = soft_rock(Level::rigid);
  scene.connections = Connections::off;
  const double stand_off = 5.0;  // [m]
  scene.start.bit_depth -= stand_off;
  const auto operation = [](OperationKind kind)
  {
    Operation o = default_operation(kind);
    o.speed = 0.5;
    return o;
  };
  Operation out = operation(OperationKind::trip), in = out, taken = operation(OperationKind::connection),
            pump = operation(OperationKind::flow);
  Operation wait = operation(OperationKind::wait);
  wait.time = 5.0;
  pump.flow = 0.02;
  out.to_depth = 140.0;
  in.to_depth = 195.0;
  taken.remove = 1.0;
  scene.operations = {pump, operation(OperationKind::connection), out, wait, in, wait, taken};
  EXPECT_TRUE(scene_problems(scene).empty()) << scene_problems(scene).front().text;
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  const auto play_up_to = [&](int number)
  {
    for (int k = 0; k < 200000 && player.operations().status().number != number; ++k)
      ASSERT_EQ(play_frame(rig, &player, slips_frame), FrameStatus::running) << rig.failure();
    ASSERT_EQ(player.operations().status().number, number);
  };
  const int stands = rig.truth().stand_count;
  play_up_to(2);
  play_up_to(3);
  EXPECT_EQ(rig.truth().stand_count, stands + 1);
  EXPECT_EQ(rig.setpoints().pump.flow, 0.02) << "as before it";
  EXPECT_LT(rig.truth().bit_depth, rig.truth().hole_depth);
  play_up_to(4);
  EXPECT_NEAR(rig.truth().bit_depth, out.to_depth, 0.03);
  EXPECT_LT(std::abs(rig.truth().block_velocity), 0.12) << "it comes to stand there: sqrt(2 a 1 cm) = 0.1 m/s";
  EXPECT_LT(rig.truth().stand_count, stands);
  play_up_to(6);
  EXPECT_NEAR(rig.truth().bit_depth, in.to_depth, 0.03);
  play_up_to(7);
  const int there = rig.truth().stand_count;
  play_up_to(0);
  EXPECT_EQ(rig.truth().stand_count, there - 1);
  EXPECT_TRUE(rig.setpoints().winch.brake);
  rig.command(WinchSetpoint{0.5, false});
  play_until(rig, slips_frame, 300.0, [](const Truth& m) { return m.stop_reached; });
  EXPECT_EQ(rig.truth().stand_count, there - 1) << "the crew was not called";
  scene.rig.hoisting.highest_block_height = 25.0;
  ASSERT_EQ(scene_problems(scene).size(), 4u);
  EXPECT_EQ(scene_problems(scene).front().text, "connection: the block travels 24 m, needed for a stand: 30 m");
}

// Longer than the mast is high: the way of pick_up, and of the strokes of ream, is the bit's. pick_up is over where the block
// still rises by v^2/(2 a).
TEST(Crew, strokesGoOverAStand)
{
  Scene scene = soft_rock(Level::rigid);
  scene.start.bit_depth -= 5.0;
  const auto stroke = [](OperationKind kind, double distance)
  {
    Operation o = default_operation(kind);
    o.speed = 0.5;
    o.distance = distance;
    return o;
  };
  scene.operations = {stroke(OperationKind::pick_up, 45.0), stroke(OperationKind::ream, 40.0)};
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  const double begun = rig.readings().bit_depth, rise = 0.25 / (2.0 * scene.rig.hoisting.max_acceleration);
  double picked_up = 0.0, highest = begun;
  for (int k = 0; k < 200000 && !player.finished(); ++k)
  {
    ASSERT_EQ(play_frame(rig, &player, slips_frame), FrameStatus::running) << rig.failure();
    if (player.operations().status().number == 1) picked_up = begun - rig.readings().bit_depth;
    highest = std::min(highest, rig.readings().bit_depth);
  }
  ASSERT_TRUE(player.finished());
  EXPECT_NEAR(picked_up, 45.0 - rise, 0.02);
  EXPECT_NEAR(begun - highest, picked_up + 40.0, 0.05);
  EXPECT_NEAR(begun - rig.readings().bit_depth, picked_up, rise + 0.05);
}

// What no crew would do ends with a reason, and the block does not set the string down.
TEST(Crew, operationsThatCannotBeAreTold)
{
  Scene scene = soft_rock(Level::rigid);
  scene.connections = Connections::off;
  scene.start.block_height = 20.0;
  const auto operation = [](OperationKind kind, double to_depth, double remove)
  {
    Operation o = default_operation(kind);
    o.speed = 1.0;
    o.to_depth = to_depth;
    o.remove = remove;
    return o;
  };
  const auto gives_up = [&](const std::vector<Operation>& operations)
  {
    Scene with = scene;
    with.operations = operations;
    Simulator rig(with);
    ScenePlayer player(with);
    for (int k = 0; k < 100000 && player.operations().status().trouble == OperationTrouble::none; ++k)
    {
      if (play_frame(rig, &player, slips_frame) == FrameStatus::failed) break;
      EXPECT_LT(rig.truth().wob, 20e3);
    }
    EXPECT_STREQ(rig.failure(), "");
    EXPECT_TRUE(rig.asked().winch.brake);
    return std::string(text_of(player.operations().status().trouble));
  };
  const double none = Operation::unset;
  EXPECT_EQ(gives_up({operation(OperationKind::connection, none, none)}),
            "the bit reaches bottom before the block is low enough to add a stand, needed: drill deeper first");
  EXPECT_EQ(gives_up({operation(OperationKind::trip, 206.0, none)}),
            "to_depth is below the bottom of the hole, allowed: down to the bottom");
  EXPECT_EQ(gives_up({operation(OperationKind::trip, 2.0, none)}),
            "the block is at its highest position, and there is no stand to remove");
  scene.operations = {operation(OperationKind::trip, 206.0, none)};
  ASSERT_EQ(scene_problems(scene).size(), 1u);
  EXPECT_EQ(scene_problems(scene).front().text, "206 m is below the hole's bottom, allowed: down to 205.05 m");
}

// Saved in the midst of the crew's work: it goes on as it did.
TEST(Crew, isInSnapshots)
{
  Simulator rig(soft_rock(Level::hybrid));
  turn_and_feed(rig, 0.05);
  for (const CrewTask in : {CrewTask::slacking, CrewTask::connecting, CrewTask::lowering})
  {
    play_until(rig, slips_frame, 1e3, [in](const Truth& m) { return m.crew == in; });
    const auto saved = rig.save();
    play_on(rig, 20.0);
    const std::vector<double> end = numbers_of(rig.truth());
    rig.restore(*saved);
    play_on(rig, 20.0);
    EXPECT_TRUE(bit_identical(numbers_of(rig.truth()), end)) << text_of(in);
    rig.restore(*saved);
  }
}
}  // namespace test_sim_crew
