#include "drill_rig_sim/ros/frame_publisher.h"

#include <utility>

#include "drill_rig_sim/ros/frame_messages.h"

namespace drill_rig_sim
{
namespace
{
const ros::WallDuration standing_still(0.5);  // longer than any tf_rate in use between two messages
}  // namespace

FramePublisher::FramePublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions,
                               std::function<void()> ask_for_picture)
    : prefix_(parameters.frame_prefix),
      subscriptions_(subscriptions),
      ask_for_picture_(std::move(ask_for_picture)),
      tf_(node.advertise<tf2_msgs::TFMessage>(
          "/tf", 100, [this](const ros::SingleSubscriberPublisher& s) { greet(s); },
          [this](const ros::SingleSubscriberPublisher&) { subscriptions_.tf = tf_.getNumSubscribers() > 0; }))
{
  tf_static_.sendTransform(to_rig_pose(parameters.rig_pose, parameters.floor()));
}

void FramePublisher::publish(const FrameOutput& s)
{
  if (!s.tf_due) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  fill_transforms(s, prefix_, frames_.transforms);
  tf_.publish(frames_);
  sent_ = ros::WallTime::now();
}

void FramePublisher::greet(const ros::SingleSubscriberPublisher& subscriber)
{
  if (!subscriptions_.tf.exchange(true))
  {
    subscriptions_.tf_missing = true;
    ask_for_picture_();
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!frames_.transforms.empty() && ros::WallTime::now() - sent_ > standing_still) subscriber.publish(frames_);
}

}  // namespace drill_rig_sim
