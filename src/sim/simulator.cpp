#include "simulator_impl.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/accuracy/refined.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_hash.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

const Scene& available(const Scene& scene)
{
  const ProblemList problems = unavailable(scene);
  if (!problems.empty()) throw std::runtime_error(problems.front().key + ": " + problems.front().text);
  return scene;
}

namespace
{
const char* name_of(Level level) noexcept
{
  if (all_guided(level)) return level == Level::rigid ? "rigid" : "axial_torsional";
  return level == Level::hybrid ? "hybrid" : "beam3d";
}

int guided_nodes(const State& state) noexcept
{
  return static_cast<int>(std::count_if(state.nodes.begin(), state.nodes.end(), [](const NodeState& node) { return node.guided; }));
}

/// Of the nodes, rotor and line.
int coordinates_of(const State& state, int guided) noexcept
{
  const int nodes = static_cast<int>(state.nodes.size());
  const int of_rail = state.nodes.back().guided ? 0 : 4;
  return 6 * (nodes - guided) + 2 * guided - of_rail + 2;
}
}  // namespace

Simulator::Impl::Impl(const Scene& s, std::uint64_t seed_of_noise, RigAtRest&& rig)
  : scene(s), seed(seed_of_noise), model(std::move(rig.model)), state(std::move(rig.state), std::move(rig.statics.forces)),
    integrator(make_integrator(scene.numerics.integrator, model, state.mechanics)),
    watch(*model), levels(*model), variable(scene.numerics.has_variable_steps()), stride_end(state.mechanics), between(state.mechanics),
    end_forces(state.forces), forces_between(state.forces)
{
  state.scene = scene_hash(scene);
  state.string = {model->mesh().total_length, scene.start.bit_depth};
  statistics.nodes = model->nodes();
  statistics.guided_nodes = guided_nodes(state.mechanics);
  statistics.coordinates = coordinates_of(state.mechanics, statistics.guided_nodes);
  state.levels.free_length = std::min(free_length(scene), model->mesh().nodes.back().from_bit);
  statistics.level = name_of(level_of(*model, state.levels.free_length));
  statistics.integrator = find_integrator(scene.numerics.integrator).name;
  statistics.kernel = model->kernel();
  statistics.step = scene.numerics.step;
  statistics.tight = tight_assembly(*model, state.forces);
  state.forces.hook_load = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  state.forces.meter_torque = rig.statics.top_torque;
  find_stand();
  state.delay = CommandDelay(scene.rig.plc_latency, scene.rig.hoisting.latency);
  state.zero_mean = ZeroMean(scene.rig.heave.wave_period());
  measure();
  state.instruments = Instruments(scene, state.truth, seed);
  note_ring();
  state.instruments.read(state.truth, sensor_view(), state.readings);
}

Simulator::Simulator(const Scene& scene, std::uint64_t seed) : impl_(std::make_unique<Impl>(with_choice(available(scene)), seed))
{
  if (scene.numerics.level == Level::automatic) impl_->choice = choose(scene).reason;
  const CompanionKind kind = impl_->scene.numerics.companion;
  impl_->statistics.not_measured = why_not_measured(scene.numerics);
  if (kind == CompanionKind::none) return;
  impl_->state.measured = MeasuredError(traits_of(kind).error_over_difference);
  try
  {
    add_companion(refined(with_free_nodes(impl_->scene.numerics), traits_of(kind).refinement));
    impl_->statistics.companion = impl_->companions.front()->as_companion();
  }
  catch (const std::runtime_error&)
  {
    if (scene.numerics.companion == kind) throw;  // asked for by the scene
    impl_->statistics.not_measured = "the finer model found no static equilibrium at the start";
  }
}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

template <class Setpoint>
CommandResult Simulator::Impl::command(const Setpoint& c, const char* lock) noexcept
{
  const CommandResult result = lock ? CommandResult{CommandResult::Outcome::refused, lock} : take(scene.rig, now(), c, state.commands);
  statistics.commands_clamped += result.outcome == CommandResult::Outcome::clamped;
  statistics.commands_refused += result.outcome == CommandResult::Outcome::refused;
  return result;
}

