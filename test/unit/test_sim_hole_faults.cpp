// SPDX-License-Identifier: BSD-3-Clause
// Faults of the hole and of the pipe in it: each shows as its law says, and is gone when it has ended.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_ahead.h"
#include "drill_rig_sim/contact/filter_cake.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/wall_faults.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "faulty_pair.h"

namespace test_sim_hole_faults
{
using namespace drill_rig_sim;

TEST(Fault, aPackOffDragsBothWays)
{
  Scene scene = hanging();
  scene.rig.hoisting.rail_friction = 0.0;
  const double force = 50e3;
  for (const double way : {1.0, -1.0})
  {
    Pair rigs(scene);
    EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::pack_off, 100.0, force)));
    rigs.command(WinchSetpoint{0.05 * way, false});
    rigs.play_both(20.0);
    EXPECT_NEAR(way * rigs.difference(&RigSignals::hook_load), force, 0.02 * force);
    rigs.faulty.clear(FaultKind::pack_off, Gauge::hook_load);
    rigs.play_both(20.0);
    EXPECT_NEAR(rigs.difference(&RigSignals::hook_load), 0.0, 0.02 * force) << "over";
  }
}

TEST(Fault, aPackOffBrakesTurningPipe)
{
  Pair rigs(hanging());
  const double force = 30e3;
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::pack_off, 100.0, force)));
  rigs.command(turning(60.0 * rpm));
  rigs.play_both(20.0);
  const double radius = rigs.faulty.scene().string.back().pipe->tool_joint_diameter / 2.0;
  EXPECT_NEAR(rigs.difference(&RigSignals::torque), force * radius, 0.05 * force * radius);
}

TEST(Fault, aPackOffHoldsMudBack)
{
  Pair rigs(hanging());
  const double force = 30e3;
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::pack_off, 100.0, force)));
  rigs.command(PumpSetpoint{0.03});
  rigs.play_both(60.0);
  const double gap = 0.2159 - 0.127;
  const double plug = 4.0 * force / (pi * 0.127 * gap);
  EXPECT_NEAR(pack_off_pressure(force, 0.2159, 0.127), plug, 1e-9 * plug);
  // the node at 100 m is a tool joint's, its share of the pipe a little thicker
  EXPECT_NEAR(rigs.difference(&RigSignals::stand_pipe_pressure), plug, 0.25 * plug);
  // it pushes the pipe up by its section, and what it drags with it drags on pipe that goes up
  const double piston = rigs.difference(&RigSignals::stand_pipe_pressure) * pi / 4.0 * 0.127 * 0.127;
  rigs.command(WinchSetpoint{0.02, false});
  rigs.play_both(20.0);
  EXPECT_NEAR(rigs.difference(&RigSignals::hook_load), force - piston, 0.03 * piston);
  rigs.command(WinchSetpoint{0.0, true});
  EXPECT_GT(rigs.difference(&RigSignals::ecd), 0.9 * plug / (standard_gravity * 140.0))
      << "it shows in the density that the bit feels";
  rigs.faulty.clear(FaultKind::pack_off, Gauge::hook_load);
  rigs.play_both(60.0);
  EXPECT_NEAR(rigs.difference(&RigSignals::stand_pipe_pressure), 0.0, 0.01 * plug);
}

