// SPDX-License-Identifier: BSD-3-Clause
// Errors of a gauge, each against its closed form: samples that are held, lag, quantisation, drift, drop-outs, and what faults
// add to them.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/instruments/instruments.h"
#include "drill_rig_sim/math/units.h"
#include "drill_ahead.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_gauge_errors
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;  // [s]

/// Mean and standard deviation.
struct Moments
{
  double sum = 0.0, squares = 0.0;
  int count = 0;
  void add(double x)
  {
    sum += x;
    squares += x * x;
    ++count;
  }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
};

/// All of a gauge's errors at once.
SensorSpec bad_spec()
{
  SensorSpec spec;
  spec.noise = 300.0;
  spec.bias = 100.0;
  spec.delay = 0.05;
  spec.filter_time = 0.2;
  spec.resolution = 10.0;
  spec.drift = 50.0;
  spec.rate = 20.0;
  spec.dropout_interval = 1.0;
  spec.dropout_duration = 0.3;
  spec.outlier_interval = 2.0;
  spec.outlier_size = 5000.0;
  return spec;
}

Scene scene_of_bad_gauges()
{
  Scene scene = motor_drilling_scene(0.02);
  static_cast<SensorSpec&>(scene.instruments.hook_load) = bad_spec();
  scene.instruments.torque = bad_spec();
  return scene;
}

std::vector<std::vector<double>> readings_of(Simulator& rig, int frames)
{
  std::vector<std::vector<double>> all;
  for (int k = 0; k < frames; ++k)
  {
    rig.frame(frame);
    all.push_back(numbers_of(rig.readings()));
  }
  return all;
}
}  // namespace

// 8 samples a second: what is seen at multiples of 0.125 s is shown until the next.
TEST(Sensor, holdsASampleUntilTheNext)
{
  SensorSpec spec;
  spec.rate = 8.0;
  Sensor sensor(spec, 0.03125);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(sensor.read(k, 0.03125 * k), k / 4 * 4) << k;
}

// 30 a second in frames of 10 ms: each waits for the next frame, and over 10 s there are 300 all the same.
TEST(Sensor, keepsItsRateInFramesThatDoNotFit)
{
  SensorSpec spec;
  spec.rate = 30.0;
  Sensor sensor(spec, frame);
  double before = -1.0;
  int samples = 0;
  for (int k = 0; k < 1000; ++k)
  {
    const double shown = sensor.read(k, frame * k);
    samples += shown != before;
    EXPECT_LT(k - shown, 4.0) << "none is older than a period and a frame";
    before = shown;
  }
  EXPECT_EQ(300, samples);
}

TEST(Sensor, aRateAboveTheFramesShowsEachFrame)
{
  SensorSpec spec;
  spec.rate = 1000.0;
  Sensor sensor(spec, frame);
  for (int k = 0; k < 500; ++k) ASSERT_EQ(sensor.read(k, frame * k), k);
}

// Behind a ramp of v by v h/(e^(h/T) - 1), which is v (T - h/2) for short frames.
TEST(Sensor, filterLagsARampByItsTime)
{
  SensorSpec spec;
  spec.filter_time = 0.5;
  Sensor sensor(spec, frame);
  const double speed = 3.0;
  double shown = 0.0;
  for (int k = 0; k <= 2000; ++k) shown = sensor.read(speed * frame * k, frame * k);
  const double lag = speed * frame / std::expm1(frame / spec.filter_time);
  EXPECT_NEAR(speed * 20.0 - shown, lag, 1e-9);
  EXPECT_NEAR(lag, speed * (spec.filter_time - 0.5 * frame), 1e-4);
}

// Of a signal that is anywhere between two steps: even in -r/2 .. r/2, deviation r/sqrt(12).
TEST(Sensor, quantisationErrsEvenly)
{
  SensorSpec spec;
  spec.resolution = 0.5;
  Sensor sensor(spec, frame);
  Moments error;
  const int n = 20000;
  for (int k = 0; k < n; ++k)
  {
    const double signal = 0.618033988749895 * k;  // the golden ratio's multiples lie evenly
    error.add(sensor.read(signal, frame * k) - signal);
    EXPECT_LE(std::abs(sensor.read(signal, frame * k) - signal), 0.25 + 1e-9);
  }
  EXPECT_NEAR(error.mean(), 0.0, 1e-3);
  EXPECT_NEAR(error.deviation(), 0.5 / std::sqrt(12.0), 1e-3);
}

