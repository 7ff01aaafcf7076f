// SPDX-License-Identifier: BSD-3-Clause
// RigState and RigTruth of a frame: every field against the number that was put into it.
#include <gtest/gtest.h>

#include <vector>

#include "drill_rig_sim/ros/conversions.h"
#include "frame_header.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_rig_messages
{
namespace
{
template <class Message>
void expect_numbers(const Message& m, double base)
{
  EXPECT_EQ(base + 1, m.hook_load);
  EXPECT_EQ(base + 2, m.dead_line_hook_load);
  EXPECT_EQ(base + 3, m.hook_load_string);
  EXPECT_EQ(base + 4, m.block_height);
  EXPECT_EQ(base + 5, m.block_velocity);
  EXPECT_EQ(base + 6, m.top_drive_angle);
  EXPECT_EQ(base + 7, m.top_drive_speed);
  EXPECT_EQ(base + 8, m.torque);
  EXPECT_EQ(base + 9, m.stand_pipe_pressure);
  EXPECT_EQ(base + 10, m.differential_pressure);
  EXPECT_EQ(base + 11, m.flow);
  EXPECT_EQ(base + 16, m.ecd);
  EXPECT_EQ(base + 21, m.encoder_bit_depth);
  EXPECT_EQ(base + 22, m.flow_line_temperature);
  EXPECT_EQ(base + 17, m.stroke_rate);
  EXPECT_EQ(base + 18, m.pump_strokes);
  EXPECT_EQ(base + 19, m.floor_height);
  EXPECT_EQ(base + 20, m.floor_velocity);
  EXPECT_EQ(base + 12, m.hole_depth);
  EXPECT_EQ(base + 13, m.bit_depth);
  EXPECT_EQ(base + 14, m.surface_wob);
  EXPECT_EQ(base + 15, m.rop);
}

/// A flag of the simulator and its field.
template <class From, class Message>
struct Flag
{
  bool From::*from;
  std::uint8_t Message::*to;
};

template <class From, class Message>
const std::vector<Flag<From, Message>> common_flags = {{&From::tared, &Message::tared},
                                                       {&From::in_slips, &Message::in_slips},
                                                       {&From::brake_set, &Message::brake_set},
                                                       {&From::winch_limited, &Message::winch_limited},
                                                       {&From::slack_line, &Message::slack_line},
                                                       {&From::stop_reached, &Message::stop_reached},
                                                       {&From::relief_valve_open, &Message::relief_valve_open},
                                                       {&From::accuracy_warning, &Message::accuracy_warning},
                                                       {&From::top_drive_brake_set, &Message::top_drive_brake_set},
                                                       {&From::top_drive_limited, &Message::top_drive_limited},
                                                       {&From::command_clamped, &Message::command_clamped},
                                                       {&From::commands_timed_out, &Message::commands_timed_out},
                                                       {&From::over_pull, &Message::over_pull},
                                                       {&From::pump_tripped, &Message::pump_tripped},
                                                       {&From::drive_tripped, &Message::drive_tripped}};

const std::vector<Flag<Truth, RigTruth>> unsensed_flags = {{&Truth::on_bottom, &RigTruth::on_bottom},
                                                           {&Truth::motor_stalled, &RigTruth::motor_stalled},
                                                           {&Truth::over_stress, &RigTruth::over_stress},
                                                           {&Truth::over_torque, &RigTruth::over_torque},
                                                           {&Truth::buckled, &RigTruth::buckled}};

/// Each flag by itself reaches its own field.
template <class From, class Message, class Convert>
void expect_own(const std::vector<Flag<From, Message>>& flags, From FrameRecord::*from, const Convert& convert)
{
  for (const Flag<From, Message>& set : flags)
  {
    FrameRecord frame = numbered_record();
    (frame.*from).*set.from = true;
    const Message m = convert(frame);
    for (const Flag<From, Message>& flag : flags)
      EXPECT_EQ(flag.to == set.to, bool(m.*flag.to)) << &flag - flags.data() << ", set " << &set - flags.data();
  }
}

}  // namespace

TEST(RigStateMessage, readingsAndTruthComeFromTheirOwnNumbers)
{
  const FrameRecord frame = numbered_record();
  const RigTruth truth = to_rig_truth(frame.truth, frame, floor_name);
  const RigState readings = to_rig_state(frame.readings, frame, floor_name);
  expect_numbers(truth, 100.0);
  expect_numbers(readings, 300.0);
  expect_header(truth.header, 12, 345678901);
  expect_header(readings.header, 12, 345678901);
}

TEST(RigStateMessage, namesTheLostGauges)
{
  const FrameRecord frame = numbered_record();
  EXPECT_EQ(RigState::HOOK_LOAD + RigState::TORQUE, to_rig_state(frame.readings, frame, floor_name).lost_gauges);
  const std::uint32_t bits[gauge_count] = {
      RigState::HOOK_LOAD, RigState::DEAD_LINE_HOOK_LOAD, RigState::TORQUE,           RigState::STAND_PIPE_PRESSURE,
      RigState::FLOW,      RigState::BLOCK_HEIGHT,        RigState::ENCODER_BIT_DEPTH};
  for (int k = 0; k < gauge_count; ++k) EXPECT_EQ(1u << k, bits[k]) << gauge_names[k];
}

TEST(RigStateMessage, eachFlagIsItsOwn)
{
  expect_own(common_flags<Readings, RigState>, &FrameRecord::readings,
             [](const FrameRecord& f) { return to_rig_state(f.readings, f, floor_name); });
}

TEST(RigTruthMessage, eachFlagIsItsOwn)
{
  std::vector<Flag<Truth, RigTruth>> flags = common_flags<Truth, RigTruth>;
  flags.insert(flags.end(), unsensed_flags.begin(), unsensed_flags.end());
  expect_own(flags, &FrameRecord::truth, [](const FrameRecord& f) { return to_rig_truth(f.truth, f, floor_name); });
}

TEST(RigTruthMessage, tellsWhatTheSteerableToolObeys)
{
  FrameRecord frame = numbered_record();
  frame.commands.of(CommandKind::steering) = 5'000'000'005;
  frame.truth.setpoints.steering = {411.0, 0.412};
  frame.truth.setpoints.magnetic_steering = true;
  const RigTruth m = to_rig_truth(frame.truth, frame, floor_name);
  EXPECT_EQ(ros::Time(5, 5), m.steering.header.stamp);
  EXPECT_EQ(411.0, m.steering.toolface);
  EXPECT_EQ(0.412, m.steering.ratio);
  EXPECT_TRUE(m.magnetic_steering);
}

TEST(RigStateMessage, setPointsInForceWithTheStampsOfTheirCommands)
{
  const FrameRecord frame = numbered_record();
  const RigState m = to_rig_state(frame.readings, frame, floor_name);
  EXPECT_EQ(ros::Time(9, 9), m.last_command);
  EXPECT_EQ(ros::Time(7, 7), m.winch.header.stamp);
  EXPECT_EQ(401.0, m.winch.block_velocity);
  EXPECT_FALSE(m.winch.brake);
  EXPECT_EQ(ros::Time(8, 8), m.top_drive.header.stamp);
  EXPECT_EQ(TopDriveCommand::TORQUE, m.top_drive.mode);
  EXPECT_EQ(402.0, m.top_drive.speed);
  EXPECT_EQ(403.0, m.top_drive.torque);
  EXPECT_EQ(404.0, m.top_drive.angle);
  EXPECT_EQ(405.0, m.top_drive.torque_limit);
  EXPECT_EQ(407.0, m.top_drive.amplitude_right);
  EXPECT_EQ(408.0, m.top_drive.amplitude_left);
  EXPECT_EQ(ros::Time(9, 9), m.mud_pump.header.stamp);
  EXPECT_EQ(406.0, m.mud_pump.flow);
  FrameRecord braked = frame;
  braked.truth.setpoints.winch.brake = true;
  EXPECT_TRUE(to_rig_state(frame.readings, braked, floor_name).winch.brake);
  EXPECT_FALSE(m.top_drive.brake);
  braked.truth.setpoints.top_drive.brake = true;
  EXPECT_TRUE(to_rig_state(frame.readings, braked, floor_name).top_drive.brake);
}

TEST(RigStateMessage, runStates)
{
  FrameRecord frame;
  const std::vector<std::pair<RunState, std::uint8_t>> states = {{RunState::running, RigState::RUNNING},
                                                                 {RunState::paused, RigState::PAUSED},
                                                                 {RunState::waiting, RigState::WAITING},
                                                                 {RunState::failed, RigState::FAILED}};
  for (const auto& [state, said] : states)
  {
    frame.run_state = state;
    EXPECT_EQ(said, to_rig_state(frame.readings, frame, "").run_state);
    EXPECT_EQ(said, to_rig_truth(frame.truth, frame, "").run_state);
  }
  EXPECT_EQ(0, RigState::RUNNING);
  EXPECT_EQ(1, RigState::PAUSED);
  EXPECT_EQ(2, RigState::WAITING);
  EXPECT_EQ(3, RigState::FAILED);
  EXPECT_EQ(RigTruth::FAILED, static_cast<int>(RigState::FAILED)) << "the constants of both are alike";
}

}  // namespace drill_rig_sim::test_ros_rig_messages
