// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_FAULTS_H
#define DRILL_RIG_SIM_SIM_FAULTS_H

#include <array>
#include <cstdint>
#include <vector>

#include "drill_rig_sim/scene/fault_spec.h"

/// Faults of a rig. They are part of the state, so that snapshots hold them. Each kind can be active once: a second request
/// replaces the first.
///
/// - stuck_pipe: the formation grips the pipe at a place (forces/stuck_point.h).
/// - differential_sticking, pack_off: drags at a place (forces/place_drag.h); a pack-off holds mud back in the annulus too,
/// pack_off_pressure().
/// - friction_change, washed_out_hole: of the wall (model/wall_faults.h). The annulus's volume and losses stay as they were at
/// the start.
/// - formation_change: a factor on the drillability of all rock.
/// - washed_out_pipe: mud leaks through a hole in the pipe, which moves with it (hydraulics/hydraulics.h). The flow above it,
/// larger than that
///   through the bit, loses no more than that.
/// - motor_stall: the mud motor's rotor stands still, over the lag of its speed; the mud goes on past it, at the pressure of its
/// stall.
/// - brake_slip: the winch's brake holds no more than a load (slipping_line() in rig/hoisting.h).
/// - drive_trip: the top drive coasts, its brake apart. pump_trip: the pump's flow falls to 0, at its ramp.
/// - sensor_freeze, sensor_bias, sensor_noise, sensor_dropout, sensor_drift: of a gauge (instruments/sensor.h). The dead line's
/// float, a load cell
///   that loses its fluid, is a drift of dead_line_hook_load.
namespace drill_rig_sim
{
class Model;
struct SensorFault;
struct State;

/// The formation grips the node of the string that is nearest to measured depth `md` [m], where it is now: half an element off at
/// most, or the uppermost in the hole; the shaft is never gripped. `bit_depth`: of the bit's face [m MD]. Needs pipe in the hole
/// at `md`.
void stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept;
/// Releases the stuck pipe.
void free_pipe(State& state) noexcept;

/// Begins a mechanical fault, which must be valid (crew/refusals.h).
void begin(const Model& model, double bit_depth, const Fault& fault, State& state) noexcept;
/// Ends it; without such a fault it does nothing.
void end(FaultKind kind, State& state) noexcept;
/// Those under way, a bit for each FaultKind: of the mechanics, of a gauge.
std::uint32_t active_faults(const State& state) noexcept;
std::uint32_t active_faults(const SensorFault& gauge) noexcept;
/// Where those of the mechanics are now, by FaultKind: of a stuck pipe the gripped place, of a leak the pipe's present depth, of
/// a friction change its upper end [m MD]; NaN: it is not under way, or has no place.
using FaultDepths = std::array<double, fault_count>;
FaultDepths fault_depths(const Model& model, const State& state) noexcept;
/// The same in the order of words_of(); NaN also for a gauge's fault.
std::vector<double> depths_of(const ActiveFaults& faults, const FaultDepths& depths);
/// The same of a gauge.
void begin(const Fault& fault, SensorFault& gauge) noexcept;
void end(FaultKind kind, SensorFault& gauge) noexcept;

}  // namespace drill_rig_sim

#endif
