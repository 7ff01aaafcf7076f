#include "drill_rig_sim/ros/simulation_loop.h"

#include <cstdio>

#include "drill_rig_sim/sim/run.h"

namespace drill_rig_sim
{
namespace
{
constexpr int pipe_every = 5;            // joints between two frames of the pipe
constexpr double picture_spacing = 1.0;  // between points of the drawn well [m]
constexpr std::size_t spare_points = 4096;
}  // namespace

RunningRig::RunningRig(std::unique_ptr<Simulator> s, bool play)
    : simulator(std::move(s)), player(simulator->scene()), playing(play)
{
}

SimulationLoop::SimulationLoop(const Parameters& parameters, std::unique_ptr<Simulator> simulator, Mailbox& mailbox,
                               FrameRing& ring)
    : parameters_(parameters),
      mailbox_(mailbox),
      ring_(ring),
      rig_(std::move(simulator), parameters.play_program),
      time_(parameters.time_source(), parameters.clock, parameters.frame_period(),
            static_cast<std::int64_t>(ros::WallTime::now().toNSec())),
      frame_duration_(1.0 / parameters.rate),
      state_cadence_(parameters.state_rate),
      accuracy_cadence_(accuracy_rate),
      profile_cadence_(parameters.drillstring_rate),
      tf_cadence_(parameters.tf_rate),
      marker_cadence_(parameters.marker_rate),
      well_cadence_(parameters.trajectory_rate)
{
  set_timeout();
  pace_companions();
  reserve_memory();
}

SimulationLoop::~SimulationLoop() { join(); }

void SimulationLoop::start()
{
  time_.restart(steady_now());
  if (time_.follows())
    hand_over({});  // no stamp before another rig's clock is heard: for the diagnostics alone
  else
    publish_now(true);
  thread_ = std::thread([this] { run(); });
}

void SimulationLoop::halt() noexcept
{
  halted_ = true;
  wake_.post();
}

void SimulationLoop::join()
{
  if (!thread_.joinable()) return;
  quit_ = true;
  wake_.post();
  thread_.join();
}

// --- the simulation thread ----------------------------------------------------------------------------------------------

void SimulationLoop::run() noexcept
{
  name_thread("simulation");
  wake_on_time();
  prioritise_thread(parameters_.realtime.fifo_priority, parameters_.realtime.core);
  time_.restart(steady_now());  // what the thread took to come is no lateness of frames
  while (!quit_)
  {
    run_between_frames();
    wait_or_work();
  }
}

void SimulationLoop::run_between_frames() noexcept
{
  if (!asked_.exchange(false)) return;
  entered_.post();
  left_.wait();
}

void SimulationLoop::wait_or_work() noexcept
{
  if (halted_ && stepping_) end_step(StepResult::End::shut_down);
  const bool may_run = !halted_ && run_state() == RunState::running;
  if (may_run && time_.adopt_clock()) restart_cadences();
  const std::int64_t due = may_run ? time_.next_frame_at() : Timekeeper::not_yet;
  subscriptions_.time_stands = due == Timekeeper::not_yet;
  if (due == Timekeeper::not_yet)
  {
    if (subscriptions_.refresh.exchange(false)) hand_over({false, true});
    wake_.wait();
    return;
  }
  if (due > steady_now() && wake_.wait_until(due)) return;  // a request has come: it is first
  one_frame(steady_now());
}

void SimulationLoop::one_frame(std::int64_t now) noexcept
{
  const std::int64_t late = time_.frame_begins(now);
  if (time_.is_realtime()) statistics_.lateness.add(late, time_.wall_period());
  take_commands();
  ScenePlayer* player = rig_.playing ? &rig_.player : nullptr;
  rig_.failed = play_frame(*rig_.simulator, player, frame_duration_) == FrameStatus::failed;
  statistics_.frame_times.add(steady_now() - now, time_.wall_period());

  if (!rig_.failed) time_.tick();
  if (stepping_)
  {
    --frames_to_go_;
    ++step_.frames;
  }
  hand_over({!rig_.failed, rig_.failed, !announced_});
  if (stepping_ && (rig_.failed || frames_to_go_ == 0))
    end_step(rig_.failed ? StepResult::End::failed : StepResult::End::complete);
}

void SimulationLoop::take_commands() noexcept
{
  if (const WinchSetpoint* c = mailbox_.winch()) take(*c);
  if (const TopDriveSetpoint* c = mailbox_.top_drive()) take(*c);
  if (const PumpSetpoint* c = mailbox_.pump()) take(*c);
  if (const SteeringSetpoint* c = mailbox_.steering()) take(*c);
}

template <class Setpoint>
CommandResult SimulationLoop::accept(const Setpoint& c, CommandKind kind) noexcept
{
  const CommandResult result = rig_.simulator->command(c);
  if (result.outcome == CommandResult::Outcome::refused)
  {
    mailbox_.refusals().count(result.reason);
    return result;
  }
  if (result.outcome == CommandResult::Outcome::clamped) rig_.last_clamp = result.reason;
  rig_.commands.last = rig_.commands.of(kind) = time_.stamp();
  if (rig_.playing)
  {
    rig_.playing = false;  // a command takes over the rig
    set_timeout();
  }
  watch_stream(c);
  return result;
}

template CommandResult SimulationLoop::accept(const WinchSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const TopDriveSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const PumpSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const SteeringSetpoint&, CommandKind) noexcept;

// A single command stands until the next one, and so does the last one of a stream where it stops what it moved: a driller's hand goes elsewhere.
void SimulationLoop::watch_stream(const WinchSetpoint& c) noexcept
{
  const bool is_stream = rig_.winch_stream.take(rig_.simulator->truth().time, parameters_.command_timeout);
  if (!is_stream || !moves(c)) rig_.simulator->winch_command_stands();
}

void SimulationLoop::watch_stream(const TopDriveSetpoint& c) noexcept
{
  const bool is_stream = rig_.drive_stream.take(rig_.simulator->truth().time, parameters_.command_timeout);
  if (!is_stream || !turns(c)) rig_.simulator->drive_command_stands();
}

// A program speaks once per line: its silence is no lost stream.
void SimulationLoop::set_timeout() noexcept
{
  rig_.simulator->set_command_timeout(rig_.playing ? 0.0 : parameters_.command_timeout);
}

void SimulationLoop::end_step(StepResult::End end) noexcept
{
  stepping_ = false;
  frames_to_go_ = 0;
  step_.end = end;
  step_.handed_over = ring_.handed_over();
  step_done_.post();
}

// --- what a frame hands out -------------------------------------------------------------------------------------------------

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
  if (s.state_due || s.state_again) run_state_said_ = run_state();
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
  record.physics = rig_.simulator->statistics();
  record.accuracy = accuracy_due ? accuracy_with_statistics(*rig_.simulator) : accuracy_of(*rig_.simulator);
  record.loop = statistics_;
  record.loop.overruns = time_.overruns();
  record.loop.dropped_seconds = time_.dropped_seconds();
  record.loop.speed = time_.speed();
  record.loop.ticked_seconds = time_.ticked_seconds();
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

// --- between frames -----------------------------------------------------------------------------------------------------------

RunState SimulationLoop::run_state() const noexcept
{
  if (rig_.failed) return RunState::failed;
  if (time_.in_lockstep()) return frames_to_go_ > 0 ? RunState::running : RunState::waiting;
  return paused_ ? RunState::paused : RunState::running;
}

void SimulationLoop::set_paused(bool paused) noexcept
{
  if (paused && !paused_ && profile_stamp_ != time_.stamp()) subscriptions_.profile_missing = true;  // the last one is older than what stands now
  paused_ = paused;
  time_.restart(steady_now());
  hand_over({});  // for the diagnostics and rig_state's run_state
}

std::unique_ptr<Simulator> SimulationLoop::replace(std::unique_ptr<Simulator> simulator)
{
  std::unique_ptr<Simulator> old = std::move(rig_.simulator);
  rig_ = RunningRig(std::move(simulator), parameters_.play_program);
  ++epoch_;
  mailbox_.clear();
  set_timeout();
  pace_companions();
  reserve_memory();
  restart_cadences();
  publish_now(true);
  return old;
}

void SimulationLoop::restart_cadences() noexcept
{
  for (Cadence* cadence : {&state_cadence_, &accuracy_cadence_, &profile_cadence_, &tf_cadence_, &marker_cadence_, &well_cadence_})
    cadence->restart();
}

void SimulationLoop::go_back(const SimulatorState& state, const ScenePlayer& player, bool playing, const CommandStamps& commands)
{
  rig_.simulator->restore(state);
  ++epoch_;
  rig_.player = player;
  rig_.playing = playing;
  rig_.failed = false;
  rig_.commands = commands;
  mailbox_.clear();
  set_timeout();
  publish_now(false);
}

void SimulationLoop::hand_over_again() noexcept
{
  Occasion again;
  again.said_again = run_state() != RunState::running;
  hand_over(again);
}

/// The present state as one tick of the clock: after a change that no frame made.
void SimulationLoop::publish_now(bool rebuilt) noexcept
{
  time_.tick();
  time_.restart(steady_now());
  hand_over({true, true, rebuilt, !rebuilt});
}

void SimulationLoop::begin_step(std::uint32_t frames) noexcept
{
  step_ = StepResult();
  frames_to_go_ = frames;
  stepping_ = true;
  if (frames == 0) end_step(StepResult::End::complete);
}

StepResult SimulationLoop::wait_for_step() noexcept
{
  step_done_.wait();
  return step_;
}

bool SimulationLoop::end_step_early() noexcept
{
  if (!stepping_) return false;
  frames_to_go_ = 0;
  hand_over({});  // for rig_state's run_state
  end_step(StepResult::End::ended_early);
  return true;
}

void SimulationLoop::reserve_memory()
{
  const Wellbore& well = rig_.simulator->wellbore();
  FrameOutput whole;
  whole.profile_due = whole.tf_due = whole.well_due = true;
  ring_.with_every_set(
      [&](FrameArrays& set)
      {
        std::swap<FrameArrays>(whole, set);
        whole.well.reserve(static_cast<std::size_t>(well.node_count()) + spare_points);
        fill_arrays(whole);
        std::swap<FrameArrays>(whole, set);
      });
}

}  // namespace drill_rig_sim
