// SPDX-License-Identifier: BSD-3-Clause
// Top drive: condensation of the rotor, speed loop against its analytic step response, saturation, modes.
#include <complex>

#include "top_drive_fixtures.h"

namespace drill_rig_sim::test_rig_top_drive
{
namespace
{
TEST(TopDrive, EveryBranchObeysTheEquationOfMotion)
{
  const TopDriveSpec spec = smooth();
  const RotorStage stage{0.005, 300.0, 90000.0, 0.4, 300.0 * 0.4 - 900.0};
  const DriveState start = running(5.5, 0.3, 0.006);
  EXPECT_FALSE(check(spec, speed_command(5.5), start, stage, 0.0275).state.limited);
  EXPECT_TRUE(check(spec, speed_command(20.0), start, stage, 0.0275).state.limited);
  EXPECT_TRUE(check(spec, speed_command(-20.0), start, stage, 0.0275).state.limited);
  EXPECT_FALSE(check(spec, torque_command(8e3), start, stage, 0.0275).state.limited);
  EXPECT_TRUE(check(spec, torque_command(9e4), start, stage, 0.0275).state.limited);

  // near the speed limit
  const RotorStage fast{0.005, 200.0, 40000.0, 0.0, -200.0 * spec.max_speed};
  const DriveState at_limit = running(spec.max_speed);
  EXPECT_TRUE(check(spec, torque_command(3e4), at_limit, fast, 0.005 * spec.max_speed).state.limited);
  EXPECT_NEAR(check(spec, torque_command(3e4), at_limit, fast, 0.005 * spec.max_speed).state.speed, spec.max_speed, 1e-9);
}

// Where another integrator has the rotor the same laws hold: at the solution both give the same.
TEST(TopDrive, TheMotorOnItsOwnAgreesWithTheSolvedRotor)
{
  const RotorStage stage{0.005, 300.0, 90000.0, 0.4, 300.0 * 0.4 - 900.0};
  const DriveState start = running(5.5, 0.3, 0.006);
  TopDriveSpec spec = smooth(), weak = smooth();
  weak.max_power = 40e3;
  TopDriveSpec slow = smooth();
  slow.max_speed = 2.0;  // the rotor runs at some 3 rad/s
  TopDriveSetpoint held_back = speed_command(20.0);
  held_back.torque_limit = 6e3;
  struct Case
  {
    const char* name;
    TopDriveSpec spec = smooth();
    TopDriveSetpoint command;
    bool limited;
  };
  const Case cases[] = {{"speed", spec, speed_command(5.5), false},
                        {"torque limit", spec, speed_command(20.0), true},
                        {"torque limit, backwards", spec, speed_command(-20.0), true},
                        {"torque limit of the command", spec, held_back, true},
                        {"power limit", weak, speed_command(20.0), true},
                        {"torque", spec, torque_command(8e3), false},
                        {"torque beyond the limit", spec, torque_command(9e4), true},
                        {"torque beyond the power limit", weak, torque_command(9e3), true},
                        {"torque at the speed limit", slow, torque_command(8e3), true},
                        {"torque against the speed", slow, torque_command(-3e4), false}};
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const RotorResult solved = solve_rotor(c.spec, c.command, start, stage, 0.0275);
    const DriveTorque motor =
        drive_torque(c.spec, c.command, start, stage.time, solved.increment, solved.state.speed, solved.state.meter_twist);
    EXPECT_NEAR(motor.motor, solved.motor_torque, 1e-6);
    EXPECT_NEAR(motor.state.integral, solved.state.integral, 1e-9);
    EXPECT_EQ(motor.state.limited, c.limited);
    EXPECT_EQ(solved.state.limited, c.limited);
    const double slope = motor.by_turn + motor.by_speed * stage.dv_du, spring = c.spec.meter_stiffness;
    const double free = c.spec.inertia * stage.da_du + spring - slope;
    EXPECT_NEAR(solved.stiffness, spring * (1.0 - spring / free), 1e-9 * spring);
  }
}

// A set point that falls from 17 rad/s to 0 in 1 s: the loop goes through 0 by 3.5 rad/s2, so that the 0.02 rad/s about it are
// shorter than a step of 6 ms. Without the brake what the integral has gathered would turn the rotor back by 0.42 rad/s.
TEST(TopDrive, TheBrakeSetsAtTheFirstReversalHoweverLongTheStepsAre)
{
  for (const double h : {0.0005, 0.0025, 0.01, 0.013, 0.02, 0.05})
  {
    SCOPED_TRACE(h);
    FreeRotor rotor(smooth());
    rotor.state() = running(17.0);
    double least = rotor.state().speed;
    for (double t = 0.0; t < 5.0; t += h)
      least = std::min(least, rotor.step(speed_command(17.0 * std::max(0.0, 1.0 - t)), h).state.speed);
    EXPECT_GT(least, -0.05);
    EXPECT_TRUE(rotor.state().braked);
  }
}

// A step in which the loop reaches its limit: I stops where the law is at it, of 0.3 + 0.2 - 0.12 = 0.38 rad that it would come
// to: 8 kN m come from the error of 0.4 rad/s, the rest from I.
TEST(TopDrive, TheSolvedRotorStopsItsIntegralWithinAStep)
{
  const TopDriveSpec spec = smooth();
  for (const double way : {1.0, -1.0})
  {
    const RotorStage stage{0.2, 5.0, 25.0, 0.0, -way * 5.0 * 0.6};
    TopDriveSetpoint command = speed_command(way);
    command.torque_limit = 9.7e3;
    const double top = way * 0.12 - way * 9.7e3 / spec.meter_stiffness;  // the meter takes what the motor gives: the speed stays
    const RotorResult solved = solve_rotor(spec, command, running(way * 0.6, way * 0.3, 0.0), stage, top);
    EXPECT_NEAR(solved.increment, way * 0.12, 1e-9);
    EXPECT_TRUE(solved.state.limited);
    EXPECT_NEAR(solved.state.integral, way * 0.34, 1e-9);
  }
}

TEST(TopDrive, TorqueLimits)
{
  const TopDriveSpec spec = smooth();
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, speed_command(5.0), 0.0), 50e3);
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, speed_command(5.0), -20.0), 750e3 / 20.0);
  TopDriveSetpoint command = speed_command(5.0);
  command.torque_limit = 12e3;
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, command, 1.0), 12e3);
  command.torque_limit = 0.5;
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, command, 1.0), 0.5);
  command.torque_limit = 90e3;
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, command, 1.0), 50e3);
}

