// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_RIG_FORCES_H
#define DRILL_RIG_SIM_MODEL_RIG_FORCES_H

#include <Eigen/Core>
#include <vector>

namespace drill_rig_sim
{
/// Forces at one instant, for those who measure.
struct RigForces
{
  std::vector<double> tension;                           ///< of the elements [N]
  std::vector<double> torque;                            ///< of the elements [N m]
  std::vector<double> bending_moment;                    ///< at the nodes, from the element below [N m]
  std::vector<double> contact;                           ///< normal, at the nodes [N]
  std::vector<Eigen::Vector3d> wall;                     ///< wall on string, at the nodes [N]
  std::vector<double> span_contact;                      ///< normal, at the elements' middles [N]
  std::vector<Eigen::Vector3d> span_wall;                ///< wall on string, at the elements' middles [N]
  Eigen::Vector3d bit_force = Eigen::Vector3d::Zero();   ///< rock on bit [N]
  Eigen::Vector3d bit_moment = Eigen::Vector3d::Zero();  ///< rock on bit about its centre [N m]
  Eigen::Vector3d rock_force = Eigen::Vector3d::Zero();  ///< bit on rock that breaks it: bottom normal and gauge normal [N]
  double wob = 0.0;                                      ///< [N]
  double bit_torque = 0.0;                               ///< rock against the bit's turning [N m]
  double motor_torque = 0.0;      ///< what loads the mud motor: the bit's torque and its gauge's friction [N m]
  double bit_speed = 0.0;         ///< [rad/s]
  double hook_load = 0.0;         ///< of the lines on the block [N]
  double block_resistance = 0.0;  ///< of rail and stops on the block, + up [N]
  double meter_torque = 0.0;      ///< [N m]
  double drive_torque = 0.0;      ///< of the top drive's motor [N m]
  double gear_friction = 0.0;     ///< of its gearbox and brake, on the rotor [N m]

  template <class V>
  void visit(V& v)
  {
    v("tension", tension);
    v("torque", torque);
    v("bending_moment", bending_moment);
    v("contact", contact);
    v("wall", wall);
    v("span_contact", span_contact);
    v("span_wall", span_wall);
    v("bit_force", bit_force);
    v("bit_moment", bit_moment);
    v("rock_force", rock_force);
    v("wob", wob);
    v("bit_torque", bit_torque);
    v("motor_torque", motor_torque);
    v("bit_speed", bit_speed);
    v("hook_load", hook_load);
    v("block_resistance", block_resistance);
    v("meter_torque", meter_torque);
    v("drive_torque", drive_torque);
    v("gear_friction", gear_friction);
  }
};

}  // namespace drill_rig_sim

#endif
