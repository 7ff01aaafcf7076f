// SPDX-License-Identifier: BSD-3-Clause
// The zero of the weight on bit: a mean over whole periods of the string's ringing in its lines, and only of what hangs there as
// it does now.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/instruments/zero_mean.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/requests.h"
#include "drill_rig_sim/sim/simulator.h"
#include "test_scenes.h"

namespace test_sim_zero_mean
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;  // [s]

HungString hung_in(const Scene& scene)
{
  const double height = scene.start.block_height;
  return {build_mesh(scene, scene.start.bit_depth + height), scene.rig.hoisting, height};
}

/// A hook load of 500 kN that swings by 10 kN, at a time, with the block lowered.
struct Ring
{
  double period, mean = 5e5, half = 1e4;
  double at(double time) const { return mean + half * std::sin(2.0 * pi * time / period); }
};

RigSignals lowered(double time)
{
  RigSignals now;
  now.time = time;
  now.setpoints.winch = {-0.05, false};
  return now;
}

/// Frames from `begin` to `end` [s].
void take(ZeroMean& zero, const Ring& ring, double begin, double end, RigSignals now = lowered(0.0))
{
  for (double time = begin; time < end - 0.5 * frame; time += frame)
  {
    now.time = time;
    now.block_height = now.setpoints.winch.block_velocity * time;
    zero.take(ring.at(time), now);
  }
}

/// The zero that a tare at this moment gives to the readings [N].
double zero_of(Simulator& rig)
{
  EXPECT_TRUE(rig.tare());
  EXPECT_NEAR(rig.readings().hook_load + rig.readings().surface_wob, rig.truth().hook_load + rig.truth().surface_wob, 1e-6)
      << "the gauge is ideal";
  return rig.readings().hook_load + rig.readings().surface_wob;
}
}  // namespace

// A rod that hangs on stiff lines: four times the way of a wave; a stiff one that bounces with its block on soft lines.
TEST(HungString, ringsAsItsLimitsDo)
{
  HungString hung = hung_in(vertical_scene(1000.0, 900.0));
  const double block = 17500.0;
  EXPECT_GT(hung.mass, 2e4);
  const HungString as_it_is = hung;
  hung.lines = 1e15;
  EXPECT_NEAR(4.0 * std::sqrt(hung.mass / hung.stiffness), hung.ring_period(block), 1e-3 * hung.ring_period(block));
  hung = as_it_is;
  hung.stiffness = 1e15;
  EXPECT_NEAR(2.0 * pi * std::sqrt((hung.mass + block) / hung.lines), hung.ring_period(block), 1e-3 * hung.ring_period(block));
  EXPECT_GT(as_it_is.ring_period(block), hung.ring_period(block)) << "both give way";
}

TEST(ZeroMean, takesWholePeriodsOfTheRing)
{
  for (const double period : {0.25, 1.7, 4.5})
  {
    const Ring ring{period};
    ZeroMean zero(0.0);
    zero.rings_with(period);
    double time = 12.0;
    take(zero, ring, 0.0, time);
    for (int phase = 0; phase < 8; ++phase, time += period / 8.0)
    {
      EXPECT_NEAR(ring.mean, zero.mean(), 0.02 * ring.half) << period << " s, " << phase;
      take(zero, ring, time, time + period / 8.0);
    }
  }
}

// An estimate of the period that is off by a tenth still takes most of the ring away.
TEST(ZeroMean, bearsAnErrorOfThePeriod)
{
  const Ring ring{1.7};
  ZeroMean zero(0.0);
  zero.rings_with(1.1 * ring.period);
  double time = 12.0;
  take(zero, ring, 0.0, time);
  for (int phase = 0; phase < 8; ++phase, time += ring.period / 8.0)
  {
    EXPECT_NEAR(ring.mean, zero.mean(), 0.15 * ring.half) << phase;
    take(zero, ring, time, time + ring.period / 8.0);
  }
}

