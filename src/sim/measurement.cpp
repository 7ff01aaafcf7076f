// SPDX-License-Identifier: BSD-3-Clause
#include "measurement.h"

#include <algorithm>
#include <cmath>

#include "between.h"
#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

Measurement::Measurement(const Scene& scene, const Motion& motion, const CommandIntake& commands, std::uint64_t seed,
                         SimulatorState& state, SimulatorStatistics& statistics)
    : scene_(scene),
      motion_(motion),
      commands_(commands),
      state_(state),
      truth_(state.truth),
      instruments_(state.instruments),
      readings_(state.readings),
      zero_mean_(state.zero_mean),
      tared_(state.tared),
      tare_hook_load_(state.tare_hook_load),
      tare_pressure_(state.tare_pressure),
      accuracy_(state.accuracy),
      statistics_(statistics),
      watch_(*motion.model())
{
  zero_mean_ = ZeroMean(scene_.rig.heave.wave_period());
  measure_all();
  instruments_ = Instruments(scene_, truth_, seed);
  note_ring();
  read();
}

void Measurement::string_changed()
{
  watch_ = StringWatch(*motion_.model());
  looked_at_ = NAN;
  note_ring();
}

/// How the string as it is built rings: of zeros of the weight.
void Measurement::note_ring() noexcept
{
  const HoistingSpec& hoisting = scene_.rig.hoisting;
  const double period = HungString(motion_.model()->mesh(), hoisting, scene_.start.block_height).ring_period(hoisting.block_mass);
  zero_mean_.rings_with(period);
  instruments_.rings_with(period);
}

void Measurement::measure(double duration) noexcept
{
  truth_.rop = (motion_.hole_depth() - truth_.hole_depth) / duration;
  watch_model(*motion_.model(), motion_.reached(), motion_.reached_forces(), duration, accuracy_);
  measure_all();
}

void Measurement::measure_all() noexcept
{
  measure_string_built();
  measure_rig();
  measure_bit();
  measure_string();
}

void Measurement::read() noexcept
{
  instruments_.read(truth_, sensor_view(), readings_);
}

Outputs Measurement::judged() const noexcept
{
  return scene_.numerics.judge == Judge::truth ? outputs_of(truth_) : outputs_of(readings_, truth_);
}

void Measurement::show_pipe_handling() noexcept
{
  measure_string_built();
  readings_.in_slips = truth_.in_slips;
  readings_.crew = truth_.crew;
}

void Measurement::tare() noexcept
{
  take_zero(zero_mean_.mean());
  instruments_.tare(readings_);
}

Zero Measurement::tare_over(double duration) noexcept
{
  take_zero(zero_mean_.window().over(duration).hook_load);
  return instruments_.tare_over(duration, readings_);
}

/// Of the true values.
void Measurement::take_zero(double hook_load) noexcept
{
  tared_ = true;
  tare_hook_load_ = hook_load;
  tare_pressure_ += truth_.differential_pressure;
  measure_rig();
}

void Measurement::warn_of_error(const AccuracyReport& report) noexcept
{
  if (accuracy_.report.doubt != AccuracyDoubt::none) return;
  statistics_.accuracy = accuracy_.report = report;
  truth_.accuracy_warning = readings_.accuracy_warning = true;
}

/// That the motor's torque needs [Pa].
double Measurement::motor_pressure() const noexcept
{
  const State& s = motion_.shown_at_ends();
  const MotorSpec* motor = motion_.model()->motor();
  return motor ? mud_motor_pressure(s.flow, motor->pressure_displacement(), motor_load(*motion_.model(), s)) : 0.0;
}

