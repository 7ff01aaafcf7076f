// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_STRING_TUBE_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_STRING_TUBE_H

#include <functional>
#include <vector>

#include "hole_axis.h"
#include "mesh_data.h"
#include "string_data.h"

namespace drill_rig_sim
{
/// The string's outside at a distance from the bit's face [m].
struct OutlinePoint
{
  double from_bit = 0.0;
  double radius = 0.0;
};

/// The string's radius along it, from the bit's top to `total_length`: bodies, tool joints (two thirds of a metre at each joint's
/// lower end), a motor's sleeve. Blades are none of it. `joints`: with tool joints.
std::vector<OutlinePoint> outline_of(const RigData& rig, double total_length, bool joints = true);

/// A node as it is drawn.
struct DrawnNode
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  AxisPoint axis;  ///< the hole's axis nearest to it
};

/// Places of the string's rings among its nodes; they change with its parts alone, not with every message.
class StringTube
{
public:
  /// Takes the string's make; nothing is done where it is the one of before. `joints`: with tool joints.
  void shape(const RigData& rig, const std::vector<double>& from_bit, bool joints = true);
  void forget() { from_bit_.clear(); }

  /// Where the nodes are drawn.
  static std::vector<DrawnNode> place(const StringData& data, const HoleAxis& axis, double exaggeration);
  /// The tube's rings, bit first. `values`: what colours each node; `color`: of a value; `thickness`: of the string's own
  /// diameter.
  const std::vector<Ring>& rings(const std::vector<DrawnNode>& nodes, const std::vector<double>& values,
                                 const std::function<Color(double)>& color, double thickness);

private:
  struct Place
  {
    std::size_t node;  // the lower of the two
    double share;      // towards the upper
    double radius;
  };
  std::vector<double> from_bit_;
  bool joints_ = true;
  std::vector<Place> places_;
  std::vector<Ring> rings_;
};

/// Where, between nodes, a distance from the bit's face lies, as the lower node and the share of the way to the upper one; beyond
/// the ends the share is below 0 or above 1. `from_bit`: at least two, ascending.
struct Between
{
  std::size_t node = 0;
  double share = 0.0;
};
Between between(const std::vector<double>& from_bit, double s) noexcept;

}  // namespace drill_rig_sim

#endif