// tau = k_p (w* - w) + k_i (I + w* t - turn), by hand: 20e3 * 0.5 + 5e3 * (0.3 + 0.03 - 0.0275).
TEST(TopDrive, SpeedLoopByHand)
{
  const TopDriveSpec spec = smooth();
  const DriveTorque motor = drive_torque(spec, speed_command(6.0), running(5.0, 0.3, 0.0), 0.005, 0.0275, 5.5, 0.0);
  EXPECT_NEAR(motor.motor, 10000.0 + 1512.5, 1e-9);
  EXPECT_NEAR(motor.state.integral, 0.3025, 1e-12);
  EXPECT_DOUBLE_EQ(motor.by_speed, -20e3);
  EXPECT_DOUBLE_EQ(motor.by_turn, -5e3);
  EXPECT_FALSE(motor.state.limited);
  // backwards all changes its sign
  EXPECT_NEAR(drive_torque(spec, speed_command(-6.0), running(-5.0, -0.3, 0.0), 0.005, -0.0275, -5.5, 0.0).motor, -11512.5, 1e-9);
  // a speed beyond the rig's is its limit, either way
  const double most = spec.max_speed, near = most - 0.2;
  EXPECT_NEAR(drive_torque(spec, speed_command(most + 50.0), running(near, 0.0, 0.0), 0.0, 0.0, near, 0.0).motor, 4000.0, 1e-6);
  EXPECT_NEAR(drive_torque(spec, speed_command(-most - 50.0), running(-near, 0.0, 0.0), 0.0, 0.0, -near, 0.0).motor, -4000.0,
              1e-6);
}

