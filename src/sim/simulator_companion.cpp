// Other models of the same rig that go through what it goes through.
#include <limits>
#include <stdexcept>

#include "simulator_impl.h"

namespace drill_rig_sim
{
int Simulator::add_companion(const NumericsSpec& numerics)
{
  if (impl_->statistics.frames > 0) throw std::runtime_error("companion: frames were computed, allowed: before the first");
  Scene scene = impl_->scene;
  scene.numerics = numerics;
  scene.numerics.companion = CompanionKind::none;
  scene = with_choice(available(scene));
  impl_->companions.push_back(std::make_unique<Impl>(scene, 0));
  return companions() - 1;
}

int Simulator::companions() const noexcept
{
  return static_cast<int>(impl_->companions.size());
}

const Truth& Simulator::companion_truth(int i) const noexcept
{
  return impl_->companions[static_cast<std::size_t>(i)]->state.truth;
}

const SimulatorStatistics& Simulator::companion_statistics(int i) const noexcept
{
  return impl_->companions[static_cast<std::size_t>(i)]->statistics;
}

const char* Simulator::companion_failure(int i) const noexcept
{
  return impl_->companions[static_cast<std::size_t>(i)]->failure;
}

double Simulator::measured_error(Output output) const noexcept
{
  return impl_->measures() ? impl_->state.measured.error(output) : std::numeric_limits<double>::quiet_NaN();
}

/// What the companion says of the frame just computed.
void Simulator::Impl::judge(double duration) noexcept
{
  statistics.error_is_measured = measures();
  if (!statistics.error_is_measured) return;
  state.measured.add(outputs_of(state.truth), outputs_of(companions.front()->state.truth), duration);
  statistics.errors = state.measured.errors();
  const OutputError largest = largest_of(statistics.errors, scene.needs);
  if (largest.error > scene.numerics.tolerance && state.accuracy.report.doubt == AccuracyDoubt::none)  // doubts of the model come first
    state.accuracy.report = {AccuracyDoubt::measured, largest.error, 0.0, 0.0, 0.0, largest.output};
  statistics.accuracy = state.accuracy.report;
  state.truth.accuracy_warning = statistics.accuracy.doubt != AccuracyDoubt::none;
}

/// A frame under the leader's set points, whose crew, watchdog and interlocks have made them.
void Simulator::Impl::follow(const Impl& leader, double duration, const Setpoints& setpoints) noexcept
{
  state.commands = leader.state.commands;
  state.downlink = leader.state.downlink;
  state.interlocks = leader.state.interlocks;
  state.crew = leader.state.crew;
  if (state.connection.under_way) state.connection.elapsed = leader.state.connection.elapsed;
  integrator->profiler().restart();
  compute_frame(duration, setpoints);
  integrator->profiler().lap(Cost::other);
  statistics.costs = integrator->profiler();
}

void Simulator::Impl::restore_companions(const CompanionStates& saved, bool keep_time)
{
  for (std::size_t i = 0; i < companions.size(); ++i)
    if (i >= saved.states.size() || !companions[i]->restore(saved.states[i], keep_time)) companions[i]->failure = "it is not in the snapshot";
}

}  // namespace drill_rig_sim