// Sheaves and walls rub the other way, or no more: what was before is no part of the zero.
TEST(ZeroMean, beginsAnewWhereFrictionChanges)
{
  RigSignals up = lowered(0.0), stopped = lowered(0.0), braked = lowered(0.0), turning = lowered(0.0);
  up.setpoints.winch.block_velocity = 0.05;
  stopped.setpoints.winch.block_velocity = 0.0;
  braked.setpoints.winch.brake = true;
  turning.top_drive_speed = 60.0 * rpm;
  const Ring before{1.0, 6e5, 0.0}, after{1.0, 5e5, 0.0};
  for (const RigSignals& next : {up, stopped, braked, turning})
  {
    ZeroMean zero(0.0);
    zero.rings_with(1.0);
    take(zero, before, 0.0, 10.0);
    EXPECT_NEAR(before.mean, zero.mean(), 1e-6);
    take(zero, after, 10.0, 10.1, next);
    EXPECT_NEAR(after.mean, zero.mean(), 1e-6);
  }
  ZeroMean faster(0.0);
  faster.rings_with(1.0);
  take(faster, before, 0.0, 10.0);
  RigSignals now = lowered(0.0);
  now.setpoints.winch.block_velocity = -0.02;
  take(faster, after, 10.0, 10.5, now);
  EXPECT_GT(faster.mean(), 5.5e5) << "another speed is no other friction";
}

// The sheaves' friction turns round over the first 2 cm: 0.4 s at 0.05 m/s. The mean begins after them.
TEST(ZeroMean, leavesOutTheWayOverWhichFrictionTurnsRound)
{
  const Ring before{1.0, 6e5, 0.0}, after{1.0, 5e5, 0.0};
  ZeroMean zero(0.0);
  zero.rings_with(1.0);
  take(zero, before, 0.0, 0.4);
  take(zero, after, 0.41, 0.8);
  EXPECT_NEAR(after.mean, zero.mean(), 0.03 * (before.mean - after.mean));
}

TEST(ZeroMean, ofAFloatingRigGoesOverAPeriodOfTheWaves)
{
  const Ring waves{10.0};
  ZeroMean zero(10.0);
  zero.rings_with(1.0);
  take(zero, waves, 0.0, 23.0);
  RigSignals stopped = lowered(0.0);
  stopped.setpoints.winch.block_velocity = 0.0;
  take(zero, waves, 23.0, 27.3, stopped);
  EXPECT_NEAR(waves.mean, zero.mean(), 0.02 * waves.half);
}

// A sine of half-width A about a mean: standard deviation A / sqrt(2) over whole periods.
TEST(ZeroWindow, hasMeanAndDeviationOfTheLastSeconds)
{
  ZeroWindow window;
  const Ring before{1.0, 9e5, 0.0}, ring{1.0};
  for (double time = 0.0; time < 100.0; time += frame)
    window.take((time < 80.0 ? before : ring).at(time), 1e7 + 1e5 * time, time);
  EXPECT_NEAR(ZeroWindow::longest, window.held(), 0.3);
  const Zero zero = window.over(10.0);
  EXPECT_NEAR(10.0, zero.duration, 0.25 + 1e-9);
  EXPECT_NEAR(ring.mean, zero.hook_load, 0.02 * ring.half);
  EXPECT_NEAR(ring.half / std::sqrt(2.0), zero.hook_load_deviation, 0.02 * ring.half);
  EXPECT_NEAR(1e7 + 1e5 * (100.0 - 0.5 * zero.duration), zero.stand_pipe_pressure, 2e3);
  EXPECT_NEAR(1e5 * zero.duration / std::sqrt(12.0), zero.stand_pipe_pressure_deviation, 2e3) << "a ramp";
  const Zero longer = window.over(40.0);
  EXPECT_NEAR(0.5 * (ring.mean + before.mean), longer.hook_load, 3e3) << "half of it is from before";
}

// Readings are weighted by their time: frames of another length in between change nothing. Digits are not lost beside a large
// mean.
TEST(ZeroWindow, goesByTimeAndNotByReadings)
{
  ZeroWindow window;
  double time = 0.0;
  for (; time < 5.0; time += 1e-3) window.take(1e9, 0.0, time);
  for (; time < 10.0 + 1e-9; time += 0.1) window.take(1e9 + 2.0, 0.0, time);
  const Zero zero = window.over(10.0 - 0.2);
  EXPECT_NEAR(1e9 + 1.0, zero.hook_load, 0.1);
  EXPECT_NEAR(1.0, zero.hook_load_deviation, 0.05);
}

