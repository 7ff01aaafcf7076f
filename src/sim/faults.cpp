// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/faults.h"

#include <cmath>

#include "drill_rig_sim/instruments/sensor.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
void stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept
{
  const int nearest = nearest_node(model, bit_depth, md);
  const NodeState& node = state.nodes[static_cast<std::size_t>(nearest)];
  state.stuck_point = {nearest, node.position, node.spin_angle};
}

void free_pipe(State& state) noexcept
{
  state.stuck_point = HeldNode();
}

namespace
{
/// A drag at a fault's place, from rest.
DragState drag_of(const Fault& fault) noexcept
{
  DragState drag;
  drag.amount = fault.magnitude;
  drag.md = fault.depth;
  return drag;
}

/// What a fault of the mechanics is made of.
struct Beginning
{
  const Model& model;
  double bit_depth;
  const Fault& fault;
  State& state;
};

/// What begins a fault of the mechanics, what ends it, and whether it is under way.
struct Deed
{
  FaultKind kind;
  void (*begin)(const Beginning& b);
  void (*end)(State& state);
  bool (*is_on)(const State& state);
};

constexpr Deed deeds[] = {
    {FaultKind::stuck_pipe, [](const Beginning& b) { stick_pipe(b.model, b.bit_depth, b.fault.depth, b.state); }, free_pipe,
     [](const State& s) { return s.stuck_point.node >= 0; }},
    {FaultKind::brake_slip, [](const Beginning& b) { b.state.faults.brake_holds = b.fault.magnitude; },
     [](State& s) { s.faults.brake_holds = FaultState().brake_holds; },
     [](const State& s) { return s.faults.brake_holds > 0.0; }},
    {FaultKind::drive_trip, [](const Beginning& b) { b.state.faults.drive_tripped = true; },
     [](State& s) { s.faults.drive_tripped = false; }, [](const State& s) { return s.faults.drive_tripped; }},
    {FaultKind::pump_trip, [](const Beginning& b) { b.state.faults.pump_tripped = true; },
     [](State& s) { s.faults.pump_tripped = false; }, [](const State& s) { return s.faults.pump_tripped; }},
    {FaultKind::motor_stall, [](const Beginning& b) { b.state.faults.motor_locked = true; },
     [](State& s) { s.faults.motor_locked = false; }, [](const State& s) { return s.faults.motor_locked; }},
    {FaultKind::washed_out_hole,
     [](const Beginning& b)
     {
       b.state.faults.washed_out_by = b.fault.magnitude;
       b.state.faults.washed_out_at = b.fault.depth;
     },
     [](State& s) { s.faults.washed_out_by = s.faults.washed_out_at = 0.0; },
     [](const State& s) { return s.faults.washed_out_by > 0.0; }},
    {FaultKind::washed_out_pipe,
     [](const Beginning& b)
     {
       b.state.faults.leak_area = b.fault.magnitude;
       b.state.faults.leak_from_bit = b.bit_depth - b.fault.depth;
     },
     [](State& s) { s.faults.leak_area = s.faults.leak_from_bit = 0.0; },
     [](const State& s) { return s.faults.leak_area > 0.0; }},
    {FaultKind::differential_sticking, [](const Beginning& b) { b.state.faults.sticking = drag_of(b.fault); },
     [](State& s) { s.faults.sticking = FaultState().sticking; }, [](const State& s) { return s.faults.sticking.amount > 0.0; }},
    {FaultKind::pack_off, [](const Beginning& b) { b.state.faults.pack_off = drag_of(b.fault); },
     [](State& s) { s.faults.pack_off = FaultState().pack_off; }, [](const State& s) { return s.faults.pack_off.amount > 0.0; }},
    {FaultKind::friction_change,
     [](const Beginning& b)
     {
       b.state.faults.friction_factor = b.fault.magnitude;
       b.state.faults.friction_from = b.fault.depth;
     },
     [](State& s)
     {
       s.faults.friction_factor = FaultState().friction_factor;
       s.faults.friction_from = FaultState().friction_from;
     },
     [](const State& s) { return s.faults.friction_factor != 1.0; }},
    {FaultKind::formation_change, [](const Beginning& b) { b.state.faults.drillability_factor = b.fault.magnitude; },
     [](State& s) { s.faults.drillability_factor = FaultState().drillability_factor; },
     [](const State& s) { return s.faults.drillability_factor != 1.0; }}};

/// The same of a gauge.
struct GaugeDeed
{
  FaultKind kind;
  void (*begin)(SensorFault& gauge, double magnitude);
  void (*end)(SensorFault& gauge);
  bool (*is_on)(const SensorFault& gauge);
};

constexpr GaugeDeed gauge_deeds[] = {
    {FaultKind::sensor_freeze, [](SensorFault& g, double) { g.frozen = true; }, [](SensorFault& g) { g.frozen = false; },
     [](const SensorFault& g) { return g.frozen; }},
    {FaultKind::sensor_dropout, [](SensorFault& g, double) { g.dropped = true; }, [](SensorFault& g) { g.dropped = false; },
     [](const SensorFault& g) { return g.dropped; }},
    {FaultKind::sensor_bias, [](SensorFault& g, double m) { g.bias = m; }, [](SensorFault& g) { g.bias = 0.0; },
     [](const SensorFault& g) { return g.bias != 0.0; }},
    {FaultKind::sensor_noise, [](SensorFault& g, double m) { g.noise = m; }, [](SensorFault& g) { g.noise = 0.0; },
     [](const SensorFault& g) { return g.noise != 0.0; }},
    {FaultKind::sensor_drift,
     [](SensorFault& g, double m)
     {
       g.drift = m;
       g.drifted = 0.0;
     },
     [](SensorFault& g) { g.drift = g.drifted = 0.0; }, [](const SensorFault& g) { return g.drift != 0.0; }}};
static_assert(sizeof deeds / sizeof deeds[0] + sizeof gauge_deeds / sizeof gauge_deeds[0] == fault_count,
              "every fault begins and ends");

template <class Row, std::size_t N, class Place>
std::uint32_t bits_of(const Row (&rows)[N], const Place& place) noexcept
{
  std::uint32_t bits = 0;
  for (const Row& row : rows) bits |= row.is_on(place) ? 1u << static_cast<int>(row.kind) : 0u;
  return bits;
}

/// Null: there is none of this kind.
template <class Row, std::size_t N>
const Row* row_of(const Row (&rows)[N], FaultKind kind) noexcept
{
  for (const Row& row : rows)
    if (row.kind == kind) return &row;
  return nullptr;
}
}  // namespace

