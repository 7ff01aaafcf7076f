// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/frame_messages.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
// A time of the simulator [s] in the stamps' time: so long before the frame; 0 where that is before the stamps began, as after a
// state of another node was restored.
std_msgs::Header measured_at(const FrameRecord& frame, double time, const std::string& floor)
{
  std_msgs::Header header = to_header(frame.stamp, floor);
  const std::int64_t age = ros::Duration(frame.readings.time - time).toNSec();
  header.stamp = to_time(std::max<std::int64_t>(0, frame.stamp - age));
  return header;
}

geometry_msgs::Quaternion from_euler(double roll, double pitch, double yaw)
{
  return to_quaternion(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
}

void set_pose(geometry_msgs::TransformStamped& t, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation)
{
  t.transform.translation = to_vector(position);
  t.transform.rotation = to_quaternion(orientation);
}
}  // namespace

sensor_msgs::JointState to_joint_states(const FrameRecord& frame)
{
  const Readings& r = frame.readings;
  sensor_msgs::JointState m;
  m.header.stamp = to_time(frame.stamp);
  m.name = {"traveling_block", "top_drive"};
  m.position = {r.block_height, r.top_drive_angle};
  m.velocity = {r.block_velocity, r.top_drive_speed};
  m.effort = {r.hook_load, r.torque};
  return m;
}

geometry_msgs::PoseStamped to_bit_pose(const FrameRecord& frame, const std::string& floor)
{
  geometry_msgs::PoseStamped m;
  m.header = to_header(frame.stamp, floor);
  m.pose.position = to_point(frame.truth.bit_position);
  m.pose.orientation = to_quaternion(frame.truth.bit_orientation);
  return m;
}

geometry_msgs::TwistStamped to_bit_twist(const FrameRecord& frame, const std::string& floor)
{
  geometry_msgs::TwistStamped m;
  m.header = to_header(frame.stamp, floor);
  m.twist.linear = to_vector(frame.truth.bit_velocity);
  m.twist.angular = to_vector(frame.truth.bit_angular_velocity);
  return m;
}

geometry_msgs::WrenchStamped to_bit_wrench(const FrameRecord& frame, const std::string& floor)
{
  geometry_msgs::WrenchStamped m;
  m.header = to_header(frame.stamp, floor);
  m.wrench.force = to_vector(frame.truth.bit_force);
  m.wrench.torque = to_vector(frame.truth.bit_moment);
  return m;
}

BitTruth to_bit_truth(const FrameRecord& frame, const std::string& floor)
{
  const Truth& t = frame.truth;
  BitTruth m;
  m.header = to_header(frame.stamp, floor);
#define BIT(name, field, dimension, value, ...) m.field = value;
#include "drill_rig_sim/scene/signal_list.h"
  return m;
}

MwdSurvey to_mwd_survey(const FrameRecord& frame, const std::string& floor)
{
  const MwdReading& survey = frame.readings.mwd;
  MwdSurvey m;
  m.header = measured_at(frame, survey.time, floor);
  m.md = survey.md;
  m.inclination = survey.inclination;
  m.azimuth = survey.azimuth;
  return m;
}

MwdToolface to_mwd_toolface(const FrameRecord& frame, const std::string& floor)
{
  const ToolfaceReading& toolface = frame.readings.toolface;
  MwdToolface m;
  m.header = measured_at(frame, toolface.time, floor);
  m.toolface = toolface.toolface;
  m.reference = toolface.magnetic ? MwdToolface::MAGNETIC : MwdToolface::GRAVITY;
  return m;
}

MwdInclination to_mwd_inclination(const FrameRecord& frame, const std::string& floor)
{
  const InclinationReading& reading = frame.readings.inclination;
  MwdInclination m;
  m.header = measured_at(frame, reading.time, floor);
  m.md = reading.md;
  m.inclination = reading.inclination;
  return m;
}

