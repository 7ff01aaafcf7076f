// Connections that the crew makes by itself.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/rig/drive_reference.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
namespace
{
constexpr double lifting_speed = 0.2;     // [m/s]
constexpr double lowering_speed = 0.1;    // [m/s]
constexpr double slacking_speed = 0.01;   // [m/s]
constexpr double slowest = 5e-4;          // of it when the slips bear hardly anything [m/s]
constexpr double by_load = 5e-7;          // of the block's speed by what the hook carries too much [m/s/N]
constexpr double share_in_a_frame = 0.5;  // of what the hook carries too much that is taken off in one frame at most: by twice that the block would swing
constexpr double rests = 2e3;             // what the pipe above the slips may carry to count as slack [N]
constexpr double rest_time = 5.0, quiet_block = 2e-3;  // the string rings in its lines before it is laid into the slips [s], [m/s]
constexpr double patience = 60.0;         // with what may not come about [s]
constexpr double above_bottom = 0.1, tares_at = 0.5;  // of the block above where it stopped [m]

WinchSetpoint run(double velocity, const HoistingSpec& spec) noexcept
{
  return {std::clamp(velocity, -spec.max_speed, spec.max_speed), false};
}

bool stands(const State& state) noexcept
{
  return std::abs(state.hoist.winch_speed) <= standing_winch;
}
}  // namespace

const char* text_of(CrewTask task) noexcept
{
  static constexpr const char* words[] = {"", "stopping", "lifting", "quieting", "slacking", "connecting", "picking_up", "restarting", "lowering"};
  return words[static_cast<std::size_t>(task)];
}

double height_to_add(const HoistingSpec& spec, double stump, double stand) noexcept
{
  return std::max(spec.lowest_block_height, std::min(stump, spec.highest_block_height - room_for_stand(stand)));
}

void Simulator::Impl::crew_does(CrewTask task) noexcept
{
  state.crew.doing = task;
  state.crew.waited = 0.0;
}

/// Where the block comes to one of the places from which it goes no further.
void Simulator::Impl::crew_begins() noexcept
{
  if (scene.connections != Connections::automatic && !state.crew.called) return;
  const WinchSetpoint winch = state.commands.in_force().winch;
  const State& now = shown();
  if (winch.brake || winch.block_velocity == 0.0 || now.slips.node >= 0 || state.connection.under_way) return;
  const HoistingSpec& spec = scene.rig.hoisting;
  const double height = block_height(now), speed = now.hoist.winch_speed;
  const double stop = 0.5 * speed * speed / spec.max_acceleration + 0.02;
  const double stand = spec.stand_joints * scene.string.back().joint_length;
  const bool adds = winch.block_velocity < 0.0;
  if (adds)
  {
    if (joints_below_stump(model->mesh(), scene) < 1) return;
    const double stump = state.string.length - model->mesh().nodes[static_cast<std::size_t>(uppermost_joint(model->mesh()))].from_bit;
    if (height > height_to_add(spec, stump, stand + lift_over_waves(scene.rig.heave)) + stop) return;
  }
  else
  {
    if (below_stand < 0) return;
    const double joint = now.nodes[static_cast<std::size_t>(below_stand)].position.z() - now.hoist.floor.height;
    if (joint < stick_up - stop && height < spec.highest_block_height - stop) return;
  }
  const bool called = state.crew.called;
  state.crew = CrewState();
  state.crew.adds = adds;
  state.crew.called = called;
  crew_does(CrewTask::stopping);
  state.commands.by_crew = state.commands.in_force();
  state.commands.crew_drives = true;
}

/// What brings the pipe above the slips to hang on the hook, no more and no less; for a frame [s].
WinchSetpoint Simulator::Impl::to_slack(double frame) const noexcept
{
  const double load = rest_load();
  if (std::abs(load) <= rests) return {0.0, false};
  const double stiffness = line_pull(scene.rig.hoisting, block_height(shown()), shown().hoist.line_length).stiffness;
  const double gain = std::min(by_load, share_in_a_frame / std::max(stiffness * frame, share_in_a_frame));
  return run(std::clamp(-gain * load, -slacking_speed, slacking_speed), scene.rig.hoisting);
}

