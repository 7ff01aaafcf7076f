#include "drill_rig_sim/ros/state_publisher.h"

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>

#include "drill_rig_sim/MwdSurvey.h"
#include "drill_rig_sim/MwdToolface.h"
#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
constexpr int queue = 10;

std_msgs::Float64 number(double value)
{
  std_msgs::Float64 m;
  m.data = value;
  return m;
}
}  // namespace

StatePublisher::StatePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions)
    : floor_(parameters.frame_prefix + "rig_floor"),
      subscriptions_(subscriptions),
      hook_load_(node.advertise<std_msgs::Float64>("hook_load", queue)),
      torque_(node.advertise<std_msgs::Float64>("torque", queue)),
      rig_state_(node.advertise<RigState>("rig_state", queue)),
      true_rig_state_(node.advertise<RigState>("truth/rig_state", queue)),
      rig_limits_(node.advertise<RigLimits>("rig_limits", queue, true)),
      joint_states_(node.advertise<sensor_msgs::JointState>("joint_states", queue)),
      bit_pose_(node.advertise<geometry_msgs::PoseStamped>("bit/pose", queue)),
      bit_twist_(node.advertise<geometry_msgs::TwistStamped>("bit/twist", queue)),
      bit_wrench_(node.advertise<geometry_msgs::WrenchStamped>("bit/wrench", queue)),
      mwd_(node.advertise<MwdSurvey>("downhole/mwd", queue)),
      toolface_(node.advertise<MwdToolface>("downhole/toolface", queue)),
      drillstring_(node.advertise<DrillstringState>(
          "drillstring_state", queue, [this](const ros::SingleSubscriberPublisher&) { subscriptions_.profile = true; },
          [this](const ros::SingleSubscriberPublisher&) { subscriptions_.profile = drillstring_.getNumSubscribers() > 0; }))
{
}

void StatePublisher::publish(const FrameOutput& s)
{
  if (s.rebuilt)
  {
    std_msgs::Header header;
    header.stamp = to_time(s.frame.stamp);
    header.frame_id = floor_;
    rig_limits_.publish(to_rig_limits(s.frame.rig, header));
    last_survey_ = last_toolface_ = 0;
  }
  if (s.state_due || s.run_state_changed)
  {
    rig_state_.publish(to_rig_state(s.frame.readings, s.frame, floor_));
    true_rig_state_.publish(to_rig_state(s.frame.truth, s.frame, floor_));
  }
  if (s.state_due)
  {
    publish_rig(s);
    publish_bit(s);
  }
  if (s.new_stamp) publish_telemetry(s);
  if (s.profile_due) publish_profile(s);
}

void StatePublisher::publish_rig(const FrameOutput& s)
{
  const Readings& m = s.frame.readings;
  hook_load_.publish(number(m.hook_load));
  torque_.publish(number(m.torque));

  sensor_msgs::JointState joints;
  joints.header.stamp = to_time(s.frame.stamp);
  joints.name = {"traveling_block", "top_drive"};
  joints.position = {m.block_height, m.top_drive_angle};
  joints.velocity = {m.block_velocity, m.top_drive_speed};
  joints.effort = {m.hook_load, m.torque};
  joint_states_.publish(joints);
}

void StatePublisher::publish_bit(const FrameOutput& s)
{
  const Truth& m = s.frame.truth;
  geometry_msgs::PoseStamped pose;
  pose.header.stamp = to_time(s.frame.stamp);
  pose.header.frame_id = floor_;
  pose.pose.position = to_point(m.bit_position);
  pose.pose.orientation = to_quaternion(m.bit_orientation);
  bit_pose_.publish(pose);

  geometry_msgs::TwistStamped twist;
  twist.header = pose.header;
  twist.twist.linear = to_vector(m.bit_velocity);
  twist.twist.angular = to_vector(m.bit_angular_velocity);
  bit_twist_.publish(twist);

  geometry_msgs::WrenchStamped wrench;
  wrench.header = pose.header;
  wrench.wrench.force = to_vector(m.bit_force);
  wrench.wrench.torque = to_vector(m.bit_moment);
  bit_wrench_.publish(wrench);
}

ros::Time StatePublisher::measured_at(const FrameRecord& frame, double time) const
{
  return to_time(frame.stamp) - ros::Duration(frame.readings.time - time);
}

void StatePublisher::publish_telemetry(const FrameOutput& s)
{
  const MwdReading& survey = s.frame.readings.mwd;
  if (survey.sequence > last_survey_)
  {
    MwdSurvey m;
    m.header.stamp = measured_at(s.frame, survey.time);
    m.header.frame_id = floor_;
    m.md = survey.md;
    m.inclination = survey.inclination;
    m.azimuth = survey.azimuth;
    mwd_.publish(m);
  }
  last_survey_ = survey.sequence;  // a restored state may have gone back
  const ToolfaceReading& toolface = s.frame.readings.toolface;
  if (toolface.sequence > last_toolface_)
  {
    MwdToolface m;
    m.header.stamp = measured_at(s.frame, toolface.time);
    m.header.frame_id = floor_;
    m.toolface = toolface.toolface;
    m.reference = toolface.magnetic ? MwdToolface::MAGNETIC : MwdToolface::GRAVITY;
    toolface_.publish(m);
  }
  last_toolface_ = toolface.sequence;
}

void StatePublisher::publish_profile(const FrameOutput& s)
{
  const StringProfile& from = s.profile;
  profile_.header.stamp = to_time(s.frame.stamp);
  profile_.header.frame_id = floor_;
  profile_.md = from.md;
  profile_.from_bit = from.from_bit;
  profile_.position.resize(from.position.size());
  for (std::size_t i = 0; i < from.position.size(); ++i) profile_.position[i] = to_point(from.position[i]);
  profile_.tension = from.tension;
  profile_.true_axial_force = from.true_axial_force;
  profile_.torque = from.torque;
  profile_.bending_moment = from.bending_moment;
  profile_.contact_force = from.contact_force;
  profile_.contact_side = from.contact_side;
  profile_.spin_speed = from.spin_speed;
  drillstring_.publish(profile_);
}

}  // namespace drill_rig_sim
