// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/interpolate.h"

#include <cmath>

namespace drill_rig_sim
{
namespace
{
/// Straight lines between two values at one share of the way.
struct Between
{
  double share;

  double operator()(double a, double b) const noexcept { return a + share * (b - a); }
  Eigen::Vector3d operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const noexcept { return a + share * (b - a); }
  template <class T>
  void operator()(const std::vector<T>& a, const std::vector<T>& b, std::vector<T>& out) const noexcept
  {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = (*this)(a[i], b[i]);
  }
};

constexpr int terms = 10;

/// Of the series of share_of_sine.
struct SineTerms
{
  double square[terms] = {}, constant[terms] = {};

  constexpr SineTerms() noexcept
  {
    for (int i = 1; i <= terms; ++i)
    {
      square[i - 1] = 1.0 / (i * (2 * i + 1));
      constant[i - 1] = static_cast<double>(i) / (2 * i + 1);
    }
  }
};
constexpr SineTerms sine_terms;

/// sin(share angle) / sin(angle) from less = cos(angle) - 1, down to -0.15, to 1e-13 (Eberly, J. Graphics, GPU, and Game Tools 15
/// (2011), 161-176): a fraction of what the sines cost.
double share_of_sine(double share, double less) noexcept
{
  double sum = 1.0;
  for (int i = terms; i-- > 0;) sum = 1.0 + sum * less * (share * share * sine_terms.square[i] - sine_terms.constant[i]);
  return share * sum;
}

/// On the shortest great circle.
Eigen::Quaterniond turned(const Eigen::Quaterniond& a, double share, const Eigen::Quaterniond& b) noexcept
{
  const double dot = a.dot(b), less = std::abs(dot) - 1.0;
  if (less < -0.15) return a.slerp(share, b);
  const double of_b = std::copysign(share_of_sine(share, less), dot);
  return Eigen::Quaterniond(share_of_sine(1.0 - share, less) * a.coeffs() + of_b * b.coeffs());
}

void interpolate_node(const Between& between, const NodeState& a, const NodeState& b, NodeState& out) noexcept
{
  out.position = between(a.position, b.position);
  out.orientation = turned(a.orientation, between.share, b.orientation);
  out.spin_angle = between(a.spin_angle, b.spin_angle);
  out.rate.velocity = between(a.rate.velocity, b.rate.velocity);
  out.rate.tilt = between(a.rate.tilt, b.rate.tilt);
  out.rate.spin = between(a.rate.spin, b.rate.spin);
}

void interpolate_mud(const Between& between, const HydraulicState& a, const HydraulicState& b, HydraulicState& out) noexcept
{
  out.pump_flow = between(a.pump_flow, b.pump_flow);
  out.strokes = between(a.strokes, b.strokes);
  out.stand_pipe_pressure = between(a.stand_pipe_pressure, b.stand_pipe_pressure);
  out.annulus_pressure = between(a.annulus_pressure, b.annulus_pressure);
  out.return_flow = between(a.return_flow, b.return_flow);
}
}  // namespace

void interpolate_nodes(const State& start, const State& end, double share, std::size_t first, std::size_t last,
                       State& out) noexcept
{
  const Between between{share};
  for (std::size_t i = first; i < last; ++i) interpolate_node(between, start.nodes[i], end.nodes[i], out.nodes[i]);
}

void interpolate_rig(const State& start, const State& end, double share, State& out) noexcept
{
  const Between between{share};
  out.time = between(start.time, end.time);
  out.drive.angle = between(start.drive.angle, end.drive.angle);
  out.drive.speed = between(start.drive.speed, end.drive.speed);
  out.hoist.line_length = between(start.hoist.line_length, end.hoist.line_length);
  out.hoist.winch_speed = between(start.hoist.winch_speed, end.hoist.winch_speed);
  out.hoist.sheave_slip = between(start.hoist.sheave_slip, end.hoist.sheave_slip);
  out.hoist.floor.height = between(start.hoist.floor.height, end.hoist.floor.height);
  out.hoist.at_sea = between(start.hoist.at_sea, end.hoist.at_sea);
  out.hoist.floor.speed = between(start.hoist.floor.speed, end.hoist.floor.speed);
  out.bit.motor_speed = between(start.bit.motor_speed, end.bit.motor_speed);
  out.bit.motor_torque = between(start.bit.motor_torque, end.bit.motor_torque);
  out.bit.turned = between(start.bit.turned, end.bit.turned);
  interpolate_mud(between, start.hydraulics, end.hydraulics, out.hydraulics);
  out.flow = between(start.flow, end.flow);
}

void interpolate(const State& start, const State& end, double share, State& out) noexcept
{
  interpolate_rig(start, end, share, out);
  interpolate_nodes(start, end, share, 0, out.nodes.size(), out);
}

void interpolate_loads(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept
{
  const Between between{share};
  between(start.tension, end.tension, out.tension);
  between(start.torque, end.torque, out.torque);
  between(start.bending_moment, end.bending_moment, out.bending_moment);
  between(start.contact, end.contact, out.contact);
  between(start.wall, end.wall, out.wall);
  between(start.span_contact, end.span_contact, out.span_contact);
  between(start.span_wall, end.span_wall, out.span_wall);
}

void interpolate_rig(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept
{
  const Between between{share};
  out.bit_force = between(start.bit_force, end.bit_force);
  out.bit_moment = between(start.bit_moment, end.bit_moment);
  out.rock_force = between(start.rock_force, end.rock_force);
  out.wob = between(start.wob, end.wob);
  out.bit_torque = between(start.bit_torque, end.bit_torque);
  out.motor_torque = between(start.motor_torque, end.motor_torque);
  out.bit_speed = between(start.bit_speed, end.bit_speed);
  out.hook_load = between(start.hook_load, end.hook_load);
  out.block_resistance = between(start.block_resistance, end.block_resistance);
  out.meter_torque = between(start.meter_torque, end.meter_torque);
  out.drive_torque = between(start.drive_torque, end.drive_torque);
  out.gear_friction = between(start.gear_friction, end.gear_friction);
}

void interpolate(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept
{
  interpolate_rig(start, end, share, out);
  interpolate_loads(start, end, share, out);
}

}  // namespace drill_rig_sim
