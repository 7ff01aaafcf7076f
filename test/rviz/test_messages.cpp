// SPDX-License-Identifier: BSD-3-Clause
// Which field of the messages each reading, limit and flag of the console comes from.
#include <boost/make_shared.hpp>
#include <gtest/gtest.h>

#include <cmath>

#include "rviz/message_values.h"

using namespace drill_rig_sim;
using namespace drill_rig_sim::console;

namespace
{
News with(const RigState& state)
{
  News news;
  news.state = boost::make_shared<RigState>(state);
  return news;
}

RigState tared()
{
  RigState s;
  s.tared = true;
  s.hook_load = 300e3;
  s.surface_wob = 50e3;
  s.torque = 5e3;
  s.top_drive_speed = 10.0;
  s.rop = 0.005;
  s.differential_pressure = 1e6;
  s.block_height = 12.0;
  return s;
}
}  // namespace

TEST(Messages, AFlagIsTheFieldOfItsKey)
{
#define EXPECT_FLAG_OF(field, owner)                                              \
  {                                                                               \
    RigState state;                                                               \
    RigTruth truth;                                                               \
    owner.field = true;                                                           \
    Flags expected;                                                               \
    expected.set(static_cast<std::size_t>(Flag::field));                          \
    EXPECT_EQ(expected, flags_of(state, &truth)) << #field;                       \
    EXPECT_STREQ(#field, flag_rows()[static_cast<std::size_t>(Flag::field)].key); \
  }
#define EXPECT_FLAG(field) EXPECT_FLAG_OF(field, state)
#define EXPECT_TRUE_FLAG(field) EXPECT_FLAG_OF(field, truth)
  EXPECT_FLAG(accuracy_warning)
  EXPECT_FLAG(over_pull)
  EXPECT_FLAG(slack_line)
  EXPECT_TRUE_FLAG(over_stress)
  EXPECT_TRUE_FLAG(over_torque)
  EXPECT_TRUE_FLAG(buckled)
  EXPECT_TRUE_FLAG(motor_stalled)
  EXPECT_FLAG(relief_valve_open)
  EXPECT_FLAG(pump_tripped)
  EXPECT_FLAG(drive_tripped)
  EXPECT_FLAG(commands_timed_out)
  EXPECT_FLAG(command_clamped)
  EXPECT_FLAG(stop_reached)
  EXPECT_FLAG(winch_limited)
  EXPECT_FLAG(top_drive_limited)
  EXPECT_FLAG(brake_set)
  EXPECT_FLAG(top_drive_brake_set)
  EXPECT_FLAG(in_slips)
  EXPECT_TRUE_FLAG(on_bottom)
#undef EXPECT_FLAG
#undef EXPECT_TRUE_FLAG
#undef EXPECT_FLAG_OF
  EXPECT_TRUE(flags_of(RigState(), nullptr).none());
}

TEST(Messages, Readings)
{
  const Values v = readings_of(with(tared()), 0.2159);
  EXPECT_EQ(300e3, v[Quantity::hook_load]);
  EXPECT_EQ(50e3, v[Quantity::surface_wob]);
  EXPECT_EQ(12.0, v[Quantity::block_height]);
  EXPECT_DOUBLE_EQ(specific_energy(50e3, 5e3, 10.0, 0.005, 0.2159), v[Quantity::specific_energy]);
  EXPECT_TRUE(std::isnan(v[Quantity::inclination]));
  EXPECT_STREQ("no survey yet", v.why[index_of(Quantity::inclination)]);
}

TEST(Messages, WithoutATareThereIsNoWeight)
{
  RigState s = tared();
  s.tared = false;
  const Values v = readings_of(with(s), 0.2159);
  for (const Quantity q : {Quantity::surface_wob, Quantity::differential_pressure, Quantity::specific_energy})
  {
    EXPECT_TRUE(std::isnan(v[q]));
    EXPECT_STREQ("not zeroed", v.why[index_of(q)]);
  }
  EXPECT_STREQ("bit size not set", readings_of(with(tared()), 0.0).why[index_of(Quantity::specific_energy)]);
}

TEST(Messages, InTheSlipsThereIsNoWeight)
{
  RigState s = tared();
  s.in_slips = true;
  s.differential_pressure = -8e6;
  const Values v = readings_of(with(s), 0.2159);
  for (const Quantity q : {Quantity::surface_wob, Quantity::differential_pressure, Quantity::specific_energy})
  {
    EXPECT_TRUE(std::isnan(v[q]));
    EXPECT_STREQ("in slips", v.why[index_of(q)]);
  }
  EXPECT_EQ(300e3, v[Quantity::hook_load]);
}

TEST(Messages, OffBottomThereIsNoSpecificEnergy)
{
  RigState s = tared();
  s.hole_depth = s.bit_depth + 0.5;  // the rate of penetration is a mean of 10 s, and still there
  EXPECT_STREQ("not drilling", readings_of(with(s), 0.2159).why[index_of(Quantity::specific_energy)]);
  s = tared();
  s.surface_wob = -2102e3;
  EXPECT_STREQ("not drilling", readings_of(with(s), 0.2159).why[index_of(Quantity::specific_energy)]);
}

TEST(Messages, LostGauges)
{
  RigState s = tared();
  const std::pair<unsigned, Quantity> gauges[] = {
      {RigState::HOOK_LOAD, Quantity::hook_load}, {RigState::DEAD_LINE_HOOK_LOAD, Quantity::dead_line_hook_load},
      {RigState::TORQUE, Quantity::torque},       {RigState::STAND_PIPE_PRESSURE, Quantity::stand_pipe_pressure},
      {RigState::FLOW, Quantity::flow},           {RigState::BLOCK_HEIGHT, Quantity::block_height}};
  for (const auto& [bit, quantity] : gauges)
  {
    s.lost_gauges = bit;
    const Values v = readings_of(with(s), 0.0);
    EXPECT_EQ(1u, v.lost.count());
    EXPECT_TRUE(v.lost[index_of(quantity)]);
  }
}

TEST(Messages, TheLaterInclinationCounts)
{
  News news = with(tared());
  MwdSurvey survey;
  survey.header.stamp = ros::Time(10.0);
  survey.inclination = 0.5;
  survey.azimuth = 2.0;
  MwdInclination inclination;
  inclination.inclination = 0.6;
  inclination.header.stamp = ros::Time(5.0);
  news.survey = boost::make_shared<MwdSurvey>(survey);
  news.inclination = boost::make_shared<MwdInclination>(inclination);
  EXPECT_EQ(0.5, readings_of(news, 0.0)[Quantity::inclination]);
  inclination.header.stamp = ros::Time(15.0);
  news.inclination = boost::make_shared<MwdInclination>(inclination);
  EXPECT_EQ(0.6, readings_of(news, 0.0)[Quantity::inclination]);
  EXPECT_EQ(2.0, readings_of(news, 0.0)[Quantity::azimuth]);
}

TEST(Messages, ErrorsOfTheOutputsThatHaveAGauge)
{
  News news = with(tared());
  EXPECT_TRUE(std::isnan(readings_of(news, 0.0).error[index_of(Quantity::hook_load)]));
  Accuracy accuracy;
  accuracy.outputs = {"hook_load", "torque", "wob", "rop", "bit_speed", "stand_pipe_pressure"};
  accuracy.absolute = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  news.accuracy = boost::make_shared<Accuracy>(accuracy);
  std::array<double, quantity_count> expected = Values().error;
  expected[index_of(Quantity::hook_load)] = 1.0;
  expected[index_of(Quantity::torque)] = 2.0;
  expected[index_of(Quantity::surface_wob)] = 3.0;
  expected[index_of(Quantity::rop)] = 4.0;
  expected[index_of(Quantity::stand_pipe_pressure)] = 6.0;
  const Values v = readings_of(news, 0.0);
  for (std::size_t n = 0; n < quantity_count; ++n)
  {
    const char* key = row_of(static_cast<Quantity>(n)).key;
    if (std::isnan(expected[n]))
      EXPECT_TRUE(std::isnan(v.error[n])) << key;
    else
      EXPECT_EQ(expected[n], v.error[n]) << key;
  }
  EXPECT_EQ(300e3, v[Quantity::hook_load]) << "the number stays what it was";
}

TEST(Messages, TheTruthIsTheBits)
{
  News news;
  RigTruth truth;
  truth.tared = true;
  truth.hook_load = 300e3;
  truth.rop = 0.005;
  news.truth = boost::make_shared<RigTruth>(truth);
  BitTruth bit;
  bit.wob = 40e3;
  bit.torque = 3e3;
  bit.speed = 20.0;
  bit.toolface = 1.0;
  news.bit = boost::make_shared<BitTruth>(bit);
  const Values v = truth_of(news, 0.2159);
  EXPECT_EQ(40e3, v[Quantity::surface_wob]);
  EXPECT_EQ(1.0, v[Quantity::toolface]);
  EXPECT_DOUBLE_EQ(specific_energy(40e3, 3e3, 20.0, 0.005, 0.2159), v[Quantity::specific_energy]);
}

TEST(Messages, AbilitiesByTheirNames)
{
  RigLimits m;
  m.max_hook_load = 1.0;
  m.trip_hook_load = 2.0;
  m.min_hook_load = 3.0;
  m.max_flow = 4.0;
  m.relief_pressure = 5.0;
  m.trip_pressure = 6.0;
  m.max_top_drive_speed = 7.0;
  m.max_top_drive_torque = 8.0;
  m.lowest_block_height = 9.0;
  m.highest_block_height = 10.0;
  m.max_block_speed = 11.0;
  const RigAbilities rig = abilities_of(m);
  EXPECT_EQ(1.0, rig.max_hook_load);
  EXPECT_EQ(2.0, rig.trip_hook_load);
  EXPECT_EQ(3.0, rig.min_hook_load);
  EXPECT_EQ(4.0, rig.max_flow);
  EXPECT_EQ(5.0, rig.relief_pressure);
  EXPECT_EQ(6.0, rig.trip_pressure);
  EXPECT_EQ(7.0, rig.max_top_drive_speed);
  EXPECT_EQ(8.0, rig.max_top_drive_torque);
  EXPECT_EQ(9.0, rig.lowest_block_height);
  EXPECT_EQ(10.0, rig.highest_block_height);
  EXPECT_EQ(11.0, rig.max_block_speed);
}
