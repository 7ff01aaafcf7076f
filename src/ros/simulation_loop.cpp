// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/ros/simulation_loop.h"

#include "drill_rig_sim/sim/run.h"

namespace drill_rig_sim
{
namespace
{
constexpr std::size_t spare_points = 4096;
constexpr std::int64_t most_behind = 1000000000;      // of the next frame of a rig that follows; far less than
                                                      // Timekeeper::longest_jump, where it would leave out frames [ns]
constexpr std::int64_t longest_silence = 3000000000;  // of a follower that is waited for within a step [wall ns]
constexpr std::int64_t told_again = 500000000;        // wall time after which a rig_state without an answer is sent again [ns]
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
      well_cadence_(parameters.trajectory_rate),
      wake_(mailbox.bell())
{
  mailbox_.ring_for_commands(parameters.step_on_commands != 0);
  set_timeout();
  pace_companions();
  reserve_memory();
}

SimulationLoop::~SimulationLoop()
{
  join();
}

void SimulationLoop::start()
{
  time_.restart(steady_now());
  if (time_.follows())
    hand_over({});  // no stamp before another rig's clock is received: only for the diagnostics
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
  step_on_commands();
  const bool may_run = !halted_ && run_state() == RunState::running;
  if (may_run && time_.adopt_clock()) restart_cadences();
  const std::int64_t due = may_run ? time_.next_frame_at() : Timekeeper::not_yet;
  subscriptions_.time_stands = due == Timekeeper::not_yet;
  if (due == Timekeeper::not_yet)
  {
    if (subscriptions_.refresh.exchange(false)) hand_over({false, true});
    if (run_state() != RunState::running && refusals_said_ != mailbox_.refusals().number()) hand_over_again();
    return wait_while_time_stands();
  }
  if (time_.in_lockstep() && slowest_follower_ < time_.stamp() - most_behind) return wait_for_followers();
  if (due > steady_now() && wake_.wait_until(due)) return;  // a request has come: it is first
  one_frame(steady_now());
}

/// Where all have answered the last rig_state, on to the next one.
void SimulationLoop::step_on_commands() noexcept
{
  if (parameters_.step_on_commands == 0 || run_state() != RunState::waiting || halted_) return;
  if (mailbox_.answered(parameters_.step_on_commands, time_.stamp())) frames_to_go_ = parameters_.frames_of_state();
}

/// A controller that has come since, or has lost the last rig_state, gets it again now and then: it would wait for ever, and
/// the rig for it.
void SimulationLoop::wait_while_time_stands() noexcept
{
  const bool tells = parameters_.step_on_commands != 0 && run_state() == RunState::waiting && !halted_;
  if (!tells) return wake_.wait();
  if (!wake_.wait_until(steady_now() + told_again)) hand_over_again();
}

/// Woken as a follower goes on. One that says nothing is left behind until it does: it may wait for the next clock.
void SimulationLoop::wait_for_followers() noexcept
{
  if (!wake_.wait_until(steady_now() + longest_silence)) slowest_follower_ = INT64_MAX;
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
  if (frames_to_go_ > 0) --frames_to_go_;
  if (stepping_) ++step_.frames;
  hand_over({!rig_.failed, rig_.failed, !announced_});
  if (stepping_ && (rig_.failed || frames_to_go_ == 0))
    end_step(rig_.failed ? StepResult::End::failed : StepResult::End::complete);
  if (rig_.failed) frames_to_go_ = 0;
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
  if (rig_.playing) take_over(kind == CommandKind::winch);
  watch_stream(c);
  return result;
}

template CommandResult SimulationLoop::accept(const WinchSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const TopDriveSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const PumpSetpoint&, CommandKind) noexcept;
template CommandResult SimulationLoop::accept(const SteeringSetpoint&, CommandKind) noexcept;

// A single command stands until the next one, and so does the last one of a stream where it stops what it moved: a driller's hand
// goes elsewhere.
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

void SimulationLoop::take_over(bool by_winch) noexcept
{
  rig_.playing = false;
  rig_.player.hand_over(*rig_.simulator, by_winch);
  set_timeout();
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

// --- between frames -----------------------------------------------------------------------------------------------------------

RunState SimulationLoop::run_state() const noexcept
{
  if (rig_.failed) return RunState::failed;
  if (time_.in_lockstep()) return frames_to_go_ > 0 ? RunState::running : RunState::waiting;
  return paused_ ? RunState::paused : RunState::running;
}

void SimulationLoop::set_paused(bool paused) noexcept
{
  if (paused && !paused_ && profile_stamp_ != time_.stamp())
    subscriptions_.profile_missing = true;  // the last one is older than what stands now
  paused_ = paused;
  time_.restart(steady_now());
  hand_over({});  // for the diagnostics and rig_state's run_state
}

std::uint32_t SimulationLoop::play(const ScenePlayer& player)
{
  if (rig_.playing) rig_.player.hand_over(*rig_.simulator, false);
  rig_.player = player;
  rig_.playing = true;
  rig_.order = ++orders_;
  mailbox_.clear();
  set_timeout();
  hand_over_again();
  return rig_.order;
}

void SimulationLoop::stop_playing(std::uint32_t order) noexcept
{
  if (!rig_.playing || rig_.order != order) return;
  take_over(false);
  hand_over_again();
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
  for (Cadence* cadence :
       {&state_cadence_, &accuracy_cadence_, &profile_cadence_, &tf_cadence_, &marker_cadence_, &well_cadence_})
    cadence->restart();
}

bool SimulationLoop::go_back(const SimulatorState& state, const ScenePlayer& player, bool playing, const CommandStamps& commands)
{
  if (!rig_.simulator->restore(state)) return false;
  ++epoch_;
  rig_.player = player;
  rig_.playing = playing;
  rig_.order = 0;
  rig_.failed = false;
  rig_.commands = commands;
  mailbox_.clear();
  set_timeout();
  publish_now(false);
  return true;
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
  frames_to_go_ = 0;
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
