// SPDX-License-Identifier: BSD-3-Clause
// Faults of all kinds: what is refused, what gauges show of theirs, programs, snapshots, the energy balance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/math/units.h"
#include "drill_ahead.h"
#include "faulty_pair.h"
#include "sim_numbers.h"

namespace test_sim_faults
{
using namespace drill_rig_sim;

TEST(Fault, whatMakesNoSenseIsRefused)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  Simulator rig(motor_drilling_scene(5.0));
  const double bit = rig.truth().bit_depth, bottom = rig.truth().hole_depth;
  const std::vector<unsigned char> before = to_bytes(*rig.save());
  const auto refused = [&](const Fault& fault, const char* says)
  {
    const char* wrong = rig.inject(fault);
    ASSERT_TRUE(wrong) << traits_of(fault.kind).word << " at " << fault.depth << " by " << fault.magnitude;
    EXPECT_NE(std::string(wrong).find(says), std::string::npos) << wrong;
    EXPECT_EQ(std::string(wrong).find('\n'), std::string::npos);
  };
  for (const FaultKind kind :
       {FaultKind::stuck_pipe, FaultKind::differential_sticking, FaultKind::pack_off, FaultKind::washed_out_pipe})
    for (const double nowhere : {0.0, -1.0, bit + 0.1, nan, inf}) refused(at(kind, nowhere, 1e-3), "depth");
  for (const double nowhere : {0.0, -1.0, bottom + 0.1, nan}) refused(at(FaultKind::washed_out_hole, nowhere, 0.1), "depth");
  for (const double nowhere : {-1.0, bottom + 0.1, nan}) refused(at(FaultKind::friction_change, nowhere, 2.0), "depth");
  for (int kind = 0; kind < fault_count; ++kind)
    if (has_magnitude(static_cast<FaultKind>(kind)))
      for (const double senseless : {nan, inf, -inf, 1e12})
        refused(at(static_cast<FaultKind>(kind), 50.0, senseless), "magnitude");
  for (const FaultKind kind : {FaultKind::brake_slip, FaultKind::washed_out_hole, FaultKind::washed_out_pipe,
                               FaultKind::differential_sticking, FaultKind::pack_off, FaultKind::formation_change,
                               FaultKind::sensor_noise, FaultKind::sensor_bias, FaultKind::sensor_drift})
    refused(at(kind, 50.0, 0.0), "magnitude");
  for (const FaultKind kind : {FaultKind::brake_slip, FaultKind::pack_off, FaultKind::friction_change, FaultKind::sensor_noise})
    refused(at(kind, 50.0, -1.0), "magnitude");
  EXPECT_EQ(before, to_bytes(*rig.save())) << "nothing has changed";
  Simulator without_motor(drilling_scene(1.0));
  EXPECT_TRUE(without_motor.inject(at(FaultKind::motor_stall, 0.0)));
}

TEST(Fault, ofAGaugeShowsInItsReadingAlone)
{
  Scene scene = hanging();
  scene.instruments.hook_load.place = HookLoadPlace::block;
  Simulator rig(scene);
  rig.command(WinchSetpoint{0.05, false});
  play(rig, 2.0);
  EXPECT_EQ(rig.truth().block_height, rig.readings().block_height);
  EXPECT_FALSE(rig.inject({FaultKind::sensor_freeze, 0.0, 0.0, Gauge::block_height}));
  EXPECT_FALSE(rig.inject({FaultKind::sensor_bias, 0.0, 1000.0, Gauge::hook_load}));
  EXPECT_FALSE(rig.inject({FaultKind::sensor_drift, 0.0, -200.0, Gauge::dead_line_hook_load}));
  EXPECT_FALSE(rig.inject({FaultKind::sensor_dropout, 0.0, 0.0, Gauge::torque}));
  EXPECT_FALSE(rig.inject({FaultKind::sensor_noise, 0.0, 1e5, Gauge::stand_pipe_pressure}));
  const double height = rig.readings().block_height;
  double squares = 0.0;
  play(rig, 10.0,
       [&](const Truth& truth)
       {
         const Readings& shown = rig.readings();
         squares += std::pow(shown.stand_pipe_pressure - truth.stand_pipe_pressure, 2) / 1000.0;
         EXPECT_EQ(height, shown.block_height);
         EXPECT_EQ(truth.hook_load + 1000.0, shown.hook_load);
         EXPECT_EQ(1u << static_cast<int>(Gauge::torque), shown.lost_gauges);
       });
  EXPECT_NEAR(std::sqrt(squares), 1e5, 1e4);
  EXPECT_NEAR(rig.readings().dead_line_hook_load, rig.truth().dead_line_hook_load - 2000.0, 1.0) << "the dead line's float";
  for (const FaultKind kind : {FaultKind::sensor_freeze, FaultKind::sensor_bias, FaultKind::sensor_drift,
                               FaultKind::sensor_dropout, FaultKind::sensor_noise})
    for (int g = 0; g < gauge_count; ++g) rig.clear(kind, static_cast<Gauge>(g));
  play(rig, 0.1);
  const Readings& shown = rig.readings();
  const Truth& truth = rig.truth();
  EXPECT_EQ(truth.block_height, shown.block_height);
  EXPECT_EQ(truth.hook_load, shown.hook_load);
  EXPECT_EQ(truth.dead_line_hook_load, shown.dead_line_hook_load);
  EXPECT_EQ(truth.stand_pipe_pressure, shown.stand_pipe_pressure);
  EXPECT_EQ(0u, shown.lost_gauges);
}

