// SPDX-License-Identifier: BSD-3-Clause
// Top drive: ramps, turning to an angle, rocking, and the impedance that SOFT_TORQUE and Z_TORQUE put in front of the string.
#include <complex>
#include <functional>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/drive_reference.h"
#include "top_drive_fixtures.h"

namespace drill_rig_sim::test_rig_drive_modes
{
namespace
{
using Complex = std::complex<double>;

TopDriveSetpoint angle_command(double angle, double speed = 0.0)
{
  TopDriveSetpoint c{TopDriveMode::angle};
  c.angle = angle;
  c.speed = speed;
  return c;
}

TopDriveSetpoint oscillate_command(double middle, double right, double left, double speed)
{
  TopDriveSetpoint c{TopDriveMode::oscillate};
  c.angle = middle;
  c.amplitude_right = right;
  c.amplitude_left = left;
  c.speed = speed;
  return c;
}

TEST(DriveReference, RampsByHand)
{
  TopDriveSpec spec;
  spec.max_acceleration = 2.0;
  DriveState start;
  start.reference = 1.0;
  const SpeedReference up = speed_reference(spec, speed_command(5.0), start);
  EXPECT_DOUBLE_EQ(up.at(0.5), 2.0);
  EXPECT_DOUBLE_EQ(up.turned(0.5), 0.75);
  EXPECT_DOUBLE_EQ(up.at(3.0), 5.0);
  EXPECT_DOUBLE_EQ(up.turned(3.0), 2.0 * 3.0 + 5.0);  // two seconds of the ramp, one of 5 rad/s
  EXPECT_DOUBLE_EQ(up.acceleration(0.5), 2.0);
  EXPECT_DOUBLE_EQ(up.acceleration(4.0), 1.0);  // half of them without
  const SpeedReference down = speed_reference(spec, speed_command(-1.0), start);
  EXPECT_DOUBLE_EQ(down.at(0.25), 0.5);
  EXPECT_DOUBLE_EQ(down.turned(1.0), 0.0);
  spec.max_acceleration = 0.0;
  const SpeedReference at_once = speed_reference(spec, speed_command(5.0), start);
  EXPECT_DOUBLE_EQ(at_once.at(0.0), 5.0);
  EXPECT_DOUBLE_EQ(at_once.turned(0.1), 0.5);
  EXPECT_EQ(at_once.acceleration(0.1), 0.0);
}

// The motor has the rotor's inertia beside: what its loop sees stays small.
TEST(DriveModes, TheRotorFollowsItsRamp)
{
  TopDriveSpec spec = smooth();
  spec.max_acceleration = 0.5;
  spec.soft_torque = {800.0, 3950.0, 0.0};
  spec.z_torque = {400.0, 60.0, 0.98};
  for (const TopDriveMode mode : {TopDriveMode::speed, TopDriveMode::soft_torque, TopDriveMode::z_torque})
  {
    FreeRotor rotor(spec);
    TopDriveSetpoint command = speed_command(5.0);
    command.mode = mode;
    for (int i = 1; i <= 2200; ++i)
    {
      rotor.step(command, 0.005);
      EXPECT_NEAR(rotor.state().reference, std::min(0.5 * 0.005 * i, 5.0), 1e-9);
      EXPECT_NEAR(rotor.state().speed, rotor.state().reference, 0.01);
    }
    command.speed = -1.0;
    for (int i = 0; i < 400; ++i) rotor.step(command, 0.005);
    EXPECT_NEAR(rotor.state().speed, 4.0, 0.01);
  }
}

// a = 2 rad/s2: slower by itself below 2 rad, sqrt(2 a (e - 1)) beyond, no faster than asked.
TEST(DriveReference, TheSpeedThatComesToRestAtAnAngle)
{
  const TopDriveSpec spec;
  const auto target = [&](double left, double most) { return speed_reference(spec, angle_command(left, most), DriveState()).to; };
  EXPECT_DOUBLE_EQ(target(0.5, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(target(-0.5, 3.0), -0.5);
  EXPECT_DOUBLE_EQ(target(3.0, 3.0), std::sqrt(8.0));
  EXPECT_DOUBLE_EQ(target(30.0, 3.0), 3.0);
  EXPECT_DOUBLE_EQ(target(-30.0, -3.0), -3.0);
  EXPECT_DOUBLE_EQ(target(30.0, 0.0), 10.0 * rpm);
  EXPECT_DOUBLE_EQ(target(300.0, 1e3), std::min(spec.max_speed, std::sqrt(4.0 * 299.0)));
}

TEST(DriveModes, AnglesAreReachedAndHeldByTheBrake)
{
  const TopDriveSpec spec;
  FreeRotor rotor(spec);
  double fastest = 0.0;
  const auto turn_to = [&](double angle, double load)
  {
    for (int i = 0; i < 3000; ++i)
    {
      rotor.step(angle_command(angle, 2.0), 0.005, load);
      fastest = std::max(fastest, std::abs(rotor.state().speed));
    }
    EXPECT_TRUE(rotor.state().braked);
    EXPECT_NEAR(rotor.state().angle, angle, angle_tolerance);
  };
  turn_to(7.0, 0.0);
  turn_to(-3.0, 0.0);
  turn_to(-2.9, 0.0);  // 6 deg
  EXPECT_LT(fastest, 2.0 * 1.03);
  // on the way the string winds up; the motor has that torque when the brake lets go
  turn_to(0.5, 9e3);
  rotor.step(angle_command(1.5, 2.0), 0.005, 9e3);
  EXPECT_FALSE(rotor.state().braked);
  EXPECT_GT(rotor.state().speed, -0.02) << "without falling back";
}

TEST(DriveModes, RocksBetweenItsAmplitudes)
{
  TopDriveSpec spec = smooth();
  spec.max_acceleration = 4.0;
  FreeRotor rotor(spec);
  const TopDriveSetpoint command = oscillate_command(20.0, 3.0, 5.0, 2.0);
  rotor.state().angle = 20.0;
  double highest = 20.0, lowest = 20.0, last = 0.0;
  int turns = 0;
  for (int i = 0; i < 8000; ++i)  // 40 s
  {
    rotor.step(command, 0.005);
    const DriveState& now = rotor.state();
    highest = std::max(highest, now.angle);
    lowest = std::min(lowest, now.angle);
    turns += now.speed * last < 0.0;
    last = now.speed;
    EXPECT_LE(std::abs(now.speed), 2.0 * 1.05);
  }
  EXPECT_NEAR(highest, 23.0, 0.1);
  EXPECT_NEAR(lowest, 15.0, 0.1);
  // 8 rad at 2 rad/s, and 0.5 s more for every turn about: 4.5 s
  EXPECT_NEAR(turns, 40.0 / 4.5, 1.0);
}

// A string that lets it go no farther turns it back, at the torque limit.
TEST(DriveModes, RockingTurnsBackAtTheTorqueLimit)
{
  const TopDriveSpec spec = smooth();
  TopDriveSetpoint command = oscillate_command(0.0, 10.0, 10.0, 1.0);
  command.torque_limit = 6e3;
  FreeRotor rotor(spec);
  double highest = 0.0, lowest = 0.0;
  for (int i = 0; i < 20000; ++i)  // 100 s
  {
    rotor.step(command, 0.005, 3e3 * rotor.state().angle);
    highest = std::max(highest, rotor.state().angle);
    lowest = std::min(lowest, rotor.state().angle);
  }
  // 3 kN m/rad take 6 kN m at 2 rad; the rotor's swing goes on by w sqrt(J/k) at most
  const double swing = 2.0 + command.speed * std::sqrt(spec.inertia / 3e3);
  EXPECT_GT(highest, 2.0);
  EXPECT_LT(highest, swing);
  EXPECT_LT(lowest, -2.0);
  EXPECT_GT(lowest, -swing);
}

/// A drive on top of a string without end, of impedance zeta, up which a wave comes.
class EndlessString
{
public:
  EndlessString(const TopDriveSpec& spec, double zeta) : spec_(spec), zeta_(zeta) {}

  /// Reflection of the waves of torque at `frequency` [Hz] about a steady turning at 5 rad/s.
  Complex reflection(TopDriveMode mode, double frequency)
  {
    TopDriveSetpoint command = speed_command(5.0);
    command.mode = mode;
    const double period = 1.0 / frequency, h = std::min(1e-3, period / 2000.0), wave = 0.05;
    state_ = running(5.0);
    const double settling = std::ceil(60.0 / period) * period;
    const int from = static_cast<int>(settling / h), to = from + static_cast<int>(std::lround(2.0 * period / h));
    Complex up = 0.0, down = 0.0;
    for (int i = 0; i < to; ++i)
    {
      const double time = (i + 1) * h;
      const Complex turning = std::exp(Complex(0.0, -2.0 * pi * frequency * time));
      const double rising = wave * std::cos(2.0 * pi * frequency * time);
      const double falling = step(command, h, rising);
      if (i < from) continue;
      up += -rising * turning;
      down += falling * turning;
    }
    return down / up;
  }

private:
  /// T = zeta (w - 5 - 2 w_up) of the waves about 5 rad/s; the wave that goes down [rad/s].
  double step(const TopDriveSetpoint& command, double h, double rising)
  {
    double top = h * 5.0;
    RotorResult r;
    for (int k = 0; k < 2; ++k)  // linear: the second is exact
    {
      r = solve_rotor(spec_, command, state_, euler(h, state_.speed), top);
      const double wrong = r.meter_torque - zeta_ * (top / h - 5.0 - 2.0 * rising);
      top += wrong / (r.stiffness + zeta_ / h);
    }
    r = solve_rotor(spec_, command, state_, euler(h, state_.speed), top);
    state_ = r.state;
    return top / h - 5.0 - rising;
  }

  TopDriveSpec spec_;
  double zeta_;
  DriveState state_;
};

// r = (Z - zeta)/(Z + zeta), Z = P + s (1 - c) J + I/s, in series with the meter's spring.
TEST(DriveModes, TheReflectionIsThatOfTheImpedance)
{
  TopDriveSpec spec = smooth();
  spec.soft_torque = {800.0, 3950.0, 0.0};
  spec.z_torque = {400.0, 60.0, 0.98};
  const double zeta = 400.0;
  EndlessString string(spec, zeta);
  for (const TopDriveMode mode : {TopDriveMode::speed, TopDriveMode::soft_torque, TopDriveMode::z_torque})
  {
    const DriveImpedance& set = mode == TopDriveMode::soft_torque ? spec.soft_torque : spec.z_torque;
    const double damping = mode == TopDriveMode::speed ? spec.proportional_gain : set.damping;
    const double stiffness = mode == TopDriveMode::speed ? spec.integral_gain : set.stiffness;
    const double inertia = mode == TopDriveMode::speed ? spec.inertia : spec.inertia * (1.0 - set.inertia_compensation);
    for (const double frequency : {0.05, 0.1, 0.2, 0.4, 0.7, 1.0, 2.0})
    {
      const Complex s(0.0, 2.0 * pi * frequency);
      const Complex drive = damping + s * inertia + stiffness / s;
      const Complex reflection = string.reflection(mode, frequency);
      EXPECT_LT(std::abs(reflection - (drive - zeta) / (drive + zeta)), 0.03) << frequency;
      const Complex with_meter = 1.0 / (1.0 / drive + s / spec.meter_stiffness);
      EXPECT_LT(std::abs(reflection - (with_meter - zeta) / (with_meter + zeta)), 0.01) << frequency;
    }
  }
}

TEST(DriveModes, ImpedancesObeyTheEquationOfMotionToo)
{
  TopDriveSpec spec;
  spec.soft_torque = {800.0, 3950.0, 0.3};
  spec.z_torque = {400.0, 60.0, 0.98};
  const RotorStage stage{0.005, 300.0, 90000.0, 5.5 - 300.0 * 0.0275, -90000.0 * 0.0275};  // goes on at 5.5 rad/s
  for (const TopDriveMode mode : {TopDriveMode::soft_torque, TopDriveMode::z_torque})
  {
    TopDriveSetpoint command = speed_command(5.5);
    command.mode = mode;
    for (const double limit : {0.0, 2e3})
    {
      command.torque_limit = limit;
      DriveState start = running(5.5, 6e3 / (mode == TopDriveMode::soft_torque ? 3950.0 : 60.0), 0.006);
      start.loop = mode;
      const RotorResult r = check(spec, command, start, stage, 0.0275);
      EXPECT_EQ(r.state.limited, limit > 0.0);
      const DriveTorque drive = drive_torque(spec, command, start, stage.time, r.increment, r.state.speed, r.state.meter_twist);
      EXPECT_NEAR(drive.motor, r.motor_torque, 1e-5);
      EXPECT_NEAR(drive.state.integral, r.state.integral, 1e-9);
      const double slope = drive.by_turn + drive.by_speed * stage.dv_du + drive.by_meter * spec.meter_stiffness;
      const double h = 1e-6;
      const auto torques = [&](double d)
      {
        const DriveTorque moved = drive_torque(spec, command, start, stage.time, r.increment + d, r.state.speed + stage.dv_du * d,
                                               r.state.meter_twist + d);
        return moved.motor + moved.friction;
      };
      EXPECT_NEAR((torques(h) - torques(-h)) / (2.0 * h), slope, 1e-5 * std::abs(slope) + 1e-3);
    }
  }
}

// The loop's torque is the motor's, whatever the mode: a change under load makes no step of it.
TEST(DriveModes, ModesTakeOverWithoutABump)
{
  TopDriveSpec spec = smooth();
  spec.soft_torque = {800.0, 3950.0, 0.0};
  spec.z_torque = {400.0, 60.0, 0.98};
  FreeRotor rotor(spec);
  for (int i = 0; i < 4000; ++i) rotor.step(speed_command(5.0), 0.005, 9e3);
  for (const TopDriveMode mode :
       {TopDriveMode::soft_torque, TopDriveMode::z_torque, TopDriveMode::speed, TopDriveMode::torque, TopDriveMode::soft_torque})
  {
    TopDriveSetpoint command = speed_command(5.0);
    command.mode = mode;
    command.torque = 9e3;
    EXPECT_NEAR(rotor.step(command, 0.005, 9e3).motor_torque, 9e3, 10.0);
    for (int i = 0; i < 400; ++i) rotor.step(command, 0.005, 9e3);
    EXPECT_NEAR(rotor.state().speed, 5.0, 0.01);
  }
}

// w = w* - T/P
TEST(DriveModes, DroopSlowsDownInProportionToTheTorque)
{
  const TopDriveSpec spec = smooth();
  FreeRotor rotor(spec);
  TopDriveSetpoint command = speed_command(5.0);
  command.mode = TopDriveMode::droop;
  for (const double load : {0.0, 2e3, 8e3})
  {
    for (int i = 0; i < 2000; ++i) rotor.step(command, 0.005, load);
    EXPECT_NEAR(rotor.state().speed, 5.0 - load / spec.proportional_gain, 1e-6) << load;
  }
}

// Nor does one amid the string's waves and against the gearbox's friction, which Z_TORQUE carries fifty times lighter than the
// others.
TEST(DriveModes, ModesTakeOverAmidWaves)
{
  TopDriveSpec spec;
  spec.soft_torque = {800.0, 3950.0, 0.0};
  spec.z_torque = {400.0, 60.0, 0.98};
  FreeRotor rotor(spec);
  double time = 0.0;
  const auto step = [&](TopDriveMode mode)
  {
    TopDriveSetpoint command = speed_command(5.0);
    command.mode = mode;
    time += 0.005;
    return rotor.step(command, 0.005, 9e3 + 300.0 * std::sin(2.0 * pi * 0.2 * time)).motor_torque;
  };
  double before = 0.0;
  for (int i = 0; i < 4000; ++i) before = step(TopDriveMode::speed);
  for (const TopDriveMode mode : {TopDriveMode::z_torque, TopDriveMode::speed, TopDriveMode::soft_torque, TopDriveMode::z_torque,
                                  TopDriveMode::soft_torque})
  {
    EXPECT_NEAR(step(mode), before, 150.0) << static_cast<int>(mode);
    for (int i = 0; i < 777; ++i) before = step(mode);
  }
}

}  // namespace
}  // namespace drill_rig_sim::test_rig_drive_modes
