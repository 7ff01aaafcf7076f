// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_SIGNALS_H
#define DRILL_RIG_SIM_INSTRUMENTS_SIGNALS_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>

#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_rig_sim/rig/setpoints.h"

/// The values of the rig in a frame, twice: as it is (Truth) and as its instruments show it (Readings).
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

/// Inclination between surveys, from the accelerometers only.
struct InclinationReading
{
  std::uint64_t sequence = 0;
  double time = 0.0;         ///< simulated time of measurement [s]
  double md = 0.0;           ///< sensor's measured depth [m]
  double inclination = 0.0;  ///< [rad]

  template <class V>
  void visit(V& v)
  {
    v("sequence", sequence);
    v("time", time);
    v("md", md);
    v("inclination", inclination);
  }
};

/// What the rig's crew is about (crew.h).
enum class CrewTask
{
  none,
  stopping,    ///< the block, for a connection by `connections: auto`
  lifting,     ///< the bit off bottom
  quieting,    ///< drive and pump come to rest
  slacking,    ///< the weight goes to the slips
  connecting,  ///< pipe is added or taken away; by make_connection too
  picking_up,  ///< the weight comes back to the hook
  restarting,  ///< drive and pump go back to their set points
  lowering     ///< to where the bit was
};

/// Name of the task; empty for none.
const char* text_of(CrewTask task) noexcept;

/// Measurements of a dynamics tool over an interval (dynamics_tool.h).
struct DynamicsReading
{
  std::uint64_t sequence = 0;
  double time = 0.0;                                           ///< simulated time of the interval's end [s]
  double md = 0.0;                                             ///< the tool's measured depth [m]
  double duration = 0.0;                                       ///< [s]
  double weight = 0.0;                                         ///< mean [N]
  double torque = 0.0;                                         ///< mean [N m]
  double bending_moment = 0.0;                                 ///< largest [N m]
  double speed = 0.0, least_speed = 0.0, largest_speed = 0.0;  ///< the first its mean [rad/s]
  double stick_slip = 0.0;                                     ///< index [-]
  double axial_acceleration = 0.0;                             ///< largest [m/s2]
  double lateral_acceleration = 0.0;                           ///< [m/s2]

  template <class V>
  void visit(V& v)
  {
    v("sequence", sequence);
    v("time", time);
    v("md", md);
    v("duration", duration);
    v("weight", weight);
    v("torque", torque);
    v("bending_moment", bending_moment);
    v("speed", speed);
    v("least_speed", least_speed);
    v("largest_speed", largest_speed);
    v("stick_slip", stick_slip);
    v("axial_acceleration", axial_acceleration);
    v("lateral_acceleration", lateral_acceleration);
  }
};

/// A rig's signals at one instant, in SI units and the signs of commands.h: the fields of truth and readings alike. The list of
/// signals (scene/signal_list.h) gives their meaning.
struct RigSignals
{
  double time = 0.0;  ///< simulated [s]
#define BOTH(type, name, ...) type name{};
#include "drill_rig_sim/scene/signal_list.h"
  CrewTask crew = CrewTask::none;
  Setpoints setpoints;

  template <class V>
  void visit(V& v)
  {
    v("time", time);
#define BOTH(type, name, ...) v(#name, name);
#include "drill_rig_sim/scene/signal_list.h"
    v("crew", crew);
    v("setpoints", setpoints);
  }
};

/// Those of the truth, with what no rig can sense.
struct TrueSignals : RigSignals
{
#define TRUTH(type, name, ...) type name{};
#include "drill_rig_sim/scene/signal_list.h"

  template <class V>
  void visit(V& v)
  {
    RigSignals::visit(v);
#define TRUTH(type, name, ...) v(#name, name);
#include "drill_rig_sim/scene/signal_list.h"
  }
};

/// Those of the readings, with what instruments say of themselves.
struct ShownSignals : RigSignals
{
#define READING(type, name, ...) type name{};
#include "drill_rig_sim/scene/signal_list.h"

