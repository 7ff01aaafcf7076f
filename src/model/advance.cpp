// SPDX-License-Identifier: BSD-3-Clause
// What follows an accepted step; of the mud, what goes before one.
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/bore_fill.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/extend_hole.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/model/pointing.h"
#include "drill_rig_sim/model/running_speed.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d carried(const NodeMotion& node, const Vector3d& across) noexcept
{
  const Vector3d moved = across + node.tilt.cross(across);
  return moved - node.normal * node.normal.dot(moved);
}

NodeRate split(const NodeMotion& node, const Vector6d& vector) noexcept
{
  const double spin = vector.tail<3>().dot(node.axis);
  return {vector.head<3>(), carried(node, vector.tail<3>() - spin * node.axis), spin};
}

namespace
{
/// The rates of the free nodes by the batch kernel. False: it is not there, or not for these.
bool split_rates(const Stage& stage, const Workspace& work, State& state) noexcept
{
  if (!work.history || !work.columns.moved) return false;
  each_between(stage.guided_nodes, static_cast<int>(work.nodes.size()),
               [&](int first, int last) {
                 work.history->split_rates(work, {first, last}, state);
               });
  return true;
}
}  // namespace

void commit(const Stage& stage, const Workspace& work, State& state) noexcept
{
  const bool rates_are_there = split_rates(stage, work, state);
  each_outside(stage.guided_nodes, static_cast<int>(work.nodes.size()),
               [&](int k)
               {
                 const std::size_t i = static_cast<std::size_t>(k);
                 const NodeMotion& motion = work.nodes[i];
                 NodeState& node = state.nodes[i];
                 if (!rates_are_there) node.rate = split(motion, motion.rate);
                 node.position = motion.position;
                 node.spin_angle += motion.spin;
                 node.orientation = motion.orientation.normalized();
                 node.segment = motion.closest.segment;
               });
  commit_guided(stage, work, state);
  each_outside(stage.guided_elements, static_cast<int>(work.spans.size()),
               [&](int e)
               { state.spans[static_cast<std::size_t>(e)].segment = work.spans[static_cast<std::size_t>(e)].closest.segment; });
}

void advance_static(const Workspace& work, State& state) noexcept
{
  for (std::size_t i = 0; i < work.nodes.size(); ++i)
  {
    state.nodes[i].bristle = work.result.bristle[i];
    state.nodes[i].rest = work.result.rest[i];
  }
  for (std::size_t e = 0; e < work.spans.size(); ++e)
  {
    if (state.nodes[e].guided && state.nodes[e + 1].guided) continue;
    state.spans[e].bristle = work.result.span_bristle[e];
    state.spans[e].rest = work.result.span_rest[e];
  }
}

void advance_discrete(const Model& model, const Stage& stage, Workspace& work, State& state) noexcept
{
  advance_static(work, state);
  // the guide rail holds the shaft upright: round-off of many turns must not tilt it
  Quaterniond& shaft = state.nodes.back().orientation;
  shaft = pointed_along(shaft, -Vector3d::UnitZ());
  state.pads = work.result.pads;
  if (model.mesh().pivot_node >= 0) state.lean = shaft_end(model, stage, work).lean;
  state.hoist = stage.hoist;
  state.hoist.rail_deflection = work.result.rail_deflection;
  state.drive = work.result.drive;
  state.bit = work.result.bit;
  advance_drags(stage, work.result, state.faults);
  state.time += stage.time;
  work.profiler.lap(Cost::other);
  extend_hole(model, stage, work.result, state);
  advance_cuttings(model, stage.time, state);
  advance_temperature(model, stage.time, state);
  work.profiler.lap(Cost::rock_penetration);
}

double motor_load(const Model& model, const State& state) noexcept
{
  return state.faults.motor_locked ? model.motor()->stall_torque : state.bit.motor_torque;
}

MudPressures pressures_in_mud(const Model& model, const State& state) noexcept
{
  const bool has_waves = !state.mud_waves.bore_with.empty();  // not before the start's equilibrium
  return has_waves ? wave_pressures(state.hydraulics, state.mud_waves, state.cuttings.load, state.temperature.heads.annulus)
                   : mud_pressures(model.mud(), state.hydraulics, state.flow, state.temperature.places(),
                                   state.temperature.heads.annulus);
}

namespace
{
/// That a hole in the pipe is in.
std::size_t leaking_element(const Model& model, const State& state) noexcept
{
  std::size_t e = 0;
  while (e + 1 < model.mesh().elements.size() && model.mesh().nodes[e + 1].from_bit < state.faults.leak_from_bit) ++e;
  return e;
}

/// Through a hole in the pipe [m3/s].
double leak_flow(const Model& model, const State& state) noexcept
{
  const FaultState& faults = state.faults;
  if (faults.leak_area <= 0.0) return 0.0;
  const MudPressures pressures = pressures_in_mud(model, state);
  const std::size_t e = leaking_element(model, state);
  return orifice_flow(faults.leak_area, pressures.in_bore(model.mud(), e) - pressures.in_annulus(model.mud(), e),
                      model.scene().mud.density);
}
}  // namespace

void advance_mud(const Model& model, double commanded, double step, State& state) noexcept
{
  const MotorSpec* motor = model.motor();
  const double over_motor =
      motor ? mud_motor_pressure(mud_motor_leakage, motor->pressure_displacement(), motor_load(model, state)) : 0.0;
  const MudCircuit& mud = model.mud();
  const double narrowing = state.cuttings.narrowing * rotation_factor(mud.rotation_factor, state.drive.speed);
  const double speed = mud.displaced_area > 0.0 ? running_speed(mud, state.nodes) : 0.0, displaced = mud.displaced_area * speed;
  if (mud.waves.any())
  {
    fill_bore(model, state);
    const MudWays ways{plug_pressure(model, state), 0.0, 0.0, annulus_load(state), narrowing, state.temperature.places(),
                       state.temperature.heads};
    const WaveLoads loads{over_motor, displaced, speed, ways, state.faults.leak_area, leaking_element(model, state)};
    return advance_pressure_waves(model.scene().rig.mud_pump, mud.circuit, mud.waves, commanded, loads, state.time, step,
                                  state.flow, state.hydraulics, state.mud_waves);
  }
  const MudWays ways{
      plug_pressure(model, state), leak_flow(model, state), fill_bore(model, state), annulus_load(state), narrowing,
      state.temperature.places(),  state.temperature.heads};
  advance_hydraulics(model.scene().rig.mud_pump, mud.circuit, commanded, over_motor, displaced, step, state.flow,
                     state.hydraulics, ways);
}

}  // namespace drill_rig_sim
