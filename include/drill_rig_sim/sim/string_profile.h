// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_STRING_PROFILE_H
#define DRILL_RIG_SIM_SIM_STRING_PROFILE_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace drill_rig_sim
{
/// Quantities along the string, one entry per node, bit first.
struct StringProfile
{
  std::vector<double> md;        ///< of the node's place in the well; negative above the rotary table [m]
  std::vector<double> from_bit;  ///< unstretched distance from the bit's face [m]
  std::vector<Eigen::Vector3d> position;
  std::vector<double> tension;           ///< effective [N]
  std::vector<double> true_axial_force;  ///< [N]
  std::vector<double> torque;            ///< [N m]
  std::vector<double> bending_moment;    ///< magnitude [N m]
  std::vector<double> contact_force;  ///< normal, wall on string: the node's own and half of what the elements beside it have at
                                      ///< their middles [N]
  std::vector<Eigen::Vector3d> contact_vector;  ///< normal plus friction, wall on string, world axes [N]
  std::vector<double> contact_side;             ///< clockwise from high side looking downhole [rad]
  std::vector<double> spin_speed;               ///< [rad/s]
  std::vector<double> radius;                   ///< outer radius drawn at the node [m]
  std::vector<double>
      bending_stress;  ///< of the outer fibre, only by the bending moment; of the elements that meet there the larger [Pa]
  std::vector<double> buckling;       ///< buckling_share() (string_watch.h), of the elements that meet there the larger [-]
  std::vector<unsigned char> guided;  ///< 1: only along the hole and about it
};

/// Pose of a named string part: x along the string towards the bit, origin at the part's lower end.
struct PartPose
{
  std::string name;  ///< bottom-hole parts by name, `pipe_<n>` for every k-th joint
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

}  // namespace drill_rig_sim

#endif
