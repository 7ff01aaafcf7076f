// SPDX-License-Identifier: BSD-3-Clause
// What the instruments show: equal to the truth where they are ideal, and off by what the scene says of each gauge where they are
// not.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drill_rig_sim/instruments/instruments.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_ahead.h"
#include "test_scenes.h"

namespace test_sim_readings
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;  // [s]

Scene scene_with(const std::function<void(InstrumentsSpec&)>& change)
{
  Scene scene = motor_drilling_scene(0.02);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  change(scene.instruments);
  return scene;
}

Scene ideal_scene()
{
  return scene_with([](InstrumentsSpec&) {});
}

/// Lowers a turning string onto the bottom and drills, `frames` long.
void drill(Simulator& rig, int frames, const std::function<void()>& after_frame)
{
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  for (int k = 0; k < frames; ++k)
  {
    ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
    after_frame();
  }
}

/// A gauge by name: its specification, its signal in truth, its field in the readings.
struct GaugeField
{
  const char* name;
  SensorSpec& (*spec)(InstrumentsSpec&);
  double RigSignals::*field;
  double size;  // an error that shows, in the signal's unit
};

const GaugeField gauges[] = {
    {"hook_load", [](InstrumentsSpec& s) -> SensorSpec& { return s.hook_load; }, &RigSignals::hook_load, 1000.0},
    {"torque", [](InstrumentsSpec& s) -> SensorSpec& { return s.torque; }, &RigSignals::torque, 50.0},
    {"stand_pipe_pressure", [](InstrumentsSpec& s) -> SensorSpec& { return s.stand_pipe_pressure; },
     &RigSignals::stand_pipe_pressure, 1e5},
    {"flow", [](InstrumentsSpec& s) -> SensorSpec& { return s.flow; }, &RigSignals::flow, 1e-3},
    {"block_height", [](InstrumentsSpec& s) -> SensorSpec& { return s.block_height; }, &RigSignals::block_height, 0.01},
    {"encoder_bit_depth", [](InstrumentsSpec& s) -> SensorSpec& { return s.encoder_bit_depth; }, &RigSignals::encoder_bit_depth,
     0.5},
};
}  // namespace

TEST(Readings, idealInstrumentsAtTheBlockShowTheTruthToTheLastBit)
{
  Simulator rig(ideal_scene());
  drill(rig, 600,
        [&]
        {
          const Truth& t = rig.truth();
          const Readings& r = rig.readings();
          for (const GaugeField& gauge : gauges) ASSERT_EQ(r.*gauge.field, t.*gauge.field) << gauge.name << " at " << t.time;
          ASSERT_EQ(r.time, t.time);
          ASSERT_EQ(r.dead_line_hook_load, t.dead_line_hook_load);
          ASSERT_EQ(r.hook_load_string, t.hook_load_string);
          ASSERT_EQ(r.block_velocity, t.block_velocity);
          ASSERT_EQ(r.top_drive_angle, t.top_drive_angle);
          ASSERT_EQ(r.top_drive_speed, t.top_drive_speed);
        });
  EXPECT_GT(rig.truth().wob, 1e3) << "it drills";
}

// The encoder's depth goes as the block does, has errors of its own, and knows nothing of the string's stretch.
TEST(Readings, theEncodersDepthIsTheStringsLengthBelowTheTable)
{
  Simulator rig(scene_with([](InstrumentsSpec& s) { s.encoder_bit_depth.bias = 0.3; }));
  rig.frame(frame);
  const Readings before = rig.readings();
  EXPECT_EQ(before.encoder_bit_depth, rig.truth().encoder_bit_depth + 0.3);
  EXPECT_NEAR(before.bit_depth, ideal_scene().start.bit_depth, 1e-6) << "worked out from the block's height, without that error";
  const double stretch = rig.truth().bit_depth - rig.truth().encoder_bit_depth;
  EXPECT_GT(stretch, 1e-4);
  EXPECT_LT(stretch, 0.1);
  rig.command(WinchSetpoint{0.1, false});
  for (int k = 0; k < 500; ++k) rig.frame(frame);
  const double raised = rig.truth().block_height - before.block_height;
  EXPECT_GT(raised, 0.3);
  EXPECT_NEAR(before.encoder_bit_depth - rig.readings().encoder_bit_depth, raised, 1e-9);
}

