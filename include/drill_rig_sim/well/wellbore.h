#ifndef DRILL_RIG_SIM_WELL_WELLBORE_H
#define DRILL_RIG_SIM_WELL_WELLBORE_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// The nine numbers of a wellbore node.
struct WellNode
{
  double md = 0.0;                                    ///< material coordinate l [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ(); ///< unit, down the hole
  double radius = 0.0;                                ///< [m]
  double friction = 0.0;                              ///< kinetic [-]
};

/// The hole's cross section nearest to a point D: where c(md) satisfies (r_D - c) . c' = 0.
struct HoleSite
{
  double md = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();      ///< unit
  Eigen::Vector3d centre_slope = -Eigen::Vector3d::UnitZ(); ///< dc/dmd, nearly the tangent
  Eigen::Vector3d md_gradient = -Eigen::Vector3d::UnitZ();  ///< d md / d r_D = c' / (|c'|^2 - (r_D - c) . c'')
  double radius = 0.0;
  double radius_slope = 0.0;  ///< dR/dmd
  double friction = 0.0;
  int segment = 0;     ///< start of the next search
  int iterations = 0;  ///< Newton iterations used
};

}  // namespace drill_rig_sim

#endif
