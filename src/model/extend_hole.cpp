// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/extend_hole.h"

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/well/formation.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// A guided bit has no directions of its own.
bool is_guided(const State& state) noexcept
{
  return state.nodes.front().guided;
}

Vector3d let_by_body(const Model& model, const State& state, const Vector3d& way) noexcept
{
  return is_guided(state) ? way : limited_way(state.well, model.turn_limit(), way);
}
}  // namespace

FormationLayer rock_under_bit(const Model& model, const State& state) noexcept
{
  FormationLayer rock = model.rock_under(state.well);
  rock.drillability *= state.faults.drillability_factor;
  return rock;
}

Vector3d rock_velocity(const Model& model, const State& state, const RigForces& forces, double drilling_speed,
                       const Vector3d& bit_axis) noexcept
{
  if (forces.wob <= 0.0 || model.regenerative()) return Vector3d::Zero();
  const Wellbore& well = state.well;
  const FormationLayer rock = rock_under_bit(model, state);
  if (model.pilot().is_ahead(well.hole_depth()))
    return on_axis_rop(rock, drilling_speed, forces.wob) * model.pilot().direction(well.bottom_position(), well.hole_depth());
  return let_by_body(model, state,
                     rock_breaking_velocity(rock, forces.rock_force, drilling_speed, bit_axis, model.bit().side_cutting));
}

double refused_turn(const Model& model, const State& state, const RigForces& forces) noexcept
{
  if (forces.wob <= 0.0 || is_guided(state) || model.pilot().is_ahead(state.well.hole_depth())) return 0.0;
  const Vector3d way = rock_breaking_velocity(rock_under_bit(model, state), forces.rock_force, forces.bit_speed,
                                              x_axis(state.nodes[0].orientation), model.bit().side_cutting);
  return refused_turn(state.well, model.turn_limit(), way);
}

namespace
{
/// `way` of the bottom in a step or a second; a guided bit goes straight on, whatever the rock: nothing of a string without
/// bending would hold it back.
Vector3d way_of_bit(const Stage& stage, const Wellbore& well, const Vector3d& way) noexcept
{
  if (!stage.guides.guided.front()) return way;
  const Vector3d& on = well.end_direction();
  return on * on.dot(way);
}

/// By the rock that the blades have cut away since the last step.
void extend_by_cut(const Model& model, const Stage& stage, const StageResult& result, State& state) noexcept
{
  const BitSpec& bit = model.bit();
  const Vector3d bit_axis = x_axis(state.nodes[0].orientation);
  const Vector3d down = state.well.bottom_normal();
  const FormationLayer rock = rock_under_bit(model, state);
  const double lowered = cut(state.ground, bit.torque.blades, result.cut.angle, result.cut.height);
  state.ground.flats = result.cut.flats;
  const Vector3d by_rock = lowered * rock_breaking_direction(rock, result.forces.rock_force, bit_axis, bit.side_cutting, down);
  const Vector3d way = way_of_bit(stage, state.well, let_by_body(model, state, by_rock));
  state.bit.rock_velocity = way / stage.time;
  state.well.extend(way, bit_axis);
}
}  // namespace

void extend_hole(const Model& model, const Stage& stage, const StageResult& result, State& state) noexcept
{
  if (model.regenerative()) return extend_by_cut(model, stage, result, state);
  const RigForces& forces = result.forces;
  const Vector3d bit_axis = x_axis(state.nodes[0].orientation);
  state.bit.rock_velocity =
      stage.bit.bottom_known
          ? Vector3d(stage.bit.bottom_increment / stage.time)
          : way_of_bit(stage, state.well, rock_velocity(model, state, forces, stage.bit.drilling_speed, bit_axis));
  state.well.extend(stage.bit.bottom_known ? stage.bit.bottom_increment : Vector3d(stage.time * state.bit.rock_velocity),
                    bit_axis);
}

}  // namespace drill_rig_sim
