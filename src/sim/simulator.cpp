#include "simulator_impl.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/rig/mud_motor.h"
#include "drill_rig_sim/rig/mud_pump.h"
#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
CommandResult refused(const char* reason) noexcept
{
  return {CommandResult::Outcome::refused, reason};
}

/// `value` within its limits; sets `clamped` where it was not.
double clamped_to(double value, double low, double high, bool& clamped) noexcept
{
  const double inside = std::clamp(value, low, high);
  clamped = clamped || inside != value;
  return inside;
}

}  // namespace

const Scene& available(const Scene& scene)
{
  const ProblemList problems = unavailable(scene);
  if (!problems.empty()) throw std::runtime_error(problems.front().key + ": " + problems.front().text);
  return scene;
}

Simulator::Impl::Impl(const Scene& s, std::uint64_t seed, RigAtRest&& rig)
  : scene(s), model(std::move(rig.model)), state(std::move(rig.state), std::move(rig.statics.forces)),
    integrator(make_integrator(scene.numerics.integrator, model, state.mechanics))
{
  state.noise.state = seed;
  const InstrumentsSpec& spec = scene.instruments;
  state.hook_load_sensor = Sensor(spec.hook_load, scene.numerics.step);
  state.torque_sensor = Sensor(spec.torque, scene.numerics.step);
  state.pressure_sensor = Sensor(spec.stand_pipe_pressure, scene.numerics.step);
  state.mwd = Mwd(spec.mwd, spec.toolface);
  for (const PartSpec& part : scene.string)
    if (part.motor) motor = &*part.motor;
  statistics.nodes = model->nodes();
  statistics.coordinates = 6 * model->nodes() - 4 + 2;  // less the rail's four, plus rotor and line
  statistics.level = "beam3d";
  statistics.integrator = find_integrator(scene.numerics.integrator).name;
  statistics.step = scene.numerics.step;
  state.forces.hook_load = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  state.forces.meter_torque = rig.statics.top_torque;
  measure();
}

Simulator::Simulator(const Scene& scene, std::uint64_t seed) : impl_(std::make_unique<Impl>(scene, seed)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

CommandResult Simulator::command(const WinchSetpoint& c) noexcept
{
  if (!std::isfinite(c.block_velocity))
  {
    ++impl_->statistics.commands_refused;
    return refused("block_velocity: must be finite");
  }
  bool clamped = false;
  const double limit = impl_->scene.rig.hoisting.max_speed;
  impl_->state.setpoints.winch = {clamped_to(c.block_velocity, -limit, limit, clamped), c.brake};
  impl_->state.last_winch_command = impl_->mechanics().time;
  impl_->state.timed_out = false;
  return impl_->note(clamped, "block_velocity: clamped to the winch's max_speed");
}

CommandResult Simulator::command(const TopDriveSetpoint& c) noexcept
{
  const TopDriveSpec& spec = impl_->scene.rig.top_drive;
  const char* wrong = nullptr;
  if (c.mode != TopDriveMode::speed && c.mode != TopDriveMode::torque)
    wrong = "mode: not available yet; SPEED and TORQUE are";
  else if (!std::isfinite(c.speed) || !std::isfinite(c.torque) || !std::isfinite(c.angle) || !std::isfinite(c.torque_limit))
    wrong = "speed, torque, angle and torque_limit: must be finite";
  else if (c.torque_limit < 0.0)
    wrong = "torque_limit: must not be negative; 0 means the rig's";
  if (wrong)
  {
    ++impl_->statistics.commands_refused;
    return refused(wrong);
  }
  bool clamped = false;
  TopDriveSetpoint taken = c;
  taken.speed = clamped_to(c.speed, -spec.max_speed, spec.max_speed, clamped);
  taken.torque = clamped_to(c.torque, -spec.max_torque, spec.max_torque, clamped);
  taken.torque_limit = clamped_to(c.torque_limit, 0.0, spec.max_torque, clamped);
  impl_->state.setpoints.top_drive = taken;
  impl_->state.last_drive_command = impl_->mechanics().time;
  impl_->state.timed_out = false;
  return impl_->note(clamped, "speed, torque or torque_limit: clamped to the top drive's limits");
}

CommandResult Simulator::command(const PumpSetpoint& c) noexcept
{
  if (!std::isfinite(c.flow))
  {
    ++impl_->statistics.commands_refused;
    return refused("flow: must be finite");
  }
  bool clamped = false;
  impl_->state.setpoints.pump.flow = clamped_to(c.flow, 0.0, impl_->scene.rig.mud_pump.max_flow, clamped);
  return impl_->note(clamped, "flow: clamped to 0 .. the pump's max_flow");
}

void Simulator::set_command_timeout(double seconds) noexcept
{
  impl_->command_timeout = seconds;
}

FrameStatus Simulator::frame(double duration) noexcept
{
  if (*impl_->failure) return FrameStatus::failed;
  impl_->integrator->profiler().restart();
  impl_->watch_commands();
  const int steps = std::max(1, static_cast<int>(std::lround(duration / impl_->scene.numerics.step)));
  State& mechanics = impl_->mechanics();
  double drilled = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    mechanics.flow = impl_->state.setpoints.pump.flow;
    if (!impl_->integrator->advance(mechanics, duration / steps, impl_->state.setpoints))
    {
      impl_->failure = impl_->integrator->failure();
      return FrameStatus::failed;
    }
    drilled += mechanics.bit.rock_velocity.norm() * duration / steps;
  }
  impl_->state.forces = impl_->integrator->find_forces(mechanics);
  impl_->state.measurements.rop = drilled / duration;
  ++impl_->statistics.frames;
  const StepperCounters& counters = impl_->integrator->counters();
  impl_->statistics.steps = counters.steps;
  impl_->statistics.newton_iterations = counters.newton_iterations;
  impl_->statistics.convergence_failures = counters.convergence_failures;
  impl_->statistics.error_test_failures = counters.error_test_failures;
  impl_->statistics.work = impl_->integrator->work();
  if (const ReferenceReport* report = impl_->integrator->reference())
  {
    impl_->statistics.is_reference = true;
    impl_->statistics.reference = *report;
  }
  impl_->statistics.last_error_estimate = impl_->integrator->error_estimate();
  impl_->measure();
  impl_->integrator->profiler().lap(Cost::other);
  impl_->statistics.costs = impl_->integrator->profiler();
  return FrameStatus::running;
}

