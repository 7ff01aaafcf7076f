#include "drill_rig_sim/ros/trajectory_publisher.h"

#include <nav_msgs/Path.h>

#include "drill_rig_sim/ros/conversions.h"

namespace drill_rig_sim
{
TrajectoryPublisher::TrajectoryPublisher(ros::NodeHandle& node, const Parameters& parameters)
    : floor_(parameters.frame_prefix + "rig_floor"), trajectory_(node.advertise<nav_msgs::Path>("trajectory", 10, true))
{
}

void TrajectoryPublisher::publish(const FrameOutput& s)
{
  if (!s.well_due || !s.new_stamp) return;  // a latched path needs no repeating
  nav_msgs::Path path;
  path.header.stamp = to_time(s.frame.stamp);
  path.header.frame_id = floor_;
  path.poses.resize(s.well.size());
  for (std::size_t i = 0; i < s.well.size(); ++i)
  {
    path.poses[i].header = path.header;
    path.poses[i].pose.position = to_point(s.well[i].position);
    path.poses[i].pose.orientation = pointing(s.well[i].tangent);
  }
  trajectory_.publish(path);
}

}  // namespace drill_rig_sim
