// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/hoisting.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
namespace
{
double block_weight(const StageContext& at) noexcept
{
  return standard_gravity * at.model.scene().rig.hoisting.block_mass;
}

/// Above the rotary table.
double height_of_block(const StageContext& at) noexcept
{
  return at.node(at.model.top()).position.z() - at.stage.hoist.floor.height;
}

double velocity_of_block(const StageContext& at) noexcept
{
  return at.node(at.model.top()).rate[2] - at.stage.hoist.floor.speed;
}

LinePull pull_of(const StageContext& at) noexcept
{
  return line_pull(at.model.scene().rig.hoisting, height_of_block(at), at.stage.hoist.line_length);
}

LineDamper damper_at(const StageContext& at, const LinePull& pull) noexcept
{
  return line_damper(at.model.scene().rig.hoisting, pull, velocity_of_block(at), at.stage.hoist.winch_speed);
}

BristleForce rail_at(const StageContext& at) noexcept
{
  const double moved = at.node(at.model.top()).increment[2] - (at.stage.hoist.floor.height - at.start.hoist.floor.height);
  return rail_bristle(at.model.scene().rig.hoisting, at.start.hoist.rail_deflection)
      .at(moved, velocity_of_block(at), at.stage.time);
}

StopForce stop_at(const StageContext& at) noexcept
{
  return stop_force(at.model.scene().rig.hoisting, height_of_block(at), velocity_of_block(at));
}

void add_hoisting(const StageContext& at, const ForceRows& to) noexcept
{
  const int top = at.model.top();
  const LinePull pull = pull_of(at);
  const LineDamper damper = damper_at(at, pull);
  const BristleForce rail = rail_at(at);
  const StopForce stop = stop_at(at);
  StageResult& result = at.work.result;
  result.forces.hook_load = pull.hook_force + damper.force;
  result.forces.block_resistance = rail.force + stop.force;
  result.rail_deflection = rail.next;
  to.force(top)[2] -= result.forces.hook_load + result.forces.block_resistance - block_weight(at);
  if (!to.with_tangent()) return;
  const double by_place = pull.stiffness - rail.by_move + stop.stiffness, by_rate = damper.damping + stop.damping - rail.by_speed;
  to.slope(top)(2, 2) += by_place + at.stage.dv_du * by_rate;
}

void store_hoisting(const StageContext& at, StoredEnergy& energy) noexcept
{
  const double line = at.stage.hoist.line_length, tension = pull_of(at).tension;
  energy.line += 0.5 * tension * tension * line / at.model.scene().rig.hoisting.line_ea;
  energy.weight += block_weight(at) * at.node(at.model.top()).position.z();
  const double held = rail_at(at).next;
  energy.block += 0.5 * rail_stiffness * held * held + stop_at(at).energy;
}

void sample_hoisting(const StageContext& at, EnergySample& sample) noexcept
{
  const HoistingSpec& spec = at.model.scene().rig.hoisting;
  const HoistState& end = at.stage.hoist;
  const LinePull pull = pull_of(at);
  sample.hook_force = pull.hook_force;
  sample.line_damping = damper_at(at, pull).force;
  sample.winch_speed = end.winch_speed;
  sample.block_resistance = at.work.result.forces.block_resistance;
  sample.line_price = pull.tension * (1.0 + 0.5 * pull.tension / spec.line_ea);
  sample.line_paid_out = end.line_length - at.start.hoist.line_length;
  sample.pay_out = -2.0 * spec.sheaves * end.winch_speed * end.line_length / strung_length(spec, height_of_block(at));
  sample.floor_speed = end.floor.speed;
  sample.floor_moved = end.floor.height - at.start.hoist.floor.height;
}
}  // namespace

const Force hoisting = {"hoisting", Cost::rig, Sum::none, add_hoisting, nullptr, add_hoisting, store_hoisting, sample_hoisting};

namespace
{
/// A winch that stands at a stop stays there until it is sent the other way, or the block is well away: a block that bounces in
/// its lines would be let down a little further at each bounce, until it lay on the stop.
bool stays_at_stop(const HoistingSpec& spec, const HoistState& hoist, const WinchSetpoint& command, double height) noexcept
{
  constexpr double well_away = 0.05;  // [m]
  const double above = height - spec.lowest_block_height, below = spec.highest_block_height - height;
  const bool on_towards_it = above < below ? command.block_velocity < 0.0 : command.block_velocity > 0.0;
  return hoist.at_stop && !command.brake && on_towards_it && std::min(above, below) < well_away;
}
}  // namespace

namespace
{
/// With a brake that slips, while the floor comes to `floor`.
HoistState slip(const HoistingSpec& spec, const State& state, const FloorMotion& floor, double time) noexcept
{
  const double before = state.hoist.line_length, height = block_height(state);
  HoistState out = state.hoist;
  const double velocity = state.nodes.back().rate.velocity.z() - (floor.height - state.hoist.floor.height) / time;
  out.line_length = slipping_line(spec, before, height, velocity, state.faults.brake_holds, time);
  const double paid_out = (out.line_length - before) / (2.0 * spec.sheaves);
  out.winch_speed = -paid_out / time * strung_length(spec, height) / before;
  out.sheave_slip = sheave_slip(state.hoist.sheave_slip, -paid_out);
  out.limited = out.at_stop = false;
  return out;
}

HoistState wind(const HoistingSpec& spec, const State& state, const WinchSetpoint& command, double time) noexcept
{
  const double height = block_height(state);
  const double hook_load = line_pull(spec, height, state.hoist.line_length).hook_force;
  const bool stays = stays_at_stop(spec, state.hoist, command, height);
  const WinchStep winch = advance_winch(spec, stays ? WinchSetpoint{0.0, false} : command, state.hoist.line_length,
                                        state.hoist.winch_speed, height, hook_load, time);
  HoistState out = state.hoist;
  out.line_length = winch.line_length;
  out.winch_speed = winch.speed;
  out.sheave_slip = sheave_slip(state.hoist.sheave_slip, (state.hoist.line_length - winch.line_length) / (2.0 * spec.sheaves));
  out.limited = stays || winch.limits.any();
  out.at_stop = stays || (winch.limits.height && std::abs(winch.speed) < standing_winch);
  return out;
}
}  // namespace

HoistState advance_hoist(const Model& model, const State& state, const Setpoints& setpoints, double time) noexcept
{
  const RigSpec& rig = model.scene().rig;
  const bool slips = setpoints.winch.brake && state.faults.brake_holds > 0.0;
  const double at_sea = state.hoist.at_sea + time;
  const FloorMotion floor = floor_motion(rig.heave, at_sea);
  HoistState out = slips ? slip(rig.hoisting, state, floor, time) : wind(rig.hoisting, state, setpoints.winch, time);
  out.at_sea = at_sea;
  out.floor = floor;
  return out;
}

}  // namespace drill_rig_sim