TEST(Fault, pipeThatRestsSticksByItsCake)
{
  Scene scene = vertical_scene(150.0, 140.0, 0.3);
  scene.rig.hoisting.rail_friction = 0.0;
  const double amount = 4e7;  // 4 MPa along 10 m
  Pair rigs(scene);
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::differential_sticking, 100.0, amount)));
  rigs.command(WinchSetpoint{0.05, false});
  rigs.play_both(4.0);
  EXPECT_NEAR(rigs.difference(&RigSignals::hook_load), 0.0, 500.0) << "it moves on";
  rigs.command(WinchSetpoint{0.0, true});
  rigs.play_both(120.0);
  const double rested = rigs.faulty.save()->mechanics.faults.sticking.rest;
  EXPECT_GT(rested, 110.0);
  EXPECT_LT(rested, 120.0) << "it has bounced at first";
  rigs.command(WinchSetpoint{0.005, false});
  double most = 0.0, begins = rigs.faulty.truth().time, broken = 0.0, free = 0.0;
  bool holds = true;
  play(rigs.sound, 60.0, [&](const Truth& truth) { free += truth.hook_load / 6000.0; });
  play(rigs.faulty, 60.0,
       [&](const Truth& truth)
       {
         holds = holds && truth.hook_load > most - 5e3;  // later it bounces
         if (!holds || truth.hook_load <= most) return;
         most = truth.hook_load;
         broken = truth.time;
       });
  const double rest = rested + broken - begins, radius = 0.168 / 2.0;
  const double held = 0.3 * amount * sealed_width(radius, 0.2159 / 2.0 - radius) * sealed_share(rest);
  EXPECT_NEAR(most - free, held, 0.01 * held);
  EXPECT_GT(held, 50e3);
  double after = 0.0;
  play(rigs.faulty, 5.0, [&](const Truth& truth) { after += truth.hook_load / 500.0; });
  EXPECT_NEAR(after, free, 0.03 * held) << "broken loose";
}

TEST(Fault, frictionOfTheWallChangesFromADepthDown)
{
  const auto survey = build_and_hold(30.0, 5.0 * degree / 30.0, 20.0 * degree, 1.0, 200.0);
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    const auto load = [&](double friction, double below, double factor, double from)
    {
      Scene scene = scene_in(survey, 200.0, 190.0, friction);
      scene.well.sections = {{120.0, 0.2159, friction}, {200.0, 0.2159, below}};
      scene.numerics.level = level;
      Simulator rig(scene);
      if (factor != 1.0)
      {
        EXPECT_FALSE(rig.inject(at(FaultKind::friction_change, from, factor)));
      }
      rig.command(WinchSetpoint{0.1, false});
      play(rig, 8.0);
      double sum = 0.0;
      play(rig, 2.0, [&](const Truth& truth) { sum += truth.hook_load / 200.0; });
      return sum;
    };
    const double as_it_is = load(0.2, 0.2, 1.0, 0.0), all = load(0.4, 0.4, 1.0, 0.0), below = load(0.2, 0.4, 1.0, 0.0);
    EXPECT_GT(all - as_it_is, 1500.0);
    EXPECT_EQ(load(0.2, 0.2, 2.0, 0.0), all) << static_cast<int>(level);
    EXPECT_NEAR(load(0.2, 0.2, 2.0, 120.0), below, 0.01 * (all - as_it_is)) << static_cast<int>(level);
  }
}

TEST(Fault, frictionComesBack)
{
  Pair rigs(slanted_scene(150.0, 0.2));
  rigs.command(WinchSetpoint{0.1, false});
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::friction_change, 0.0, 3.0)));
  rigs.play_both(10.0);
  EXPECT_GT(rigs.difference(&RigSignals::hook_load), 2000.0);
  rigs.faulty.clear(FaultKind::friction_change, Gauge::hook_load);
  rigs.play_both(10.0);
  EXPECT_NEAR(rigs.difference(&RigSignals::hook_load), 0.0, 100.0);
}

TEST(Fault, harderRockTakesMoreWeight)
{
  Pair rigs(drilling_scene(0.01, 0.0));
  for (Simulator* rig : {&rigs.sound, &rigs.faulty}) drill_ahead(*rig, 120.0 * rpm, 0.02, 0.004);
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::formation_change, 0.0, 0.5)));
  rigs.play_both(60.0);
  double weight[2] = {};
  int k = 0;
  for (Simulator* rig : {&rigs.sound, &rigs.faulty})
  {
    play(*rig, 5.0, [&](const Truth& truth) { weight[k] += truth.wob / 500.0; });
    ++k;
  }
  EXPECT_GT(weight[0], 1000.0);
  EXPECT_NEAR(weight[1], 2.0 * weight[0], 0.04 * weight[1]);
}