// By default the hook load is the dead line's: after more than 1 cm of raising it carries the least of all lines.
TEST(Readings, hookLoadIsTheDeadLinesByDefault)
{
  Scene scene = ideal_scene();
  scene.instruments.hook_load = HookLoadSpec();
  Simulator rig(scene);
  EXPECT_EQ(scene.instruments.hook_load.place, HookLoadPlace::dead_line);
  rig.command(WinchSetpoint{0.1, false});
  for (int k = 0; k < 200; ++k) rig.frame(frame);
  const Truth& t = rig.truth();
  ASSERT_GT(t.block_velocity, 0.05);
  const HoistingSpec& h = scene.rig.hoisting;
  EXPECT_EQ(rig.readings().hook_load, dead_line_hook_load(t.hook_load, 1.0, h.sheaves, h.sheave_efficiency));
  EXPECT_EQ(rig.readings().hook_load, rig.readings().dead_line_hook_load);
  EXPECT_GT(std::abs(rig.readings().hook_load / t.hook_load - 1.0), 0.05) << "sheaves have friction";
  EXPECT_EQ(rig.readings().hook_load_string, rig.readings().hook_load - standard_gravity * h.block_mass);
}

// One gauge at a time is off by its bias, and no other signal moves; the physics do not feel it.
TEST(Readings, eachGaugeHasItsOwnBias)
{
  for (const GaugeField& off : gauges)
  {
    Simulator ideal(ideal_scene());
    Simulator rig(scene_with([&](InstrumentsSpec& s) { off.spec(s).bias = off.size; }));
    drill_ahead(ideal, 60.0 * rpm, 0.03, 0.01);
    drill(rig, 100,
          [&]
          {
            ideal.frame(frame);
            for (const GaugeField& gauge : gauges)
            {
              const double error = &gauge == &off ? off.size : 0.0;
              ASSERT_NEAR(rig.readings().*gauge.field, ideal.readings().*gauge.field + error, 1e-9 * off.size)
                  << off.name << " on " << gauge.name;
              ASSERT_EQ(rig.truth().*gauge.field, ideal.truth().*gauge.field) << off.name << ": a gauge moves the rig";
            }
          });
  }
}

