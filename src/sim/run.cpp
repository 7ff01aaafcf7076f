#include "drill_rig_sim/sim/run.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double growth = 1e-3;  // of the hole that is not nothing [m]
}  // namespace

FrameStatus play_frame(Simulator& simulator, ProgramPlayer* program, double duration) noexcept
{
  if (program) program->apply(simulator);
  simulator.attend();
  return simulator.frame(duration);
}

double frame_of_whole_steps(double length, double step) noexcept
{
  return step > 0.0 ? step * std::max(1.0, std::round(length / step)) : length;
}

RunEnd run(Simulator& simulator, ProgramPlayer& program, const RunGoal& goal, double frame_length,
           const std::function<void(const Truth&)>& after_frame)
{
  const double frame = frame_of_whole_steps(frame_length, simulator.scene().numerics.step);
  const Truth& m = simulator.truth();
  // half a frame: the sums of many steps miss the end by rounding
  const double last_start = m.time + goal.duration - 0.5 * frame;
  double grown_at = m.time, grown_to = m.hole_depth;
  while (m.hole_depth < goal.depth)
  {
    if (m.time >= last_start) return RunEnd::duration;
    if (m.time - grown_at >= goal.patience) return RunEnd::standstill;
    if (play_frame(simulator, &program, frame) == FrameStatus::failed) return RunEnd::failure;
    if (!program.finished() || m.operation != Operation::none || m.hole_depth >= grown_to + growth)
    {
      grown_at = m.time;
      grown_to = m.hole_depth;
    }
    if (after_frame) after_frame(m);
  }
  return RunEnd::depth;
}

}  // namespace drill_rig_sim
