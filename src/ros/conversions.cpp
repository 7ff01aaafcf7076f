// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/conversions.h"

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
ros::Time to_time(std::int64_t stamp)
{
  return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp));
}

std_msgs::Header to_header(std::int64_t stamp, const std::string& frame_id)
{
  std_msgs::Header header;
  header.stamp = to_time(stamp);
  header.frame_id = frame_id;
  return header;
}

std_msgs::Float64 to_number(double value)
{
  std_msgs::Float64 m;
  m.data = value;
  return m;
}

geometry_msgs::Point to_point(const Eigen::Vector3d& v)
{
  geometry_msgs::Point p;
  p.x = v.x();
  p.y = v.y();
  p.z = v.z();
  return p;
}

geometry_msgs::Vector3 to_vector(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 p;
  p.x = v.x();
  p.y = v.y();
  p.z = v.z();
  return p;
}

geometry_msgs::Quaternion to_quaternion(const Eigen::Quaterniond& q)
{
  const Eigen::Quaterniond unit = q.normalized();
  geometry_msgs::Quaternion m;
  m.x = unit.x();
  m.y = unit.y();
  m.z = unit.z();
  m.w = unit.w();
  return m;
}

geometry_msgs::Quaternion pointing(const Eigen::Vector3d& direction)
{
  return to_quaternion(shortest_turn(Eigen::Vector3d::UnitX(), direction));
}

WinchSetpoint to_setpoint(const WinchCommand& m)
{
  WinchSetpoint s;
  s.block_velocity = m.block_velocity;
  s.brake = m.brake;
  return s;
}

TopDriveSetpoint to_setpoint(const TopDriveCommand& m)
{
  TopDriveSetpoint s;
  s.mode = static_cast<TopDriveMode>(m.mode);
  s.speed = m.speed;
  s.torque = m.torque;
  s.angle = m.angle;
  s.torque_limit = m.torque_limit;
  s.brake = m.brake;
  s.amplitude_right = m.amplitude_right;
  s.amplitude_left = m.amplitude_left;
  return s;
}

PumpSetpoint to_setpoint(const MudPumpCommand& m)
{
  PumpSetpoint s;
  s.flow = m.flow;
  return s;
}

SteeringSetpoint to_setpoint(const SteeringCommand& m)
{
  SteeringSetpoint s;
  s.toolface = m.toolface;
  s.ratio = m.ratio;
  return s;
}

namespace
{
template <class Message>
void copy_setpoints(const FrameRecord& frame, Message& m)
{
  const Setpoints& s = frame.truth.setpoints;
  m.last_command = to_time(frame.commands.last);
  m.winch.header.stamp = to_time(frame.commands.of(CommandKind::winch));
  m.winch.block_velocity = s.winch.block_velocity;
  m.winch.brake = s.winch.brake;
  m.top_drive.header.stamp = to_time(frame.commands.of(CommandKind::top_drive));
  m.top_drive.mode = static_cast<std::uint8_t>(s.top_drive.mode);
  m.top_drive.speed = s.top_drive.speed;
  m.top_drive.torque = s.top_drive.torque;
  m.top_drive.angle = s.top_drive.angle;
  m.top_drive.torque_limit = s.top_drive.torque_limit;
  m.top_drive.brake = s.top_drive.brake;
  m.top_drive.amplitude_right = s.top_drive.amplitude_right;
  m.top_drive.amplitude_left = s.top_drive.amplitude_left;
  m.mud_pump.header.stamp = to_time(frame.commands.of(CommandKind::mud_pump));
  m.mud_pump.flow = s.pump.flow;
}

void copy_steering(const FrameRecord& frame, RigTruth& m)
{
  const Setpoints& s = frame.truth.setpoints;
  m.steering.header.stamp = to_time(frame.commands.of(CommandKind::steering));
  m.steering.toolface = s.steering.toolface;
  m.steering.ratio = s.steering.ratio;
  m.magnetic_steering = s.magnetic_steering;
}

std::uint8_t to_run_state(RunState state)
{
  switch (state)
  {
    case RunState::running:
      return RigTruth::RUNNING;
    case RunState::paused:
      return RigTruth::PAUSED;
    case RunState::waiting:
      return RigTruth::WAITING;
    case RunState::failed:
      return RigTruth::FAILED;
  }
  return RigTruth::FAILED;
}
/// What both messages have.
template <class Message>
Message to_message(const RigSignals& from, const FrameRecord& frame, const std::string& frame_id)
{
  Message m;
  m.header.stamp = to_time(frame.stamp);
  m.header.frame_id = frame_id;
  m.run_state = to_run_state(frame.run_state);
  m.epoch = frame.epoch;
#define BOTH(type, name, ...) m.name = from.name;
#include "drill_rig_sim/scene/signal_list.h"
  m.current_operation = what_is_done(frame);
  m.operation_number = static_cast<std::uint32_t>(frame.operation.number);
  m.operation_progress = frame.operation.progress;
  copy_setpoints(frame, m);
  return m;
}
}  // namespace

std::string what_is_done(const FrameRecord& frame)
{
  if (frame.truth.crew != CrewTask::none) return text_of(frame.truth.crew);
  return frame.operation.number > 0 ? word_of(frame.operation.kind) : "";
}

RigState to_rig_state(const ShownSignals& from, const FrameRecord& frame, const std::string& frame_id)
{
  RigState m = to_message<RigState>(from, frame, frame_id);
#define READING(type, name, ...) m.name = from.name;
#include "drill_rig_sim/scene/signal_list.h"
  m.accuracy_code = code_of(frame.physics.accuracy.doubt);
  m.accuracy_reason = text_of(frame.physics.accuracy);
  m.commands_refused = static_cast<std::uint32_t>(frame.commands_refused);
  m.last_refusal = frame.last_refusal;
  return m;
}

RigTruth to_rig_truth(const TrueSignals& from, const FrameRecord& frame, const std::string& frame_id)
{
  RigTruth m = to_message<RigTruth>(from, frame, frame_id);
#define TRUTH(type, name, ...) m.name = from.name;
#include "drill_rig_sim/scene/signal_list.h"
  copy_steering(frame, m);
  m.active_faults = words_of(frame.faults);
  m.active_fault_depths = depths_of(frame.faults, frame.fault_depths);
  return m;
}

RigLimits to_rig_limits(const RigSpec& rig, const std_msgs::Header& header)
{
  RigLimits m;
  m.header = header;
  m.max_block_speed = rig.hoisting.max_speed;
  m.max_block_acceleration = rig.hoisting.max_acceleration;
  m.max_hook_load = rig.hoisting.max_hook_load;
  m.lowest_block_height = rig.hoisting.lowest_block_height;
  m.highest_block_height = rig.hoisting.highest_block_height;
  m.max_top_drive_speed = rig.top_drive.max_speed;
  m.max_top_drive_torque = rig.top_drive.max_torque;
  m.max_top_drive_power = rig.top_drive.max_power;
  m.max_flow = rig.mud_pump.max_flow;
  m.min_hook_load = rig.hoisting.min_hook_load;
  m.trip_hook_load = rig.hoisting.trip_hook_load;
  m.relief_pressure = rig.mud_pump.relief_pressure;
  m.trip_pressure = rig.mud_pump.trip_pressure;
  return m;
}

}  // namespace drill_rig_sim
