#ifndef DRILL_RIG_SIM_ROS_MARKER_PUBLISHER_H
#define DRILL_RIG_SIM_ROS_MARKER_PUBLISHER_H

#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <string>

#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/ros/simulation_loop.h"
#include "drill_rig_sim/realtime/frame_output.h"

namespace drill_rig_sim
{
/// Draws the rig for rviz: the string coloured by a quantity, the bit, contact forces, the wellbore as a tube, its stations, the
/// travelling block. Fixed namespaces and ids, so each message replaces what it shows; the tube goes out when it has changed.
///
/// Lateral exaggeration: the hole's radius, the pipe's and the string's offset from the hole's axis are drawn larger by this
/// factor, because a hole of 0.3 m in a well of 730 m is thinner than a pixel. Lengths along the hole stay true.
class MarkerPublisher
{
public:
  /// `ask_for_picture` is called when somebody new subscribes.
  MarkerPublisher(ros::NodeHandle& node, const Parameters& parameters, Subscriptions& subscriptions, std::function<void()> ask_for_picture);
  void publish(const FrameOutput& s);

private:
  visualization_msgs::Marker marker(const FrameOutput& s, const std::string& name, int type) const;
  Eigen::Vector3d drawn(const FrameOutput& s, std::size_t i) const;
  visualization_msgs::Marker string_marker(const FrameOutput& s);
  visualization_msgs::Marker bit_marker(const FrameOutput& s) const;
  visualization_msgs::Marker force_marker(const FrameOutput& s) const;
  visualization_msgs::Marker block_marker(const FrameOutput& s) const;
  visualization_msgs::Marker tube_marker(const FrameOutput& s) const;
  visualization_msgs::Marker station_marker(const FrameOutput& s) const;

  std::string floor_;
  double exaggeration_;
  double force_scale_;
  ColorQuantity color_by_;
  double color_full_ = 0.0;  // quantity drawn in the last colour
  Subscriptions& subscriptions_;
  ros::Publisher markers_;
};

}  // namespace drill_rig_sim

#endif