TEST(ZeroWindow, forgetsWhatHungInAnotherWay)
{
  RigSignals up = lowered(0.0), pumped = lowered(0.0), in_slips = lowered(0.0);
  up.setpoints.winch.block_velocity = 0.05;
  pumped.setpoints.pump.flow = 0.03;
  in_slips.in_slips = true;
  for (const RigSignals& next : {up, pumped, in_slips})
  {
    ZeroMean zero(0.0);
    zero.rings_with(1.0);
    take(zero, Ring{1.0}, 0.0, 10.0);
    EXPECT_GT(zero.window().held(), 9.0);
    take(zero, Ring{1.0}, 10.0, 11.0, next);
    EXPECT_LE(zero.window().held(), 1.0);
  }
  ZeroMean on_bottom(0.0);
  take(on_bottom, Ring{1.0}, 0.0, 10.0);
  RigSignals now = lowered(10.0);
  now.block_height = -0.5;
  on_bottom.take(5e5, now, true);
  EXPECT_EQ(0.0, on_bottom.window().held());
}

// The block stops and the string rings: whenever the driller zeroes, it is the same zero.
TEST(Tare, hitsTheMeanOfARingingHookLoad)
{
  Scene scene = vertical_scene(1000.0, 900.0);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  Simulator rig(scene);
  rig.command(WinchSetpoint{-0.3, false});
  for (int k = 0; k < 300; ++k) ASSERT_EQ(FrameStatus::running, rig.frame(frame));
  rig.command(WinchSetpoint{0.0, true});
  for (int k = 0; k < 400; ++k) ASSERT_EQ(FrameStatus::running, rig.frame(frame));
  double least = 1e9, largest = 0.0, least_zero = 1e9, largest_zero = 0.0;
  for (int k = 0; k < 300; ++k)
  {
    ASSERT_EQ(FrameStatus::running, rig.frame(frame));
    least = std::min(least, rig.truth().hook_load);
    largest = std::max(largest, rig.truth().hook_load);
    if (k % 20 != 0) continue;
    const double zero = zero_of(rig);
    least_zero = std::min(least_zero, zero);
    largest_zero = std::max(largest_zero, zero);
  }
  EXPECT_GT(largest - least, 1e3) << "it rings";
  EXPECT_LT(largest_zero - least_zero, 0.2 * (largest - least));
}

TEST(Tare, overADurationAnswersMeanAndDeviation)
{
  Scene scene = vertical_scene(1000.0, 900.0);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  scene.instruments.hook_load.noise = 2e3;
  Simulator rig(scene);
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < 1200; ++k)
  {
    ASSERT_EQ(FrameStatus::running, rig.frame(frame));
    if (k < 200) continue;
    sum += rig.readings().hook_load;
    squares += rig.readings().hook_load * rig.readings().hook_load;
  }
  const double mean = sum / 1000.0, deviation = std::sqrt(squares / 1000.0 - mean * mean);
  EXPECT_THROW(ask_tare_over(rig, 0.1), std::runtime_error);
  EXPECT_THROW(ask_tare_over(rig, 61.0), std::runtime_error);
  EXPECT_THROW(ask_tare_over(rig, std::nan("")), std::runtime_error);
  EXPECT_THROW(ask_tare_over(rig, 30.0), std::runtime_error) << "it hangs for 12 s";
  EXPECT_FALSE(rig.readings().tared);
  const Zero zero = ask_tare_over(rig, 10.0);
  EXPECT_TRUE(rig.readings().tared);
  EXPECT_NEAR(10.0, zero.duration, 0.25);
  EXPECT_NEAR(mean, zero.hook_load, 20.0);
  EXPECT_NEAR(deviation, zero.hook_load_deviation, 0.02 * deviation);
  EXPECT_GT(deviation, 1.5e3) << "the noise";
  EXPECT_NEAR(zero.hook_load, rig.readings().hook_load + rig.readings().surface_wob, 1e-6);
  EXPECT_NE("", words_of(zero));
}

}  // namespace test_sim_zero_mean
