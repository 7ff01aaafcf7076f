// SPDX-License-Identifier: BSD-3-Clause
// What the run of a program is sure to refuse is found beforehand, in the run's own words; what it may take is left to it.
#include <gtest/gtest.h>

#include <string>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/crew/rehearsal.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "in_source.h"

namespace drill_rig_sim::test_sim_rehearsal
{
namespace
{
constexpr double kFrame = 0.01;  // [s]

Scene quick(const std::string& program)
{
  return read_scene(in_source("config/scenes/quick.yaml"), {"program=" + program});
}

std::string refused(const Scene& scene)
{
  const std::optional<Problem> problem = refused_line(scene);
  return problem ? problem->key + ": " + problem->text : "";
}

/// Why the run of the program itself fails within `duration` [s].
std::string failure(const Scene& scene, double duration)
{
  Simulator simulator(scene);
  ProgramPlayer program(scene.program);
  while (simulator.truth().time < duration && *simulator.failure() == 0)
  {
    program.apply(simulator);
    simulator.attend(kFrame);
    simulator.frame(kFrame);
  }
  return simulator.failure();
}

struct Case
{
  const char* program;
  const char* words;
};

TEST(Rehearsal, findsWhatTheRunRefuses)
{
  const Case cases[] = {
      {"[{at: 0.1, stuck_at: 5000}]", "stuck_at is below the bit, allowed: where there is pipe in the hole"},
      {"[{at: 0, stuck_at: 99.9}]", "stuck_at is below the bit, allowed: where there is pipe in the hole"},
      {"[{at: 0.1, fault: stuck_pipe, fault_depth: 5000}]",
       "fault_depth is below the bit, allowed: where there is pipe in the hole"},
      {"[{at: 0.1, fault: pack_off, fault_depth: 1500, fault_magnitude: 1e4}]",
       "fault_depth is below the bit, allowed: where there is pipe in the hole"},
      {"[{at: 0.1, fault: friction_change, fault_depth: 3000, fault_magnitude: 2}]",
       "depth: allowed is 0 (all of the hole) to the hole's bottom"},
      {"[{at: 0.1, fault: motor_stall}]", "fault: there is no mud motor in the string"},
      {"[{at: 0.1, slips: false}]", "slips: the slips are not set"},
      {"[{at: 0.1, slips: true}, {at: 0.2, slips: true}]", "slips: the slips are already set"},
      {"[{at: 0, block_velocity: 0.2}, {at: 1, block_velocity: 0, slips: true}]", "slips: the block moves, allowed: at rest"},
      {"[{at: 0.1, top_drive_speed_rpm: 60, slips: true}]", "slips: the top drive turns, allowed: at rest"},
      {"[{at: 0.1, connection: 3}]", "connection: the slips are not set"},
      {"[{at: 0, flow: 0.02}, {at: 0.1, slips: true}, {at: 0.2, connection: 3}]", "connection: the pump runs, allowed: off"},
      {"[{at: 0.1, slips: true}, {at: 0.2, block_velocity: -0.01, connection: 3}]",
       "connection: the block moves, allowed: at rest"},
      {"[{at: 0.1, slips: true}, {at: 0.2, top_drive_speed_rpm: 60}]",
       "the string is in the slips: the top drive is locked, allowed: at rest"}};
  for (const Case& c : cases)
  {
    const Scene scene = quick(c.program);
    const std::string found = refused(scene);
    EXPECT_NE(found.find(c.words), std::string::npos) << c.program << ": " << found;
    EXPECT_EQ(found.rfind("program[", 0), 0u) << found;
    EXPECT_NE(failure(scene, 1.5).find(c.words), std::string::npos) << c.program << ": " << failure(scene, 1.5);
  }
}

TEST(Rehearsal, knowsHowLongAConnectionTakes)
{
  const std::string connected =
      "{at: 0.1, slips: true}, {at: 1, block_velocity: -0.02}, {at: 2, brake: true}, {at: 5, connection: 3}";
  EXPECT_NE(refused(quick("[" + connected + ", {at: 20, block_velocity: 0.1}]"))
                .find("the connection is broken out: the crew moves the block"),
            std::string::npos);
  EXPECT_NE(refused(quick("[" + connected + ", {at: 20, flow: 0.01}]")).find("the connection is broken out: the pump is locked"),
            std::string::npos);
  EXPECT_NE(refused(quick("[" + connected + ", {at: 20, slips: false}]")).find("it must be made up first"), std::string::npos);
  EXPECT_NE(refused(quick("[" + connected + ", {at: 20, connection: 3}]")).find("a connection is already under way"),
            std::string::npos);
  EXPECT_EQ(refused(quick("[" + connected + ", {at: 300, block_velocity: 0.1}, {at: 302, slips: false}]")), "");
}

// What goes by a bit that has moved, or by other hands than the program's, is refused where no way leads there.
TEST(Rehearsal, goesByTheDeepestThatTheBitCanBe)
{
  const Scene start = quick("[]");
  const double bit = start.start.bit_depth;
  const auto stuck = [](double md) { return "stuck_at: " + std::to_string(md) + "}]"; };
  EXPECT_EQ(refused(quick("[{at: 0, block_velocity: -0.2}, {at: 60, brake: true, " + stuck(bit + 10.0))), "");
  EXPECT_NE(refused(quick("[{at: 0, block_velocity: -0.2}, {at: 60, brake: true, " + stuck(bit + 30.0))), "");
  EXPECT_NE(refused(quick("[{at: 0, block_velocity: 0.2}, {at: 60, brake: true, " + stuck(bit))), "") << "pulled up";
  EXPECT_EQ(refused(quick("[{at: 0, stuck_at: 50}, {at: 1, block_velocity: 0.02}, {at: 200, brake: true, fault: pack_off, "
                          "fault_magnitude: 1e4, fault_depth: " +
                          std::to_string(bit) + "}]")),
            "")
      << "a stuck bit may stay behind";
  Scene drilled = quick("[{at: 1000, " + stuck(bit + 100.0));
  EXPECT_NE(refused(drilled), "");
  drilled.operations.emplace_back();
  EXPECT_EQ(refused(drilled), "") << "an operation may have drilled there";
  drilled.program[0].at = 1.0;
  EXPECT_NE(refused(drilled), "") << "but not that fast";
  EXPECT_FALSE(refused_line(quick("[{at: 100, connection: 3}]"), 50.0)) << "a run that ends before";
}
}  // namespace
}  // namespace drill_rig_sim::test_sim_rehearsal