CommandResult Simulator::command(const WinchSetpoint& c) noexcept
{
  return impl_->command(c, locked(c));
}

CommandResult Simulator::command(const TopDriveSetpoint& c) noexcept
{
  return impl_->command(c, locked(c));
}

CommandResult Simulator::command(const PumpSetpoint& c) noexcept
{
  return impl_->command(c, locked(c));
}

const char* Simulator::locked(const SteeringSetpoint&) const noexcept
{
  return impl_->model->steerable() ? nullptr : "steering: the string has no rotary_steerable";
}

CommandResult Simulator::command(const SteeringSetpoint& c) noexcept
{
  return impl_->command(c, locked(c));
}

/// What the tool in the string hears and feels before a frame.
void Simulator::Impl::steer() noexcept
{
  const int node = model->mesh().steering_node();
  if (node < 0) return;
  Setpoints& asked = state.commands.asked;
  const auto heard = state.downlink.hear(now(), state.truth.bit_flow, model->steerable()->downlink_bit_time);
  if (heard) asked.steering = *heard;
  asked.magnetic_steering = toolface_reference(x_axis(shown().nodes[node].orientation), asked.magnetic_steering).magnetic;
}

Setpoints Simulator::setpoints() const noexcept
{
  return impl_->state.commands.in_force();
}

const Setpoints& Simulator::asked() const noexcept
{
  return impl_->state.commands.asked;
}

void Simulator::set_command_timeout(double seconds) noexcept
{
  impl_->command_timeout = seconds;
}

void Simulator::winch_command_stands() noexcept
{
  impl_->state.commands.last_winch = CommandState().last_winch;
}

void Simulator::drive_command_stands() noexcept
{
  impl_->state.commands.last_drive = CommandState().last_drive;
}

FrameStatus Simulator::frame(double duration) noexcept
{
  if (*impl_->failure) return FrameStatus::failed;
  if (!(duration > 0.0)) return FrameStatus::running;
  if (impl_->state.connection.under_way) impl_->state.connection.elapsed += duration;
  impl_->state.crew.waited += duration;
  impl_->integrator->profiler().restart();
  drill_rig_sim::watch_commands(impl_->command_timeout, impl_->now(), impl_->state.commands);
  impl_->steer();
  watch_interlocks(impl_->scene.rig, impl_->state.readings, impl_->state.commands.in_force(), impl_->state.interlocks);
  impl_->state.delay.take(impl_->state.commands.in_force(), impl_->now());
  const Setpoints setpoints = impl_->in_force();
  impl_->order_frame(duration, setpoints);
  impl_->integrator->profiler().restart();  // what companions took in this thread is theirs
  if (!impl_->compute_frame(duration, setpoints)) return FrameStatus::failed;
  impl_->state.instruments.read(impl_->state.truth, impl_->sensor_view(), impl_->state.readings);
  impl_->integrator->profiler().lap(Cost::other);
  impl_->statistics.costs = impl_->integrator->profiler();  // before what waits for companions
  impl_->judge(duration);
  return FrameStatus::running;
}

/// The physics of a frame under `setpoints`, and what there is to be measured after it. False: `failure` says why.
bool Simulator::Impl::compute_frame(double duration, const Setpoints& setpoints) noexcept
{
  const double before = state.truth.hole_depth;
  if (!advance_frame(duration, setpoints))
  {
    failure = integrator->failure();
    return false;
  }
  state.truth.rop = (hole_depth() - before) / duration;
  count_frame();
  watch_model(*model, shown(), shown_forces(), duration, state.accuracy);
  measure();
  return true;
}

