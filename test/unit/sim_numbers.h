#ifndef DRILL_RIG_SIM_TEST_SIM_NUMBERS_H
#define DRILL_RIG_SIM_TEST_SIM_NUMBERS_H

#include <cmath>
#include <cstring>
#include <vector>

#include "drill_rig_sim/math/visit.h"
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

struct NumberCollector
{
  std::vector<double> out;
  template <class N>
  void operator()(const std::string&, N& number)
  {
    out.push_back(static_cast<double>(number));
  }
  void size(const std::string&, std::size_t& count) { out.push_back(static_cast<double>(count)); }
};

/// Every number of a value that lists its fields (math/visit.h).
template <class T>
std::vector<double> numbers_of(const T& value)
{
  NumberCollector collector;
  visit_numbers(const_cast<T&>(value), collector);
  return collector.out;
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
