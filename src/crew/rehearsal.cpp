// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drill_rig_sim/crew/connection.h"
#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/crew/rig_controls.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
namespace
{
constexpr double longest_step = 0.05;  // [s]
constexpr int most_steps = 20000;      // between two lines of the program
constexpr double still_stops = 0.1;    // the winch may stand by then: frames of the run are not these steps [s]
constexpr double stretch = 3e-3;       // of the string at most, by what pulls and pushes it [-]
constexpr double least_margin = 1.0;   // of the bit's depth, by starts of pump and drive [m]

/// A rig without forces.
class BareRig final : public RigControls
{
public:
  explicit BareRig(const Scene& scene)
      : scene_(scene), by_others_(!scene.operations.empty() || scene.connections == Connections::automatic)
  {
    truth_.bit_depth = deepest_ = scene.start.bit_depth;
    truth_.hole_depth = scene.well.hole_depth;
    truth_.block_height = scene.start.block_height;
  }

  CommandResult command(const WinchSetpoint& c) noexcept override { return obey(c); }
  CommandResult command(const TopDriveSetpoint& c) noexcept override { return obey(c); }
  CommandResult command(const PumpSetpoint& c) noexcept override { return obey(c); }
  CommandResult command(const SteeringSetpoint& c) noexcept override { return take(scene_.rig, truth_.time, c, commands_); }
  const Setpoints& asked() const noexcept override { return commands_.asked; }
  const Truth& truth() const noexcept override { return truth_; }
  const Readings& readings() const noexcept override { return readings_; }
  const Scene& scene() const noexcept override { return scene_; }
  void fail(const char* reason) noexcept override
  {
    if (!failure_) failure_ = reason;
  }
  bool tare() noexcept override { return true; }
  bool stick_pipe(double md) noexcept override { return !inject({FaultKind::stuck_pipe, md, 0.0, Gauge::hook_load}); }
  void free_pipe() noexcept override { clear(FaultKind::stuck_pipe, Gauge::hook_load); }
  const char* inject(const Fault& fault) noexcept override
  {
    const double bit = deepest_bit();
    if (const char* wrong = what_is_wrong(scene_, bit, std::max(truth_.hole_depth, bit), fault)) return wrong;
    gripped_ = gripped_ || fault.kind == FaultKind::stuck_pipe || fault.kind == FaultKind::differential_sticking ||
               fault.kind == FaultKind::pack_off;
    falls_ = falls_ || fault.kind == FaultKind::brake_slip;
    return nullptr;
  }
  void clear(FaultKind /*kind*/, Gauge /*gauge*/) noexcept override {}  // a string that was gripped once may have stayed behind
  bool set_free_length(double /*from_bit*/) noexcept override { return true; }  // by program_problems()
  const char* set_slips(bool set) noexcept override
  {
    if (by_others_) return nullptr;
    if (const char* refused = set ? why_slips_are_not_set(at_table()) : why_slips_are_not_pulled(at_table())) return refused;
    in_slips_ = set;
    return nullptr;
  }
  const char* make_connection(int joints, bool remove) noexcept override
  {
    if (by_others_) return nullptr;
    if (const char* refused = why_no_connection(at_table())) return refused;
    travel_ = (remove ? -1.0 : 1.0) * joints * scene_.string.back().joint_length;
    made_up_at_ = truth_.time + connection_duration(scene_.rig.hoisting, travel_);
    broken_out_ = true;
    return nullptr;
  }
  void call_crew(bool /*on*/) noexcept override {}

  const char* failure() const noexcept { return failure_; }

