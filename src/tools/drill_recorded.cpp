// SPDX-License-Identifier: BSD-3-Clause
#include "drill_recorded.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "drill_command.h"
#include "drill_rig_sim/accuracy/outputs.h"
#include "drill_run_options.h"

namespace drill_rig_sim
{
namespace
{
constexpr double rounding = 1e-6;  // of stamps and sums of frames [s]

/// The frames' length in whole steps of the scene.
double frame_of(const RecordedRun& run, double step)
{
  double shortest = frame_length;
  for (std::size_t i = 1; i < run.rows.size(); ++i) shortest = std::min(shortest, run.rows[i].time - run.rows[i - 1].time);
  return frame_of_whole_steps(shortest < frame_length - rounding ? shortest : frame_length, step);
}

std::string fixed(double value, int digits)
{
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}
}  // namespace

bool is_bag(const std::string& file)
{
  const std::string end = ".bag";
  return file.size() > end.size() && file.compare(file.size() - end.size(), end.size(), end) == 0;
}

RecordedPlayer::RecordedPlayer(std::string file, const RecordedRun& run, const Scene& scene)
    : file_(std::move(file)), run_(run), program_(scene), frame_(frame_of(run, scene.numerics.step))
{
  const RecordedRun::Row& first = run.rows.front();
  if (first.commanded && first.time > frame_ + rounding)
    throw UsageError(file_ + ": begins " + fixed(first.time, 2) +
                     " s after the start of the rig, after the first command; needed: a bag recorded from the start");
}

void RecordedPlayer::command(Simulator& simulator, const Setpoints& setpoints)
{
  const bool first = !commands_;
  commands_ = true;
  if (first || !(setpoints.winch == commanded_.winch)) simulator.command(setpoints.winch);
  if (first || !(setpoints.top_drive == commanded_.top_drive)) simulator.command(setpoints.top_drive);
  if (first || setpoints.pump.flow != commanded_.pump.flow) simulator.command(setpoints.pump);
  if ((first || !(setpoints.steering == commanded_.steering)) && simulator.locked(setpoints.steering) == nullptr)
    simulator.command(setpoints.steering);
  commanded_ = setpoints;
}

void RecordedPlayer::require_recorded(const Truth& truth, const RecordedRun::Row& row, double tolerance) const
{
  const auto require = [&](const char* what, double found, double recorded, Output output, const char* unit)
  {
    if (std::abs(found - recorded) <= std::max(traits_of(output).resolved, tolerance * std::abs(recorded))) return;
    throw UsageError(file_ + ": cannot be replayed: at " + fixed(row.time, 2) + " s the " + what + " is " +
                     fixed(1e-3 * found, 2) + " " + unit + ", recorded: " + fixed(1e-3 * recorded, 2) +
                     "; services (faults, slips, connections, snapshots) are not in a bag, and another build may differ");
  };
  require("hook load", truth.hook_load, row.hook_load, Output::hook_load, "kN");
  require("torque", truth.torque, row.torque, Output::torque, "kN m");
}

RunEnd RecordedPlayer::play(Simulator& simulator, double duration, const std::function<void(const Truth&)>& after_frame)
{
  const Truth& m = simulator.truth();
  const double tolerance = simulator.scene().numerics.tolerance;
  auto row = run_.rows.begin();
  while (m.time < std::min(duration, this->duration()) - 0.5 * frame_)
  {
    const double end = m.time + frame_;
    while (row->time < end - 0.25 * frame_ && std::next(row) != run_.rows.end()) ++row;
    if (row->commanded)
      command(simulator, row->setpoints);
    else
      program_.apply(simulator);
    if (play_frame(simulator, nullptr, frame_) == FrameStatus::failed) return RunEnd::failure;
    if (std::abs(row->time - m.time) < 0.25 * frame_) require_recorded(m, *row, tolerance);
    after_frame(m);
  }
  return RunEnd::duration;
}

}  // namespace drill_rig_sim
