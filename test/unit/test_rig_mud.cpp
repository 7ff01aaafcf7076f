// SPDX-License-Identifier: BSD-3-Clause
// Mud pump and mud motor: hand figures, stall, the motor's lag.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/hydraulics/mud_pump.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/mud.h"

namespace drill_rig_sim::test_rig_mud
{
namespace
{
constexpr double displacement = 0.024;
constexpr double stall = 12e3;

// 5 in pipe in an 8 1/2 in hole moves 2.06 times its volume of mud; in a wide hole, its volume (Fritz 1972).
TEST(MudAround, isMoreInANarrowHole)
{
  EXPECT_NEAR(confinement(0.127, 0.2159), (0.04661281 + 0.016129) / (0.04661281 - 0.016129), 1e-12);
  EXPECT_NEAR(confinement(0.127, 1e3), 1.0, 1e-6);
  EXPECT_EQ(confinement(0.2, 0.21), 5.0) << "a close fit";
  EXPECT_EQ(confinement(0.2, 0.2), 5.0);
  EXPECT_EQ(confinement(0.2, 0.1), 5.0) << "a ledge";
}

TEST(MudAround, dragIsHalfTheDynamicPressureOnTheDiameter)
{
  MudSpec mud;
  mud.density = 1200.0;
  mud.drag_coefficient = 1.5;
  EXPECT_DOUBLE_EQ(lateral_drag(mud, 0.1), 90.0);
}

TEST(MudPump, goesToItsCommandAtItsRamp)
{
  MudPumpSpec spec;
  spec.flow_ramp = 0.02;
  EXPECT_DOUBLE_EQ(advance_pump(spec, 0.0, 0.045, 0.5), 0.01);
  EXPECT_DOUBLE_EQ(advance_pump(spec, 0.01, 0.0, 0.25), 0.005);
  EXPECT_EQ(advance_pump(spec, 0.0, 0.045, 10.0), 0.045) << "not past it";
  EXPECT_EQ(advance_pump(spec, 0.0, 0.1, 10.0), spec.max_flow);
  EXPECT_EQ(advance_pump(spec, 0.01, -0.1, 10.0), 0.0);
}

TEST(MudMotor, SpeedHoldsUntilNearStall)
{
  // 0.045 m3/s at 0.024 m3/rev: 1.875 rev/s
  const double free = 1.875 * 2.0 * pi;
  const auto speed = [](double torque, double exponent)
  { return mud_motor_steady_speed(0.045, displacement, stall, exponent, torque); };
  EXPECT_NEAR(speed(0.0, 4.0).value, free, 1e-12);
  EXPECT_NEAR(speed(3e3, 1.0).value, 0.75 * free, 1e-12);
  EXPECT_NEAR(speed(6e3, 4.0).value, 0.9375 * free, 1e-12);
  EXPECT_NEAR(speed(12e3, 4.0).value, 0.0, 1e-12);
  EXPECT_NEAR(speed(-3e3, 4.0).value, free, 1e-12);
  EXPECT_EQ(speed(-3e3, 4.0).slope, 0.0);
  // dragged round backwards by the string at 5.5 rad/s it carries an eighth more than at stall: 4 free (T/T_stall - 1) = 5.5
  EXPECT_NEAR(speed(12e3 * (1.0 + 5.5 / (4.0 * free)), 4.0).value, -5.5, 1e-9);
  EXPECT_EQ(mud_motor_steady_speed(0.0, displacement, stall, 4.0, 15e3).value, 0.0) << "locked";
  for (const double torque : {500.0, 6e3, 11.9e3, 12.1e3, 20e3})
  {
    const double h = 1.0;
    EXPECT_NEAR(speed(torque, 4.0).slope, (speed(torque + h, 4.0).value - speed(torque - h, 4.0).value) / (2.0 * h), 1e-9);
  }
  EXPECT_FALSE(mud_motor_stalled(0.045, stall, 11.9e3));
  EXPECT_TRUE(mud_motor_stalled(0.045, stall, 12e3));
  EXPECT_FALSE(mud_motor_stalled(0.0, stall, 13e3));
}

// Implicit Euler with the torque's answer: (w - w_0)/h = (w_ss + s k h (w - w_0) - w)/tau for a bit of stiffness k.
TEST(MudMotor, AStuckBitDoesNotSwingAgainstIt)
{
  const double h = 0.01, k = 6e5, speed = 3.0;
  const MudMotorSpeed steady{-2.0, -4e-3};
  const double next = advance_mud_motor(speed, steady, k, h);
  EXPECT_NEAR((next - speed) / h, (steady.value + steady.slope * k * h * (next - speed) - next) / mud_motor_lag, 1e-9);
  EXPECT_DOUBLE_EQ(advance_mud_motor(speed, steady, -k, h), advance_mud_motor(speed, steady, 0.0, h)) << "a bit that slips";
  // the bit stands, its bristle winds up by the motor's turn: it settles at stall
  double w = 14.0, twist = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    twist += h * w;
    w = advance_mud_motor(w, mud_motor_steady_speed(0.045, displacement, stall, 4.0, k * twist), k, h);
    ASSERT_LT(k * twist, 16.0 * stall);
  }
  EXPECT_NEAR(w, 0.0, 1e-9);
  EXPECT_NEAR(k * twist, stall, 1e-6 * stall);
}

TEST(MudMotor, PressureDoesTheWorkOfTheTorque)
{
  // ideal motor: dp V = 2 pi T per revolution
  EXPECT_NEAR(mud_motor_pressure(0.045, displacement, 4e3) * displacement, 2.0 * pi * 4e3, 1e-9);
  EXPECT_EQ(mud_motor_pressure(0.0, displacement, 4e3), 0.0);
  EXPECT_DOUBLE_EQ(mud_motor_pressure(0.5 * mud_motor_leakage, displacement, 4e3),
                   0.5 * mud_motor_pressure(0.045, displacement, 4e3))
      << "it leaks";
  EXPECT_EQ(mud_motor_pressure(0.045, displacement, -4e3), 0.0);
  // never more power out than in, also of what flows on behind a pump that stands
  for (const double flow : {0.045, 1.9 * mud_motor_leakage, 0.9 * mud_motor_leakage, 0.1 * mud_motor_leakage})
    for (int i = 0; i < 30; ++i)
    {
      const double torque = 500.0 * i, power = flow * mud_motor_pressure(flow, displacement, torque);
      EXPECT_LE(torque * mud_motor_steady_speed(flow, displacement, stall, 4.0, torque).value, power * (1.0 + 1e-12));
      EXPECT_NEAR(torque * mud_motor_flow_speed(flow, displacement), power, 1e-9 * power);
    }
}

TEST(MudMotor, FlowBelowItsLeakageDoesNotTurnIt)
{
  const double free = 2.0 * pi / displacement;  // [rad/s per m3/s]
  EXPECT_EQ(mud_motor_steady_speed(0.99 * mud_motor_leakage, displacement, stall, 4.0, 1e3).value, 0.0);
  EXPECT_NEAR(mud_motor_steady_speed(1.5 * mud_motor_leakage, displacement, stall, 4.0, 0.0).value,
              0.75 * mud_motor_leakage * free, 1e-12);
  EXPECT_NEAR(mud_motor_steady_speed(2.0 * mud_motor_leakage, displacement, stall, 4.0, 0.0).value,
              2.0 * mud_motor_leakage * free, 1e-12);
}

TEST(MudMotor, LagsByItsTimeConstantAndSettlesExactly)
{
  const double wanted = 10.0;
  double w = 0.0;
  const double h = 1e-5;
  for (int i = 0; i < 5000; ++i)
  {
    w = advance_mud_motor(w, {wanted, 0.0}, 0.0, h);
  }
  EXPECT_NEAR(w, wanted * (1.0 - std::exp(-1.0)), 1e-3);
  EXPECT_DOUBLE_EQ(advance_mud_motor(wanted, {wanted, 0.0}, 0.0, 0.005), wanted);
}

}  // namespace
}  // namespace drill_rig_sim::test_rig_mud
