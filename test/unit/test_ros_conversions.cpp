// SPDX-License-Identifier: BSD-3-Clause
// Every field of the messages of a frame against the number that was put into it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/ros/accuracy_message.h"
#include "drill_rig_sim/ros/conversions.h"
#include "drill_rig_sim/ros/frame_messages.h"
#include "frame_header.h"
#include "numbered_frame.h"

namespace drill_rig_sim::test_ros_conversions
{
TEST(RigLimitsMessage, eachLimitIsTheScenes)
{
  RigSpec rig;
  rig.hoisting.max_speed = 1.0;
  rig.hoisting.max_acceleration = 2.0;
  rig.hoisting.max_hook_load = 3.0;
  rig.hoisting.lowest_block_height = 4.0;
  rig.hoisting.highest_block_height = 5.0;
  rig.top_drive.max_speed = 6.0;
  rig.top_drive.max_torque = 7.0;
  rig.top_drive.max_power = 8.0;
  rig.mud_pump.max_flow = 9.0;
  std_msgs::Header header;
  header.stamp = ros::Time(12, 345678901);
  header.frame_id = floor_name;
  const RigLimits m = to_rig_limits(rig, header);
  expect_header(m.header, 12, 345678901);
  EXPECT_EQ(1.0, m.max_block_speed);
  EXPECT_EQ(2.0, m.max_block_acceleration);
  EXPECT_EQ(3.0, m.max_hook_load);
  EXPECT_EQ(4.0, m.lowest_block_height);
  EXPECT_EQ(5.0, m.highest_block_height);
  EXPECT_EQ(6.0, m.max_top_drive_speed);
  EXPECT_EQ(7.0, m.max_top_drive_torque);
  EXPECT_EQ(8.0, m.max_top_drive_power);
  EXPECT_EQ(9.0, m.max_flow);
}

TEST(SetPoints, eachFieldComesFromItsOwn)
{
  WinchCommand winch;
  winch.block_velocity = -0.3;
  winch.brake = false;
  EXPECT_EQ(-0.3, to_setpoint(winch).block_velocity);
  EXPECT_FALSE(to_setpoint(winch).brake);
  winch.brake = true;
  EXPECT_TRUE(to_setpoint(winch).brake);

  TopDriveCommand drive;
  drive.speed = 1.0;
  drive.torque = 2.0;
  drive.angle = 3.0;
  drive.torque_limit = 4.0;
  drive.amplitude_right = 5.0;
  drive.amplitude_left = 6.0;
  const std::vector<std::pair<std::uint8_t, TopDriveMode>> modes = {
      {TopDriveCommand::SPEED, TopDriveMode::speed},       {TopDriveCommand::TORQUE, TopDriveMode::torque},
      {TopDriveCommand::ANGLE, TopDriveMode::angle},       {TopDriveCommand::SOFT_TORQUE, TopDriveMode::soft_torque},
      {TopDriveCommand::Z_TORQUE, TopDriveMode::z_torque}, {TopDriveCommand::OSCILLATE, TopDriveMode::oscillate}};
  for (const auto& [said, mode] : modes)
  {
    drive.mode = said;
    EXPECT_EQ(mode, to_setpoint(drive).mode);
  }
  drive.mode = 77;
  EXPECT_EQ(77, static_cast<int>(to_setpoint(drive).mode)) << "an unknown mode stays so";
  EXPECT_EQ(1.0, to_setpoint(drive).speed);
  EXPECT_EQ(2.0, to_setpoint(drive).torque);
  EXPECT_EQ(3.0, to_setpoint(drive).angle);
  EXPECT_EQ(4.0, to_setpoint(drive).torque_limit);
  EXPECT_EQ(5.0, to_setpoint(drive).amplitude_right);
  EXPECT_EQ(6.0, to_setpoint(drive).amplitude_left);
  EXPECT_FALSE(to_setpoint(drive).brake);
  drive.brake = true;
  EXPECT_TRUE(to_setpoint(drive).brake);

  MudPumpCommand pump;
  pump.flow = 0.04;
  EXPECT_EQ(0.04, to_setpoint(pump).flow);
}

TEST(Geometry, pointsVectorsAndTimes)
{
  const geometry_msgs::Point p = to_point({1.0, 2.0, 3.0});
  EXPECT_EQ(1.0, p.x);
  EXPECT_EQ(2.0, p.y);
  EXPECT_EQ(3.0, p.z);
  const geometry_msgs::Vector3 v = to_vector({4.0, 5.0, 6.0});
  EXPECT_EQ(4.0, v.x);
  EXPECT_EQ(5.0, v.y);
  EXPECT_EQ(6.0, v.z);
  EXPECT_EQ(ros::Time(3, 4), to_time(3'000'000'004));
}

TEST(Geometry, quaternionsAreNormalised)
{
  const geometry_msgs::Quaternion q = to_quaternion(Eigen::Quaterniond(2.0, 0.4, -0.6, 0.8));
  const double length = std::sqrt(5.16);
  EXPECT_NEAR(2.0 / length, q.w, 1e-15);
  EXPECT_NEAR(0.4 / length, q.x, 1e-15);
  EXPECT_NEAR(-0.6 / length, q.y, 1e-15);
  EXPECT_NEAR(0.8 / length, q.z, 1e-15);
}

TEST(Geometry, pointingTurnsXIntoTheDirection)
{
  for (const Eigen::Vector3d& direction :
       std::vector<Eigen::Vector3d>{{0.0, 0.0, -1.0}, {0.6, 0.0, -0.8}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}})
    expect_turns(pointing(direction), Eigen::Vector3d::UnitX(), direction);
}

TEST(JointStates, areReadings)
{
  const sensor_msgs::JointState m = to_joint_states(numbered_record());
  EXPECT_EQ(ros::Time(12, 345678901), m.header.stamp);
  EXPECT_EQ((std::vector<std::string>{"traveling_block", "top_drive"}), m.name);
  EXPECT_EQ((std::vector<double>{304.0, 306.0}), m.position);  // block height, angle
  EXPECT_EQ((std::vector<double>{305.0, 307.0}), m.velocity);  // block velocity, speed
  EXPECT_EQ((std::vector<double>{301.0, 308.0}), m.effort);    // hook load, torque
}

TEST(Bit, poseTwistAndWrench)
{
  const FrameRecord frame = numbered_record();
  const geometry_msgs::PoseStamped pose = to_bit_pose(frame, floor_name);
  expect_header(pose.header, 12, 345678901);
  EXPECT_EQ(201.0, pose.pose.position.x);
  EXPECT_EQ(202.0, pose.pose.position.y);
  EXPECT_EQ(203.0, pose.pose.position.z);
  EXPECT_NEAR(2.0 / std::sqrt(5.16), pose.pose.orientation.w, 1e-15);
  EXPECT_NEAR(0.4 / std::sqrt(5.16), pose.pose.orientation.x, 1e-15);
  const geometry_msgs::TwistStamped twist = to_bit_twist(frame, floor_name);
  expect_header(twist.header, 12, 345678901);
  EXPECT_EQ(211.0, twist.twist.linear.x);
  EXPECT_EQ(213.0, twist.twist.linear.z);
  EXPECT_EQ(221.0, twist.twist.angular.x);
  EXPECT_EQ(223.0, twist.twist.angular.z);
  const geometry_msgs::WrenchStamped wrench = to_bit_wrench(frame, floor_name);
  expect_header(wrench.header, 12, 345678901);
  EXPECT_EQ(231.0, wrench.wrench.force.x);
  EXPECT_EQ(233.0, wrench.wrench.force.z);
  EXPECT_EQ(241.0, wrench.wrench.torque.x);
  EXPECT_EQ(243.0, wrench.wrench.torque.z);
}

TEST(Bit, truth)
{
  FrameRecord frame = numbered_record();
  Truth& t = frame.truth;
  t.wob = 1.0;
  t.bit_torque = 2.0;
  t.bit_speed = 3.0;
  t.bit_inclination = 4.0;
  t.bit_azimuth = 5.0;
  t.bend_toolface = 6.0;
  const BitTruth m = to_bit_truth(frame, floor_name);
  expect_header(m.header, 12, 345678901);
  EXPECT_EQ(201.0, m.position.x);
  EXPECT_EQ(203.0, m.position.z);
  EXPECT_EQ((std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}),
            (std::vector<double>{m.wob, m.torque, m.speed, m.inclination, m.azimuth, m.toolface}));
}

TEST(DrillstringStateMessage, eachArrayComesFromItsOwn)
{
  const FrameOutput s = numbered_output();
  DrillstringState m;
  m.position.resize(9);  // what a longer string left
  fill_drillstring_state(s, floor_name, m);
  expect_header(m.header, 12, 345678901);
  EXPECT_EQ((std::vector<double>{601.0, 602.0, 603.0}), m.md);
  EXPECT_EQ((std::vector<double>{611.0, 612.0, 613.0}), m.from_bit);
  EXPECT_EQ((std::vector<double>{621.0, 622.0, 623.0}), m.tension);
  EXPECT_EQ((std::vector<double>{631.0, 632.0, 633.0}), m.true_axial_force);
  EXPECT_EQ((std::vector<double>{641.0, 642.0, 643.0}), m.torque);
  EXPECT_EQ((std::vector<double>{651.0, 652.0, 653.0}), m.bending_moment);
  EXPECT_EQ((std::vector<double>{0.0, 2000.0, 0.0}), m.contact_force);
  EXPECT_EQ((std::vector<double>{671.0, 672.0, 673.0}), m.contact_side);
  EXPECT_EQ((std::vector<double>{681.0, 682.0, 683.0}), m.spin_speed);
  EXPECT_EQ((std::vector<double>{691.0, 692.0, 693.0}), m.bending_stress);
  EXPECT_EQ((std::vector<double>{0.701, 0.702, 0.703}), m.buckling_factor);
  EXPECT_EQ((std::vector<std::uint8_t>{0, 0, 1}), m.guided);
  ASSERT_EQ(3u, m.position.size());
  EXPECT_EQ(4.5, m.position[1].x);
  EXPECT_EQ(5.0, m.position[1].y);
  EXPECT_EQ(-80.0, m.position[2].z);
}

TEST(AccuracyMessage, eachFieldComesFromItsOwn)
{
  FrameRecord frame = numbered_record();
  frame.physics.error_is_measured = true;
  frame.physics.errors = {0.11, 0.12, 0.13, 0.14, 0.15, 0.16};
  frame.physics.companion = {"beam3d", 21, 126, 2.0};
  frame.accuracy.absolute_errors = {31.0, 32.0, 33.0, 34.0, 35.0, 36.0};
  for (std::size_t i = 0; i < output_count; ++i)
    frame.accuracy.statistics[i] = {0.41 + 0.01 * i, 0.51 + 0.01 * i, 0.61 + 0.01 * i, 0.71 + 0.01 * i};
  frame.accuracy.needs = need_torque | need_rop;
  frame.accuracy.tolerance = 0.05;
  const Accuracy m = to_accuracy(frame, floor_name);
  expect_header(m.header, 12, 345678901);
  EXPECT_EQ((std::vector<std::string>{"hook_load", "torque", "wob", "rop", "bit_speed", "stand_pipe_pressure"}), m.outputs);
  EXPECT_EQ((std::vector<std::uint8_t>{0, 1, 0, 1, 0, 0}), m.needed);
  EXPECT_EQ((std::vector<double>{0.11, 0.12, 0.13, 0.14, 0.15, 0.16}), m.error);
  EXPECT_EQ((std::vector<double>{31.0, 32.0, 33.0, 34.0, 35.0, 36.0}), m.absolute);
  EXPECT_EQ(3.0, m.window);
  for (std::size_t i = 0; i < output_count; ++i)
  {
    EXPECT_EQ(0.41 + 0.01 * i, m.mean_error.at(i));
    EXPECT_EQ(0.51 + 0.01 * i, m.deviation_error.at(i));
    EXPECT_EQ(0.61 + 0.01 * i, m.extremes_error.at(i));
    EXPECT_EQ(0.71 + 0.01 * i, m.period_error.at(i));
  }
  EXPECT_EQ(30.0, m.statistics_window);
  EXPECT_EQ(0.05, m.tolerance);
  EXPECT_TRUE(m.measured);
  EXPECT_EQ("beam3d, 21 nodes, 126 coordinates", m.companion);
  EXPECT_EQ("", m.why_not_measured);
  EXPECT_EQ(1.0, m.cost_share) << "all of 2 s";
}

TEST(AccuracyMessage, whatIsNotMeasuredIsNoNumber)
{
  FrameRecord frame = numbered_record();
  frame.physics.not_measured = "too slow";
  const Accuracy m = to_accuracy(frame, floor_name);
  EXPECT_FALSE(m.measured);
  EXPECT_EQ("too slow", m.why_not_measured);
  EXPECT_EQ(output_count, m.error.size());
  for (const double error : m.error) EXPECT_TRUE(std::isnan(error));
  EXPECT_EQ(output_count, m.absolute.size());
  for (const double error : m.absolute) EXPECT_TRUE(std::isnan(error));
  EXPECT_EQ("", m.companion);
  EXPECT_EQ(0.0, m.cost_share);
}

TEST(PathMessage, followsTheWell)
{
  FrameOutput s = numbered_output();
  s.well = {{0.0, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 0.1, 0.2}, {50.0, {3.0, 4.0, -49.0}, {0.6, 0.0, -0.8}, 0.1, 0.2}};
  const nav_msgs::Path path = to_path(s, floor_name);
  expect_header(path.header, 12, 345678901);
  ASSERT_EQ(2u, path.poses.size());
  expect_header(path.poses[1].header, 12, 345678901);
  EXPECT_EQ(3.0, path.poses[1].pose.position.x);
  EXPECT_EQ(-49.0, path.poses[1].pose.position.z);
  expect_turns(path.poses[0].pose.orientation, Eigen::Vector3d::UnitX(), {0.0, 0.0, -1.0});
  expect_turns(path.poses[1].pose.orientation, Eigen::Vector3d::UnitX(), {0.6, 0.0, -0.8});
}

}  // namespace drill_rig_sim::test_ros_conversions