void begin(const Model& model, double bit_depth, const Fault& fault, State& state) noexcept
{
  if (const Deed* deed = row_of(deeds, fault.kind)) deed->begin({model, bit_depth, fault, state});
}

void end(FaultKind kind, State& state) noexcept
{
  if (const Deed* deed = row_of(deeds, kind)) deed->end(state);
}

void begin(const Fault& fault, SensorFault& gauge) noexcept
{
  if (const GaugeDeed* deed = row_of(gauge_deeds, fault.kind)) deed->begin(gauge, fault.magnitude);
}

void end(FaultKind kind, SensorFault& gauge) noexcept
{
  if (const GaugeDeed* deed = row_of(gauge_deeds, kind)) deed->end(gauge);
}

std::uint32_t active_faults(const State& state) noexcept
{
  return bits_of(deeds, state);
}

std::uint32_t active_faults(const SensorFault& gauge) noexcept
{
  return bits_of(gauge_deeds, gauge);
}

FaultDepths fault_depths(const Model& model, const State& state) noexcept
{
  FaultDepths depths;
  depths.fill(NAN);
  const std::uint32_t active = active_faults(state);
  const auto set = [&](FaultKind kind, double md)
  {
    const int k = static_cast<int>(kind);
    if (active >> k & 1u) depths[static_cast<std::size_t>(k)] = md;
  };
  const FaultState& f = state.faults;
  if (const int node = state.stuck_point.node; node >= 0)
    set(FaultKind::stuck_pipe,
        state.well.locate(state.stuck_point.position, state.nodes[static_cast<std::size_t>(node)].segment).md);
  set(FaultKind::washed_out_hole, f.washed_out_at);
  if (f.leak_area > 0.0) set(FaultKind::washed_out_pipe, depth_of_bit(model, state) - f.leak_from_bit);
  set(FaultKind::differential_sticking, f.sticking.md);
  set(FaultKind::pack_off, f.pack_off.md);
  set(FaultKind::friction_change, f.friction_from);
  return depths;
}

std::vector<double> depths_of(const ActiveFaults& faults, const FaultDepths& depths)
{
  std::vector<double> out;
  for (std::size_t k = 0; k < fault_count; ++k)
  {
    if (faults.of_rig >> k & 1u) out.push_back(depths[k]);
    for (const std::uint32_t of_gauge : faults.of_gauges)
      if (of_gauge >> k & 1u) out.push_back(NAN);
  }
  return out;
}

}  // namespace drill_rig_sim
