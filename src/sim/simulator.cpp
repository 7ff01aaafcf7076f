// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/simulator.h"

#include <limits>
#include <stdexcept>

#include "drill_rig_sim/accuracy/refined.h"
#include "drill_rig_sim/scene/scene_problems.h"
#include "drill_rig_sim/sim/choice.h"
#include "drill_rig_sim/sim/faults.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
namespace
{
/// Throws std::runtime_error with one line if the scene asks for what is not available.
const Scene& available(const Scene& scene)
{
  const ProblemList problems = unavailable(scene);
  if (!problems.empty()) throw std::runtime_error(problems.front().key + ": " + problems.front().text);
  return scene;
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
}  // namespace

Simulator::Simulator(const Scene& scene, std::uint64_t seed) : impl_(std::make_unique<Impl>(with_choice(available(scene)), seed))
{
  if (scene.numerics.level == Level::automatic) impl_->choice = choose(scene).reason;
  const NumericsSpec& numerics = impl_->rig.scene.numerics;
  const CompanionKind kind = numerics.companion;
  SimulatorStatistics& statistics = impl_->rig.statistics;
  statistics.not_measured = why_not_measured(scene.numerics);
  if (kind == CompanionKind::none) return;
  impl_->error.begin(traits_of(kind).error_over_difference);
  try
  {
    add_companion(refined(with_free_nodes(numerics), traits_of(kind).refinement));
    statistics.companion = impl_->companions.companion(0).as_companion();
  }
  catch (const std::runtime_error&)
  {
    if (scene.numerics.companion == kind) throw;  // asked for by the scene
    statistics.not_measured = "the finer model found no static equilibrium at the start";
  }
}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

template <class Setpoint>
CommandResult Simulator::Impl::command(const Setpoint& c) noexcept
{
  const CommandResult result = rig.commands.command(c);
  rig.statistics.commands_clamped += result.outcome == CommandResult::Outcome::clamped;
  rig.statistics.commands_refused += result.outcome == CommandResult::Outcome::refused;
  return result;
}

CommandResult Simulator::command(const WinchSetpoint& c) noexcept
{
  return impl_->command(c);
}

CommandResult Simulator::command(const TopDriveSetpoint& c) noexcept
{
  return impl_->command(c);
}

CommandResult Simulator::command(const PumpSetpoint& c) noexcept
{
  return impl_->command(c);
}

CommandResult Simulator::command(const SteeringSetpoint& c) noexcept
{
  return impl_->command(c);
}

const char* Simulator::locked(const WinchSetpoint& c) const noexcept
{
  return impl_->rig.commands.locked(c);
}

const char* Simulator::locked(const TopDriveSetpoint& c) const noexcept
{
  return impl_->rig.commands.locked(c);
}

const char* Simulator::locked(const PumpSetpoint& c) const noexcept
{
  return impl_->rig.commands.locked(c);
}

const char* Simulator::locked(const SteeringSetpoint& c) const noexcept
{
  return impl_->rig.commands.locked(c);
}

Setpoints Simulator::setpoints() const noexcept
{
  return impl_->rig.commands.requested();
}

const Setpoints& Simulator::asked() const noexcept
{
  return impl_->rig.commands.asked();
}

void Simulator::set_command_timeout(double seconds) noexcept
{
  impl_->rig.commands.set_timeout(seconds);
}

void Simulator::winch_command_stands() noexcept
{
  impl_->rig.commands.winch_command_stands();
}

void Simulator::drive_command_stands() noexcept
{
  impl_->rig.commands.drive_command_stands();
}

FrameStatus Simulator::frame(double duration) noexcept
{
  SimulatedRig& rig = impl_->rig;
  if (*rig.failure) return FrameStatus::failed;
  if (!(duration > 0.0)) return FrameStatus::running;
  Profiler& profiler = rig.motion.integrator().profiler();
  rig.pipe.go_on(duration);
  impl_->crew.wait(duration);
  rig.commands.watch();
  const Setpoints setpoints = rig.commands.in_force();
  impl_->error.make_room();
  impl_->companions.order(duration, setpoints);
  profiler.restart();  // what companions took in this thread is theirs
  if (!rig.compute_frame(duration, setpoints)) return FrameStatus::failed;
  rig.measurement.read();
  profiler.lap(Cost::other);
  rig.statistics.costs = profiler;  // before what waits for companions
  impl_->error.judge(duration);
  return FrameStatus::running;
}

void Simulator::attend(double duration) noexcept
{
  if (*impl_->rig.failure) return;
  impl_->actions.finish_connection();
  impl_->crew.attend(duration);
}

void Simulator::fail(const char* reason) noexcept
{
  impl_->rig.fail(reason);
}

void Simulator::balance_energy(bool on)
{
  impl_->rig.motion.balance_energy(on);
}

const EnergyAccounts& Simulator::energy() const noexcept
{
  return impl_->rig.motion.energy();
}

const char* Simulator::failure() const noexcept
{
  return impl_->rig.failure;
}

const Truth& Simulator::truth() const noexcept
{
  return impl_->rig.state.truth;
}

const Readings& Simulator::readings() const noexcept
{
  return impl_->rig.state.readings;
}

const Wellbore& Simulator::wellbore() const noexcept
{
  return impl_->rig.state.mechanics.well;
}

void Simulator::raw_path(std::vector<Eigen::Vector3d>& out) const
{
  impl_->rig.state.mechanics.well.raw_path(out);
}

const SimulatorStatistics& Simulator::statistics() const noexcept
{
  return impl_->rig.statistics;
}

const std::string& Simulator::choice() const noexcept
{
  return impl_->choice;
}

const Scene& Simulator::scene() const noexcept
{
  return impl_->rig.scene;
}

bool Simulator::tare() noexcept
{
  return impl_->actions.tare();
}

bool Simulator::tare_over(double duration, Zero& zero) noexcept
{
  return impl_->actions.tare_over(duration, zero);
}

double Simulator::zero_held() const noexcept
{
  return impl_->rig.measurement.zero_held();
}

bool Simulator::stick_pipe(double md) noexcept
{
  return !inject({FaultKind::stuck_pipe, md, 0.0, Gauge::hook_load});
}

void Simulator::free_pipe() noexcept
{
  clear(FaultKind::stuck_pipe, Gauge::hook_load);
}

const char* Simulator::inject(const Fault& fault) noexcept
{
  return impl_->actions.inject(fault);
}

void Simulator::clear(FaultKind kind, Gauge gauge) noexcept
{
  impl_->actions.clear(kind, gauge);
}

ActiveFaults Simulator::active_faults() const noexcept
{
  SimulatedRig& rig = impl_->rig;
  ActiveFaults faults;
  faults.of_rig = drill_rig_sim::active_faults(rig.state.mechanics);
  for (int g = 0; g < gauge_count; ++g)
    faults.of_gauges[static_cast<std::size_t>(g)] = drill_rig_sim::active_faults(rig.measurement.fault_of(static_cast<Gauge>(g)));
  return faults;
}

FaultDepths Simulator::fault_depths() const noexcept
{
  return drill_rig_sim::fault_depths(*impl_->rig.motion.model(), impl_->rig.state.mechanics);
}

bool Simulator::set_free_length(double from_bit) noexcept
{
  return impl_->rig.motion.set_free_length(from_bit);
}

const char* Simulator::set_slips(bool set) noexcept
{
  if (impl_->crew.is_busy()) return "slips: the crew is making a connection";
  const char* refused = set ? impl_->actions.set_slips(impl_->rig.pipe.joint_at_table()) : impl_->actions.pull_slips();
  impl_->rig.measurement.show_pipe_handling();
  return refused;
}

const char* Simulator::set_slips_for(int joints, bool remove)
{
  if (impl_->crew.is_busy()) return "slips: the crew is making a connection";
  const int joint = impl_->rig.pipe.joint_for(joints, remove);
  const char* refused = joint < 0 ? "slips: the string has fewer joints than that" : impl_->actions.set_slips(joint);
  impl_->rig.measurement.show_pipe_handling();
  return refused;
}

const char* Simulator::make_connection(int joints, bool remove) noexcept
{
  if (impl_->crew.is_busy()) return "connection: the crew is already making one";
  const char* refused = impl_->actions.make_connection(joints, remove);
  impl_->rig.measurement.show_pipe_handling();
  return refused;
}

void Simulator::call_crew(bool on) noexcept
{
  impl_->crew.call(on);
}

int Simulator::add_companion(const NumericsSpec& numerics)
{
  if (impl_->rig.has_begun) throw std::runtime_error("companion: must be set before the first frame");
  Scene scene = impl_->rig.scene;
  scene.numerics = numerics;
  scene.numerics.companion = CompanionKind::none;
  impl_->companions.add(with_choice(available(scene)), impl_->seed);
  return companions() - 1;
}

int Simulator::companions() const noexcept
{
  return impl_->companions.count();
}

void Simulator::set_companion_pace(CompanionPace pace)
{
  impl_->companions.set_pace(pace);
}

const Truth& Simulator::companion_truth(int i) const noexcept
{
  return impl_->companions.companion(i).state.truth;
}

const SimulatorStatistics& Simulator::companion_statistics(int i) const noexcept
{
  return impl_->companions.companion(i).statistics;
}

const char* Simulator::companion_failure(int i) const noexcept
{
  return impl_->companions.failure_of(i);
}

double Simulator::measured_error(Output output) const noexcept
{
  return impl_->error.is_under_way() ? impl_->error.measured().error(output) : unknown;
}

double Simulator::measured_absolute_error(Output output) const noexcept
{
  return impl_->error.is_under_way() ? impl_->error.measured().absolute_error(output) : unknown;
}

StatisticDifferences Simulator::measured_statistics(Output output) const noexcept
{
  if (!impl_->error.is_under_way()) return {unknown, unknown, unknown, unknown};
  return impl_->error.measured().statistics(output);
}

std::shared_ptr<const SimulatorState> Simulator::save() const
{
  impl_->error.collect_all();
  const auto saved = std::make_shared<SimulatorState>(impl_->rig.state);
  impl_->companions.save(*saved);
  return saved;
}

bool Simulator::restore(const SimulatorState& state)
{
  impl_->error.collect_all();
  if (state.scene != impl_->rig.state.scene || !impl_->rig.restore(state)) return false;
  impl_->error.restore(state);
  return true;
}

}  // namespace drill_rig_sim