TEST(Sensor, biasAndNoiseAreMeanAndDeviation)
{
  SensorSpec spec;
  spec.bias = 7.0;
  spec.noise = 2.0;
  Sensor sensor(spec, frame, NoiseSource::of(4, 1));
  Moments error;
  const int n = 40000;
  for (int k = 0; k < n; ++k) error.add(sensor.read(100.0, frame * k) - 100.0);
  EXPECT_NEAR(error.mean(), 7.0, 4.0 * 2.0 / std::sqrt(n));
  EXPECT_NEAR(error.deviation(), 2.0, 4.0 * 2.0 / std::sqrt(2.0 * n));
}

// Of 2000 gauges after 4 s: mean 0, deviation K sqrt(t), whatever the rate of their samples; and half the variance after half the
// time.
TEST(Sensor, driftIsARandomWalk)
{
  for (const double rate : {0.0, 1.0})
  {
    SensorSpec spec;
    spec.drift = 3.0;
    spec.rate = rate;
    const int n = 2000;
    Moments half, end, later;
    for (int g = 0; g < n; ++g)
    {
      Sensor sensor(spec, 0.1, NoiseSource::of(9, static_cast<std::uint64_t>(g)));
      double at_half = 0.0, shown = 0.0;
      for (int k = 0; k <= 40; ++k)
      {
        shown = sensor.read(5.0, 0.1 * k) - 5.0;
        if (k == 0)
        {
          ASSERT_EQ(0.0, shown) << "right at the start";
        }
        if (k == 20) at_half = shown;
      }
      half.add(at_half);
      end.add(shown);
      later.add((shown - at_half) * at_half);
    }
    EXPECT_NEAR(end.mean(), 0.0, 4.0 * 6.0 / std::sqrt(n)) << rate;
    EXPECT_NEAR(end.deviation(), 6.0, 4.0 * 6.0 / std::sqrt(2.0 * n)) << rate;
    EXPECT_NEAR(half.deviation(), 3.0 * std::sqrt(2.0), 4.0 * 3.0 * std::sqrt(2.0) / std::sqrt(2.0 * n)) << rate;
    EXPECT_NEAR(later.mean(), 0.0, 4.0 * 18.0 / std::sqrt(n)) << rate << ": what comes does not know what was";
  }
}

// Good for 4 s and lost for 1 s in the mean: a fifth of all time is lost. In frames the means are those of runs left with the
// probability q: h/q, q = (1 - e^(-(a + b) h)) times a/(a + b) or b/(a + b).
TEST(Sensor, dropOutsHaveTheirShareAndLength)
{
  SensorSpec spec;
  spec.dropout_interval = 4.0;
  spec.dropout_duration = 1.0;
  Sensor sensor(spec, frame, NoiseSource::of(2, 3));
  const int n = 2000000;
  const double a = 0.25, b = 1.0;
  int lost = 0, falls = 0;
  bool before = false;
  for (int k = 0; k < n; ++k)
  {
    sensor.read(k, frame * k);
    lost += sensor.is_lost();
    falls += sensor.is_lost() && !before;
    before = sensor.is_lost();
  }
  // neighbours are alike for 1/(a + b): this number of times fewer are independent
  const double share = a / (a + b), independent = n * frame * (a + b) / 2.0;
  EXPECT_NEAR(static_cast<double>(lost) / n, share, 4.0 * std::sqrt(share * (1.0 - share) / independent));
  const double left = -std::expm1(-(a + b) * frame) * b / (a + b), mean = frame / left;
  EXPECT_NEAR(lost * frame / falls, mean, 4.0 * mean / std::sqrt(falls));
  const double fallen = -std::expm1(-(a + b) * frame) * a / (a + b), good = frame / fallen;
  EXPECT_NEAR((n - lost) * frame / falls, good, 4.0 * good / std::sqrt(falls));
}

TEST(Sensor, aLostOneShowsItsLastReading)
{
  SensorSpec spec;
  spec.dropout_interval = 0.5;
  spec.dropout_duration = 0.5;
  Sensor sensor(spec, frame, NoiseSource::of(2, 3));
  double last = 0.0;
  int lost = 0;
  for (int k = 0; k < 5000; ++k)
  {
    const double shown = sensor.read(k, frame * k);
    if (!sensor.is_lost()) last = k;
    ASSERT_EQ(shown, last) << k;
    lost += sensor.is_lost();
  }
  EXPECT_GT(lost, 1000);
}

TEST(Sensor, neverBeginsWithADropOut)
{
  SensorSpec spec;
  spec.dropout_interval = 1e-3;
  spec.dropout_duration = 1e6;
  for (int g = 0; g < 50; ++g)
  {
    Sensor sensor(spec, frame, NoiseSource::of(1, static_cast<std::uint64_t>(g)));
    EXPECT_EQ(3.5, sensor.read(3.5, 0.0));
    EXPECT_EQ(3.5, sensor.read(4.5, 10.0)) << "but is soon lost";
  }
}

