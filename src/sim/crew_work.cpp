// SPDX-License-Identifier: BSD-3-Clause
#include "crew_work.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/rig/drive_reference.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
namespace
{
constexpr double lifting_speed = 0.2;    // [m/s]
constexpr double lowering_speed = 0.1;   // [m/s]
constexpr double zeroing_speed = 0.02;   // the same where the weight is zeroed [m/s]
constexpr double slacking_speed = 0.01;  // [m/s]
constexpr double slowest = 5e-4;         // of it when the slips carry hardly anything [m/s]
constexpr double by_load = 5e-7;         // of the block's speed by what the hook carries too much [m/s/N]
constexpr double share_at_a_time =
    0.5;  // of what the hook carries too much, before the gauge shows what a set point does: by twice that the block would swing
constexpr double rests = 2e3;  // what the pipe above the slips may carry to count as slack [N]
constexpr double rest_time = 5.0,
                 quiet_block = 2e-3;                  // the string rings in its lines before it is laid into the slips [s], [m/s]
constexpr double patience = 60.0;                     // with what may not come about [s]
constexpr double above_bottom = 0.1, tares_at = 0.5;  // of the block above where it stopped [m]

WinchSetpoint run(double velocity, const HoistingSpec& spec) noexcept
{
  return {std::clamp(velocity, -spec.max_speed, spec.max_speed), false};
}

bool stands(const State& state) noexcept
{
  return std::abs(state.hoist.winch_speed) <= standing_winch;
}

/// Between a set point of the winch and what it does [s].
double dead_time(const RigSpec& rig) noexcept
{
  return rig.plc_latency + rig.hoisting.latency;
}

/// That the block goes before a set point given now acts [m].
double goes_on_by(const State& state, const RigSpec& rig) noexcept
{
  return std::abs(state.hoist.winch_speed) * dead_time(rig);
}

/// In which the block stops from the winch's speed [m].
double stopping_distance(const State& state, const RigSpec& rig) noexcept
{
  const double speed = state.hoist.winch_speed;
  return goes_on_by(state, rig) + 0.5 * speed * speed / rig.hoisting.max_acceleration + 0.02;
}
}  // namespace

void CrewWork::attend(double duration) noexcept
{
  if (rig_.commands.is_broken_out_by_hand()) rig_.commands.by_crew().winch = to_slack(duration);
  if (!is_busy()) begin_connection();
  if (!is_busy()) return;
  Setpoints& by_crew = rig_.commands.by_crew();
  const double height = block_height(rig_.motion.shown_at_ends());
  if (has_done(duration, by_crew.winch)) go_on(height);
  const bool at_rest = crew_.doing >= CrewTask::quieting && crew_.doing < CrewTask::restarting;
  by_crew.top_drive = at_rest ? TopDriveSetpoint() : rig_.commands.asked().top_drive;
  by_crew.pump = at_rest ? PumpSetpoint() : rig_.commands.asked().pump;
  crew_.pressure.take(rig_.motion.shown_at_ends().hydraulics.stand_pipe_pressure, rig_.motion.shown_at_ends().time);
  if (crew_.doing == CrewTask::lowering && zeroes_at(height)) actions_.tare();  // and again, until the bit is near the bottom
}

/// Whether the weight is zeroed on the way down, at a height of the block [m].
bool CrewWork::zeroes_at(double height) const noexcept
{
  return rig_.state.tared && height <= crew_.stopped_at + tares_at + lift_over_waves(rig_.scene.rig.heave);
}

/// Where the block comes to one of the places from which it goes no further.
void CrewWork::begin_connection() noexcept
{
  if (rig_.scene.connections != Connections::automatic && !crew_.called) return;
  const WinchSetpoint winch = rig_.commands.requested().winch;
  const bool moves = !winch.brake && winch.block_velocity != 0.0;
  if (!moves || rig_.motion.shown_at_ends().slips.node >= 0 || rig_.state.connection.under_way) return;
  const bool adds = winch.block_velocity < 0.0;
  if (!(adds ? has_to_add() : has_to_take_away())) return;
  const bool called = crew_.called;
  crew_ = CrewState();
  crew_.adds = adds;
  crew_.called = called;
  do_task(CrewTask::stopping);
  rig_.commands.by_crew() = rig_.commands.requested();
  rig_.commands.let_crew_drive(true);
}

bool CrewWork::has_to_add() const noexcept
{
  const State& now = rig_.motion.shown_at_ends();
  const Mesh& mesh = rig_.motion.model()->mesh();
  const HoistingSpec& spec = rig_.scene.rig.hoisting;
  if (joints_below_stump(mesh, rig_.scene) < 1) return false;
  const double stand = spec.stand_joints * rig_.scene.string.back().joint_length;
  const double stump = rig_.state.string.length - rig_.pipe.place_of(uppermost_joint(mesh));
  const double height = height_to_add(spec, stump, stand + lift_over_waves(rig_.scene.rig.heave));
  return block_height(now) <= height + stopping_distance(now, rig_.scene.rig);
}

