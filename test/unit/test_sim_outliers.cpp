// SPDX-License-Identifier: BSD-3-Clause
// Outliers of a gauge and the pump's pulsation at the pressure gauge, against their closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/instruments/instruments.h"
#include "drill_ahead.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_outliers
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;  // [s]
}

// A Poisson process: n h/I of n samples are off, up and down alike, within four standard deviations sqrt(n h/I).
TEST(Sensor, outliersHaveTheirRateAndSize)
{
  SensorSpec spec;
  spec.outlier_interval = 5.0;
  spec.outlier_size = 1000.0;
  Sensor sensor(spec, frame, NoiseSource::of(7, 0));
  int up = 0, down = 0;
  const int n = 500000;
  for (int k = 0; k < n; ++k)
  {
    const double error = sensor.read(3.0, frame * k) - 3.0;
    if (error == 0.0) continue;
    ASSERT_EQ(std::abs(error), 1000.0);
    ++(error > 0.0 ? up : down);
  }
  const double expected = 0.5 * n * frame / 5.0;
  EXPECT_NEAR(up, expected, 4.0 * std::sqrt(expected));
  EXPECT_NEAR(down, expected, 4.0 * std::sqrt(expected));
}

TEST(Sensor, anOutlierIsOneSampleLong)
{
  SensorSpec spec;
  spec.rate = 1.0;
  spec.outlier_interval = 3.0;
  spec.outlier_size = 10.0;
  Sensor sensor(spec, frame, NoiseSource::of(1, 0));
  double last = 0.0;
  for (int k = 0; k < 100000; ++k)
  {
    const double shown = sensor.read(0.0, frame * k);
    if (k % 100 != 0)
    {
      ASSERT_EQ(shown, last) << k;
    }
    last = shown;
  }
}

// Three maxima a stroke, of the amplitude times the pressure.
TEST(Instruments, thePumpPulsatesThreeTimesAStroke)
{
  for (const double strokes : {0.0, 1.0 / 6.0, 5.0 / 6.0, 1234.5}) EXPECT_NEAR(pulsation_of(0.05, strokes), 0.0, 1e-9);
  for (const double strokes : {1.0 / 12.0, 5.0 / 12.0, 9.0 / 12.0, 100.0 + 1.0 / 12.0})
    EXPECT_NEAR(pulsation_of(0.05, strokes), 0.05, 1e-9);
}

TEST(Readings, havePumpNoiseInThePressureAlone)
{
  Scene scene = motor_drilling_scene(0.02);
  Simulator quiet(scene, 1);
  scene.instruments.stand_pipe_pressure.pump_noise = 0.04;
  Simulator noisy(scene, 1);
  double largest = 0.0;
  for (int k = 0; k < 500; ++k)
  {
    for (Simulator* rig : {&quiet, &noisy})
    {
      if (k == 0) rig->command(PumpSetpoint{0.02});
      rig->frame(frame);
    }
    ASSERT_EQ(quiet.truth().stand_pipe_pressure, noisy.truth().stand_pipe_pressure);
    ASSERT_EQ(quiet.readings().hook_load, noisy.readings().hook_load);
    if (quiet.readings().stand_pipe_pressure > 0.0)
      largest = std::max(largest, std::abs(noisy.readings().stand_pipe_pressure / quiet.readings().stand_pipe_pressure - 1.0));
  }
  EXPECT_LE(largest, 0.04 + 1e-9);
  EXPECT_GT(largest, 0.035);
}

}  // namespace test_sim_outliers
