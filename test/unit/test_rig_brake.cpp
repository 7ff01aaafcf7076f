// SPDX-License-Identifier: BSD-3-Clause
// Friction of the top drive's gearbox and brake: by hand, solved and given outright alike, coasting, holding.
#include "top_drive_fixtures.h"

namespace drill_rig_sim::test_rig_brake
{
// c_g = sqrt(1e7 * 2500) = 158114 N m s/rad, c_g/k_g = 15.8 ms.
TEST(Brake, FrictionByHand)
{
  const TopDriveSpec spec;
  // sticks: 1e7 * (2e-5 + 1e-5) + 158114 * 1e-3
  DriveTorque d = drive_torque(spec, torque_command(0.0), running(0.0, 0.0, 0.0, 2e-5), 0.01, 1e-5, 1e-3, 0.0);
  EXPECT_NEAR(d.friction, -458.114, 1e-3);
  EXPECT_NEAR(d.state.gear_twist, 3e-5, 1e-15);
  EXPECT_NEAR(d.by_turn, -1e7, 1e-6);
  EXPECT_NEAR(d.by_speed, -158113.883, 1e-3);
  // turns: 1 kN m against it; the bristle goes 0.01/(0.01 + 0.0158114) of its way to 1e-4 rad
  d = drive_torque(spec, torque_command(0.0), running(5.0, 0.0, 0.0, 2e-5), 0.01, 0.05, 5.0, 0.0);
  EXPECT_DOUBLE_EQ(d.friction, -1000.0);
  EXPECT_NEAR(d.state.gear_twist, 2e-5 + 8e-5 * 0.01 / 0.025811388, 1e-12);
  EXPECT_EQ(d.by_turn, 0.0);
  EXPECT_EQ(d.by_speed, 0.0);
  EXPECT_DOUBLE_EQ(drive_torque(spec, torque_command(0.0), running(-5.0, 0.0, 0.0, 2e-5), 0.01, -0.05, -5.0, 0.0).friction,
                   1000.0);
}

TEST(Brake, FrictionOfTheSolvedRotorIsTheSame)
{
  const TopDriveSpec spec;
  const RotorStage stage{0.005, 300.0, 90000.0, 0.4, 300.0 * 0.4 - 900.0}, still{0.005, 300.0, 90000.0, 0.0, 0.0};
  struct Case
  {
    const char* name;
    TopDriveSetpoint command;
    DriveState start;
    RotorStage stage;
    double top;
    bool sticks;
  };
  const Case cases[] = {
      {"turns", speed_command(5.5), running(5.5, 0.3, 0.006, 1e-4), stage, 0.0275, false},
      {"at its limit", speed_command(20.0), running(5.5, 0.3, 0.006, 1e-4), stage, 0.0275, false},
      {"backwards",
       speed_command(-5.5),
       running(-5.5, -0.3, -0.006, -1e-4),
       {0.005, 300.0, 90000.0, -0.4, 900.0 - 120.0},
       -0.0275,
       false},
      {"gearbox holds", torque_command(300.0), running(0.0, 0.0, 0.0, 1e-5), still, 0.0, true},
      {"gearbox gives way", torque_command(3e3), running(0.0, 0.0, 0.0, -1e-4), {0.005, 300.0, 90000.0, 0.1, 30.0}, 0.0, false},
      {"brake holds", brake_command(), running(0.0, 0.0, 0.03, -3e-3, true), still, 0.0, true},
      {"brake by itself", speed_command(0.0), running(0.0, 6.0, 0.03, 0.0), still, 0.0, true},
      {"brake slips", brake_command(), running(5.5, 0.0, 0.0, 0.0), stage, 0.0275, false}};
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const RotorResult solved = check(spec, c.command, c.start, c.stage, c.top);
    const DriveTorque drive =
        drive_torque(spec, c.command, c.start, c.stage.time, solved.increment, solved.state.speed, solved.state.meter_twist);
    EXPECT_NEAR(drive.motor, solved.motor_torque, 1e-6);
    EXPECT_NEAR(drive.friction, solved.friction, 1e-5);
    EXPECT_NEAR(drive.state.gear_twist, solved.state.gear_twist, 1e-12);
    EXPECT_NEAR(drive.state.integral, solved.state.integral, 1e-9);
    const double most = spec.gearbox_friction + (brake_is_on(spec, c.command, c.start) ? spec.brake_torque : 0.0);
    EXPECT_EQ(std::abs(solved.friction) < most * (1.0 - 1e-9), c.sticks);
  }
}

// J w = 1000 N m t: 220 rpm last 57.6 s on the gearbox alone; the brake's 51 kN m stop them in 1.13 s.
TEST(Brake, CoastsAgainstItsGearboxAndStopsByItsBrake)
{
  const TopDriveSpec spec;
  for (const bool brake : {false, true})
  {
    FreeRotor rotor(spec);
    rotor.state().speed = spec.max_speed;
    const double h = 1e-3;
    double stopped = 0.0;
    while (rotor.state().speed > 0.01 && stopped < 100.0)
    {
      rotor.step(brake ? brake_command() : torque_command(0.0), h);
      stopped += h;
    }
    EXPECT_NEAR(stopped, spec.inertia * spec.max_speed / (brake ? 51e3 : 1e3), brake ? 0.02 : 0.1);
  }
}

// 30 kN m of a wound string: the loop stops the rotor, the brake takes over, and five minutes later it stands where it stood.
TEST(Brake, TheBrakeHoldsAWoundStringWithoutCreep)
{
  const TopDriveSpec spec;
  DriveState state = running(0.0, 6.0, 0.03);
  double turned = 0.0;
  for (int i = 0; i < 30000; ++i)
  {
    EXPECT_TRUE(brake_is_on(spec, speed_command(0.0), state));
    const RotorResult r = solve_rotor(spec, speed_command(0.0), state, euler(0.01, state.speed),
                                      -turned);  // the string's top goes back as it turns: a soft string
    turned += r.increment;
    state = r.state;
    state.meter_twist = 0.03;
  }
  EXPECT_NEAR(turned, 0.0, 1e-9) << "it takes the torque over as it is";
  EXPECT_NEAR(state.integral * spec.integral_gain, 30e3, 10.0) << "the motor takes over with that torque";
  EXPECT_FALSE(brake_is_on(spec, speed_command(1.0), state));
  EXPECT_FALSE(brake_is_on(spec, torque_command(0.0), state));
  EXPECT_FALSE(brake_is_on(spec, speed_command(0.0), running(0.011)));
}

}  // namespace drill_rig_sim::test_rig_brake
