// SPDX-License-Identifier: BSD-3-Clause
// What the simulation thread hands to the publishers.
#include "drill_rig_sim/ros/simulation_loop.h"

#include <cstdio>

namespace drill_rig_sim
{
namespace
{
constexpr int pipe_every = 5;            // joints between two frames of the pipe
constexpr double picture_spacing = 1.0;  // between points of the drawn well [m]
}  // namespace

void SimulationLoop::hand_over(Occasion occasion) noexcept
{
  const bool may_be_lost = time_.is_realtime() && occasion.new_stamp && !occasion.rebuilt;
  FrameOutput* output = may_be_lost ? ring_.try_claim() : ring_.claim();
  if (output == nullptr)
  {
    ++statistics_.unpublished_frames;
    return;
  }
  occasion.whole_picture |= subscriptions_.refresh.exchange(false);
  note_due(*output, occasion);
  if (output->arrays_due() && !ring_.lend_arrays(*output, !may_be_lost)) leave_out_picture(*output, occasion.whole_picture);
  note_shown(*output);
  fill_record(output->frame, output->accuracy_due);
  fill_arrays(*output);
  announced_ = announced_ || occasion.new_stamp;
  ring_.hand_over();
}

void SimulationLoop::note_due(FrameOutput& s, const Occasion& occasion) noexcept
{
  const std::int64_t simulated = time_.stamp();
  const std::int64_t shown = time_.in_lockstep() ? simulated : steady_now();
  const double depth = rig_.simulator->truth().hole_depth;
  s.new_stamp = occasion.new_stamp;
  s.rebuilt = occasion.rebuilt;
  s.state_due = s.new_stamp && (state_cadence_.due(simulated) || occasion.rebuilt);
  s.restored = occasion.restored;
  s.state_again = !s.new_stamp && announced_ && (occasion.said_again || run_state() != run_state_said_);
  if (s.state_due || s.state_again)
  {
    run_state_said_ = run_state();
    refusals_said_ = mailbox_.refusals().number();
  }
  s.accuracy_due = s.new_stamp && (accuracy_cadence_.due(simulated) || occasion.rebuilt || occasion.restored);
  // where time runs on, a new subscriber waits for the next of its stamps
  const bool profile_moves = s.new_stamp && (profile_cadence_.due(simulated) || occasion.restored);
  s.profile_due = (profile_moves || (!s.new_stamp && announced_ && subscriptions_.profile_missing)) && subscriptions_.profile;
  if (s.profile_due)
  {
    subscriptions_.profile_missing = false;
    profile_stamp_ = simulated;
  }
  const bool tf_moves = s.new_stamp && (tf_cadence_.due(shown) || occasion.rebuilt);
  s.tf_due = (tf_moves || subscriptions_.tf_missing.exchange(false)) && subscriptions_.tf;
  s.markers_due = (marker_cadence_.due(shown) || occasion.whole_picture) && subscriptions_.markers;
  s.well_due = occasion.whole_picture || (s.new_stamp && depth != well_handed_over_ && well_cadence_.due(shown));
  s.tube_due = s.markers_due && (tube_pending_ || s.well_due);
}

// Small readings are never left out; a well that has grown is due again at once, and so is a picture for a new subscriber.
void SimulationLoop::leave_out_picture(FrameOutput& s, bool asked_for) noexcept
{
  ++statistics_.pictures_left_out;
  if (asked_for) subscriptions_.refresh = true;
  if (s.well_due) well_cadence_.restart();
  s.profile_due = s.tf_due = s.markers_due = s.well_due = s.tube_due = false;
}

void SimulationLoop::note_shown(const FrameOutput& s) noexcept
{
  if (s.well_due && s.new_stamp) well_handed_over_ = rig_.simulator->truth().hole_depth;
  tube_pending_ = (tube_pending_ || s.well_due) && !s.tube_due;
}

void SimulationLoop::fill_record(FrameRecord& record, bool accuracy_due) const noexcept
{
  record.stamp = time_.stamp();
  record.run_state = run_state();
  record.epoch = epoch_;
  record.truth = rig_.simulator->truth();
  record.readings = rig_.simulator->readings();
  record.rig = rig_.simulator->scene().rig;
  record.commands = rig_.commands;
  record.operation = rig_.playing ? rig_.player.operations().status() : OperationStatus();
  record.playing = rig_.playing;
  record.order = rig_.order;
  record.physics = rig_.simulator->statistics();
  record.accuracy = accuracy_due ? accuracy_with_statistics(*rig_.simulator) : accuracy_of(*rig_.simulator);
  record.loop = statistics_;
  record.loop.overruns = time_.overruns();
  record.loop.dropped_seconds = time_.dropped_seconds();
  record.loop.speed = time_.speed();
  record.loop.ticked_seconds = time_.ticked_seconds();
  record.commands_refused = mailbox_.refusals().number();
  record.last_refusal = mailbox_.refusals().last();
  record.faults = rig_.simulator->active_faults();
  record.fault_depths = rig_.simulator->fault_depths();
  record.last_clamp = rig_.last_clamp;
  std::snprintf(record.failure.data(), record.failure.size(), "%s", rig_.failed ? rig_.simulator->failure() : "");
}

void SimulationLoop::fill_arrays(FrameOutput& s) noexcept
{
  const Wellbore& well = rig_.simulator->wellbore();
  if (s.profile_due || s.markers_due)
  {
    rig_.simulator->profile(s.profile);
    s.axis.clear();
    for (const double md : s.profile.md) s.axis.push_back(well.at(md));
  }
  if (s.tf_due) rig_.simulator->part_poses(pipe_every, s.parts);
  if (s.well_due || s.tube_due)
  {
    s.well.clear();
    for (int i = 0; i < well.node_count(); ++i)
    {
      const WellNode node = well.node(i);
      if (s.well.empty() || node.md >= s.well.back().md + picture_spacing) s.well.push_back(node);
    }
    s.well.push_back(well.at(well.hole_depth()));
    s.stations.clear();
    for (const SurveyStation& station : rig_.simulator->scene().well.survey) s.stations.push_back(well.at(station.md));
  }
}

}  // namespace drill_rig_sim
