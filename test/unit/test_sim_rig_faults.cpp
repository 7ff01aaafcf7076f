// SPDX-License-Identifier: BSD-3-Clause
// Faults of winch, top drive, pump and motor: each shows as its law says, and is gone when it has ended.
#include <gtest/gtest.h>

#include "drill_rig_sim/math/units.h"
#include "faulty_pair.h"

namespace test_sim_rig_faults
{
using namespace drill_rig_sim;

TEST(Fault, aBrakeThatSlipsLetsTheBlockSink)
{
  Scene scene = without_damping(hanging());
  scene.rig.mud_pump.pressure_coefficient = 0.0;  // no surge
  Simulator rig(scene);
  play(rig, 1.0);
  const double weight = rig.truth().hook_load;
  EXPECT_FALSE(rig.inject(at(FaultKind::brake_slip, 0.0, 1.05 * weight)));
  play(rig, 2.0);
  EXPECT_NEAR(rig.truth().block_velocity, 0.0, 1e-3) << "it holds what hangs";
  const double holds = 0.9 * weight;
  EXPECT_FALSE(rig.inject(at(FaultKind::brake_slip, 0.0, holds)));
  double sum = 0.0, from = 0.0;
  play(rig, 0.5);
  from = rig.truth().block_velocity;
  play(rig, 2.0, [&](const Truth& truth) { sum += truth.hook_load / 200.0; });
  EXPECT_TRUE(rig.truth().brake_set);
  EXPECT_NEAR(sum, holds, 0.01 * holds);
  const double mass = scene.rig.hoisting.block_mass + scene.string[0].bit->mass + 160.0 * tool_jointed_mass;
  EXPECT_NEAR(rig.truth().block_velocity - from, -2.0 * (weight - holds) / mass, 0.1 * 2.0 * (weight - holds) / mass);
  rig.clear(FaultKind::brake_slip, Gauge::hook_load);
  play(rig, 8.0);
  const double height = rig.truth().block_height;
  play(rig, 5.0);
  EXPECT_NEAR(rig.truth().block_height, height, 0.02) << "it holds again, but for what bounces";
}

TEST(Fault, aBrakeThatSlipsIsNoMatterWhereItIsOff)
{
  Pair rigs(hanging());
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::brake_slip, 0.0, 1000.0)));
  rigs.command(WinchSetpoint{0.0, false});
  rigs.play_both(2.0);
  EXPECT_EQ(rigs.sound.truth().hook_load, rigs.faulty.truth().hook_load);
}

TEST(Fault, aTrippedDriveCoastsAndComesBack)
{
  Simulator rig(hanging());
  rig.command(turning(60.0 * rpm));
  play(rig, 10.0);
  EXPECT_NEAR(rig.truth().top_drive_speed, 60.0 * rpm, 0.1);
  EXPECT_FALSE(rig.inject(at(FaultKind::drive_trip, 0.0)));
  play(rig, 0.5);
  EXPECT_LT(rig.truth().top_drive_speed, 60.0 * rpm);
  EXPECT_TRUE(rig.truth().drive_tripped);
  EXPECT_TRUE(rig.readings().drive_tripped) << "a rig knows it";
  EXPECT_EQ(TopDriveMode::torque, rig.truth().setpoints.top_drive.mode);
  play(rig, 30.0);
  EXPECT_NEAR(rig.truth().top_drive_speed, 0.0, 0.05);
  rig.clear(FaultKind::drive_trip, Gauge::hook_load);
  play(rig, 10.0);
  EXPECT_NEAR(rig.truth().top_drive_speed, 60.0 * rpm, 0.1) << "what was asked for is in force again";
  EXPECT_FALSE(rig.truth().drive_tripped);
}

TEST(Fault, aTrippedDriveIsSlowedByItsGearbox)
{
  Scene scene = without_damping(hanging());
  scene.rig.top_drive.inertia = 1e5;
  scene.rig.top_drive.gearbox_friction = 2000.0;
  Simulator rig(scene);
  rig.command(turning(60.0 * rpm));
  play(rig, 60.0);
  EXPECT_FALSE(rig.inject(at(FaultKind::drive_trip, 0.0)));
  const double from = rig.truth().top_drive_speed;
  play(rig, 20.0);
  EXPECT_NEAR(from - rig.truth().top_drive_speed, 20.0 * 2000.0 / 1e5, 0.02);
}

TEST(Fault, aTrippedPumpStops)
{
  Scene scene = hanging();
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.03});
  play(rig, 20.0);
  const double pressure = rig.truth().stand_pipe_pressure;
  EXPECT_FALSE(rig.inject(at(FaultKind::pump_trip, 0.0)));
  play(rig, 1.0);
  EXPECT_NEAR(rig.truth().flow, 0.03 - scene.rig.mud_pump.flow_ramp, 1e-9) << "at its ramp";
  play(rig, 30.0);
  EXPECT_EQ(0.0, rig.truth().flow);
  EXPECT_LT(rig.truth().stand_pipe_pressure, 0.2 * pressure);
  EXPECT_TRUE(rig.truth().pump_tripped);
  rig.clear(FaultKind::pump_trip, Gauge::hook_load);
  play(rig, 30.0);
  EXPECT_NEAR(rig.truth().flow, 0.03, 1e-12);
  EXPECT_FALSE(rig.truth().pump_tripped);
}

TEST(Fault, aStalledMotorStands)
{
  const Scene scene = motor_drilling_scene(5.0);
  Pair rigs(scene);
  rigs.command(PumpSetpoint{0.03});
  rigs.play_both(20.0);
  const double turns = 2.0 * pi * rigs.sound.truth().bit_flow / scene.string[1].motor->displacement_per_rev;
  EXPECT_NEAR(rigs.sound.truth().bit_speed, turns, 0.1 * turns);
  EXPECT_FALSE(rigs.faulty.inject(at(FaultKind::motor_stall, 0.0)));
  rigs.play_both(20.0);
  EXPECT_NEAR(rigs.faulty.truth().bit_speed, 0.0, 0.01);
  EXPECT_TRUE(rigs.faulty.truth().motor_stalled);
  const double stall = 2.0 * pi * scene.string[1].motor->stall_torque / scene.string[1].motor->displacement_per_rev;
  EXPECT_NEAR(rigs.difference(&RigSignals::stand_pipe_pressure), stall, 0.05 * stall);
  rigs.faulty.clear(FaultKind::motor_stall, Gauge::hook_load);
  rigs.play_both(20.0);
  EXPECT_NEAR(rigs.faulty.truth().bit_speed, turns, 0.1 * turns);
}
}  // namespace test_sim_rig_faults