// Saturated, the integral moves no deeper than to where the law is at its limit, and freely out of it; k_i |I| never exceeds the
// limit.
TEST(TopDrive, IntegralStopsWhereTheMotorDoes)
{
  const TopDriveSpec spec = smooth();
  TopDriveSetpoint command = speed_command(1.0);
  command.torque_limit = 10e3;
  // at rest: k_p w* = 20 kN m is beyond the limit already: I stays, 0.1 rad, though 0.02 rad of error came
  const DriveTorque held = drive_torque(spec, command, running(0.0, 0.1, 0.0), 0.02, 0.0, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(held.motor, 10e3);
  EXPECT_TRUE(held.state.limited);
  EXPECT_DOUBLE_EQ(held.state.integral, 0.1);
  // 8 kN m by the error of 0.4 rad/s: I may come to 0.4 rad, where the law is at its limit, of the 0.5 it would have
  EXPECT_NEAR(drive_torque(spec, command, running(0.6, 0.3, 0.0), 0.2, 0.0, 0.6, 0.0).state.integral, 0.4, 1e-12);
  // runs back while the motor is at its limit: out of the saturation, freely
  EXPECT_NEAR(drive_torque(spec, command, running(0.0, 1.5, 0.0), 0.0, 0.1, 0.0, 0.0).state.integral, 1.4, 1e-12);
  // above the wanted speed the loop brakes, I would grow by 2 rad: 10e3/5e3 is the most it holds
  EXPECT_NEAR(drive_torque(spec, command, running(1.4, 1.9, 0.0), 2.0, 0.0, 1.4, 0.0).state.integral, 2.0, 1e-12);
  // and all of it backwards
  TopDriveSetpoint back = speed_command(-1.0);
  back.torque_limit = 10e3;
  EXPECT_DOUBLE_EQ(drive_torque(spec, back, running(0.0, -0.1, 0.0), 0.02, 0.0, 0.0, 0.0).state.integral, -0.1);
  EXPECT_NEAR(drive_torque(spec, back, running(-0.6, -0.3, 0.0), 0.2, 0.0, -0.6, 0.0).state.integral, -0.4, 1e-12);
  EXPECT_NEAR(drive_torque(spec, back, running(0.0, -1.5, 0.0), 0.0, -0.1, 0.0, 0.0).state.integral, -1.4, 1e-12);
  EXPECT_NEAR(drive_torque(spec, back, running(-1.4, -1.9, 0.0), 2.0, 0.0, -1.4, 0.0).state.integral, -2.0, 1e-12);
  // torque mode: I follows the torque
  EXPECT_NEAR(drive_torque(spec, torque_command(8e3), running(1.0, 0.0, 0.0), 0.01, 0.01, 1.0, 0.0).state.integral, 8e3 / 5e3,
              1e-12);
  TopDriveSpec proportional = smooth();
  proportional.integral_gain = 0.0;
  EXPECT_EQ(drive_torque(proportional, command, running(0.9, 0.0, 0.0), 0.1, 0.0, 0.9, 0.0).state.integral, 0.0);
  EXPECT_EQ(drive_torque(proportional, speed_command(1.0), running(0.9, 1.0), 0.0, 0.0, 0.9, 0.0).motor, 20e3 * (1.0 - 0.9))
      << "what it held is forgotten";
}

// Torque mode is held off by k_p (w_max - w) where that is less, either way, and never pushes on beyond.
TEST(TopDrive, TorqueModeGivesWayAtTheSpeedLimit)
{
  const TopDriveSpec spec = smooth();
  for (const double way : {1.0, -1.0})
  {
    const double fast = way * (spec.max_speed - 0.1);
    const DriveTorque at_limit = drive_torque(spec, torque_command(way * 9e3), running(fast, 0.0, 0.0), 0.0, 0.0, fast, 0.0);
    EXPECT_NEAR(at_limit.motor, way * 2000.0, 1e-6);
    EXPECT_TRUE(at_limit.state.limited);
    const DriveTorque beyond =
        drive_torque(spec, torque_command(way * 9e3), running(fast, 0.0, 0.0), 0.0, 0.0, fast + way * 0.2, 0.0);
    EXPECT_NEAR(beyond.motor, -way * 2000.0, 1e-6);
    const DriveTorque braking = drive_torque(spec, torque_command(-way * 9e3), running(fast, 0.0, 0.0), 0.0, 0.0, fast, 0.0);
    EXPECT_NEAR(braking.motor, -way * 9e3, 1e-9);
    EXPECT_FALSE(braking.state.limited);
  }
}

// A power of 750 kW: 15 rad/s is where it takes over from 50 kN m.
TEST(TopDrive, PowerTakesOverFromTorqueAtTheirQuotient)
{
  TopDriveSpec spec = smooth();
  spec.max_speed = 40.0;
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, speed_command(5.0), 14.99), 50e3);
  EXPECT_DOUBLE_EQ(motor_torque_limit(spec, speed_command(5.0), 16.0), 750e3 / 16.0);
  TopDriveSetpoint command = torque_command(40e3);
  const RotorStage stage = euler(0.005, 22.0);
  const RotorResult r = solve_rotor(spec, command, running(22.0, 0.0, 0.0), stage, 0.11);
  EXPECT_NEAR(r.motor_torque, 750e3 / 22.0, 1e-6);
  EXPECT_TRUE(r.state.limited);
  command.torque_limit = 20e3;
  EXPECT_NEAR(solve_rotor(spec, command, running(22.0, 0.0, 0.0), stage, 0.11).motor_torque, 20e3, 1e-6)
      << "the command's own is less";
}

