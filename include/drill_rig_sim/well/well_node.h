// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_WELL_NODE_H
#define DRILL_RIG_SIM_WELL_WELL_NODE_H

#include <Eigen/Core>

namespace drill_rig_sim
{
/// How wide and how rough a hole is at one depth.
struct HoleWall
{
  double radius = 0.0;    ///< [m]
  double friction = 0.0;  ///< kinetic [-]
  double section = 0.0;   ///< as WellNode's
};

/// The nine numbers of a wellbore node, and its hole section.
struct WellNode
{
  double md = 0.0;                                      ///< material coordinate l [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();  ///< unit, down the hole
  double radius = 0.0;                                  ///< [m]
  double friction = 0.0;                                ///< kinetic [-]
  double section = 0.0;                                 ///< index of the hole section it lies in

  template <class V>
  void visit(V& v)
  {
    v("md", md);
    v("position", position);
    v("tangent", tangent);
    v("radius", radius);
    v("friction", friction);
    v("section", section);
  }
};

}  // namespace drill_rig_sim

#endif
