#ifndef DRILL_RIG_SIM_TEST_SIM_NUMBERS_H
#define DRILL_RIG_SIM_TEST_SIM_NUMBERS_H

#include <cmath>
#include <cstring>
#include <vector>

#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"

/// Every number that a simulator shows or remembers, for comparisons bit by bit.
namespace drill_rig_sim
{
inline void append(std::vector<double>& out, const Eigen::Vector3d& v)
{
  out.insert(out.end(), {v.x(), v.y(), v.z()});
}

inline void append(std::vector<double>& out, const Eigen::Quaterniond& q)
{
  out.insert(out.end(), {q.w(), q.x(), q.y(), q.z()});
}

/// The measured doubles of a frame; `out` is overwritten.
inline void numbers_of(const Measurements& m, std::vector<double>& out)
{
  out.assign({m.time,
              m.hook_load,
              m.dead_line_hook_load,
              m.hook_load_string,
              m.block_height,
              m.block_velocity,
              m.top_drive_angle,
              m.top_drive_speed,
              m.torque,
              m.stand_pipe_pressure,
              m.differential_pressure,
              m.flow,
              m.hole_depth,
              m.bit_depth,
              m.surface_wob,
              m.rop,
              m.wob,
              m.bit_torque,
              m.bit_speed,
              m.bit_inclination,
              m.bit_azimuth,
              m.bend_toolface,
              m.mwd.time,
              m.mwd.md,
              m.mwd.inclination,
              m.mwd.azimuth,
              m.toolface.time,
              m.toolface.toolface,
              static_cast<double>(m.mwd.sequence)});
  for (const Eigen::Vector3d* v : {&m.bit_position, &m.bit_velocity, &m.bit_angular_velocity, &m.bit_force, &m.bit_moment})
    append(out, *v);
  append(out, m.bit_orientation);
}

/// The mechanical state: nodes, elements, drive, hoist, bit and the hole's end.
inline std::vector<double> numbers_of(const SystemState& s)
{
  std::vector<double> out{s.time,
                          s.last_step,
                          s.drive.angle,
                          s.drive.speed,
                          s.drive.last_speed,
                          s.drive.last_increment,
                          s.drive.integral,
                          s.drive.meter_twist,
                          s.hoist.line_length,
                          s.hoist.winch_speed,
                          s.bit.twist,
                          s.bit.motor_speed,
                          s.bit.turned,
                          s.flow,
                          s.well.hole_depth()};
  for (const NodeState& n : s.nodes)
  {
    append(out, n.orientation);
    for (const Eigen::Vector3d* v : {&n.position, &n.rate.velocity, &n.rate.tilt, &n.last_rate.velocity, &n.last_rate.tilt,
                                     &n.last_increment.velocity, &n.last_increment.tilt, &n.acceleration.velocity, &n.acceleration.tilt,
                                     &n.bristle})
      append(out, *v);
    out.insert(out.end(), {n.spin_angle, n.rate.spin, n.last_rate.spin, n.last_increment.spin, n.acceleration.spin});
  }
  append(out, s.bit.rock_velocity);
  append(out, s.well.bottom_position());
  append(out, s.well.bottom_normal());
  return out;
}

inline bool all_finite(const std::vector<double>& numbers)
{
  for (double x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}

inline bool bit_identical(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace drill_rig_sim

#endif