/// The task under way: its set point of the winch for a frame [s]; true once it is done.
bool Simulator::Impl::crew_has_done(double frame, WinchSetpoint& winch) noexcept
{
  const HoistingSpec& spec = scene.rig.hoisting;
  const State& now = shown();
  const Setpoints& asked = state.commands.asked;
  const double height = block_height(now);
  CrewState& crew = state.crew;
  const double lift = stick_up + lift_over_waves(scene.rig.heave);
  winch = {0.0, false};
  switch (crew.doing)
  {
    case CrewTask::stopping:
      return stands(now);
    case CrewTask::lifting:
      if (height < crew.stopped_at + lift && crew.waited < patience) winch = run(lifting_speed, spec);
      return winch.block_velocity == 0.0 && stands(now);
    case CrewTask::quieting:
    {
      const int joint = crew.adds ? uppermost_joint(model->mesh()) : below_stand;
      const bool quiet = std::abs(block_velocity(now)) < quiet_block || crew.waited > patience;
      return crew.waited > rest_time && quiet && std::abs(now.drive.speed) <= standing_rotor && now.hydraulics.pump_flow <= 0.0 && !set_slips(joint);
    }
    case CrewTask::slacking:
    {
      winch = to_slack(frame);
      const char* refused = winch.block_velocity == 0.0 && stands(now) ? make_connection(0, !crew.adds) : "";
      if (refused && *refused && crew.waited > patience) failure = refused;  // what does not come about by waiting
      return !refused;
    }
    case CrewTask::connecting:
      return !state.connection.under_way;
    case CrewTask::picking_up:
      if (!pull_slips()) return true;
      winch = run(std::clamp(by_load * slips_load(now), slowest, slacking_speed), spec);
      return false;
    case CrewTask::restarting:
    {
      const bool to_speed = !asked.top_drive.brake && keeps_speed(asked.top_drive.mode);
      const bool turns = !to_speed || std::abs(now.drive.speed - asked.top_drive.speed) <= 0.05 * std::abs(asked.top_drive.speed) + standing_rotor;
      return crew.waited > patience || (turns && std::abs(now.hydraulics.pump_flow - asked.pump.flow) <= 0.01 * asked.pump.flow);
    }
    default:
      winch = run(-lowering_speed, spec);
      return height <= crew.stopped_at + above_bottom || crew.waited > patience;
  }
}

void Simulator::Impl::crew_works(double frame) noexcept
{
  CrewState& crew = state.crew;
  if (crew.doing == CrewTask::none) crew_begins();
  if (crew.doing == CrewTask::none) return;
  Setpoints& by_crew = state.commands.by_crew;
  const double height = block_height(shown());
  if (crew_has_done(frame, by_crew.winch)) crew_goes_on(height);
  const bool at_rest = crew.doing >= CrewTask::quieting && crew.doing < CrewTask::restarting;
  by_crew.top_drive = at_rest ? TopDriveSetpoint() : state.commands.asked.top_drive;
  by_crew.pump = at_rest ? PumpSetpoint() : state.commands.asked.pump;
  if (crew.doing == CrewTask::lowering && state.tared && !crew.zeroed && height <= crew.stopped_at + tares_at + lift_over_waves(scene.rig.heave))
  {
    crew.zeroed = true;
    tare();
  }
}

/// To the next task; `height`: of the block [m].
void Simulator::Impl::crew_goes_on(double height) noexcept
{
  CrewState& crew = state.crew;
  const CrewTask done = crew.doing;
  if (done == CrewTask::stopping) crew.stopped_at = height;
  if (done == CrewTask::connecting) crew.stopped_at += height - crew.broken_out_at;
  if (done == CrewTask::slacking) crew.broken_out_at = height;
  CrewTask next = static_cast<CrewTask>(static_cast<int>(done) + 1);
  if (next == CrewTask::lifting && !crew.adds) next = CrewTask::quieting;
  if (done == CrewTask::lowering || (done == CrewTask::restarting && !crew.adds)) next = CrewTask::none;
  crew_does(next);
  if (next == CrewTask::none) state.commands.crew_drives = false;
}

}  // namespace drill_rig_sim
