// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_ROS_SIMULATION_LOOP_H
#define DRILL_RIG_SIM_ROS_SIMULATION_LOOP_H

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "drill_rig_sim/crew/command_stream.h"
#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/math/semaphore.h"
#include "drill_rig_sim/realtime/cadence.h"
#include "drill_rig_sim/realtime/frame_ring.h"
#include "drill_rig_sim/realtime/timekeeper.h"
#include "drill_rig_sim/ros/mailbox.h"
#include "drill_rig_sim/ros/parameters.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// Which displays have subscribers; written by the publishers, read by the simulation thread, but for `time_stands`.
struct Subscriptions
{
  std::atomic<bool> profile{false};
  std::atomic<bool> profile_missing{false};  ///< a subscriber of drillstring_state has received none yet
  std::atomic<bool> markers{false};
  std::atomic<bool> tf{false};
  std::atomic<bool> tf_missing{false};  ///< a subscriber of tf has received none yet
  std::atomic<bool> refresh{false};     ///< a new subscriber waits for the present state
  std::atomic<bool> time_stands{true};  ///< written by the simulation thread: no frame comes before it is asked for
};

/// What the simulation thread works on. Others touch it in SimulationLoop::between_frames() only.
struct RunningRig
{
  RunningRig(std::unique_ptr<Simulator> s, bool play);

  std::unique_ptr<Simulator> simulator;
  ScenePlayer player;
  bool playing;             ///< the player's program and operations give the commands
  std::uint32_t order = 0;  ///< number of what play() gave it; 0: what it plays is the scene's
  bool failed = false;
  CommandStamps commands;
  CommandStream winch_stream, drive_stream;
  const char* last_clamp = "";
};

/// What became of a step().
struct StepResult
{
  enum class End
  {
    complete,
    failed,       ///< a frame failed
    ended_early,  ///< by end_step_early()
    shut_down     ///< by halt()
  };
  End end = End::complete;
  std::uint32_t frames = 0;       ///< computed, a failed one included
  std::uint64_t handed_over = 0;  ///< to the publishers since the node began, the step's last one included
};

/// The simulation thread: takes the commands, computes a frame when the timekeeper lets it, hands over its output. It never
/// locks, logs or allocates (the outputs' arrays have got their memory before), but between two frames where a connection ends:
/// for the string is rebuilt then. It waits in one place, on one semaphore.
class SimulationLoop
{
public:
  SimulationLoop(const Parameters& parameters, std::unique_ptr<Simulator> simulator, Mailbox& mailbox, FrameRing& ring);
  ~SimulationLoop();

  void start();
  /// Ends a step() under way; the thread goes on letting between-frames callbacks in.
  void halt() noexcept;
  /// Ends the thread; visit() must not be called any more.
  void join();

  /// Runs `visit(loop)` while the simulation thread stands between two frames. One visit at a time.
  template <class Visit>
  void between_frames(Visit visit)
  {
    const std::lock_guard<std::mutex> alone(callers_);
    asked_ = true;
    wake_.post();
    entered_.wait();
    try
    {
      visit(*this);
    }
    catch (...)
    {
      left_.post();
      throw;
    }
    left_.post();
  }

  // For between-frames callbacks
  RunningRig& rig() noexcept { return rig_; }
  Timekeeper& time() noexcept { return time_; }
  bool paused() const noexcept { return paused_; }
  void set_paused(bool paused) noexcept;
  /// Simulated seconds per wall second; 0: as fast as possible.
  void set_speed(double speed)
  {
    time_.set_speed(speed, steady_now());
    pace_companions();
  }
  /// Another simulator takes over, its commands zeroed; returns the old one, which the caller destroys.
  std::unique_ptr<Simulator> replace(std::unique_ptr<Simulator> simulator);
  /// Back to a saved state of this simulator, to where its player was and to its commands' stamps. The clock runs on. False, and
  /// nothing changed: Simulator::restore().
  bool go_back(const SimulatorState& state, const ScenePlayer& player, bool playing, const CommandStamps& commands);
  /// Another player gives the commands from the next frame on. Its number, by which frames are marked (FrameRecord::order).
  std::uint32_t play(const ScenePlayer& player);
  /// Ends the player of this number, unless another has come: a block that it moves is braked.
  void stop_playing(std::uint32_t order) noexcept;
  /// How often another rig, well or saved state has taken the place of the one before.
  std::uint32_t epoch() const noexcept { return epoch_; }
  /// Hands the present state over once more, stamped as it was: after a change only of the readings. While time stands rig_state
  /// says it; otherwise its next frame does.
  void hand_over_again() noexcept;
  /// What came from topics up to now.
  void take_commands() noexcept;
  CommandResult take(const WinchSetpoint& c) noexcept { return accept(c, CommandKind::winch); }
  CommandResult take(const TopDriveSetpoint& c) noexcept { return accept(c, CommandKind::top_drive); }
  CommandResult take(const PumpSetpoint& c) noexcept { return accept(c, CommandKind::mud_pump); }
  CommandResult take(const SteeringSetpoint& c) noexcept { return accept(c, CommandKind::steering); }
  RunState run_state() const noexcept;

