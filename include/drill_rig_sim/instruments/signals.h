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

/// The inclination between surveys, by the accelerometers alone.
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

/// The same in a word; empty for none.
const char* text_of(CrewTask task) noexcept;

/// What a tool of dynamics has measured over an interval (dynamics_tool.h).
struct DynamicsReading
{
  std::uint64_t sequence = 0;
  double time = 0.0;      ///< simulated time of the interval's end [s]
  double md = 0.0;        ///< the tool's measured depth [m]
  double duration = 0.0;  ///< [s]
  double weight = 0.0;    ///< mean [N]
  double torque = 0.0;    ///< mean [N m]
  double bending_moment = 0.0;  ///< largest [N m]
  double speed = 0.0, least_speed = 0.0, largest_speed = 0.0;  ///< the first its mean [rad/s]
  double stick_slip = 0.0;            ///< index [-]
  double axial_acceleration = 0.0;    ///< largest [m/s2]
  double lateral_acceleration = 0.0;  ///< [m/s2]

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

/// A rig's signals at one instant. Signs as in commands.h. Each field says what it is in truth; Readings says what instruments make of it.
struct RigSignals
{
  double time = 0.0;  ///< simulated [s]

  double hook_load = 0.0;              ///< load of the lines on the block, block and top drive included [N]
  double dead_line_hook_load = 0.0;    ///< what an ideal sensor at the dead line shows, sheave friction included [N]
  double hook_load_string = 0.0;       ///< hook_load without block and top drive [N]
  double block_height = 0.0;           ///< top-drive shaft above the rotary table [m]
  double block_velocity = 0.0;         ///< + up [m/s]
  double floor_height = 0.0;           ///< of the rotary table above its mean place, where `rig_floor` stays: heave [m]
  double floor_velocity = 0.0;         ///< its rate, + up [m/s]
  double top_drive_angle = 0.0;        ///< [rad], unbounded
  double top_drive_speed = 0.0;        ///< [rad/s]
  double torque = 0.0;                 ///< of the torque meter's spring, + drives the string clockwise [N m]
  double stand_pipe_pressure = 0.0;    ///< [Pa]
  double differential_pressure = 0.0;  ///< of the mud motor, zeroed by tare [Pa]
  double flow = 0.0;                   ///< that the pump delivers [m3/s]
  double stroke_rate = 0.0;            ///< of the pump [1/s]
  double ecd = 0.0;                    ///< equivalent circulating density at the bit, ecd() [kg/m3]
  double hole_depth = 0.0;             ///< [m MD]
  double bit_depth = 0.0;              ///< of the bit's face [m MD]
  double surface_wob = 0.0;            ///< tare - hook_load; 0 until tared, and in the slips [N]
  double rop = 0.0;                    ///< rate of hole_depth over the last frame [m/s]
  bool tared = false;
  bool on_bottom = false;
  bool in_slips = false;            ///< the slips are set
  bool brake_set = false;
  bool motor_stalled = false;
  bool winch_limited = false;       ///< a limit of speed, acceleration, load or height holds the winch back
  bool slack_line = false;          ///< the lines carry nothing
  bool stop_reached = false;        ///< the block is at its lowest or highest place: the winch stands, or the block rests on the stop
  bool relief_valve_open = false;   ///< by the pump: part of its flow goes back to the tanks
  bool over_stress = false;         ///< pipe is stressed beyond its yield strength (sim/string_watch.h)
  bool over_torque = false;         ///< beyond the make-up torque of its connections
  bool buckled = false;             ///< compressed beyond its critical buckling load
  bool accuracy_warning = false;    ///< the simulation may be wrong, the reason is in its diagnostics (sim/accuracy.h)
  bool top_drive_brake_set = false;
  bool top_drive_limited = false;   ///< torque, speed or power limit active
  bool command_clamped = false;     ///< the last command was
  bool commands_timed_out = false;
  bool over_pull = false;           ///< trip_hook_load was reached: the brake is set until a winch command that does not raise
  bool pump_tripped = false;        ///< by trip_pressure or a fault: no flow, after trip_pressure until a flow of 0 is commanded
  bool drive_tripped = false;       ///< by a fault: the top drive coasts
  unsigned lost_gauges = 0;  ///< in a drop-out, each 1 << Gauge
  unsigned pump_strokes = 0;        ///< whole ones of the pump since the start
  int stand_count = 0;              ///< whole stands of the last part's pipe in the string
  CrewTask crew = CrewTask::none;
  Setpoints setpoints;

  /// surface_wob or differential_pressure for a file or a display: NaN, an empty cell there, until they have been zeroed.
  double zeroed(double value) const noexcept { return tared ? value : std::numeric_limits<double>::quiet_NaN(); }