void Measurement::measure_rig() noexcept
{
  Truth& m = truth_;
  const State& s = motion_.shown_at_ends();
  const HoistingSpec& hoisting = scene_.rig.hoisting;
  m.time = s.time;
  measure_block();
  m.top_drive_angle = s.drive.angle;
  m.top_drive_speed = s.drive.speed;
  m.flow = s.hydraulics.pump_flow;
  m.stroke_rate = m.flow / scene_.rig.mud_pump.stroke_volume;
  m.pump_strokes = static_cast<unsigned>(s.hydraulics.strokes);
  m.relief_valve_open = s.hydraulics.relief_open;
  m.stand_pipe_pressure = s.hydraulics.stand_pipe_pressure;
  m.differential_pressure = motor_pressure() - tare_pressure_;
  m.tared = tared_;
  m.surface_wob = tared_ && !m.in_slips ? tare_hook_load_ - m.hook_load : 0.0;
  m.setpoints = commands_.in_force();
  zero_mean_.take(m.hook_load, m, motion_.shown_at_rig().wob > 0.0);
  m.brake_set = m.setpoints.winch.brake;
  m.winch_limited = s.hoist.limited;
  m.slack_line = line_pull(hoisting, block_height(s), s.hoist.line_length).slack;
  m.stop_reached = s.hoist.at_stop || stop_force(hoisting, block_height(s), block_velocity(s)).energy > 0.0;
  m.top_drive_brake_set = s.drive.braked;
  m.top_drive_limited = s.drive.limited;
  m.motor_stalled = s.bit.stalled;
  m.command_clamped = state_.commands.clamped;
  m.commands_timed_out = state_.commands.timed_out();
  m.over_pull = state_.interlocks.over_pull;
  m.pump_tripped = state_.interlocks.over_pressure || s.faults.pump_tripped;
  m.drive_tripped = s.faults.drive_tripped;
}

/// What the block's gauges see, which while the string is broken out is not what holds it in the slips.
void Measurement::measure_block() noexcept
{
  Truth& m = truth_;
  const State& s = motion_.shown_at_ends();
  const HoistingSpec& hoisting = scene_.rig.hoisting;
  m.hook_load = motion_.shown_at_rig().hook_load;
  m.torque = motion_.shown_at_rig().meter_torque;
  m.floor_height = s.hoist.floor.height;
  m.floor_velocity = s.hoist.floor.speed;
  m.block_height = block_height(s);
  m.block_velocity = block_velocity(s);
  double slip = s.hoist.sheave_slip;
  if (const ConnectionState& c = state_.connection; c.under_way)
  {
    const BlockRun run = block_run(hoisting, c);
    m.hook_load = shown_while_broken_out(hoisting, c, m.hook_load, c.load_between, c.load_after);
    m.torque = shown_while_broken_out(hoisting, c, m.torque, 0.0, 0.0);
    m.block_height += run.travel;
    m.block_velocity += run.speed;
    slip = sheave_slip(slip, run.travel);
  }
  m.hook_load_string = m.hook_load - standard_gravity * hoisting.block_mass;
  m.dead_line_hook_load = dead_line_hook_load(m.hook_load, slip, hoisting.sheaves, hoisting.sheave_efficiency);
}

void Measurement::measure_string_built() noexcept
{
  Truth& m = truth_;
  m.in_slips = motion_.shown_at_ends().slips.node >= 0;
  m.crew = state_.connection.under_way ? CrewTask::connecting : state_.crew.doing;
  // whole joints of the last part, the one at the block counted by its length
  const double pipe = state_.string.length - motion_.model()->mesh().part_bottom.back();
  m.stand_count =
      static_cast<int>(std::floor(pipe / (scene_.rig.hoisting.stand_joints * scene_.string.back().joint_length) + 1e-9));
}

void Measurement::measure_bit() noexcept
{
  Truth& m = truth_;
  const State& s = motion_.shown_at_ends();
  const NodeState& bit = s.nodes.front();
  const Vector3d axis = x_axis(bit.orientation);
  m.hole_depth = motion_.hole_depth();
  m.bit_depth = bit_depth(*motion_.model(), s);
  if (!m.in_slips) m.encoder_bit_depth = state_.string.length - m.block_height;
  m.on_bottom = motion_.shown_at_rig().wob > 0.0;
  m.bit_position = bit.position + motion_.model()->mesh().bit_radius * axis;
  m.bit_orientation = bit.orientation * rotation_from_vector(Vector3d(std::remainder(s.bit.turned, 2.0 * pi), 0.0, 0.0));
  m.bit_velocity = bit.rate.velocity + bit.rate.tilt.cross(motion_.model()->mesh().bit_radius * axis);
  m.bit_flow = s.flow;
  m.cuttings_volume = cuttings_in_hole(s.cuttings);
  m.bed_height = s.cuttings.bed_height;
  m.flow_line_temperature = s.temperature.flow_line;
  m.bottom_hole_temperature = s.temperature.bit;
  m.ecd = equivalent_circulating_density(scene_.mud.density, s.hydraulics.annulus_pressure, -m.bit_position.z());
  m.bit_speed = bit.rate.spin + s.bit.motor_speed;
  m.bit_angular_velocity = bit.rate.tilt + m.bit_speed * axis;
  m.bit_force = motion_.shown_at_rig().bit_force;
  m.bit_moment = motion_.shown_at_rig().bit_moment;
  m.wob = motion_.shown_at_rig().wob;
  m.bit_torque = motion_.shown_at_rig().bit_torque;
  const Vector3d hole = s.well.end_direction();
  m.bit_inclination = inclination_of(hole);
  m.bit_azimuth = azimuth_of(hole);
  m.bend_toolface = bend_toolface(*motion_.model(), s);
}