DownholeDynamics to_downhole_dynamics(const FrameRecord& frame, const std::string& floor)
{
  const DynamicsReading& reading = frame.readings.dynamics;
  DownholeDynamics m;
  m.header = measured_at(frame, reading.time, floor);
  m.md = reading.md;
  m.duration = reading.duration;
  m.weight = reading.weight;
  m.torque = reading.torque;
  m.bending_moment = reading.bending_moment;
  m.speed = reading.speed;
  m.least_speed = reading.least_speed;
  m.largest_speed = reading.largest_speed;
  m.stick_slip = reading.stick_slip;
  m.axial_acceleration = reading.axial_acceleration;
  m.lateral_acceleration = reading.lateral_acceleration;
  return m;
}

void fill_drillstring_state(const FrameOutput& s, const std::string& floor, DrillstringState& m)
{
  const StringProfile& from = s.profile;
  m.header = to_header(s.frame.stamp, floor);
  m.md = from.md;
  m.from_bit = from.from_bit;
  m.position.resize(from.position.size());
  for (std::size_t i = 0; i < from.position.size(); ++i) m.position[i] = to_point(from.position[i]);
  m.tension = from.tension;
  m.true_axial_force = from.true_axial_force;
  m.torque = from.torque;
  m.bending_moment = from.bending_moment;
  m.contact_force = from.contact_force;
  m.contact_side = from.contact_side;
  m.spin_speed = from.spin_speed;
  m.bending_stress = from.bending_stress;
  m.buckling_factor = from.buckling;
  m.guided = from.guided;
}

nav_msgs::Path to_path(const FrameOutput& s, const std::string& floor)
{
  nav_msgs::Path path;
  path.header = to_header(s.frame.stamp, floor);
  path.poses.resize(s.well.size());
  for (std::size_t i = 0; i < s.well.size(); ++i)
  {
    path.poses[i].header = path.header;
    path.poses[i].pose.position = to_point(s.well[i].position);
    path.poses[i].pose.orientation = pointing(s.well[i].tangent);
  }
  return path;
}

void tell(const FrameRecord& frame, const std::string& floor, StepSimulation::Response& answer)
{
  const Readings& r = frame.readings;
  answer.state = to_rig_state(r, frame, floor);
  answer.truth = to_rig_truth(frame.truth, frame, floor);
  answer.bit = to_bit_truth(frame, floor);
  if (r.toolface.sequence > 0) answer.toolface = {to_mwd_toolface(frame, floor)};
  if (r.mwd.sequence > 0) answer.survey = {to_mwd_survey(frame, floor)};
  if (r.inclination.sequence > 0) answer.inclination = {to_mwd_inclination(frame, floor)};
  if (r.dynamics.sequence > 0) answer.dynamics = {to_downhole_dynamics(frame, floor)};
}

geometry_msgs::TransformStamped to_rig_pose(const std::array<double, 6>& pose, const std::string& floor)
{
  geometry_msgs::TransformStamped t;
  t.header.frame_id = "world";
  t.child_frame_id = floor;
  t.transform.translation = to_vector({pose[0], pose[1], pose[2]});
  t.transform.rotation = from_euler(pose[3], pose[4], pose[5]);
  return t;
}

void fill_transforms(const FrameOutput& s, const std::string& prefix, std::vector<geometry_msgs::TransformStamped>& transforms)
{
  transforms.resize(2 + s.parts.size());
  for (geometry_msgs::TransformStamped& t : transforms) t.header = to_header(s.frame.stamp, prefix + "rig_floor");
  const Truth& m = s.frame.truth;
  const Eigen::Vector3d block = (m.block_height + m.floor_height) * Eigen::Vector3d::UnitZ();
  transforms[0].child_frame_id = prefix + "traveling_block";
  set_pose(transforms[0], block, Eigen::Quaterniond::Identity());
  // clockwise looking downhole is negative about z
  transforms[1].child_frame_id = prefix + "top_drive";
  set_pose(transforms[1], block, Eigen::Quaterniond(Eigen::AngleAxisd(-m.top_drive_angle, Eigen::Vector3d::UnitZ())));
  for (std::size_t i = 0; i < s.parts.size(); ++i)
  {
    transforms[2 + i].child_frame_id = prefix + s.parts[i].name;
    set_pose(transforms[2 + i], s.parts[i].position, s.parts[i].orientation);
  }
}

}  // namespace drill_rig_sim