TEST(Fault, theEnergyBalanceClosesUnderThem)
{
  for (const Level level : {Level::beam3d, Level::axial_torsional})
  {
    Scene scene = slanted_scene(150.0, 0.2);
    scene.numerics.level = level;
    Simulator rig(scene);
    drill_ahead(rig, 40.0 * rpm, 0.02, 0.05);
    play(rig, 3.0);
    for (const Fault& fault : {at(FaultKind::pack_off, 60.0, 2e4), at(FaultKind::differential_sticking, 90.0, 1e7),
                               at(FaultKind::friction_change, 50.0, 1.5)})
      EXPECT_FALSE(rig.inject(fault));
    rig.balance_energy();
    play(rig, 3.0);
    rig.command(WinchSetpoint{0.0, true});
    rig.command(turning(0.0));
    play(rig, 5.0);
    rig.clear(FaultKind::pack_off, Gauge::hook_load);
    rig.command(WinchSetpoint{0.05, false});
    play(rig, 3.0);
    EXPECT_LT(rig.energy().closure(), 0.005) << static_cast<int>(level);
  }
}

TEST(Fault, isOfAProgramAsOfACall)
{
  Scene scene = slanted_scene(150.0, 0.2);
  ProgramStep begins, ends;
  begins.at = 1.0;
  begins.fault = static_cast<int>(FaultKind::pack_off);
  begins.fault_depth = 60.0;
  begins.fault_magnitude = 2e4;
  ends.at = 3.0;
  ends.clear_fault = begins.fault;
  ProgramStep bias = begins;
  bias.at = 2.0;
  bias.fault = static_cast<int>(FaultKind::sensor_bias);
  bias.fault_gauge = static_cast<int>(Gauge::torque);
  Simulator by_call(scene), by_program(scene);
  ProgramPlayer program({begins, bias, ends});
  for (Simulator* rig : {&by_call, &by_program}) rig->command(WinchSetpoint{0.05, false});
  for (int k = 0; k < 400; ++k)
  {
    program.apply(by_program);
    by_program.frame(frame);
    if (k == 100)
    {
      ASSERT_FALSE(by_call.inject(at(FaultKind::pack_off, 60.0, 2e4)));
    }
    if (k == 200)
    {
      ASSERT_FALSE(by_call.inject({FaultKind::sensor_bias, 0.0, 2e4, Gauge::torque}));
    }
    if (k == 300) by_call.clear(FaultKind::pack_off, Gauge::hook_load);
    by_call.frame(frame);
    ASSERT_EQ(by_call.truth().hook_load, by_program.truth().hook_load) << k;
    ASSERT_EQ(by_call.readings().torque, by_program.readings().torque) << k;
  }
  EXPECT_TRUE(program.finished());
  ProgramStep deep = begins;
  deep.fault_depth = 190.0;
  ProgramPlayer below({deep});
  Simulator fails(scene);
  play(fails, 1.0);
  below.apply(fails);
  EXPECT_EQ(fails.frame(frame), FrameStatus::failed);
  EXPECT_STREQ(fails.failure(), "program: fault_depth is below the bit, allowed: where there is pipe in the hole");
}