void Measurement::measure_string() noexcept
{
  Truth& m = truth_;
  look_at_loads();
  m.over_stress = statistics_.loads.stress.share > 1.0;
  m.over_torque = statistics_.loads.torque.share > 1.0;
  m.buckled = statistics_.loads.buckling.share > 1.0;
  statistics_.accuracy = accuracy_.report;
  m.accuracy_warning = statistics_.accuracy.doubt != AccuracyDoubt::none;
}

/// Of the last step's end, once a step: frames may be much shorter.
void Measurement::look_at_loads() noexcept
{
  const State& reached = motion_.reached();
  if (reached.time == looked_at_) return;
  looked_at_ = reached.time;
  statistics_.loads = watch_.look(*motion_.model(), reached, motion_.reached_forces());
}

SensorView Measurement::sensor_view() const noexcept
{
  SensorView view;
  const Mesh& mesh = motion_.model()->mesh();
  const Between at = find_between(mesh, mesh.sensor_from_bit >= 0.0 ? mesh.sensor_from_bit : 0.0);
  const State& s = motion_.shown_at_ends();
  const Quaterniond& upper = s.nodes[at.lower + 1].orientation;
  const Quaterniond q = s.nodes[at.lower].orientation.slerp(std::clamp(at.share, 0.0, 1.0), upper);
  view.md = truth_.bit_depth - std::max(mesh.sensor_from_bit, 0.0);
  view.axis = x_axis(q);
  view.scribe = y_axis(q);
  view.spin_speed = s.nodes[at.lower].rate.spin;
  view.pump_strokes = s.hydraulics.strokes;
  view.in_slips = state_.connection.under_way || slips_load(s) > 0.0;
  if (scene_.instruments.dynamics.period > 0.0) view.sub = sub_view();
  return view;
}

/// Of the element in which it sits.
SubView Measurement::sub_view() const noexcept
{
  const Mesh& mesh = motion_.model()->mesh();
  const State& s = motion_.shown();
  const double from_bit = scene_.instruments.dynamics.from_bit;
  const Between at = find_between(mesh, std::isnan(from_bit) ? std::max(mesh.sensor_from_bit, 0.0) : from_bit);
  const std::size_t here = static_cast<std::size_t>(at.lower);
  SubView view;
  view.md = truth_.bit_depth - (std::isnan(from_bit) ? std::max(mesh.sensor_from_bit, 0.0) : from_bit);
  view.axis = x_axis(s.nodes[here].orientation);
  const auto along = [&](std::size_t i) { return -x_axis(s.nodes[i].orientation).z(); };
  view.weight_below = standard_gravity * (mesh.bit_mass - scene_.mud.density * mesh.bit_displaced) * along(0);
  for (std::size_t e = 0; e <= here; ++e)
    view.weight_below += (e < here ? 1.0 : 0.5) * along(e) *
                         motion_.model()->element_weight(static_cast<int>(e), s.nodes[e].position.z(),
                                                         s.nodes[e + 1].position.z(), s.hydraulics.bore_top);
  view.tension = motion_.shown_forces().tension[here];
  view.torque = motion_.shown_forces().torque[here];
  view.bending_moment = motion_.shown_forces().bending_moment[here + 1];
  view.spin_speed = s.nodes[here].rate.spin;
  view.velocity = s.nodes[here].rate.velocity;
  return view;
}

}  // namespace drill_rig_sim
