#include "drill_rig_sim/model/extend_hole.h"

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/well/formation.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

Vector3d rock_velocity(const Model& model, const Wellbore& well, const RigForces& forces, double drilling_speed,
                       const Vector3d& bit_axis) noexcept
{
  if (forces.wob <= 0.0) return Vector3d::Zero();
  const FormationLayer& rock = model.formation().at(-well.bottom_position().z());
  return rock_breaking_velocity(rock, forces.rock_force, drilling_speed, bit_axis, model.bit().side_cutting);
}

void extend_hole(const Model& model, const Stage& stage, const RigForces& forces, State& state) noexcept
{
  const Vector3d bit_axis = x_axis(state.nodes[0].orientation);
  state.bit.rock_velocity = stage.bit.bottom_known ? Vector3d(stage.bit.bottom_increment / stage.time)
                                                   : rock_velocity(model, state.well, forces, stage.bit.drilling_speed, bit_axis);
  state.well.extend(stage.bit.bottom_known ? stage.bit.bottom_increment : Vector3d(stage.time * state.bit.rock_velocity), bit_axis);
}

}  // namespace drill_rig_sim