  /// For between-frames callbacks: the step under way ends here. False: none is.
  bool end_step_early() noexcept;

  /// Lockstep, for between-frames callbacks: has `frames` frames computed. wait_for_step(), by the same caller outside of the
  /// callback, waits until they are handed over, fewer where one fails or the step is ended. One caller at a time.
  void begin_step(std::uint32_t frames) noexcept;
  StepResult wait_for_step() noexcept;

  /// From any one thread: the clock of another rig [ns].
  void hear_clock(std::int64_t clock) noexcept
  {
    time_.hear_clock(clock);
    wake_.post();
  }
  /// From any thread, in lockstep: the least stamp of the next frames of the rigs that follow this one's clock [ns].
  void hear_followers(std::int64_t slowest) noexcept
  {
    slowest_follower_ = slowest;
    wake_.post();
  }
  Subscriptions& subscriptions() noexcept { return subscriptions_; }
  /// Asks for one picture of the present state while time stands.
  void refresh() noexcept
  {
    subscriptions_.refresh = true;
    wake_.post();
  }

private:
  // Why an output is handed over.
  struct Occasion
  {
    bool new_stamp = false;      // the stamp has moved on
    bool whole_picture = false;  // everything that can be drawn, the well included
    bool rebuilt = false;        // another rig or well
    bool restored = false;       // a state that was saved
    bool said_again = false;     // without a new stamp: rig_state repeats it
  };

  void run() noexcept;
  void run_between_frames() noexcept;
  void wait_or_work() noexcept;
  void step_on_commands() noexcept;
  void wait_while_time_stands() noexcept;
  void wait_for_followers() noexcept;
  void one_frame(std::int64_t now) noexcept;
  void publish_now(bool rebuilt) noexcept;
  void restart_cadences() noexcept;
  /// In lockstep, as fast as possible and faster than real time a frame may wait for them, in real time it must not.
  void pace_companions()
  {
    const bool keeps_time = !time_.in_lockstep() && (time_.follows() || (time_.speed() > 0.0 && time_.speed() <= 1.0));
    rig_.simulator->set_companion_pace(keeps_time ? CompanionPace::own_thread_unwaited : CompanionPace::own_thread);
  }
  template <class Setpoint>
  CommandResult accept(const Setpoint& c, CommandKind kind) noexcept;
  void set_timeout() noexcept;
  void take_over(bool by_winch) noexcept;
  void watch_stream(const WinchSetpoint& c) noexcept;
  void watch_stream(const TopDriveSetpoint& c) noexcept;
  void watch_stream(const PumpSetpoint&) noexcept {}
  void watch_stream(const SteeringSetpoint&) noexcept {}
  void end_step(StepResult::End end) noexcept;
  void hand_over(Occasion occasion) noexcept;
  void note_due(FrameOutput& s, const Occasion& occasion) noexcept;
  void fill_record(FrameRecord& record, bool accuracy_due) const noexcept;
  void leave_out_picture(FrameOutput& s, bool asked_for) noexcept;
  void note_shown(const FrameOutput& s) noexcept;
  void fill_arrays(FrameOutput& s) noexcept;
  void reserve_memory();

  const Parameters& parameters_;
  Mailbox& mailbox_;
  FrameRing& ring_;
  RunningRig rig_;
  Timekeeper time_;
  Subscriptions subscriptions_;
  LoopStatistics statistics_;
  double frame_duration_;  // [s]
  bool paused_ = false;
  double well_handed_over_ = -1.0;  // hole depth then [m]
  bool tube_pending_ = false;       // the well has changed since markers showed it last
  Cadence state_cadence_, accuracy_cadence_, profile_cadence_, tf_cadence_, marker_cadence_, well_cadence_;

  std::uint64_t refusals_said_ = 0;  // in rig_state
  std::atomic<std::int64_t> slowest_follower_{INT64_MAX};
  std::atomic<bool> halted_{false}, quit_{false}, asked_{false};
  std::mutex callers_;
  Semaphore& wake_;  // the mailbox's, which outlives this
  Semaphore entered_, left_, step_done_;
  std::int64_t profile_stamp_ = -1;  ///< of the last drillstring_state [ns]
  std::uint32_t frames_to_go_ = 0;
  bool stepping_ = false;
  StepResult step_;
  std::uint32_t epoch_ = 0, orders_ = 0;         // of FrameRecord
  RunState run_state_said_ = RunState::waiting;  // what rig_state said last
  bool announced_ = false;                       // a stamped frame of this rig has been handed over
  std::thread thread_;
};

}  // namespace drill_rig_sim

#endif