  /// surface_wob or differential_pressure for a file or a display: NaN, an empty cell there, until they have been zeroed.
  double zeroed(double value) const noexcept
  {
    return tared ? value : std::numeric_limits<double>::quiet_NaN();
  }

  template <class V>
  void visit(V& v)
  {
    RigSignals::visit(v);
#define READING(type, name, ...) v(#name, name);
#include "drill_rig_sim/scene/signal_list.h"
  }
};

/// The rig as it is, and what happens at the bit, where no instrument looks. Positions in `rig_floor` (x east, y north, z up).
struct Truth : TrueSignals
{
  Eigen::Vector3d bit_position = Eigen::Vector3d::Zero();  ///< centre of the bit's face [m]
  Eigen::Quaterniond bit_orientation =
      Eigen::Quaterniond::Identity();  ///< x along the bit's axis, downhole; turns with the bit (motor included)
  Eigen::Vector3d bit_velocity = Eigen::Vector3d::Zero();          ///< of the bit's face, world axes [m/s]
  Eigen::Vector3d bit_angular_velocity = Eigen::Vector3d::Zero();  ///< world axes, motor included [rad/s]
  Eigen::Vector3d bit_force = Eigen::Vector3d::Zero();             ///< rock on bit, world axes [N]
  Eigen::Vector3d bit_moment = Eigen::Vector3d::Zero();            ///< rock on bit about the bit's centre, world axes [N m]
  double wob = 0.0;                                                ///< >= 0 [N]
  double bit_torque = 0.0;  ///< of the rock on the bit's face, >= 0 when it resists clockwise turning; the gauge's friction on
                            ///< the wall is not in it [N m]
  double bit_flow = 0.0;    ///< through motor and bit [m3/s]
  double bit_speed = 0.0;   ///< string below the motor plus motor [rad/s]
  double bit_inclination = 0.0;  ///< of the hole at its bottom [rad]
  double bit_azimuth = 0.0;      ///< [rad], 0 .. 2 pi
  double bend_toolface = 0.0;    ///< of the bend itself [rad]

  template <class V>
  void visit(V& v)
  {
    TrueSignals::visit(v);
    v("bit_position", bit_position);
    v("bit_orientation", bit_orientation);
    v("bit_velocity", bit_velocity);
    v("bit_angular_velocity", bit_angular_velocity);
    v("bit_force", bit_force);
    v("bit_moment", bit_moment);
    v("wob", wob);
    v("bit_torque", bit_torque);
    v("bit_flow", bit_flow);
    v("bit_speed", bit_speed);
    v("bit_inclination", bit_inclination);
    v("bit_azimuth", bit_azimuth);
    v("bend_toolface", bend_toolface);
  }
};

/// By which two models of the same rig are compared.
inline Outputs outputs_of(const Truth& m) noexcept
{
  return {m.hook_load, m.torque, m.wob, m.rop, m.bit_speed, m.stand_pipe_pressure};
}

/// What the driller sees: each signal as the list says under `reading`. surface_wob, differential_pressure: 0 until tared.
struct Readings : ShownSignals
{
  double mean_surface_wob = 0.0;  ///< over a period of the waves where the rig heaves, else surface_wob: for operations [N]
  MwdReading mwd;
  ToolfaceReading toolface;
  InclinationReading inclination;
  DynamicsReading dynamics;

  template <class V>
  void visit(V& v)
  {
    ShownSignals::visit(v);
    v("mean_surface_wob", mean_surface_wob);
    v("mwd", mwd);
    v("toolface", toolface);
    v("inclination", inclination);
    v("dynamics", dynamics);
  }
};

/// The same as the instruments show them; bit speed, which none shows, as it is.
inline Outputs outputs_of(const Readings& shown, const Truth& m) noexcept
{
  return {shown.hook_load, shown.torque, shown.surface_wob, shown.rop, m.bit_speed, shown.stand_pipe_pressure};
}

}  // namespace drill_rig_sim

#endif