TEST(TopDrive, StepResponseOfTheSpeedLoop)
{
  // J w' = k_p (w* - w) + k_i int(w* - w): overdamped, w(0) = 0; w* = 0.4 rad/s stays below saturation (k_p w* = 8 kN m)
  TopDriveSpec spec = smooth();
  FreeRotor rotor(spec);
  const double target = 0.4;
  const double h = 1e-4;
  const double a = spec.proportional_gain / spec.inertia;
  const double b = spec.integral_gain / spec.inertia;
  const double root = std::sqrt(a * a / 4.0 - b);
  const double s1 = -a / 2.0 + root;
  const double s2 = -a / 2.0 - root;
  // error e: e(0) = w*, e'(0) = -a w*
  const double c1 = target * (-a - s2) / (s1 - s2);
  const double c2 = target - c1;
  double worst = 0.0;
  for (int i = 1; i <= 20000; ++i)
  {
    const RotorResult r = rotor.step(speed_command(target), h);
    EXPECT_FALSE(r.state.limited);
    const double error = c1 * std::exp(s1 * i * h) + c2 * std::exp(s2 * i * h);
    worst = std::max(worst, std::abs(target - error - rotor.state().speed));
  }
  // implicit Euler: error of order h a w* / 2e = 6e-5
  EXPECT_LT(worst, 1e-4);
}

TEST(TopDrive, IntegralActionHoldsTheSpeedUnderLoad)
{
  const TopDriveSpec spec = smooth();
  FreeRotor rotor(spec);
  RotorResult r;
  for (int i = 0; i < 20000; ++i)
  {
    r = rotor.step(speed_command(5.5), 0.005, 9e3);
  }
  EXPECT_NEAR(rotor.state().speed, 5.5, 1e-6);
  EXPECT_NEAR(r.motor_torque, 9e3, 1e-2);
  EXPECT_NEAR(rotor.state().meter_twist, 9e3 / spec.meter_stiffness, 1e-9);
}

TEST(TopDrive, NoWindUpInStall)
{
  // Stalled for a minute at a limit of 12 kN m by a load it cannot turn, then freed: the speed must not run away.
  const TopDriveSpec spec = smooth();
  TopDriveSetpoint command = speed_command(5.5);
  command.torque_limit = 12e3;
  DriveState state;
  for (int i = 0; i < 12000; ++i)
  {
    const RotorResult r = solve_rotor(spec, command, state, euler(0.005, state.speed), 0.0);
    EXPECT_LE(r.motor_torque, 12e3 * (1.0 + 1e-12));
    state = r.state;
  }
  EXPECT_NEAR(state.speed, 0.0, 1e-6);
  EXPECT_NEAR(spec.meter_stiffness * state.meter_twist, 12e3, 1.0);
  EXPECT_LE(spec.integral_gain * state.integral, 12e3);

  FreeRotor rotor(spec);
  rotor.state() = state;
  double highest = 0.0;
  for (int i = 0; i < 4000; ++i)
  {
    rotor.step(command, 0.005);
    highest = std::max(highest, rotor.state().speed);
  }
  // A PI loop without wind-up still overshoots a little: what the integral gathered while it was not saturated.
  EXPECT_LT(highest, 5.5 * 1.15);
  EXPECT_NEAR(rotor.state().speed, 5.5, 0.1);
}

TEST(TopDrive, PowerLimit)
{
  TopDriveSpec spec = smooth();
  spec.max_power = 100e3;
  FreeRotor rotor(spec);
  double last = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const RotorResult r = rotor.step(speed_command(20.0), 0.005);
    EXPECT_LE(std::abs(r.motor_torque * last), 100e3 * (1.0 + 1e-12));
    last = rotor.state().speed;
  }
  EXPECT_NEAR(last, 20.0, 0.2);
}

TEST(TopDrive, TorqueModeRunsUpToTheSpeedLimit)
{
  const TopDriveSpec spec = smooth();
  FreeRotor rotor(spec);
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_DOUBLE_EQ(rotor.step(torque_command(5e3), 0.01).motor_torque, 5e3);
  }
  EXPECT_NEAR(rotor.state().speed, 5e3 / spec.inertia * 0.2, 1e-9);
  RotorResult r;
  for (int i = 0; i < 5000; ++i)
  {
    r = rotor.step(torque_command(5e3), 0.01);
  }
  EXPECT_LE(rotor.state().speed, spec.max_speed);
  EXPECT_NEAR(rotor.state().speed, spec.max_speed, 1e-6);
  EXPECT_TRUE(r.state.limited);
}

TEST(TopDrive, ChangeToSpeedModeIsBumpless)
{
  const TopDriveSpec spec = smooth();
  FreeRotor rotor(spec);
  double torque = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    torque = rotor.step(torque_command(7e3), 0.005, 6.5e3).motor_torque;
  }
  const double speed = rotor.state().speed;
  const RotorResult r = rotor.step(speed_command(speed), 0.005, 6.5e3);
  // one step of 5 ms at 0.2 rad/s2 changes the speed by 1 mrad/s: 20 N m
  EXPECT_NEAR(r.motor_torque, torque, 25.0);
}

}  // namespace
}  // namespace drill_rig_sim::test_rig_top_drive
