// Stick-slip of a string of 3 km, by a stiff drive and by those that give way to the string's waves.
#include <gtest/gtest.h>

#include <algorithm>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "in_source.h"

using namespace drill_rig_sim;

namespace
{
struct Range
{
  double least = 1e9, most = -1e9;
  void add(double x)
  {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

Simulator rig_of_3_km()
{
  Scene scene = read_scene(in_source("test/benchmark/scenes/stick_slip.yaml"));
  scene.numerics.level = Level::axial_torsional;
  scene.numerics.step = 0.01;
  return Simulator(scene);
}

/// Of the bit's speed [rpm] at 90 rpm, from 60 to 90 s after the start.
Range bit_speed(Simulator& rig, TopDriveMode mode)
{
  TopDriveSetpoint turn;
  turn.mode = mode;
  turn.speed = 90.0 * rpm;
  rig.command(turn);
  rig.command(PumpSetpoint{0.03});
  Range out;
  for (int k = 0; k < 9000; ++k)
  {
    EXPECT_EQ(rig.frame(0.01), FrameStatus::running) << rig.failure();
    if (k >= 6000) out.add(rig.truth().bit_speed / rpm);
  }
  return out;
}
}  // namespace

TEST(StickSlip, aStiffDriveSticksAndSlips)
{
  Simulator rig = rig_of_3_km();
  const Range speed = bit_speed(rig, TopDriveMode::speed);
  EXPECT_LT(speed.least, 1.0);
  EXPECT_NEAR(speed.most, 193.0, 10.0);
}

TEST(StickSlip, aTunedSoftTorqueTurnsSteadily)
{
  Simulator rig = rig_of_3_km();
  const Range speed = bit_speed(rig, TopDriveMode::soft_torque);
  EXPECT_GT(speed.least, 80.0);
  EXPECT_LT(speed.most, 100.0);
}

TEST(StickSlip, aTunedZTorqueTurnsSteadily)
{
  Simulator rig = rig_of_3_km();
  const Range speed = bit_speed(rig, TopDriveMode::z_torque);
  EXPECT_GT(speed.least, 80.0);
  EXPECT_LT(speed.most, 100.0);
}

// Out of stick-slip, which has begun: what makes it worth switching over.
TEST(StickSlip, softTorqueEndsItOnceItRuns)
{
  Simulator rig = rig_of_3_km();
  EXPECT_LT(bit_speed(rig, TopDriveMode::speed).least, 1.0);
  const Range speed = bit_speed(rig, TopDriveMode::soft_torque);
  EXPECT_GT(speed.least, 60.0);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