TEST(SensorFault, addsToWhatTheGaugeHas)
{
  SensorSpec spec;
  spec.bias = 1.0;
  Sensor sensor(spec, frame);
  EXPECT_EQ(11.0, sensor.read(10.0, 0.0));
  sensor.fault.bias = 5.0;
  EXPECT_EQ(16.0, sensor.read(10.0, frame));
  sensor.fault.drift = 2.0;
  for (int k = 2; k <= 101; ++k) sensor.read(10.0, frame * k);
  EXPECT_NEAR(18.0, sensor.read(10.0, 1.01), 1e-9);
  sensor.fault = SensorFault();
  EXPECT_EQ(11.0, sensor.read(10.0, 1.03)) << "over";
}

TEST(SensorFault, noiseAddsBySquares)
{
  SensorSpec spec;
  spec.noise = 3.0;
  Sensor sensor(spec, frame, NoiseSource::of(5, 6));
  sensor.fault.noise = 4.0;
  Moments error;
  const int n = 40000;
  for (int k = 0; k < n; ++k) error.add(sensor.read(0.0, frame * k));
  EXPECT_NEAR(error.deviation(), 5.0, 4.0 * 5.0 / std::sqrt(2.0 * n));
}

TEST(SensorFault, frozenAndDroppedShowTheLastReadingAndOneTells)
{
  Sensor frozen{SensorSpec(), frame}, dropped{SensorSpec(), frame};
  frozen.read(1.0, 0.0);
  dropped.read(1.0, 0.0);
  frozen.fault.frozen = dropped.fault.dropped = true;
  EXPECT_EQ(1.0, frozen.read(2.0, frame));
  EXPECT_EQ(1.0, dropped.read(2.0, frame));
  EXPECT_FALSE(frozen.is_lost());
  EXPECT_TRUE(dropped.is_lost());
  frozen.fault = dropped.fault = SensorFault();
  EXPECT_EQ(3.0, frozen.read(3.0, 2.0 * frame));
  EXPECT_EQ(3.0, dropped.read(3.0, 2.0 * frame));
}

// Where the hook load is read at the dead line, its gauge is the dead line's.
TEST(Instruments, tellWhichGaugesAreLost)
{
  for (const HookLoadPlace place : {HookLoadPlace::block, HookLoadPlace::dead_line})
    for (int g = 0; g < gauge_count; ++g)
    {
      Scene scene = drilling_scene();
      scene.instruments.hook_load.place = place;
      Truth truth;
      Instruments instruments(scene, truth, 1);
      Readings readings;
      instruments.read(truth, SensorView(), readings);
      EXPECT_EQ(0u, readings.lost_gauges);
      instruments.fault_of(static_cast<Gauge>(g)).dropped = true;
#define GAUGE(type, name, ...) truth.name += 1.0;
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
      truth.time += frame;
      instruments.read(truth, SensorView(), readings);
      const bool both = place == HookLoadPlace::dead_line && g < 2;
      EXPECT_EQ(both ? 3u : 1u << g, readings.lost_gauges) << gauge_names[g];
      const double shown[] = {
#define GAUGE(type, name, ...) readings.name,
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
      };
      for (int k = 0; k < gauge_count; ++k) EXPECT_EQ(readings.lost_gauges >> k & 1u ? 0.0 : 1.0, shown[k]) << gauge_names[k];
    }
}

TEST(Readings, repeatBitByBitBySeedAndFromASnapshot)
{
  Simulator rig(scene_of_bad_gauges(), 5), again(scene_of_bad_gauges(), 5), other(scene_of_bad_gauges(), 6);
  for (Simulator* one : {&rig, &again, &other}) drill_ahead(*one, 60.0 * rpm, 0.03, 0.01);
  EXPECT_EQ(readings_of(rig, 150), readings_of(again, 150));
  const auto saved = rig.save();
  const auto ahead = readings_of(rig, 300);
  EXPECT_EQ(ahead, readings_of(again, 300));
  other.restore(*saved);
  EXPECT_EQ(ahead, readings_of(other, 300)) << "the seed's stream is part of the state";
  Simulator stranger(scene_of_bad_gauges(), 6);
  drill_ahead(stranger, 60.0 * rpm, 0.03, 0.01);
  readings_of(stranger, 150);
  EXPECT_NE(ahead, readings_of(stranger, 300));
}
}  // namespace test_sim_gauge_errors