  /// On by a step [s].
  void advance(double step) noexcept
  {
    const HoistingSpec& spec = scene_.rig.hoisting;
    truth_.time += step;
    if (broken_out_ && truth_.time >= made_up_at_)
    {
      broken_out_ = false;
      truth_.block_height += travel_;
    }
    const WinchSetpoint winch = broken_out_ ? WinchSetpoint{0.0, true} : commands_.asked.winch;
    const double before = winch_speed_;
    winch_speed_ = advance_winch(spec, winch, strung_length(spec, truth_.block_height), before, truth_.block_height,
                                 spec.min_hook_load, step)
                       .speed;
    const double way = 0.5 * (before + winch_speed_) * step;
    truth_.block_height += way;
    has_moved_ = has_moved_ || way != 0.0;
    if (!in_slips_) truth_.bit_depth -= way;
    deepest_ = std::max(deepest_, truth_.bit_depth);
  }

private:
  template <class Setpoint>
  CommandResult obey(const Setpoint& c) noexcept
  {
    const char* lock = by_others_ ? nullptr : why_locked(c, at_table());
    return lock ? CommandResult{CommandResult::Outcome::refused, lock} : take(scene_.rig, truth_.time, c, commands_);
  }

  StringAtTable at_table() const noexcept
  {
    const double stops = still_stops * scene_.rig.hoisting.max_acceleration + standing_winch;
    StringAtTable now;
    now.by_reference = scene_.numerics.integrator == IntegratorKind::ida;
    now.in_slips = in_slips_;
    now.broken_out = broken_out_;
    now.block_moves = std::abs(winch_speed_) > stops;
    now.block_commanded = moves(commands_.asked.winch);
    now.top_drive_turns = turns(commands_.asked.top_drive);
    now.pump_runs = commands_.asked.pump.flow > 0.0;
    return now;
  }

  double deepest_bit() const noexcept
  {
    if (falls_) return std::numeric_limits<double>::infinity();
    if (truth_.time == 0.0) return truth_.bit_depth;
    const double margin = least_margin + scene_.rig.heave.amplitude;
    if (by_others_) return scene_.start.bit_depth + scene_.rig.hoisting.max_speed * truth_.time + margin;
    if (!has_moved_) return truth_.bit_depth + margin;
    return (gripped_ ? deepest_ : truth_.bit_depth) + margin + stretch * (scene_.start.bit_depth + scene_.start.block_height);
  }

  const Scene& scene_;
  bool by_others_;  // operations or a crew move the block as well
  CommandState commands_;
  Truth truth_;
  Readings readings_;
  const char* failure_ = nullptr;
  double winch_speed_ = 0.0, deepest_ = 0.0;  // [m/s], [m]
  double travel_ = 0.0, made_up_at_ = 0.0;    // of the connection under way [m], [s]
  bool in_slips_ = false, broken_out_ = false, has_moved_ = false, gripped_ = false, falls_ = false;
};

/// What the run says, without the name of the program, which the problem's key has.
std::string text_of(const std::string& failure, double at)
{
  const std::string program = "program: ";
  const std::string text = failure.compare(0, program.size(), program) == 0 ? failure.substr(program.size()) : failure;
  return "at " + plain(at) + " s: " + text;
}
}  // namespace

std::optional<Problem> refused_line(const Scene& scene, double until)
{
  BareRig rig(scene);
  ProgramPlayer player(scene.program);
  for (std::size_t i = 0; i < scene.program.size() && scene.program[i].at <= until; ++i)
  {
    const double at = scene.program[i].at, way = at - rig.truth().time;
    const int steps = std::clamp(static_cast<int>(std::ceil(way / longest_step)), 1, most_steps);
    for (int k = 0; k < steps && !rig.failure(); ++k)
    {
      player.apply(rig);  // ramps of the lines before
      if (way > 0.0) rig.advance(way / steps);
    }
    const bool by_ramp = rig.failure() && i > 0 && way > 0.0;  // of an earlier line, which is locked by now
    if (!rig.failure()) player.apply(rig);
    if (rig.failure())
      return Problem(item_key("program", by_ramp ? i - 1 : i), text_of(rig.failure(), by_ramp ? rig.truth().time : at));
  }
  return std::nullopt;
}

}  // namespace drill_rig_sim
