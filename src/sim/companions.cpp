// SPDX-License-Identifier: BSD-3-Clause
#include "companions.h"

#include <limits>

namespace drill_rig_sim
{
void Companions::add(const Scene& scene, std::uint64_t seed)
{
  rigs_.push_back(std::make_unique<SimulatedRig>(scene, seed));
  if (queue_) return;
  queue_ = std::make_unique<FrameQueue>([this](FrameOrder& order) { compute(order); });
  set_pace(pace_);
}

void Companions::set_pace(CompanionPace pace)
{
  pace_ = pace;
  if (!queue_) return;
  if (pace == CompanionPace::in_turn)
    queue_->stop_thread();
  else
    queue_->start_thread();
}

void Companions::order(double duration, const Setpoints& setpoints) noexcept
{
  if (!goes_on()) return;
  FrameOrder& order = queue_->next();
  order.duration = duration;
  order.setpoints = setpoints;
  order.commands = rig_.state.commands;
  order.passed = rig_.state.delay.passed();
  order.downlink = rig_.state.downlink;
  order.interlocks = rig_.state.interlocks;
  order.crew = rig_.state.crew;
  order.connection_elapsed = rig_.state.connection.elapsed;
  queue_->post();
}

/// A frame of all companions.
void Companions::compute(FrameOrder& order) noexcept
{
  for (const std::unique_ptr<SimulatedRig>& companion : rigs_) companion->follow(order);
  const SimulatedRig& first = *rigs_.front();
  order.outputs = first.measurement.judged();
  order.companion = first.as_companion();
  if (*first.failure) order.outputs.fill(std::numeric_limits<double>::quiet_NaN());
}

const SimulatedRig& Companions::companion(int i) noexcept
{
  queue_->wait_for_all();
  return *rigs_[static_cast<std::size_t>(i)];
}

const char* Companions::failure_of(int i) noexcept
{
  const char* own = companion(i).failure;
  return *own || goes_on() ? own : "companions were given up: the first one was too slow";
}

void Companions::save(SimulatorState& saved) const
{
  for (const std::unique_ptr<SimulatedRig>& companion : rigs_) saved.companions.states.push_back(companion->state);
}

void Companions::restore(const SimulatorState& saved)
{
  for (std::size_t i = 0; i < rigs_.size(); ++i)
    if (i >= saved.companions.states.size() || !rigs_[i]->restore(saved.companions.states[i]))
      rigs_[i]->failure = "the companion is not in the snapshot";
}

}  // namespace drill_rig_sim
