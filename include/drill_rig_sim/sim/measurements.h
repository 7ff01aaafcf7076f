#ifndef DRILL_RIG_SIM_SIM_MEASUREMENTS_H
#define DRILL_RIG_SIM_SIM_MEASUREMENTS_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/sim/commands.h"

namespace drill_rig_sim
{
/// A survey by the MWD, as it reaches the surface.
struct MwdReading
{
  std::uint64_t sequence = 0;  ///< counts readings; a change means a new one has arrived
  double time = 0.0;           ///< simulated time of measurement [s]
  double md = 0.0;             ///< sensor's measured depth [m]
  double inclination = 0.0;    ///< [rad]
  double azimuth = 0.0;        ///< [rad], 0 .. 2 pi

  template <class V>
  void visit(V& v)
  {
    v("sequence", sequence);
    v("time", time);
    v("md", md);
    v("inclination", inclination);
    v("azimuth", azimuth);
  }
};

struct ToolfaceReading
{
  std::uint64_t sequence = 0;
  double time = 0.0;      ///< simulated time of measurement [s]
  double toolface = 0.0;  ///< [rad], -pi .. pi
  bool magnetic = false;  ///< true: from north (inclination below 5 deg), false: from the high side

  template <class V>
  void visit(V& v)
  {
    v("sequence", sequence);
    v("time", time);
    v("toolface", toolface);
    v("magnetic", magnetic);
  }
};

/// Everything that one frame publishes, at one instant. Signs as in commands.h; positions in `rig_floor` (x east, y north, z up).
struct Measurements
{
  double time = 0.0;  ///< simulated [s]

  double hook_load = 0.0;            ///< true load of the lines on the block [N]
  double dead_line_hook_load = 0.0;  ///< what the sensor at the dead line reads [N]
  double hook_load_string = 0.0;     ///< hook_load without block and top drive [N]
  double block_height = 0.0;         ///< top-drive shaft above the rotary table [m]
  double block_velocity = 0.0;       ///< + up [m/s]
  double top_drive_angle = 0.0;      ///< [rad], unbounded
  double top_drive_speed = 0.0;      ///< [rad/s]
  double torque = 0.0;               ///< torque meter, + drives the string clockwise [N m]
  double stand_pipe_pressure = 0.0;  ///< [Pa]
  double differential_pressure = 0.0;  ///< motor's, zeroed by tare [Pa]
  double flow = 0.0;                 ///< [m3/s]
  double hole_depth = 0.0;           ///< [m MD]
  double bit_depth = 0.0;            ///< [m MD]
  double surface_wob = 0.0;          ///< tare - hook load; 0 until tared [N]
  double rop = 0.0;                  ///< rate of the hole's depth [m/s]
  bool tared = false;
  bool on_bottom = false;
  bool in_slips = false;
  bool brake_set = false;
  bool motor_stalled = false;
  bool winch_limited = false;      ///< a limit of speed, acceleration, load or height holds the winch back
  bool top_drive_limited = false;  ///< torque, speed or power limit active
  bool command_clamped = false;    ///< the set points in force were clamped
  bool commands_timed_out = false;
  Setpoints setpoints;

  // the truth at the bit
  Eigen::Vector3d bit_position = Eigen::Vector3d::Zero();  ///< centre of the bit's face [m]
  Eigen::Quaterniond bit_orientation = Eigen::Quaterniond::Identity();  ///< x along the bit's axis, downhole; turns with the bit (motor included)
  Eigen::Vector3d bit_velocity = Eigen::Vector3d::Zero();          ///< world axes [m/s]
  Eigen::Vector3d bit_angular_velocity = Eigen::Vector3d::Zero();  ///< world axes, motor included [rad/s]
  Eigen::Vector3d bit_force = Eigen::Vector3d::Zero();    ///< rock on bit, world axes [N]
  Eigen::Vector3d bit_moment = Eigen::Vector3d::Zero();   ///< rock on bit about the bit's centre, world axes [N m]
  double wob = 0.0;               ///< >= 0 [N]
  double bit_torque = 0.0;        ///< >= 0 when the rock resists clockwise turning [N m]
  double bit_speed = 0.0;         ///< string below the motor plus motor [rad/s]
  double bit_inclination = 0.0;   ///< of the hole at its bottom [rad]
  double bit_azimuth = 0.0;       ///< [rad], 0 .. 2 pi
  double bend_toolface = 0.0;     ///< of the bend itself [rad]

  MwdReading mwd;
  ToolfaceReading toolface;

  template <class V>
  void visit(V& v)
  {
    v("time", time);
    v("hook_load", hook_load);
    v("dead_line_hook_load", dead_line_hook_load);
    v("hook_load_string", hook_load_string);
    v("block_height", block_height);
    v("block_velocity", block_velocity);
    v("top_drive_angle", top_drive_angle);
    v("top_drive_speed", top_drive_speed);
    v("torque", torque);
    v("stand_pipe_pressure", stand_pipe_pressure);
    v("differential_pressure", differential_pressure);
    v("flow", flow);
    v("hole_depth", hole_depth);
    v("bit_depth", bit_depth);
    v("surface_wob", surface_wob);
    v("rop", rop);
    v("tared", tared);
    v("on_bottom", on_bottom);
    v("in_slips", in_slips);
    v("brake_set", brake_set);
    v("motor_stalled", motor_stalled);
    v("winch_limited", winch_limited);
    v("top_drive_limited", top_drive_limited);
    v("command_clamped", command_clamped);
    v("commands_timed_out", commands_timed_out);
    v("setpoints", setpoints);
    v("bit_position", bit_position);
    v("bit_orientation", bit_orientation);
    v("bit_velocity", bit_velocity);
    v("bit_angular_velocity", bit_angular_velocity);
    v("bit_force", bit_force);
    v("bit_moment", bit_moment);
    v("wob", wob);
    v("bit_torque", bit_torque);
    v("bit_speed", bit_speed);
    v("bit_inclination", bit_inclination);
    v("bit_azimuth", bit_azimuth);
    v("bend_toolface", bend_toolface);
    v("mwd", mwd);
    v("toolface", toolface);
  }
};

/// Quantities along the string, one entry per node, bit first.
struct StringProfile
{
  std::vector<double> md;              ///< of the node's place in the well; negative above the rotary table [m]
  std::vector<double> from_bit;        ///< unstretched distance from the bit's face [m]
  std::vector<Eigen::Vector3d> position;
  std::vector<double> tension;         ///< effective [N]
  std::vector<double> true_axial_force;  ///< [N]
  std::vector<double> torque;          ///< [N m]
  std::vector<double> bending_moment;  ///< magnitude [N m]
  std::vector<double> contact_force;   ///< normal, wall on string [N]
  std::vector<Eigen::Vector3d> contact_vector;  ///< normal plus friction, wall on string, world axes [N]
  std::vector<double> contact_side;    ///< clockwise from high side looking downhole [rad]
  std::vector<double> spin_speed;      ///< [rad/s]
  std::vector<double> radius;          ///< outer radius drawn at the node [m]
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