bool Simulator::balance_energy(bool on)
{
  impl_->integrator->keep_balance(nullptr);
  impl_->balance.reset();
  if (!on) return true;
  impl_->balance = std::make_unique<EnergyBalance>(impl_->model);
  if (impl_->integrator->keep_balance(impl_->balance.get())) return true;
  impl_->balance.reset();
  return false;
}

const EnergyAccounts& Simulator::energy() const noexcept
{
  static const EnergyAccounts none;
  return impl_->balance ? impl_->balance->accounts() : none;
}

const char* Simulator::failure() const noexcept
{
  return impl_->failure;
}

const Measurements& Simulator::measurements() const noexcept
{
  return impl_->state.measurements;
}

const Wellbore& Simulator::wellbore() const noexcept
{
  return impl_->state.mechanics.well;
}

void Simulator::raw_path(std::vector<Vector3d>& out) const
{
  impl_->state.mechanics.well.raw_path(out);
}

const SimulatorStatistics& Simulator::statistics() const noexcept
{
  return impl_->statistics;
}

const Scene& Simulator::scene() const noexcept
{
  return impl_->scene;
}

bool Simulator::tare() noexcept
{
  SimulatorState& state = impl_->state;
  if (state.measurements.on_bottom) return false;
  state.tared = true;
  state.tare_hook_load = state.forces.hook_load;
  state.tare_pressure += state.measurements.differential_pressure;
  impl_->measure_rig();
  return true;
}

bool Simulator::stick_pipe(double md) noexcept
{
  if (!std::isfinite(md)) return false;
  State& mechanics = impl_->mechanics();
  const Mesh& mesh = impl_->model->mesh();
  int nearest = -1;
  double distance = impl_->scene.numerics.element_length;
  for (int i = 0; i + 1 < impl_->model->nodes(); ++i)
  {
    const double depth = impl_->state.measurements.bit_depth - mesh.nodes[i].from_bit;
    if (depth <= 0.0 || std::abs(depth - md) >= distance) continue;
    distance = std::abs(depth - md);
    nearest = i;
  }
  if (nearest < 0) return false;
  mechanics.stuck_point = {nearest, mechanics.nodes[nearest].position, mechanics.nodes[nearest].spin_angle};
  return true;
}

void Simulator::free_pipe() noexcept
{
  impl_->mechanics().stuck_point = StuckPointState();
}

std::shared_ptr<const SimulatorState> Simulator::save() const
{
  return std::make_shared<SimulatorState>(impl_->state);
}

void Simulator::restore(const SimulatorState& state, bool keep_time)
{
  const double now = impl_->mechanics().time;
  impl_->state = state;
  impl_->integrator->restart();
  if (impl_->balance) impl_->balance->restart();
  impl_->failure = "";
  if (keep_time) impl_->shift_time(now);
}

/// The simulator's clock alone: everything that is a time moves with it.
void Simulator::Impl::shift_time(double now) noexcept
{
  const double shift = now - mechanics().time;
  mechanics().time = now;
  state.measurements.time = now;
  state.last_winch_command += shift;
  state.last_drive_command += shift;
  state.hook_load_sensor.shift_time(shift);
  state.torque_sensor.shift_time(shift);
  state.pressure_sensor.shift_time(shift);
  state.mwd.shift_time(shift);
}

