// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_PLACE_DRAG_H
#define DRILL_RIG_SIM_MODEL_FORCES_PLACE_DRAG_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// What drags on the pipe at a place of the hole: cuttings packed around it (FaultState::pack_off) and its filter cake
/// (sticking). It acts on the node that is nearest to the place, half an element off at most; as the pipe moves on, the next
/// takes over.
///
/// Coulomb's friction on the pipe's surface, along the hole and around it together, so that turning takes the drag along the
/// hole: at most F, against the slip, its torque F r by the pipe's radius; carried by a damped bristle as at the wall
/// (contact/surface_friction.h). F is
/// - a pack-off's force, as it is given. The mud that it holds back pushes the pipe up by the pressure on the pipe's section
/// there (Stage::load);
///   its shear on the pipe is the force itself;
/// - of differential sticking mu p L w (1 - e^(-t/tau)): mu the wall's friction there, p L overpressure times length of the
/// permeable rock, w
///   and tau of the filter cake (contact/filter_cake.h), t the time for which the surface has not moved faster than
///   standing_pipe. Once it does the seal is broken, and begins anew.
extern const Force place_drag;

constexpr double place_drag_stiffness = 1e8;  ///< of the bristle, as the stuck point's [N/m]
constexpr double place_drag_damping = 1e5;    ///< beside it: half of critical for a joint of pipe [N s/m]
constexpr double standing_pipe = 1e-3;        ///< [m/s]

/// The node nearest to measured depth `md` [m] of those in the hole, the shaft not among them; `bit_depth`: of the bit's face [m
/// MD].
int nearest_node(const Model& model, double bit_depth, double md) noexcept;

/// Measured depth of the bit's face [m].
double depth_of_bit(const Model& model, const State& state) noexcept;

/// Whether anything drags, and where: Stage::drags.
void find_drags(const Model& model, const State& state, Stage& stage) noexcept;
/// What the drags remember of an accepted step.
void advance_drags(const Stage& stage, const StageResult& result, FaultState& faults) noexcept;

/// Pressure that a pack-off of a force [N] on pipe of a diameter in a hole of another [m] holds back [Pa]: a plug that shears at
/// tau drags with F = tau pi D L, and holds p = 4 tau L/(D_h - D), as a gel does (hydraulics/hydraulics.h).
double pack_off_pressure(double force, double hole_diameter, double diameter) noexcept;
/// Of the state's pack-off; 0 where there is none, or no pipe in it.
double plug_pressure(const Model& model, const State& state) noexcept;

}  // namespace drill_rig_sim

#endif
