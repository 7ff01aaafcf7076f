// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_COMPANIONS_H
#define DRILL_RIG_SIM_SRC_SIM_COMPANIONS_H

#include <memory>
#include <vector>

#include "frame_queue.h"
#include "simulated_rig.h"

namespace drill_rig_sim
{
/// Other models of a rig that go through what it goes through, and the frames that they still have to compute.
/// Owns `companion_ended` of the rig's state.
class Companions
{
public:
  /// `rig` has to outlive this.
  explicit Companions(SimulatedRig& rig) noexcept : rig_(rig), ended_(rig.state.companion_ended) {}

  /// Allocates. Throws as SimulatedRig's constructor does.
  void add(const Scene& scene, std::uint64_t seed);
  int count() const noexcept { return static_cast<int>(rigs_.size()); }
  CompanionPace pace() const noexcept { return pace_; }
  /// Throws std::system_error where the system has no thread left.
  void set_pace(CompanionPace pace);

  /// Hands a frame to the companions; there has to be room for it.
  void order(double duration, const Setpoints& setpoints) noexcept;
  bool is_full() const noexcept { return goes_on() && queue_->full(); }
  /// The oldest frame whose result was not taken, where it is computed; else null.
  const FrameOrder* result() const noexcept { return queue_ ? queue_->result() : nullptr; }
  /// Takes that result.
  void take() noexcept { queue_->take(); }
  /// Until the oldest frame, or all that were ordered are computed.
  void wait_for_one() noexcept { queue_->wait_for_one(); }
  void wait_for_all() noexcept
  {
    if (queue_) queue_->wait_for_all();
  }
  /// After the frames that they have to compute.
  const SimulatedRig& companion(int i) noexcept;
  /// Why it no longer goes along, after those frames; empty while it does.
  const char* failure_of(int i) noexcept;
  /// Does something to all companions that go along, after the frames that they have to compute.
  template <class Does>
  void lead(const Does& does) noexcept;

  /// Why the first one no longer goes along, without a wait for its frames; empty while it does.
  const char* first_failure() const noexcept { return rigs_.front()->failure; }
  void fail_first(const char* reason) noexcept { rigs_.front()->failure = reason; }
  /// The first one is no longer compared with the run.
  bool has_ended() const noexcept { return ended_; }
  void end() noexcept { ended_ = true; }

  /// Adds their states to one of the rig.
  void save(SimulatorState& saved) const;
  /// One that is not in it fails.
  void restore(const SimulatorState& saved);

private:
  /// There are some, and they were not given up because their thread was too slow.
  bool goes_on() const noexcept { return !rigs_.empty() && !(ended_ && pace_ == CompanionPace::own_thread_unwaited); }
  void compute(FrameOrder& order) noexcept;

  SimulatedRig& rig_;
  bool& ended_;
  std::vector<std::unique_ptr<SimulatedRig>> rigs_;  // the first measures the rig's error if numerics.companion asks for it
  CompanionPace pace_ = CompanionPace::in_turn;
  std::unique_ptr<FrameQueue> queue_;  // null without companions. Its thread ends before they do
};

template <class Does>
void Companions::lead(const Does& does) noexcept
{
  if (!goes_on()) return;
  queue_->wait_for_all();
  for (const std::unique_ptr<SimulatedRig>& companion : rigs_)
    if (!*companion->failure) does(*companion);
}

}  // namespace drill_rig_sim

#endif