// Noise of one gauge: its deviation on its own signal, nothing on the others, and not the same noise as another gauge's.
TEST(Readings, eachGaugeHasItsOwnNoise)
{
  std::vector<std::vector<double>> errors;
  for (const GaugeField& off : gauges)
  {
    Simulator rig(scene_with([&](InstrumentsSpec& s) { off.spec(s).noise = off.size; }), 3);
    std::vector<double> error;
    drill(rig, 800,
          [&]
          {
            error.push_back((rig.readings().*off.field - rig.truth().*off.field) / off.size);
            for (const GaugeField& gauge : gauges)
            {
              if (&gauge == &off) continue;
              ASSERT_EQ(rig.readings().*gauge.field, rig.truth().*gauge.field) << off.name << " on " << gauge.name;
            }
          });
    double sum = 0.0, squares = 0.0;
    for (double e : error) sum += e, squares += e * e;
    EXPECT_NEAR(sum / error.size(), 0.0, 4.0 / std::sqrt(error.size())) << off.name;
    EXPECT_NEAR(squares / error.size(), 1.0, 4.0 * std::sqrt(2.0 / error.size())) << off.name;
    errors.push_back(error);
  }
  for (std::size_t a = 0; a < errors.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (int shift = -1; shift <= 1; ++shift)
      {
        double product = 0.0;
        for (std::size_t k = 1; k + 1 < errors[a].size(); ++k) product += errors[a][k] * errors[b][k + shift];
        EXPECT_NEAR(product / errors[a].size(), 0.0, 4.0 / std::sqrt(errors[a].size()))
            << gauges[a].name << ", " << gauges[b].name;
      }
}

// A delay of five frames shows what was five frames ago; a resolution shows whole multiples of it, the nearest.
TEST(Readings, eachGaugeHasItsOwnDelayAndResolution)
{
  for (const GaugeField& off : gauges)
  {
    Simulator late(scene_with([&](InstrumentsSpec& s) { off.spec(s).delay = 5 * frame; }));
    std::vector<double> truth = {late.truth().*off.field};
    drill(late, 200,
          [&]
          {
            truth.push_back(late.truth().*off.field);
            const std::size_t then = truth.size() > 6 ? truth.size() - 6 : 0;
            ASSERT_EQ(late.readings().*off.field, truth[then]) << off.name << " at " << late.truth().time;
          });
    Simulator coarse(scene_with([&](InstrumentsSpec& s) { off.spec(s).resolution = off.size; }));
    drill(coarse, 50,
          [&]
          {
            const double steps = coarse.readings().*off.field / off.size;
            ASSERT_NEAR(steps, std::round(steps), 1e-9) << off.name;
            ASSERT_LE(std::abs(coarse.readings().*off.field - coarse.truth().*off.field), 0.5000001 * off.size) << off.name;
          });
  }
}

// Bit depth is the tally less the block's height, hole depth its largest, whatever the string's stretch makes of the truth.
TEST(Readings, depthsAreWorkedOutFromTheBlocksHeight)
{
  Simulator rig(scene_with([](InstrumentsSpec& s) { s.block_height.bias = 0.004; }));
  const double tally = rig.truth().bit_depth + rig.truth().block_height;
  EXPECT_NEAR(tally, 99.98 + 20.0, 1e-6) << "the tally is right at the start";
  double deepest = 100.0;
  bool apart = false;
  drill(rig, 1000,
        [&]
        {
          const Readings& r = rig.readings();
          ASSERT_NEAR(r.bit_depth, tally - (rig.truth().block_height + 0.004), 1e-9);
          deepest = std::max(deepest, r.bit_depth);
          ASSERT_EQ(r.hole_depth, deepest);
          apart = apart || std::abs(r.bit_depth - 0.004 - rig.truth().bit_depth) > 1e-4;
        });
  EXPECT_TRUE(rig.truth().on_bottom);
  EXPECT_TRUE(apart) << "the string shortens under weight; a block height cannot show it";
  rig.command(WinchSetpoint{0.1, false});
  while (rig.truth().block_velocity <= 0.0) rig.frame(frame);
  deepest = rig.readings().hole_depth;
  for (int k = 0; k < 100; ++k) rig.frame(frame);
  EXPECT_EQ(rig.readings().hole_depth, deepest) << "picking up makes no hole";
  EXPECT_LT(rig.readings().bit_depth, deepest);
}

// In a hole that bends by 0.3 deg a metre the survey tool's sensor, between two nodes, sees an inclination between theirs.
TEST(Readings, surveyToolMeasuresWhereItIs)
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {100.0, 0.0, 1.0}, {300.0, 60.0 * degree, 1.0}}, 300.0, 290.0, 0.2);
  scene.string.insert(scene.string.begin() + 1, mwd_part());
  scene.instruments.mwd.latency = 0.0;
  scene.numerics.element_length = 9.5;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.02});
  while (rig.readings().mwd.sequence == 0) ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
  StringProfile along;
  rig.profile(along);
  const double sensor = 0.3 + 4.0;  // above the bit's face: the bit's length and the tool's offset [m]
  std::size_t upper = 1;
  while (along.from_bit[upper] < sensor) ++upper;
  const auto inclination_at = [&](std::size_t i) { return inclination_of(x_axis(rig.save()->mechanics.nodes[i].orientation)); };
  const double share = (sensor - along.from_bit[upper - 1]) / (along.from_bit[upper] - along.from_bit[upper - 1]);
  const double below = inclination_at(upper - 1), above = inclination_at(upper);
  ASSERT_GT(std::abs(below - above), 0.5 * degree);
  EXPECT_NEAR(below + share * (above - below), rig.readings().mwd.inclination, 0.01 * degree);
  EXPECT_NEAR(rig.truth().bit_depth - sensor, rig.readings().mwd.md, 1e-9);
}

// 2 mm/s from 3 s on: 0 before; rising with the part of the window that has drilled; then the rate.
TEST(RateMeter, isTheMeanOverTheWindow)
{
  RateMeter meter;
  for (int k = 0; k <= 3000; ++k)
  {
    const double t = 0.01 * k, depth = 100.0 + 0.002 * std::max(t - 3.0, 0.0);
    const double rate = meter.rate(depth, t);
    double wanted = 0.002, error = 1e-12;
    if (t <= 10.0)
      wanted = t > 3.0 ? 0.002 * (t - 3.0) / t : 0.0;  // as long as there is
    else if (t < 13.6)
      wanted = 0.002 * std::min((t - 3.0) / 10.0, 1.0), error = 0.06 * 0.002;  // the oldest sample is up to 0.5 s younger
    ASSERT_NEAR(rate, wanted, error) << t;
  }
}

