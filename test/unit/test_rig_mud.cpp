// Mud pump and mud motor: hand figures, stall, the motor's lag.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/mud_motor.h"
#include "drill_rig_sim/rig/mud_pump.h"
#include "drill_rig_sim/string/mud.h"

namespace drill_rig_sim
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

TEST(MudPump, ClampsAndPressure)
{
  const MudPumpSpec spec;
  EXPECT_EQ(pump_flow(spec, 0.1), spec.max_flow);
  EXPECT_EQ(pump_flow(spec, -0.1), 0.0);
  EXPECT_EQ(pump_flow(spec, 0.045), 0.045);
  EXPECT_DOUBLE_EQ(stand_pipe_pressure(spec, 0.045, 1e6), 4e9 * 0.045 * 0.045 + 1e6);
}

TEST(MudMotor, SpeedFallsWithTorqueUntilItStalls)
{
  // 0.045 m3/s at 0.024 m3/rev: 1.875 rev/s
  EXPECT_NEAR(mud_motor_steady_speed(0.045, displacement, stall, 0.0), 1.875 * 2.0 * pi, 1e-12);
  EXPECT_NEAR(mud_motor_steady_speed(0.045, displacement, stall, 3e3), 0.75 * 1.875 * 2.0 * pi, 1e-12);
  EXPECT_EQ(mud_motor_steady_speed(0.045, displacement, stall, 13e3), 0.0);
  EXPECT_NEAR(mud_motor_steady_speed(0.045, displacement, stall, -3e3), 1.875 * 2.0 * pi, 1e-12);
  EXPECT_FALSE(mud_motor_stalled(0.045, stall, 11.9e3));
  EXPECT_TRUE(mud_motor_stalled(0.045, stall, 12e3));
  EXPECT_FALSE(mud_motor_stalled(0.0, stall, 13e3));
}

TEST(MudMotor, PressureDoesTheWorkOfTheTorque)
{
  // ideal motor: dp V = 2 pi T per revolution
  EXPECT_NEAR(mud_motor_pressure(0.045, displacement, 4e3) * displacement, 2.0 * pi * 4e3, 1e-9);
  EXPECT_EQ(mud_motor_pressure(0.0, displacement, 4e3), 0.0);
  EXPECT_EQ(mud_motor_pressure(0.045, displacement, -4e3), 0.0);
  // never more power out than in
  for (int i = 0; i < 30; ++i)
  {
    const double torque = 500.0 * i;
    EXPECT_LE(torque * mud_motor_steady_speed(0.045, displacement, stall, torque),
              0.045 * mud_motor_pressure(0.045, displacement, torque) * (1.0 + 1e-12));
  }
}

TEST(MudMotor, LagsByItsTimeConstantAndSettlesExactly)
{
  const double wanted = 10.0;
  double w = 0.0;
  const double h = 1e-5;
  for (int i = 0; i < 5000; ++i)
  {
    w = advance_mud_motor(w, wanted, h);
  }
  EXPECT_NEAR(w, wanted * (1.0 - std::exp(-1.0)), 1e-3);
  EXPECT_DOUBLE_EQ(advance_mud_motor(wanted, wanted, 0.005), wanted);
}

}  // namespace
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
