#include "drill_rig_sim/ros/frame_publisher.h"

#include <Eigen/Geometry>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
namespace
{
const ros::WallDuration standing_still(0.5);  // longer than any tf_rate in use between two messages

geometry_msgs::Quaternion from_euler(double roll, double pitch, double yaw)
{
  return to_quaternion(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
}

void set_transform(geometry_msgs::TransformStamped& t, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation)
{
  t.transform.translation = to_vector(position);
  t.transform.rotation = to_quaternion(orientation);
}
}  // namespace

FramePublisher::FramePublisher(ros::NodeHandle& node, const Parameters& parameters)
    : prefix_(parameters.frame_prefix),
      tf_(node.advertise<tf2_msgs::TFMessage>("/tf", 100, [this](const ros::SingleSubscriberPublisher& s) { greet(s); }))
{
  const auto& pose = parameters.rig_pose;
  geometry_msgs::TransformStamped t;
  t.header.frame_id = "world";
  t.child_frame_id = prefix_ + "rig_floor";
  t.transform.translation = to_vector({pose[0], pose[1], pose[2]});
  t.transform.rotation = from_euler(pose[3], pose[4], pose[5]);
  tf_static_.sendTransform(t);
}

void FramePublisher::publish(const FrameOutput& s)
{
  if (!s.tf_due) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time stamp = to_time(s.frame.stamp);
  const Truth& m = s.frame.truth;
  const Eigen::Vector3d block = m.block_height * Eigen::Vector3d::UnitZ();
  count_ = 0;
  set_transform(next(stamp, "traveling_block"), block, Eigen::Quaterniond::Identity());
  // clockwise looking downhole is negative about z
  set_transform(next(stamp, "top_drive"), block,
                Eigen::Quaterniond(Eigen::AngleAxisd(-m.top_drive_angle, Eigen::Vector3d::UnitZ())));
  for (const PartPose& part : s.parts) set_transform(next(stamp, part.name), part.position, part.orientation);
  frames_.transforms.resize(count_);
  tf_.publish(frames_);
  sent_ = ros::WallTime::now();
}

geometry_msgs::TransformStamped& FramePublisher::next(const ros::Time& stamp, const std::string& child)
{
  if (frames_.transforms.size() <= count_) frames_.transforms.emplace_back();
  geometry_msgs::TransformStamped& t = frames_.transforms[count_++];
  t.header.stamp = stamp;
  t.header.frame_id = prefix_ + "rig_floor";
  t.child_frame_id = prefix_ + child;
  return t;
}

void FramePublisher::greet(const ros::SingleSubscriberPublisher& subscriber)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!frames_.transforms.empty() && ros::WallTime::now() - sent_ > standing_still) subscriber.publish(frames_);
}

}  // namespace drill_rig_sim
