// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_MARKER_PICTURE_H
#define DRILL_RIG_SIM_ROS_MARKER_PICTURE_H

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <string>

#include "drill_rig_sim/realtime/frame_output.h"
#include "drill_rig_sim/ros/parameters.h"

namespace drill_rig_sim
{
/// The rig as rviz draws it: the string coloured by a quantity, the bit, contact forces, the wellbore as a tube, its stations,
/// the travelling block. Fixed namespaces and ids, so each message replaces what it shows; the tube is there when it has changed.
///
/// Lateral exaggeration: the hole's radius, the pipe's and the string's offset from the hole's axis are drawn larger by this
/// factor, because a hole of 0.3 m in a well of 730 m is thinner than a pixel. Lengths along the hole stay true.
///
/// Colours go from teal at 0 to yellow (math/viridis.h) at a full scale that nine nodes in ten stay below; after a peak it
/// falls by 2 % per picture.
class MarkerPicture
{
public:
  explicit MarkerPicture(const Parameters& parameters);
  /// Of a frame whose arrays are filled. Remembers the full scale of the colours.
  visualization_msgs::MarkerArray draw(const FrameOutput& s);
  /// Another rig: forgets the full scale.
  void restart() noexcept { color_full_ = 0.0; }

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
};

}  // namespace drill_rig_sim

#endif
