// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_DRAWN_RIG_H
#define DRILL_RIG_SIM_SRC_RVIZ_DRAWN_RIG_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ogre_vector.h"
#include "picture/hole_axis.h"
#include "picture/string_tube.h"
#include "picture/well_picture.h"

namespace drill_rig_sim
{
/// What is to be drawn, in the axes of the rig floor: what came last of each message, checked.
struct DrawnRig
{
  std::string floor;  ///< name of its frame, prefix included
  std::optional<RigData> rig;
  std::optional<HoleAxis> axis;
  std::optional<StringData> string;
  std::vector<DrawnNode> nodes;  ///< of the string, where they are drawn
  struct Fault
  {
    std::string name;
    double md;  ///< NaN: it has no place [m]
  };
  std::vector<Fault> faults;  ///< under way
  struct Law
  {
    std::string name, phase, leads;
    std::vector<std::pair<std::string, double>> set_points;  ///< as ControllerStatus has them
    std::vector<Eigen::Vector3d> plan;                       ///< empty: it does not steer
  };
  std::optional<Law> law;  ///< that commands the rig

  /// The path that the hole is to follow: of the law that steers, else of the scene. Where there is a rig.
  const std::vector<Eigen::Vector3d>& plan() const noexcept { return law && !law->plan.empty() ? law->plan : rig->plan; }

  bool complete() const noexcept { return rig && axis && string && nodes.size() == string->size(); }
  /// The middle of the bit's face as it is drawn. Where complete() alone.
  Eigen::Vector3d bit_face() const;
  /// Measured depth of the bit's face [m]. Where there is a string.
  double bit_md() const noexcept { return string->md.front() + string->from_bit.front(); }
  /// The hole reaches the bit, which may have come here before the hole that it has drilled: straight on, in whole centimetres.
  /// Whether it has grown.
  bool reach_bit();
  /// What stands before frames' names.
  std::string prefix() const;
};

inline Ogre::Vector3 to_ogre(const Eigen::Vector3d& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline Eigen::Vector3d to_eigen(const Ogre::Vector3& v)
{
  return {v.x, v.y, v.z};
}

}  // namespace drill_rig_sim

#endif