TEST(Fault, livesInASnapshot)
{
  for (const bool variable : {false, true})
    for (const Level level : {Level::beam3d, Level::axial_torsional})
    {
      Scene scene = slanted_scene(150.0, 0.2);
      scene.string.insert(scene.string.begin() + 1, motor_part(0.0));
      scene.numerics.level = level;
      if (variable) scene.numerics.step = 0.0;
      Simulator rig(scene, 3);
      drill_ahead(rig, 40.0 * rpm, 0.02, 0.02);
      play(rig, 3.0);
      for (const Fault& fault :
           {at(FaultKind::pack_off, 60.0, 2e4), at(FaultKind::differential_sticking, 90.0, 1e6),
            at(FaultKind::friction_change, 50.0, 1.5), at(FaultKind::formation_change, 0.0, 0.5),
            at(FaultKind::washed_out_hole, 100.0, 0.1), at(FaultKind::washed_out_pipe, 30.0, 1e-5),
            at(FaultKind::motor_stall, 0.0), at(FaultKind::pump_trip, 0.0), at(FaultKind::brake_slip, 0.0, 1e5),
            Fault{FaultKind::sensor_bias, 0.0, 5.0, Gauge::torque}, Fault{FaultKind::sensor_drift, 0.0, 5.0, Gauge::flow}})
        EXPECT_FALSE(rig.inject(fault)) << traits_of(fault.kind).word;
      play(rig, 1.0);
      const auto saved = rig.save();
      play(rig, 3.0);
      const auto end = to_bytes(*rig.save());
      Simulator other(scene, 99);
      ASSERT_TRUE(other.restore(*saved));
      play(other, 3.0);
      EXPECT_EQ(end, to_bytes(*other.save())) << variable << static_cast<int>(level);
      for (int kind = 0; kind < fault_count; ++kind) rig.clear(static_cast<FaultKind>(kind), Gauge::torque);
      rig.clear(FaultKind::sensor_drift, Gauge::flow);
      EXPECT_EQ(numbers_of(rig.save()->mechanics.faults), numbers_of(FaultState())) << "nothing is left of them";
      play(rig, 1.0);
    }
}
TEST(Fault, isListedWhileItIsUnderWay)
{
  Simulator rig(motor_drilling_scene(5.0));
  EXPECT_TRUE(words_of(rig.active_faults()).empty());
  for (int k = 0; k < fault_count; ++k)
  {
    const FaultTraits& traits = fault_traits[k];
    Fault fault{static_cast<FaultKind>(k), traits.place == FaultPlace::nowhere ? 0.0 : 50.0,
                traits.magnitude.label ? 0.5 * std::min(1.0, traits.magnitude.most) : 0.0};
    fault.gauge = Gauge::flow;
    ASSERT_EQ(rig.inject(fault), nullptr) << traits.word;
    const std::string word = std::string(traits.word) + (is_of_gauge(fault.kind) ? " of flow" : "");
    EXPECT_EQ(words_of(rig.active_faults()), std::vector<std::string>{word});
    rig.clear(fault.kind, Gauge::flow);
    EXPECT_TRUE(words_of(rig.active_faults()).empty()) << word;
  }
}

TEST(Fault, depthIsReportedWhereThereIsOne)
{
  Simulator rig(motor_drilling_scene(5.0));
  const double bit = rig.truth().bit_depth;
  for (int k = 0; k < fault_count; ++k)
  {
    const FaultTraits& traits = fault_traits[k];
    const bool has_place = traits.place != FaultPlace::nowhere;
    Fault fault{static_cast<FaultKind>(k), has_place ? 50.0 : 0.0,
                traits.magnitude.label ? 0.5 * std::min(1.0, traits.magnitude.most) : 0.0};
    fault.gauge = Gauge::flow;
    ASSERT_EQ(rig.inject(fault), nullptr) << traits.word;
    const std::vector<double> depths = depths_of(rig.active_faults(), rig.fault_depths());
    ASSERT_EQ(depths.size(), 1u) << traits.word;
    // a stuck pipe is gripped at the node next to 50 m
    if (has_place)
      EXPECT_NEAR(depths[0], 50.0, fault.kind == FaultKind::stuck_pipe ? 6.0 : 1e-9) << traits.word;
    else
      EXPECT_TRUE(std::isnan(depths[0])) << traits.word;
    rig.clear(fault.kind, Gauge::flow);
    EXPECT_TRUE(depths_of(rig.active_faults(), rig.fault_depths()).empty()) << traits.word;
  }
  rig.inject({FaultKind::washed_out_pipe, 50.0, 1e-4, Gauge::hook_load});
  rig.inject({FaultKind::sensor_bias, 0.0, 1.0, Gauge::torque});
  play(rig, 5.0);
  const std::vector<double> depths = depths_of(rig.active_faults(), rig.fault_depths());
  ASSERT_EQ(depths.size(), 2u) << "in the order of words_of()";
  EXPECT_TRUE(std::isnan(depths[0])) << words_of(rig.active_faults())[0];
  EXPECT_NEAR(depths[1], 50.0 + rig.truth().bit_depth - bit, 0.01) << "it moves with the pipe";
}

TEST(Fault, isRefusedWithWhatDoesNotApply)
{
  const auto why = [](FaultKind kind, const std::string& gauge, double depth, double magnitude) -> std::string
  {
    try
    {
      require_only_what_applies(kind, gauge, depth, magnitude);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why(FaultKind::drive_trip, "", 0.0, 0.0), "");
  EXPECT_EQ(why(FaultKind::drive_trip, "", 50.0, 0.0), "depth has no effect on drive_trip; allowed is 0");
  EXPECT_EQ(why(FaultKind::drive_trip, "", std::nan(""), 0.0), "depth has no effect on drive_trip; allowed is 0");
  EXPECT_EQ(why(FaultKind::stuck_pipe, "", 50.0, 1.0), "magnitude has no effect on stuck_pipe; allowed is 0");
  EXPECT_EQ(why(FaultKind::pack_off, "flow", 50.0, 1e4), "target has no effect on pack_off; allowed is an empty one");
  EXPECT_EQ(why(FaultKind::sensor_bias, "flow", 0.0, 1e-3), "");
}

}  // namespace test_sim_faults
