// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_EVALUATE_H
#define DRILL_RIG_SIM_MODEL_EVALUATE_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// The mechanics of rig, string, well and rock: residual and tangent of one stage, and what follows once a step is accepted. All
/// are free functions of Model, State and Stage; a Workspace is only written, never read for what an earlier call left in it, but
/// by update(), commit() and advance_discrete(), which belong to the evaluate() before them.
///
/// The top node is the shaft of the top drive: height and spin are free, the rest is held by the guide rail (rows of the
/// identity). The block's mass moves with it; the rotor is condensed into the spin's row.

/// Residual R(u) and, unless null, its tangent dR/du. u, residual: 6 per node, bit first [m, rad], [N, N m].
void evaluate(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work, double* residual,
              BlockTridiagonal* tangent) noexcept;

/// The same for statics (begin_static()): top node held at its height and spin, no rig.
void evaluate_static(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work,
                     double* residual, BlockTridiagonal* tangent) noexcept;

/// After a solution u: all results of evaluate() there, except the string's own forces, inertia and tangent.
void update(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work) noexcept;

/// Writes positions and rates of the accepted stage into `state`, which may be the start state.
void commit(const Stage& stage, const Workspace& work, State& state) noexcept;
/// Advances bristles, hoist, drive, motor, rock and clock; nothing else does. Call it after commit(). It extends the hole by
/// the rock-breaking velocity times the step, or by the motion stored in the stage.
void advance_discrete(const Model& model, const Stage& stage, Workspace& work, State& state) noexcept;
/// Torque that the pressure drop of the motor carries [N m]: that of the rotor; of a locked rotor, the stall torque. Needs a
/// motor.
double motor_load(const Model& model, const State& state) noexcept;
/// Pump, mud and flow over a step [s], ahead of the string's: the flow of the step that comes, against the torque of the step
/// before.
/// @param commanded  of the pump [m3/s]
void advance_mud(const Model& model, double commanded, double step, State& state) noexcept;
/// Pressures in the mud; the result refers to the state.
MudPressures pressures_in_mud(const Model& model, const State& state) noexcept;
/// The same in statics: advances only bristles.
void advance_static(const Workspace& work, State& state) noexcept;

/// Vector of an old section normal's tangent plane, carried to the new one by the node's tilt.
Eigen::Vector3d carried(const NodeMotion& node, const Eigen::Vector3d& across) noexcept;
/// Rates or accelerations of a node at the stage, split by its section normal after commit().
NodeRate split(const NodeMotion& node, const Vector6d& vector) noexcept;
/// A node's rates in the coordinates of u; `normal`: the section normal that they are split by.
inline Vector6d in_step_axes(const NodeRate& rate, const Eigen::Vector3d& normal) noexcept
{
  Vector6d out;
  out << rate.velocity, rate.tilt + rate.spin * normal;
  return out;
}

/// Tension, torque and bending moment along the string at the stage last evaluated or updated, into work.result.forces.
void find_string_forces(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept;

/// Velocity of the hole's bottom under the bit at the stage's forces: the three-dimensional rock-breaking velocity, as far as the
/// body that follows the bit lets the hole turn (well/turn_limit.h) [m/s]; of the regenerative law none: there the bottom moves
/// by what is cut, between steps. `state`: of the hole and its rock; `drilling_speed`: BitDrive's [rad/s]; `bit_axis`: unit,
/// downhole.
Eigen::Vector3d rock_velocity(const Model& model, const State& state, const RigForces& forces, double drilling_speed,
                              const Eigen::Vector3d& bit_axis) noexcept;

/// What the bit stands on, as faults have it.
FormationLayer rock_under_bit(const Model& model, const State& state) noexcept;

/// A node's motion given outright instead of through a stage.
struct GivenNode
{
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
  Vector6d increment;  ///< displacement and rotation since the start of the step, for the laws with memory [m, rad]
  Vector6d rate;       ///< velocity and angular velocity, world axes [m/s, rad/s]
};

/// Motion of the string that the caller integrates. `stage` of the calls below: its dv_du, motor, bottom, time and
/// the normals at the start of the step are used.
struct GivenMotion
{
  std::vector<GivenNode> nodes;
  GivenNode bit;  ///< of the bit as a body of its own, on the string's lowest node
};

/// All forces but the rig's at a given motion: no inertia, nothing held. `string`: of elements, weight and mud on the nodes;
/// `contact`: of wall, rock, stuck point and the bit's weight, row 0 on the bit as a body of its own; both 6 per node,
/// overwritten: force and moment that must be put on the node so that it does not accelerate (world axes). Tangents, unless null:
/// with respect to positions and spatial rotations, plus the stage's dv_du times that with respect to the rates; that of
/// `contact` has diagonal blocks only.
void evaluate_motion(const Model& model, const State& start, const Stage& stage, const GivenMotion& motion, Workspace& work,
                     double* string, double* contact, BlockTridiagonal* string_tangent,
                     BlockTridiagonal* contact_tangent) noexcept;
/// Only row 0 of `contact`.
Vector6d evaluate_bit_motion(const Model& model, const State& start, const Stage& stage, const GivenNode& bit,
                             Workspace& work) noexcept;

}  // namespace drill_rig_sim

#endif
