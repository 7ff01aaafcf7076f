#include "drill_rig_sim/sim/faults.h"

#include "drill_rig_sim/crew/rig_controls.h"

#include <cmath>

#include "drill_rig_sim/model/forces/place_drag.h"

namespace drill_rig_sim
{
const char* const no_pipe_there = "depth: allowed is where there is pipe in the hole, above 0 (the rotary table) and not below the bit";

bool is_in_hole(double md, double bit_depth) noexcept
{
  return md > 0.0 && md <= bit_depth;
}

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

const char* what_is_wrong(const Model& model, double bit_depth, double hole_depth, const Fault& fault) noexcept
{
  const bool by_reference = model.scene().numerics.integrator == IntegratorKind::ida;
  const bool apart = is_of_gauge(fault.kind) || fault.kind == FaultKind::stuck_pipe || fault.kind == FaultKind::drive_trip ||
                     fault.kind == FaultKind::pump_trip;
  if (by_reference && !apart) return "fault: not available by integrator ida";
  if (needs_pipe(fault.kind) && !is_in_hole(fault.depth, bit_depth)) return no_pipe_there;
  if (fault.kind == FaultKind::washed_out_hole && !(fault.depth > 0.0 && fault.depth <= hole_depth))
    return "depth: allowed is a place of the hole, above 0 (the rotary table) and not below its bottom";
  if (fault.kind == FaultKind::friction_change && !(fault.depth >= 0.0 && fault.depth <= hole_depth))
    return "depth: allowed is 0 (all of the hole) to the hole's bottom";
  if (fault.kind == FaultKind::motor_stall && !model.motor()) return "fault: there is no mud motor in the string";
  return what_is_wrong_with_magnitude(fault);
}

void begin(const Model& model, double bit_depth, const Fault& fault, State& state) noexcept
{
  FaultState& faults = state.faults;
  switch (fault.kind)
  {
    case FaultKind::stuck_pipe: return stick_pipe(model, bit_depth, fault.depth, state);
    case FaultKind::brake_slip: faults.brake_holds = fault.magnitude; return;
    case FaultKind::drive_trip: faults.drive_tripped = true; return;
    case FaultKind::pump_trip: faults.pump_tripped = true; return;
    case FaultKind::motor_stall: faults.motor_locked = true; return;
    case FaultKind::washed_out_hole:
      faults.washed_out_by = fault.magnitude;
      faults.washed_out_at = fault.depth;
      return;
    case FaultKind::washed_out_pipe:
      faults.leak_area = fault.magnitude;
      faults.leak_from_bit = bit_depth - fault.depth;
      return;
    case FaultKind::differential_sticking:
      faults.sticking = DragState();
      faults.sticking.amount = fault.magnitude;
      faults.sticking.md = fault.depth;
      return;
    case FaultKind::pack_off:
      faults.pack_off = DragState();
      faults.pack_off.amount = fault.magnitude;
      faults.pack_off.md = fault.depth;
      return;
    case FaultKind::friction_change:
      faults.friction_factor = fault.magnitude;
      faults.friction_from = fault.depth;
      return;
    case FaultKind::formation_change: faults.drillability_factor = fault.magnitude; return;
    default: return;
  }
}

void end(FaultKind kind, State& state) noexcept
{
  const FaultState none;
  FaultState& faults = state.faults;
  switch (kind)
  {
    case FaultKind::stuck_pipe: return free_pipe(state);
    case FaultKind::brake_slip: faults.brake_holds = none.brake_holds; return;
    case FaultKind::drive_trip: faults.drive_tripped = false; return;
    case FaultKind::pump_trip: faults.pump_tripped = false; return;
    case FaultKind::motor_stall: faults.motor_locked = false; return;
    case FaultKind::washed_out_hole: faults.washed_out_by = faults.washed_out_at = 0.0; return;
    case FaultKind::washed_out_pipe: faults.leak_area = faults.leak_from_bit = 0.0; return;
    case FaultKind::differential_sticking: faults.sticking = none.sticking; return;
    case FaultKind::pack_off: faults.pack_off = none.pack_off; return;
    case FaultKind::friction_change:
      faults.friction_factor = none.friction_factor;
      faults.friction_from = none.friction_from;
      return;
    case FaultKind::formation_change: faults.drillability_factor = none.drillability_factor; return;
    default: return;
  }
}

void begin(const Fault& fault, SensorFault& gauge) noexcept
{
  switch (fault.kind)
  {
    case FaultKind::sensor_freeze: gauge.frozen = true; return;
    case FaultKind::sensor_dropout: gauge.dropped = true; return;
    case FaultKind::sensor_bias: gauge.bias = fault.magnitude; return;
    case FaultKind::sensor_noise: gauge.noise = fault.magnitude; return;
    case FaultKind::sensor_drift:
      gauge.drift = fault.magnitude;
      gauge.drifted = 0.0;
      return;
    default: return;
  }
}

void end(FaultKind kind, SensorFault& gauge) noexcept
{
  switch (kind)
  {
    case FaultKind::sensor_freeze: gauge.frozen = false; return;
    case FaultKind::sensor_dropout: gauge.dropped = false; return;
    case FaultKind::sensor_bias: gauge.bias = 0.0; return;
    case FaultKind::sensor_noise: gauge.noise = 0.0; return;
    case FaultKind::sensor_drift: gauge.drift = gauge.drifted = 0.0; return;
    default: return;
  }
}

}  // namespace drill_rig_sim
