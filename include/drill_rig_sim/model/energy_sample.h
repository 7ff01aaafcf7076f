// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_ENERGY_SAMPLE_H
#define DRILL_RIG_SIM_MODEL_ENERGY_SAMPLE_H

#include <Eigen/Core>
#include <array>
#include <vector>

namespace drill_rig_sim
{
/// Energy that rig, string and contacts hold at an instant [J].
struct StoredEnergy
{
  double kinetic = 0.0;      ///< of translation: nodes with added mass, block
  double turning = 0.0;      ///< kinetic, of the nodes' rotation
  double rotor = 0.0;        ///< of the top drive, kinetic
  double beams = 0.0;        ///< stretch, bending, shear, torsion
  double line = 0.0;         ///< E A (L - L_0)^2 / (2 L_0) of the drill line
  double meter = 0.0;        ///< torque meter's spring
  double gear = 0.0;         ///< held by the friction of gearbox and brake
  double block = 0.0;        ///< held by the friction of the block's rail, and in its stops
  double wall = 0.0;         ///< k delta^(e + 1) / (e + 1)
  double bottom = 0.0;       ///< the same of the bit on the bottom
  double bristles = 0.0;     ///< sticking friction at the wall, k_b z^2 / 2
  double bit_bristle = 0.0;  ///< sticking bit
  double stuck_point = 0.0;  ///< formation that holds the pipe, and slips
  double weight = 0.0;       ///< - (weight in mud of this step) . places: only its change within a step means anything

  double kinetic_all() const noexcept { return kinetic + turning + rotor; }
  double elastic_all() const noexcept
  {
    return beams + line + meter + gear + block + wall + bottom + bristles + bit_bristle + stuck_point;
  }
};

/// Forces that act on the nodes, in the residual's sign (they resist the motion) and coordinates, 6 per node.
enum class NodeForce
{
  inertia,
  beams,       ///< elastic part, dead load's end moments left out
  wall,        ///< gradient of the wall's energy
  structural,  ///< damping part of the elements
  mud,
  squeeze_film,
  wall_damping,  ///< Hunt and Crossley's part of the normal force
  friction,
  ledge,  ///< what the wall's force lacks of the gradient where the radius changes (wall_contact.h: "sideways, never along")
  stuck_point,  ///< gradient of the stuck point's and the slips' energy
  pads,         ///< of a rotary steerable tool
  oscillator,   ///< of a tool that shakes the string
  unsolved,     ///< the residual that the method left
  count
};

/// At the pivot of a tool that points the bit (pointing.h): moments of the element below on the shaft's end, and how far that has
/// turned beyond the collar.
struct ShaftSample
{
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();   ///< that holds it [N m]
  Eigen::Vector3d elastic = Eigen::Vector3d::Zero();  ///< of that, without load and damping [N m]
  Eigen::Vector3d damping = Eigen::Vector3d::Zero();  ///< [N m]
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();     ///< since the start of the step [rad]
};

/// All that an energy balance takes from one instant.
struct EnergySample
{
  StoredEnergy stored;
  std::array<std::vector<double>, static_cast<std::size_t>(NodeForce::count)> force;
  std::vector<double> rate;       ///< 6 per node
  std::vector<double> increment;  ///< since the start of the step, 6 per node
  double step = 0.0;              ///< since the start of the step [s]
  ShaftSample shaft;

  // bit
  Eigen::Vector3d bottom = Eigen::Vector3d::Zero();          ///< elastic force of the bottom, residual's sign [N]
  Eigen::Vector3d bottom_damping = Eigen::Vector3d::Zero();  ///< the rest of it [N]
  double bottom_elastic = 0.0;                               ///< magnitudes of the two [N]
  double bottom_damped = 0.0;
  double rock_speed = 0.0;        ///< at which the bottom recedes along its normal [m/s]
  double rock_advance = 0.0;      ///< how far it did in the step [m]
  double bit_torque = 0.0;        ///< T [N m]
  double bit_speed = 0.0;         ///< spin of the string's end plus the motor's [rad/s]
  double gauge_torque = 0.0;      ///< of the wall's friction on the bit, against its turning [N m]
  double motor_speed = 0.0;       ///< in this step [rad/s]
  double motor_flow_speed = 0.0;  ///< what the flow would turn it at without slip (mud_motor.h) [rad/s]; 0: no motor

  // rig
  double hook_force = 0.0;        ///< [N]
  double line_damping = 0.0;      ///< of lines and sheaves, on the block, + up [N]
  double winch_speed = 0.0;       ///< [m/s], + up
  double block_resistance = 0.0;  ///< of rail and stops, + up [N]
  double line_price = 0.0;        ///< T + T^2/(2 EA), energy that a metre of unstretched line paid out takes from the line [N]
  double line_paid_out = 0.0;     ///< L_0 since the start of the step [m]
  double pay_out = 0.0;           ///< dL_0/dt as the drum turns [m/s]
  double floor_speed = 0.0;       ///< of the rotary table, that heaves [m/s]
  double floor_moved = 0.0;       ///< since the start of the step [m]
  double slips_force = 0.0;       ///< of the slips on the string, + up [N]
  double drive_torque = 0.0;      ///< of the top drive's motor [N m]
  double gear_friction = 0.0;     ///< of its gearbox and brake, on the rotor [N m]
  double rotor_speed = 0.0;       ///< [rad/s]
  double rotor_inertia = 0.0;     ///< J dw/dt [N m]
  double rotor_increment = 0.0;   ///< in the step [rad]
};

}  // namespace drill_rig_sim

#endif