  template <class V>
  void visit(V& v)
  {
    v("time", time);
    v("hook_load", hook_load);
    v("dead_line_hook_load", dead_line_hook_load);
    v("hook_load_string", hook_load_string);
    v("block_height", block_height);
    v("block_velocity", block_velocity);
    v("floor_height", floor_height);
    v("floor_velocity", floor_velocity);
    v("top_drive_angle", top_drive_angle);
    v("top_drive_speed", top_drive_speed);
    v("torque", torque);
    v("stand_pipe_pressure", stand_pipe_pressure);
    v("differential_pressure", differential_pressure);
    v("flow", flow);
    v("stroke_rate", stroke_rate);
    v("ecd", ecd);
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
    v("slack_line", slack_line);
    v("stop_reached", stop_reached);
    v("relief_valve_open", relief_valve_open);
    v("over_stress", over_stress);
    v("over_torque", over_torque);
    v("buckled", buckled);
    v("accuracy_warning", accuracy_warning);
    v("top_drive_brake_set", top_drive_brake_set);
    v("top_drive_limited", top_drive_limited);
    v("command_clamped", command_clamped);
    v("commands_timed_out", commands_timed_out);
    v("over_pull", over_pull);
    v("pump_tripped", pump_tripped);
    v("drive_tripped", drive_tripped);
    v("lost_gauges", lost_gauges);
    v("pump_strokes", pump_strokes);
    v("stand_count", stand_count);
    v("crew", crew);
    v("setpoints", setpoints);
  }
};

/// The rig as it is, and what happens at the bit, where no instrument looks. Positions in `rig_floor` (x east, y north, z up).
struct Truth : RigSignals
{
  Eigen::Vector3d bit_position = Eigen::Vector3d::Zero();  ///< centre of the bit's face [m]
  Eigen::Quaterniond bit_orientation = Eigen::Quaterniond::Identity();  ///< x along the bit's axis, downhole; turns with the bit (motor included)
  Eigen::Vector3d bit_velocity = Eigen::Vector3d::Zero();          ///< of the bit's face, world axes [m/s]
  Eigen::Vector3d bit_angular_velocity = Eigen::Vector3d::Zero();  ///< world axes, motor included [rad/s]
  Eigen::Vector3d bit_force = Eigen::Vector3d::Zero();    ///< rock on bit, world axes [N]
  Eigen::Vector3d bit_moment = Eigen::Vector3d::Zero();   ///< rock on bit about the bit's centre, world axes [N m]
  double wob = 0.0;               ///< >= 0 [N]
  double bit_torque = 0.0;        ///< of the rock on the bit's face, >= 0 when it resists clockwise turning; the gauge's friction on the wall is not in it [N m]
  double bit_flow = 0.0;          ///< through motor and bit [m3/s]
  double bit_speed = 0.0;         ///< string below the motor plus motor [rad/s]
  double bit_inclination = 0.0;   ///< of the hole at its bottom [rad]
  double bit_azimuth = 0.0;       ///< [rad], 0 .. 2 pi
  double bend_toolface = 0.0;     ///< of the bend itself [rad]

  template <class V>
  void visit(V& v)
  {
    RigSignals::visit(v);
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

/// What the driller sees.
/// - hook_load, dead_line_hook_load, torque, stand_pipe_pressure, flow, block_height: gauges, each with its errors (sensor.h); hook_load is the
///   gauge where the scene puts it. lost_gauges: those in a drop-out, which show their last reading.
/// - block_velocity, top_drive_angle, top_drive_speed: by the drives' own encoders, exact. floor_height, floor_velocity: by a motion reference
///   unit, exact. stroke_rate, pump_strokes: the pump's strokes are counted. ecd: as if a tool by the bit sent it at once.
/// - worked out, as a rig does: bit_depth = tally - block_height (the tally is right at the start), hole_depth its largest so far, rop the
///   rate of that over the last 10 s, hook_load_string = hook_load - weight of block and top drive, surface_wob = tare - hook_load,
///   differential_pressure = stand_pipe_pressure - tare, 0 until tared. While the slips bear the string bit_depth is held.
/// - on_bottom, motor_stalled, over_stress, over_torque, buckled: false, no rig can sense them. The other flags are the rig's own and true.
struct Readings : RigSignals
{
  double mean_surface_wob = 0.0;  ///< over a period of the waves where the rig heaves, else surface_wob: for operations [N]
  MwdReading mwd;
  ToolfaceReading toolface;
  InclinationReading inclination;
  DynamicsReading dynamics;

  template <class V>
  void visit(V& v)
  {
    RigSignals::visit(v);
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
