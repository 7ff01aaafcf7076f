// From the state to the truth.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/well/directions.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

void Simulator::Impl::measure() noexcept
{
  measure_string_built();
  measure_rig();
  measure_bit();
  measure_string();
}

/// That the motor's torque needs [Pa].
double Simulator::Impl::motor_pressure() const noexcept
{
  const State& s = shown();
  const MotorSpec* motor = model->motor();
  return motor ? mud_motor_pressure(s.flow, motor->pressure_displacement(), motor_load(*model, s)) : 0.0;
}

void Simulator::Impl::measure_rig() noexcept
{
  Truth& m = state.truth;
  const State& s = shown();
  const HoistingSpec& hoisting = scene.rig.hoisting;
  m.time = s.time;
  measure_block();
  m.top_drive_angle = s.drive.angle;
  m.top_drive_speed = s.drive.speed;
  m.flow = s.hydraulics.pump_flow;
  m.stroke_rate = m.flow / scene.rig.mud_pump.stroke_volume;
  m.pump_strokes = static_cast<unsigned>(s.hydraulics.strokes);
  m.relief_valve_open = s.hydraulics.relief_open;
  m.stand_pipe_pressure = s.hydraulics.stand_pipe_pressure;
  m.differential_pressure = motor_pressure() - state.tare_pressure;
  m.tared = state.tared;
  m.surface_wob = state.tared && !m.in_slips ? state.tare_hook_load - m.hook_load : 0.0;
  m.setpoints = in_force();
  state.zero_mean.take(m.hook_load, m, shown_forces().wob > 0.0);
  m.brake_set = m.setpoints.winch.brake;
  m.winch_limited = s.hoist.limited;
  m.slack_line = line_pull(hoisting, block_height(s), s.hoist.line_length).slack;
  m.stop_reached = s.hoist.at_stop || stop_force(hoisting, block_height(s), block_velocity(s)).energy > 0.0;
  m.top_drive_brake_set = s.drive.braked;
  m.top_drive_limited = s.drive.limited;
  m.motor_stalled = s.bit.stalled;
  m.command_clamped = state.commands.clamped;
  m.commands_timed_out = state.commands.timed_out();
  m.over_pull = state.interlocks.over_pull;
  m.pump_tripped = state.interlocks.over_pressure || s.faults.pump_tripped;
  m.drive_tripped = s.faults.drive_tripped;
}

void Simulator::Impl::measure_bit() noexcept
{
  Truth& m = state.truth;
  const State& s = shown();
  const NodeState& bit = s.nodes.front();
  const Vector3d axis = x_axis(bit.orientation);
  m.hole_depth = hole_depth();
  m.bit_depth = bit_depth(*model, s);
  if (!m.in_slips) m.encoder_bit_depth = state.string.length - m.block_height;
  m.on_bottom = shown_forces().wob > 0.0;
  m.bit_position = bit.position + model->mesh().bit_radius * axis;
  m.bit_orientation = bit.orientation * rotation_from_vector(Vector3d(std::remainder(s.bit.turned, 2.0 * pi), 0.0, 0.0));
  m.bit_velocity = bit.rate.velocity + bit.rate.tilt.cross(model->mesh().bit_radius * axis);
  m.bit_flow = s.flow;
  m.ecd = equivalent_circulating_density(scene.mud.density, s.hydraulics.annulus_pressure, -m.bit_position.z());
  m.bit_speed = bit.rate.spin + s.bit.motor_speed;
  m.bit_angular_velocity = bit.rate.tilt + m.bit_speed * axis;
  m.bit_force = shown_forces().bit_force;
  m.bit_moment = shown_forces().bit_moment;
  m.wob = shown_forces().wob;
  m.bit_torque = shown_forces().bit_torque;
  const Vector3d hole = s.well.end_direction();
  m.bit_inclination = inclination_of(hole);
  m.bit_azimuth = azimuth_of(hole);
  m.bend_toolface = bend_toolface(*model, s);
}

void Simulator::Impl::measure_string() noexcept
{
  Truth& m = state.truth;
  statistics.loads = watch.look(*model, shown(), shown_forces());
  m.over_stress = statistics.loads.stress.share > 1.0;
  m.over_torque = statistics.loads.torque.share > 1.0;
  m.buckled = statistics.loads.buckling.share > 1.0;
  statistics.accuracy = state.accuracy.report;
  m.accuracy_warning = statistics.accuracy.doubt != AccuracyDoubt::none;
}

SensorView Simulator::Impl::sensor_view() const noexcept
{
  SensorView view;
  const Mesh& mesh = model->mesh();
  const Between at = find_between(mesh, mesh.sensor_from_bit >= 0.0 ? mesh.sensor_from_bit : 0.0);
  const Quaterniond& upper = shown().nodes[at.lower + 1].orientation;
  const Quaterniond q = shown().nodes[at.lower].orientation.slerp(std::clamp(at.share, 0.0, 1.0), upper);
  view.md = state.truth.bit_depth - std::max(mesh.sensor_from_bit, 0.0);
  view.axis = x_axis(q);
  view.scribe = y_axis(q);
  view.spin_speed = shown().nodes[at.lower].rate.spin;
  view.pump_strokes = shown().hydraulics.strokes;
  view.in_slips = state.connection.under_way || slips_load(shown()) > 0.0;
  if (scene.instruments.dynamics.period > 0.0) view.sub = sub_view();
  return view;
}

/// Of the element in which it sits.
SubView Simulator::Impl::sub_view() const noexcept
{
  const Mesh& mesh = model->mesh();
  const State& s = shown();
  const double from_bit = scene.instruments.dynamics.from_bit;
  const Between at = find_between(mesh, std::isnan(from_bit) ? std::max(mesh.sensor_from_bit, 0.0) : from_bit);
  const std::size_t here = static_cast<std::size_t>(at.lower);
  SubView view;
  view.md = state.truth.bit_depth - (std::isnan(from_bit) ? std::max(mesh.sensor_from_bit, 0.0) : from_bit);
  view.axis = x_axis(s.nodes[here].orientation);
  const auto along = [&](std::size_t i) { return -x_axis(s.nodes[i].orientation).z(); };
  view.weight_below = standard_gravity * (mesh.bit_mass - scene.mud.density * mesh.bit_displaced) * along(0);
  for (std::size_t e = 0; e <= here; ++e)
    view.weight_below += (e < here ? 1.0 : 0.5) * along(e) *
                         model->element_weight(static_cast<int>(e), s.nodes[e].position.z(), s.nodes[e + 1].position.z(), s.hydraulics.bore_top);
  view.tension = shown_forces().tension[here];
  view.torque = shown_forces().torque[here];
  view.bending_moment = shown_forces().bending_moment[here + 1];
  view.spin_speed = s.nodes[here].rate.spin;
  view.velocity = s.nodes[here].rate.velocity;
  return view;
}

}  // namespace drill_rig_sim
