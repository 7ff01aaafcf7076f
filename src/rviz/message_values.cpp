// SPDX-License-Identifier: BSD-3-Clause
#include "message_values.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace drill_rig_sim::console
{
namespace
{
// names in `accuracy`, and the gauges that show these outputs; none shows the bit's speed
constexpr std::pair<const char*, Quantity> outputs[] = {
    {"hook_load", Quantity::hook_load},
    {"torque", Quantity::torque},
    {"wob", Quantity::surface_wob},
    {"rop", Quantity::rop},
    {"stand_pipe_pressure", Quantity::stand_pipe_pressure},
};

constexpr double near_bottom = 0.1;  // of the hole: the bit counts as on bottom [m]

void take(Values& values, const char* key, double value)
{
  values.set(quantity_of(key), value);
}

/// The numbers that RigState and RigTruth have in common.
template <class Message>
void take_fields(Values& values, const Message& m)
{
#define BOTH(type, name, ...) \
  if constexpr (std::is_same_v<type, double>) take(values, #name, m.name);
#define ZEROED(type, name, ...) m.tared != 0 ? take(values, #name, m.name) : values.lack(Quantity::name, "not zeroed");
#include "drill_rig_sim/scene/signal_list.h"
}

/// Raises the flag of this key, where the console has one.
void take(Flags& flags, const char* key, bool up)
{
  for (const FlagRow& row : flag_rows())
    if (std::strcmp(row.key, key) == 0) flags.set(static_cast<std::size_t>(row.flag), up);
}

void take_errors(Values& values, const Accuracy& accuracy)
{
  const std::size_t number = std::min(accuracy.outputs.size(), accuracy.absolute.size());
  for (std::size_t n = 0; n < number; ++n)
    for (const auto& [name, quantity] : outputs)
      if (accuracy.outputs[n] == name) values.error[index_of(quantity)] = accuracy.absolute[n];
}

void take_telemetry(Values& values, const News& news)
{
  values.lack(Quantity::inclination, "no survey yet");
  values.lack(Quantity::azimuth, "no survey yet");
  if (news.survey)
  {
    values.set(Quantity::inclination, news.survey->inclination);
    values.set(Quantity::azimuth, news.survey->azimuth);
  }
  if (news.inclination && (!news.survey || news.inclination->header.stamp > news.survey->header.stamp))
    values.set(Quantity::inclination, news.inclination->inclination);
  if (news.toolfaces.empty())
    values.lack(Quantity::toolface, "none yet");
  else
    values.set(Quantity::toolface, news.toolfaces.back()->toolface);
  if (news.dynamics)
    values.set(Quantity::stick_slip, news.dynamics->stick_slip);
  else
    values.lack(Quantity::stick_slip, "no tool received");
}

void take_energy(Values& values, double weight, double torque, double speed, double rop, double diameter)
{
  const double energy = specific_energy(weight, torque, speed, rop, diameter);
  if (energy == energy)
    values.set(Quantity::specific_energy, energy);
  else
    values.lack(Quantity::specific_energy, diameter > 0.0 ? "not drilling" : "bit size not set");
}
}  // namespace

Values readings_of(const News& news, double bit_diameter)
{
  if (news.state) return readings_of(news, *news.state, bit_diameter);
  Values values;
  take_telemetry(values, news);
  return values;
}

Values readings_of(const News& news, const RigState& s, double bit_diameter)
{
  Values values;
  take_telemetry(values, news);
  take_fields(values, s);
  if (news.accuracy) take_errors(values, *news.accuracy);
  if (s.in_slips)
    for (const Quantity quantity : {Quantity::surface_wob, Quantity::differential_pressure, Quantity::specific_energy})
      values.lack(quantity, "in slips");
  else if (!s.tared)
    values.lack(Quantity::specific_energy, "not zeroed");
  else if (!drills(s) || !(s.surface_wob > 0.0))
    values.lack(Quantity::specific_energy, "not drilling");
  else
    take_energy(values, s.surface_wob, s.torque, s.top_drive_speed, s.rop, bit_diameter);
  for (std::size_t n = 0; n < failing_gauges().size(); ++n)
    if ((s.lost_gauges >> n & 1u) != 0) values.lost.set(index_of(failing_gauges()[n]));
  return values;
}

Values truth_of(const News& news, double bit_diameter)
{
  Values values;
  if (news.truth) take_fields(values, *news.truth);
  values.lack(Quantity::surface_wob, "no reading");  // the bit's is meant
  if (news.bit)
  {
    values.set(Quantity::surface_wob, news.bit->wob);
    values.set(Quantity::inclination, news.bit->inclination);
    values.set(Quantity::azimuth, news.bit->azimuth);
    values.set(Quantity::toolface, news.bit->toolface);
    if (news.truth) take_energy(values, news.bit->wob, news.bit->torque, news.bit->speed, news.truth->rop, bit_diameter);
  }
  return values;
}

RigAbilities abilities_of(const RigLimits& m)
{
  RigAbilities rig;
  rig.max_block_speed = m.max_block_speed;
  rig.max_hook_load = m.max_hook_load;
  rig.min_hook_load = m.min_hook_load;
  rig.trip_hook_load = m.trip_hook_load;
  rig.lowest_block_height = m.lowest_block_height;
  rig.highest_block_height = m.highest_block_height;
  rig.max_top_drive_speed = m.max_top_drive_speed;
  rig.max_top_drive_torque = m.max_top_drive_torque;
  rig.max_flow = m.max_flow;
  rig.relief_pressure = m.relief_pressure;
  rig.trip_pressure = m.trip_pressure;
  return rig;
}

Flags flags_of(const RigState& state, const RigTruth* truth)
{
  Flags flags;
#define BOTH(type, name, ...) \
  if constexpr (std::is_same_v<type, bool>) take(flags, #name, state.name != 0);
#define TRUTH(type, name, ...) \
  if (truth != nullptr) take(flags, #name, truth->name != 0);
#include "drill_rig_sim/scene/signal_list.h"
  return flags;
}

MoveReading move_reading_of(const RigState& state, const Values& readings)
{
  const bool lost = readings.lost[index_of(Quantity::hook_load)];
  return {state.header.stamp.toSec(),
          lost ? missing : state.hook_load,
          state.block_height,
          state.block_velocity,
          state.top_drive_speed,
          state.bit_depth,
          state.hole_depth,
          state.in_slips != 0,
          static_cast<int>(state.epoch)};
}

bool drills(const RigState& state)
{
  return state.in_slips == 0 && state.bit_depth > state.hole_depth - near_bottom && state.rop > least_rop;
}

RunState run_state_of(const RigState& state)
{
  switch (state.run_state)
  {
    case RigState::RUNNING:
      return RunState::running;
    case RigState::PAUSED:
      return RunState::paused;
    case RigState::WAITING:
      return RunState::waiting;
    case RigState::FAILED:
      return RunState::failed;
    default:
      return RunState::unknown;
  }
}

}  // namespace drill_rig_sim::console