void Simulator::Impl::count_frame() noexcept
{
  const int guided = guided_nodes(shown());
  statistics.level = name_of(level_of(*model, state.levels.free_length));
  statistics.coordinates = coordinates_of(shown(), guided);
  statistics.guided_nodes = guided;
  statistics.guided_node_frames += static_cast<std::uint64_t>(guided);
  ++statistics.frames;
  const StepperCounters& counters = integrator->counters();
  statistics.steps = counters.steps;
  statistics.newton_iterations = counters.newton_iterations;
  statistics.convergence_failures = counters.convergence_failures;
  statistics.error_test_failures = counters.error_test_failures;
  statistics.work = integrator->work();
  if (const ReferenceReport* report = integrator->reference())
  {
    statistics.is_reference = true;
    statistics.reference = *report;
  }
  statistics.last_step = shown().memory.last_step;
  statistics.last_error_estimate = integrator->error_estimate();
}

void Simulator::fail(const char* reason) noexcept
{
  if (!*impl_->failure) impl_->failure = reason;
}

void Simulator::balance_energy(bool on)
{
  impl_->integrator->keep_balance(nullptr);
  impl_->balance.reset();
  if (!on) return;
  impl_->balance = std::make_unique<EnergyBalance>(impl_->model);
  impl_->balance_before = std::make_unique<EnergyBalance>(impl_->model);
  impl_->integrator->keep_balance(impl_->balance.get());
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

const Truth& Simulator::truth() const noexcept
{
  return impl_->state.truth;
}

const Readings& Simulator::readings() const noexcept
{
  return impl_->state.readings;
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

const std::string& Simulator::choice() const noexcept
{
  return impl_->choice;
}

const Scene& Simulator::scene() const noexcept
{
  return impl_->scene;
}

bool Simulator::set_free_length(double from_bit) noexcept
{
  const NumericsSpec& numerics = impl_->scene.numerics;
  if (!(from_bit >= 0.0) || from_bit > impl_->state.levels.free_length) return false;
  if (numerics.level == Level::rigid || has_no_levels(numerics.integrator)) return false;
  impl_->settle();
  impl_->state.levels.free_length = from_bit;
  impl_->state.levels.moved = true;
  return true;
}

std::shared_ptr<const SimulatorState> Simulator::save() const
{
  impl_->collect_all();
  const auto saved = std::make_shared<SimulatorState>(impl_->state);
  for (const std::unique_ptr<Impl>& companion : impl_->companions) saved->companions.states.push_back(companion->state);
  return saved;
}

bool Simulator::restore(const SimulatorState& state, bool keep_time)
{
  impl_->collect_all();
  if (state.scene != impl_->state.scene || !impl_->restore(state, keep_time)) return false;
  impl_->restore_companions(state, keep_time);
  return true;
}

/// False, and nothing changed: its string is not what it says.
bool Simulator::Impl::restore(const SimulatorState& saved, bool keep_time)
{
  const double before = now();
  const bool another_string = saved.string.length != state.string.length || saved.string.bit_depth != state.string.bit_depth;
  const std::shared_ptr<const Model> restored = another_string ? model_of(saved.string) : model;
  if (restored->mesh().nodes.size() != saved.mechanics.nodes.size()) return false;
  state = saved;
  state.companions.states.clear();
  if (another_string) take_string(restored);
  integrator->restart();
  if (keep_time) shift_time(before);
  if (variable && saved.stride.length > 0.0)
  {
    if (solve_stride())
      show_stride();
    else
      settle();
  }
  if (balance) balance->restart();
  failure = "";
  return true;
}

/// The simulator's clock alone: everything that is a time moves with it.
void Simulator::Impl::shift_time(double now) noexcept
{
  const double shift = now - this->now();
  mechanics().time += shift;
  state.truth.time = state.readings.time = now;
  state.zero_mean.shift_time(shift);
  state.commands.shift_time(shift);
  state.delay.shift_time(shift);
  state.downlink.shift_time(shift);
  state.instruments.shift_time(shift);
}

}  // namespace drill_rig_sim