bool CrewWork::has_to_take_away() const noexcept
{
  const State& now = rig_.motion.shown();
  const HoistingSpec& spec = rig_.scene.rig.hoisting;
  const int below_stand = rig_.pipe.joint_below_stand();
  if (below_stand < 0) return false;
  const double joint = now.nodes[static_cast<std::size_t>(below_stand)].position.z() - now.hoist.floor.height;
  const double stop = stopping_distance(now, rig_.scene.rig);
  return joint >= stick_up - stop || block_height(now) >= spec.highest_block_height - stop;
}

/// What brings the pipe above the slips to hang on the hook, no more and no less; for a frame [s]. A set point acts a frame and
/// the dead times later: faster, the block would swing about that place.
WinchSetpoint CrewWork::to_slack(double frame) const noexcept
{
  const HoistingSpec& spec = rig_.scene.rig.hoisting;
  const State& now = rig_.motion.shown_at_ends();
  const double load = rig_.pipe.rest_load();
  if (std::abs(load) <= rests) return {0.0, false};
  const double stiffness = line_pull(spec, block_height(now), now.hoist.line_length).stiffness;
  const double late = frame + dead_time(rig_.scene.rig);
  const double gain = std::min(by_load, share_at_a_time / std::max(stiffness * late, share_at_a_time));
  return run(std::clamp(-gain * load, -slacking_speed, slacking_speed), spec);
}

/// The task under way: its set point of the winch for a frame [s]; true once it is done.
bool CrewWork::has_done(double frame, WinchSetpoint& winch) noexcept
{
  const HoistingSpec& spec = rig_.scene.rig.hoisting;
  const State& now = rig_.motion.shown_at_ends();
  const double height = block_height(now), lift = stick_up + lift_over_waves(rig_.scene.rig.heave);
  const double goes_on = goes_on_by(now, rig_.scene.rig);
  winch = {0.0, false};
  switch (crew_.doing)
  {
    case CrewTask::stopping:
      return stands(now);
    case CrewTask::lifting:
      if (height + goes_on < crew_.stopped_at + lift && crew_.waited < patience) winch = run(lifting_speed, spec);
      return winch.block_velocity == 0.0 && stands(now);
    case CrewTask::quieting:
      return has_quieted();
    case CrewTask::slacking:
      winch = to_slack(frame);
      return winch.block_velocity == 0.0 && stands(now) && has_broken_out();
    case CrewTask::connecting:
      return !rig_.state.connection.under_way;
    case CrewTask::picking_up:
      if (!actions_.pull_slips()) return true;
      winch = run(std::clamp(by_load * slips_load(now), slowest, slacking_speed), spec);
      return false;
    case CrewTask::restarting:
      return has_restarted();
    default:
      winch = run(zeroes_at(height) && rig_.scene.rig.heave.amplitude == 0.0 ? -zeroing_speed : -lowering_speed, spec);
      return height - goes_on <= crew_.stopped_at + above_bottom || crew_.waited > patience;
  }
}

bool CrewWork::has_quieted() noexcept
{
  const State& now = rig_.motion.shown_at_ends();
  const bool quiet = std::abs(block_velocity(now)) < quiet_block || crew_.waited > patience;
  const bool at_rest = std::abs(now.drive.speed) <= standing_rotor && now.hydraulics.pump_flow <= 0.0;
  const int joint = crew_.adds ? uppermost_joint(rig_.motion.model()->mesh()) : rig_.pipe.joint_below_stand();
  return crew_.waited > rest_time && quiet && at_rest && !actions_.set_slips(joint);
}

/// Or fails the rig, where waiting does not help.
bool CrewWork::has_broken_out() noexcept
{
  const char* refused = actions_.make_connection(0, !crew_.adds);
  if (refused && crew_.waited > patience) rig_.fail(refused);
  return !refused;
}

bool CrewWork::has_restarted() const noexcept
{
  const State& now = rig_.motion.shown_at_ends();
  const Setpoints& asked = rig_.commands.asked();
  const double speed = asked.top_drive.speed, flow = asked.pump.flow;
  const bool to_speed = !asked.top_drive.brake && keeps_speed(asked.top_drive.mode);
  const bool turns = !to_speed || std::abs(now.drive.speed - speed) <= 0.05 * std::abs(speed) + standing_rotor;
  const bool is_steady = !rig_.state.tared || crew_.pressure.is_steady();
  return crew_.waited > patience || (turns && is_steady && std::abs(now.hydraulics.pump_flow - flow) <= 0.01 * flow);
}

/// To the next task; `height`: of the block [m].
void CrewWork::go_on(double height) noexcept
{
  const CrewTask done = crew_.doing;
  if (done == CrewTask::stopping) crew_.stopped_at = height;
  if (done == CrewTask::connecting) crew_.stopped_at += height - crew_.broken_out_at;
  if (done == CrewTask::slacking) crew_.broken_out_at = height;
  CrewTask next = static_cast<CrewTask>(static_cast<int>(done) + 1);
  if (next == CrewTask::lifting && !crew_.adds) next = CrewTask::quieting;
  if (done == CrewTask::lowering || (done == CrewTask::restarting && !crew_.adds)) next = CrewTask::none;
  do_task(next);
  if (next == CrewTask::none) rig_.commands.let_crew_drive(false);
}

void CrewWork::do_task(CrewTask task) noexcept
{
  crew_.doing = task;
  crew_.waited = 0.0;
}

}  // namespace drill_rig_sim