// Slow frames make no longer window; where they are longer than the window, it is theirs.
TEST(RateMeter, windowIsOfTimeNotOfCalls)
{
  for (const double frame : {0.5, 1.0, 2.5, 20.0})
  {
    RateMeter meter;
    const double window = std::max(10.0, frame);
    for (int k = 0; k <= 40; ++k)
    {
      const double t = frame * k, begin = 20.0 * frame;
      const double wanted = 0.002 * std::clamp((t - begin) / window, 0.0, 1.0);
      ASSERT_NEAR(meter.rate(100.0 + 0.002 * std::max(t - begin, 0.0), t), wanted, 1e-12) << frame << " s, at " << t;
    }
  }
}

// The zero is what the gauge showed, its bias included; a second tare takes another zero.
// Its own zero each: of the readings what the gauges show, the hook load in the mean (ZeroMean), of the truth what is true.
TEST(Readings, tareTakesTheReadings)
{
  Simulator rig(scene_with(
      [](InstrumentsSpec& s)
      {
        s.hook_load.bias = 5e3;
        s.stand_pipe_pressure.bias = 2e5;
      }));
  rig.command(PumpSetpoint{0.03});
  for (int k = 0; k < 20; ++k) rig.frame(frame);
  EXPECT_EQ(rig.readings().surface_wob, 0.0);
  EXPECT_EQ(rig.readings().differential_pressure, 0.0) << "no zero yet";
  ASSERT_TRUE(rig.tare());
  const double first = rig.readings().hook_load + rig.readings().surface_wob, pressure = rig.readings().stand_pipe_pressure;
  const double first_truth = rig.truth().hook_load + rig.truth().surface_wob;
  EXPECT_TRUE(rig.readings().tared);
  EXPECT_NEAR(first, first_truth + 5e3, 5.0);
  EXPECT_NEAR(rig.readings().surface_wob, 0.0, 1e3) << "at once";
  rig.command(WinchSetpoint{0.2, false});
  rig.command(PumpSetpoint{0.02});
  for (int k = 0; k < 30; ++k)
  {
    rig.frame(frame);
    EXPECT_NEAR(rig.readings().surface_wob, first - rig.readings().hook_load, 1e-6);
    EXPECT_EQ(rig.readings().differential_pressure, rig.readings().stand_pipe_pressure - pressure);
    EXPECT_NEAR(rig.truth().surface_wob, first_truth - rig.truth().hook_load, 1e-6);
  }
  ASSERT_TRUE(rig.tare());
  const double second = rig.readings().hook_load + rig.readings().surface_wob;
  EXPECT_GT(std::abs(second - first), 100.0);
  EXPECT_EQ(rig.readings().differential_pressure, 0.0);
  rig.frame(frame);
  EXPECT_NEAR(rig.readings().surface_wob, second - rig.readings().hook_load, 1e-6);
}

// At constant flow what the gauge shows over its tare is the motor's, a little later: the mean over two seconds.
TEST(Readings, differentialPressureIsTheMotorsAtConstantFlow)
{
  Scene scene = ideal_scene();
  scene.rig.mud_pump.flow_ramp = 1e3;
  scene.rig.mud_pump.pressure_coefficient = 0.0;  // nor surge of the string that follows the bit
  scene.mud.bulk_modulus = 1e11;
  Simulator rig(scene);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.0);
  for (int k = 0; k < 200; ++k) rig.frame(frame);
  ASSERT_TRUE(rig.tare());
  drill(rig, 600, [] {});
  double shown = 0.0, true_one = 0.0;
  drill(rig, 200,
        [&]
        {
          shown += rig.readings().differential_pressure / 200.0;
          true_one += rig.truth().differential_pressure / 200.0;
        });
  EXPECT_NEAR(shown, true_one, 0.02 * true_one);
  EXPECT_GT(true_one, 1e4) << "the motor works";
}

// The truth's rate of penetration is the rate of the hole's depth, frame by frame.
TEST(Truth, ropIsTheRateOfTheHolesDepth)
{
  Simulator rig(ideal_scene());
  double before = rig.truth().hole_depth, drilled = 0.0;
  drill(rig, 800,
        [&]
        {
          ASSERT_NEAR(rig.truth().rop, (rig.truth().hole_depth - before) / frame, 1e-12);
          before = rig.truth().hole_depth;
          drilled += rig.truth().rop * frame;
        });
  EXPECT_NEAR(drilled, rig.truth().hole_depth - 100.0, 1e-9);
  EXPECT_GT(drilled, 0.01);
}
}  // namespace test_sim_readings
