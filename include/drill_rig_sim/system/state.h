#ifndef DRILL_RIG_SIM_SYSTEM_STATE_H
#define DRILL_RIG_SIM_SYSTEM_STATE_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
/// Rates of a node. The section normal n splits the angular velocity: tilt (across n) and spin (about n). Both survive a change of n
/// without mixing, and spin is a plain scalar, so any number of turns is as good as none.
struct NodeRate
{
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();      ///< world axes, across n [rad/s]
  double spin = 0.0;                                   ///< [rad/s]
};

/// One node of the string at an instant.
struct NodeState
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();                   ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();      ///< body to world; x towards the bit
  double spin_angle = 0.0;                                              ///< turned since the start, unbounded [rad]
  NodeRate rate;
  NodeRate last_rate;  ///< one step before (multi-step methods)
  NodeRate last_increment;  ///< the last step's increments, in [m, rad, rad] (multi-step methods)
  NodeRate acceleration;  ///< in [m/s2, rad/s2, rad/s2]
  NodeRate averaged_acceleration;  ///< a of the generalised-alpha method, 0 with the others
  Eigen::Vector3d bristle = Eigen::Vector3d::Zero();  ///< of the sticking friction, world axes [m]
  int segment = -1;                                   ///< hole segment of the last contact search
};

/// The rotor of the top drive and its speed loop.
struct DriveState
{
  double angle = 0.0;       ///< [rad], unbounded
  double speed = 0.0;       ///< [rad/s]
  double last_speed = 0.0;  ///< one step before
  double last_increment = 0.0;   ///< the last step's increment [rad]
  double acceleration = 0.0;  ///< [rad/s2]
  double averaged_acceleration = 0.0;  ///< a of the generalised-alpha method
  double integral = 0.0;    ///< of the speed error [rad]
  double meter_twist = 0.0; ///< rotor ahead of the string's top [rad]
  bool limited = false;
};

/// Drill line and winch.
struct HoistState
{
  double line_length = 0.0;  ///< unstretched strung length L_0 [m]
  double winch_speed = 0.0;  ///< of the block, as paid out [m/s], + up
  bool limited = false;
};

/// Bit, rock and motor.
struct BitState
{
  double twist = 0.0;        ///< bristle of the torque on bit [rad]
  double motor_speed = 0.0;  ///< of the bit relative to the string [rad/s]
  double turned = 0.0;       ///< by the motor since the start [rad]
  bool stalled = false;
  Eigen::Vector3d rock_velocity = Eigen::Vector3d::Zero();  ///< of the hole's bottom in the last step [m/s]
};

/// Where the formation holds the pipe.
struct StuckPointState
{
  int node = -1;  ///< -1: none
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double spin_angle = 0.0;
};

/// Everything mechanical that the next step depends on. A copy is a snapshot.
struct SystemState
{
  explicit SystemState(Wellbore hole) : well(std::move(hole)) {}

  Wellbore well;
  double time = 0.0;       ///< [s]
  double last_step = 0.0;  ///< length of the step before; 0: no history, the next step starts a multi-step method [s]
  std::vector<NodeState> nodes;
  DriveState drive;
  HoistState hoist;
  BitState bit;
  StuckPointState stuck_point;
  double flow = 0.0;  ///< of the pump [m3/s]
};

}  // namespace drill_rig_sim

#endif