CommandResult Simulator::Impl::note(bool clamped, const char* reason) noexcept
{
  state.command_clamped = clamped;
  if (!clamped) return {};
  ++statistics.commands_clamped;
  return {CommandResult::Outcome::clamped, reason};
}

void Simulator::Impl::watch_commands() noexcept
{
  if (command_timeout <= 0.0 || state.timed_out) return;
  const double now = mechanics().time;
  if (std::max(now - state.last_winch_command, now - state.last_drive_command) <= command_timeout) return;
  state.timed_out = true;
  state.setpoints.winch = WinchSetpoint();
  state.setpoints.top_drive = TopDriveSetpoint();
  state.setpoints.top_drive.mode = TopDriveMode::torque;
}

void Simulator::Impl::measure() noexcept
{
  measure_rig();
  measure_bit();
  Measurements& m = state.measurements;
  state.mwd.update(m.time, mechanics().flow, sensor_view(), state.noise, m.mwd, m.toolface);
  m.dead_line_hook_load = state.hook_load_sensor.read(m.dead_line_hook_load, m.time, state.noise);
  m.torque = state.torque_sensor.read(m.torque, m.time, state.noise);
  m.stand_pipe_pressure = state.pressure_sensor.read(m.stand_pipe_pressure, m.time, state.noise);
}

void Simulator::Impl::measure_rig() noexcept
{
  Measurements& m = state.measurements;
  const State& s = mechanics();
  const NodeState& top = s.nodes.back();
  const HoistingSpec& hoisting = scene.rig.hoisting;
  m.time = s.time;
  m.hook_load = state.forces.hook_load;
  m.hook_load_string = m.hook_load - standard_gravity * hoisting.block_mass;
  m.block_height = top.position.z();
  m.block_velocity = top.rate.velocity.z();
  m.dead_line_hook_load = dead_line_hook_load(m.hook_load, m.block_velocity, hoisting.sheaves, hoisting.sheave_efficiency);
  m.top_drive_angle = s.drive.angle;
  m.top_drive_speed = s.drive.speed;
  m.torque = state.forces.meter_torque;
  m.flow = s.flow;
  const double motor_pressure = motor ? mud_motor_pressure(s.flow, motor->displacement_per_rev, state.forces.bit_torque) : 0.0;
  m.differential_pressure = motor_pressure - state.tare_pressure;
  m.stand_pipe_pressure = stand_pipe_pressure(scene.rig.mud_pump, s.flow, motor_pressure);
  m.tared = state.tared;
  m.surface_wob = state.tared ? state.tare_hook_load - m.hook_load : 0.0;
  m.setpoints = state.setpoints;
  m.brake_set = state.setpoints.winch.brake;
  m.winch_limited = s.hoist.limited;
  m.top_drive_limited = s.drive.limited;
  m.motor_stalled = s.bit.stalled;
  m.command_clamped = state.command_clamped;
  m.commands_timed_out = state.timed_out;
}

void Simulator::Impl::measure_bit() noexcept
{
  Measurements& m = state.measurements;
  const State& s = mechanics();
  const NodeState& bit = s.nodes.front();
  const Vector3d axis = x_axis(bit.orientation);
  m.hole_depth = s.well.hole_depth();
  m.bit_depth = bit_depth(*model, s);
  m.on_bottom = state.forces.wob > 0.0;
  m.bit_position = bit.position + model->mesh().bit_radius * axis;
  m.bit_orientation = bit.orientation * rotation_from_vector(Vector3d(std::remainder(s.bit.turned, 2.0 * pi), 0.0, 0.0));
  m.bit_velocity = bit.rate.velocity + bit.rate.tilt.cross(model->mesh().bit_radius * axis);
  m.bit_speed = bit.rate.spin + s.bit.motor_speed;
  m.bit_angular_velocity = bit.rate.tilt + m.bit_speed * axis;
  m.bit_force = state.forces.bit_force;
  m.bit_moment = state.forces.bit_moment;
  m.wob = state.forces.wob;
  m.bit_torque = state.forces.bit_torque;
  const Vector3d hole = s.well.end_direction();
  m.bit_inclination = inclination_of(hole);
  m.bit_azimuth = azimuth_of(hole);
  m.bend_toolface = bend_toolface(*model, s);
}

SensorView Simulator::Impl::sensor_view() const noexcept
{
  SensorView view;
  const Mesh& mesh = model->mesh();
  const Between at = find_between(mesh, mesh.sensor_from_bit >= 0.0 ? mesh.sensor_from_bit : 0.0);
  const Quaterniond& upper = state.mechanics.nodes[at.lower + 1].orientation;
  const Quaterniond q = state.mechanics.nodes[at.lower].orientation.slerp(at.share, upper);
  view.md = state.measurements.bit_depth - std::max(mesh.sensor_from_bit, 0.0);
  view.axis = x_axis(q);
  view.scribe = y_axis(q);
  return view;
}

}  // namespace drill_rig_sim
