// Other models of the same rig that go through what it goes through.
#include <limits>
#include <stdexcept>

#include "simulator_impl.h"

namespace drill_rig_sim
{
int Simulator::add_companion(const NumericsSpec& numerics)
{
  if (impl_->statistics.frames > 0) throw std::runtime_error("companion: must be set before the first frame");
  Scene scene = impl_->scene;
  scene.numerics = numerics;
  scene.numerics.companion = CompanionKind::none;
  scene = with_choice(available(scene));
  impl_->companions.push_back(std::make_unique<Impl>(scene, impl_->seed));
  if (!impl_->queue)
  {
    impl_->queue = std::make_unique<FrameQueue>([impl = impl_.get()](FrameOrder& order) { impl->companions_follow(order); });
    set_companion_pace(impl_->pace);
  }
  return companions() - 1;
}

void Simulator::set_companion_pace(CompanionPace pace)
{
  impl_->pace = pace;
  if (!impl_->queue) return;
  if (pace == CompanionPace::in_turn)
    impl_->queue->stop_thread();
  else
    impl_->queue->start_thread();
}

int Simulator::companions() const noexcept
{
  return static_cast<int>(impl_->companions.size());
}

const Truth& Simulator::companion_truth(int i) const noexcept
{
  impl_->queue->wait_for_all();
  return impl_->companions[static_cast<std::size_t>(i)]->state.truth;
}

const SimulatorStatistics& Simulator::companion_statistics(int i) const noexcept
{
  impl_->queue->wait_for_all();
  return impl_->companions[static_cast<std::size_t>(i)]->statistics;
}

const char* Simulator::companion_failure(int i) const noexcept
{
  impl_->queue->wait_for_all();
  return impl_->companions[static_cast<std::size_t>(i)]->failure;
}

double Simulator::measured_error(Output output) const noexcept
{
  return impl_->measures() ? impl_->state.measured.error(output) : std::numeric_limits<double>::quiet_NaN();
}

double Simulator::measured_absolute_error(Output output) const noexcept
{
  return impl_->measures() ? impl_->state.measured.absolute_error(output) : std::numeric_limits<double>::quiet_NaN();
}

StatisticDifferences Simulator::measured_statistics(Output output) const noexcept
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return impl_->measures() ? impl_->state.measured.statistics(output) : StatisticDifferences{unknown, unknown, unknown, unknown};
}

/// Hands a frame to the companions.
void Simulator::Impl::order_frame(double duration, const Setpoints& setpoints) noexcept
{
  if (companions.empty() || companions_given_up()) return;
  while (queue->full())
  {
    queue->wait_for_one();
    collect();
  }
  FrameOrder& order = queue->next();
  order.duration = duration;
  order.setpoints = setpoints;
  order.commands = state.commands;
  order.downlink = state.downlink;
  order.interlocks = state.interlocks;
  order.crew = state.crew;
  order.connection_elapsed = state.connection.elapsed;
  queue->post();
}

/// The values whose error is measured.
Outputs Simulator::Impl::judged() const noexcept
{
  return scene.numerics.judge == Judge::truth ? outputs_of(state.truth) : outputs_of(state.readings, state.truth);
}

/// A frame of all companions.
void Simulator::Impl::companions_follow(FrameOrder& order) noexcept
{
  for (const std::unique_ptr<Impl>& companion : companions) companion->follow(order);
  const Impl& first = *companions.front();
  order.outputs = first.judged();
  order.companion = first.as_companion();
  if (*first.failure) order.outputs.fill(std::numeric_limits<double>::quiet_NaN());
}

/// A companion's frame.
void Simulator::Impl::follow(const FrameOrder& order) noexcept
{
  if (*failure) return;
  state.commands = order.commands;
  state.downlink = order.downlink;
  state.interlocks = order.interlocks;
  state.crew = order.crew;
  if (state.connection.under_way) state.connection.elapsed = order.connection_elapsed;
  integrator->profiler().restart();
  const bool computed = compute_frame(order.duration, order.setpoints);
  if (computed && scene.numerics.judge == Judge::readings) state.instruments.read(state.truth, sensor_view(), state.readings);
  integrator->profiler().lap(Cost::other);
  statistics.costs = integrator->profiler();
}

/// Takes what the first companion has computed.
void Simulator::Impl::collect() noexcept
{
  if (!queue) return;
  while (const FrameOrder* order = queue->result())
  {
    if (measures())
    {
      state.measured.add_companion(order->outputs);
      statistics.companion = order->companion;
    }
    queue->take();
  }
}

/// What the companion says of the frames that are due. The set points that a frame computes with must have been ordered before.
void Simulator::Impl::judge(double duration) noexcept
{
  if (measures()) state.measured.add_run(judged(), state.truth.top_drive_speed, duration);
  collect();
  compare_frames();
  statistics.error_is_measured = measures();
  if (!statistics.error_is_measured) return;
  statistics.errors = state.measured.errors();
  const OutputError largest = largest_of(statistics.errors, scene.needs);
  if (largest.error > scene.numerics.tolerance && state.accuracy.report.doubt == AccuracyDoubt::none)  // doubts of the model come first
    state.accuracy.report = {AccuracyDoubt::measured, largest.error, 0.0, 0.0, scene.numerics.tolerance, largest.output, state.measured.statistics(largest.output)};
  statistics.accuracy = state.accuracy.report;
  state.truth.accuracy_warning = state.readings.accuracy_warning = statistics.accuracy.doubt != AccuracyDoubt::none;
}

/// Waits for the companion where it is late, but for a pace that gives it up instead.
void Simulator::Impl::compare_frames() noexcept
{
  MeasuredError& measured = state.measured;
  while (measures() && measured.due())
  {
    if (!measured.ready() && pace == CompanionPace::own_thread_unwaited)
    {
      if (measured.is_full()) end_measurement("the companion was too slow for real time: no processor core was free for it");
      return;
    }
    while (!measured.ready())
    {
      queue->wait_for_one();
      collect();
    }
    if (!measured.compare()) end_measurement(companions.front()->failure);
  }
}

void Simulator::Impl::end_measurement(const char* reason) noexcept
{
  state.companion_ended = true;
  statistics.not_measured = reason;
}

/// Waits for all frames that were ordered.
void Simulator::Impl::collect_all() noexcept
{
  if (queue) queue->wait_for_all();
  collect();
}

void Simulator::Impl::restore_companions(const SimulatorState& saved, bool keep_time)
{
  for (std::size_t i = 0; i < companions.size(); ++i)
    if (i >= saved.companions.states.size() || !companions[i]->restore(saved.companions.states[i], keep_time)) companions[i]->failure = "the companion is not in the snapshot";
  if (!measured_by_companion()) return;
  if (saved.companion_ended) companions.front()->failure = "the companion had ended when the state was saved";
  state.companion_ended = *companions.front()->failure;
  statistics.not_measured = companions.front()->failure;
}

}  // namespace drill_rig_sim
