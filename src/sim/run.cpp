// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/run.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double growth = 1e-3;    // of the hole that is not nothing [m]
constexpr double approach = 1e-4;  // of an operation's progress

/// When a run last got anywhere.
class Gains
{
public:
  explicit Gains(const Truth& m) : gained_at_(m.time), played_at_(m.time), depth_(m.hole_depth) {}

  void note(const Truth& m, const ScenePlayer& player)
  {
    if (!player.finished()) played_at_ = m.time;
    const OperationStatus operation = player.operations().status();
    const bool nearer = operation.number != number_ || operation.progress >= progress_ + approach;
    const bool by_lines = !player.finished() && operation.number == 0;
    if (!nearer && !by_lines && m.hole_depth < depth_ + growth) return;
    gained_at_ = m.time;
    depth_ = m.hole_depth;
    number_ = operation.number;
    progress_ = operation.progress;
  }
  double gained_at() const { return gained_at_; }
  double played_at() const { return played_at_; }

private:
  double gained_at_, played_at_;  // [s]
  double depth_;                  // of the hole [m]
  int number_ = 0;
  double progress_ = 0.0;
};
}  // namespace

FrameStatus play_frame(Simulator& simulator, ScenePlayer* player, double duration) noexcept
{
  if (player) player->apply(simulator);
  simulator.attend(duration);
  return simulator.frame(duration);
}

double frame_of_whole_steps(double length, double step) noexcept
{
  return step > 0.0 ? step * std::max(1.0, std::round(length / step)) : length;
}

RunEnd run(Simulator& simulator, ScenePlayer& player, const RunGoal& goal, double frame_length,
           const std::function<void(const Truth&)>& after_frame)
{
  const double frame = frame_of_whole_steps(frame_length, simulator.scene().numerics.step);
  const Truth& m = simulator.truth();
  // half a frame: the sums of many steps miss the end by rounding
  const double last_start = m.time + goal.duration - 0.5 * frame;
  Gains gains(m);
  while (m.hole_depth < goal.depth)
  {
    if (m.time >= last_start) return RunEnd::duration;
    if (m.time - gains.gained_at() >= goal.patience) return RunEnd::standstill;
    if (player.operations().status().trouble != OperationTrouble::none) return RunEnd::trouble;
    if (player.finished() && m.time - gains.played_at() >= goal.goes_on - 0.5 * frame) return RunEnd::played;
    if (play_frame(simulator, &player, frame) == FrameStatus::failed) return RunEnd::failure;
    gains.note(m, player);
    if (after_frame) after_frame(m);
  }
  return RunEnd::depth;
}

}  // namespace drill_rig_sim