TEST(WashOut, isACosine)
{
  FaultState faults;
  faults.washed_out_by = 0.2;
  faults.washed_out_at = 100.0;
  EXPECT_DOUBLE_EQ(0.1, wash_out(faults, 100.0).radius);
  EXPECT_NEAR(0.05, wash_out(faults, 100.0 + 0.5 * wash_out_length).radius, 1e-12);
  EXPECT_EQ(0.0, wash_out(faults, 100.0 - wash_out_length).radius);
  for (const double md : {96.0, 99.0, 100.0, 103.0})
    EXPECT_NEAR((wash_out(faults, md + 1e-5).radius - wash_out(faults, md - 1e-5).radius) / 2e-5, wash_out(faults, md).slope,
                1e-8)
        << md;
}

TEST(Fault, pipeLiesClearInAWashOut)
{
  Scene scene = slanted_scene(150.0, 0.2);
  Simulator rig(scene);
  rig.command(turning(30.0 * rpm));
  const auto carried = [&](double& in_it)
  {
    StringProfile profile;
    double all = 0.0;
    in_it = 0.0;
    for (int k = 0; k < 500; ++k)
    {
      rig.frame(frame);
      rig.profile(profile);
      for (std::size_t i = 0; i < profile.md.size(); ++i)
      {
        if (profile.md[i] < 40.0 || profile.md[i] > 110.0) continue;
        all += profile.contact_force[i] / 500.0;
        if (std::abs(profile.md[i] - 75.0) < 2.5) in_it += profile.contact_force[i] / 500.0;
      }
    }
    return all;
  };
  play(rig, 10.0);
  double before = 0.0, within = 0.0, after = 0.0;
  const double sound = carried(before);
  EXPECT_FALSE(rig.inject(at(FaultKind::washed_out_hole, 75.0, 0.3)));
  play(rig, 10.0);
  const double washed = carried(within);
  EXPECT_GT(before, 50.0);
  EXPECT_LT(within, 0.02 * before);
  EXPECT_NEAR(washed, sound, 0.1 * sound);
  rig.clear(FaultKind::washed_out_hole, Gauge::hook_load);
  play(rig, 10.0);
  carried(after);
  EXPECT_NEAR(after, before, 0.2 * before);
}

TEST(Fault, aHoleInThePipeTakesPressureAway)
{
  Pair rigs(hanging());
  rigs.command(PumpSetpoint{0.03});
  const double area = 1e-4;
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::washed_out_pipe, 70.0, area)));
  rigs.play_both(60.0);
  const Truth &sound = rigs.sound.truth(), &leaks = rigs.faulty.truth();
  EXPECT_NEAR(sound.bit_flow, 0.03, 1e-6);
  EXPECT_EQ(sound.flow, leaks.flow) << "the pump gives as much";
  EXPECT_LT(leaks.stand_pipe_pressure, 0.95 * sound.stand_pipe_pressure);
  // what passes the bit makes nearly all the pressure, by its square; the leak sees less than that by the bore's friction above
  // it
  const double through = leaks.bit_flow / sound.bit_flow;
  EXPECT_NEAR(leaks.stand_pipe_pressure, through * through * sound.stand_pipe_pressure, 0.05 * sound.stand_pipe_pressure);
  const double leak = leaks.flow - leaks.bit_flow;
  const double most = pi / (pi + 2.0) * area * std::sqrt(2.0 * leaks.stand_pipe_pressure / rigs.sound.scene().mud.density);
  EXPECT_LT(leak, most);
  EXPECT_GT(leak, 0.8 * most);
  rigs.faulty.clear(FaultKind::washed_out_pipe, Gauge::hook_load);
  rigs.play_both(60.0);
  EXPECT_NEAR(rigs.faulty.truth().stand_pipe_pressure, sound.stand_pipe_pressure, 1e-3 * sound.stand_pipe_pressure);
}
}  // namespace test_sim_hole_faults
