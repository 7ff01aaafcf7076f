// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_WALL_FAULTS_H
#define DRILL_RIG_SIM_MODEL_WALL_FAULTS_H

#include "drill_rig_sim/model/hole_cleaning.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/model/workspace.h"

/// What faults and a bed of cuttings make of the hole's wall: another friction (hole_cleaning.h), and a wash-out, where the hole
/// is wider. The well itself stays as it is: the search for a place in it adds these.
namespace drill_rig_sim
{
constexpr double wash_out_length = 5.0;  ///< from the middle of a wash-out to its ends [m]

/// How much larger the hole's radius is at measured depth `md`, in the shape of a cosine: by/4 (1 + cos(pi (md - at)/length))
/// [m]; and its slope.
struct WashOut
{
  double radius = 0.0;  ///< [m]
  double slope = 0.0;   ///< d radius / d md [-]
};
WashOut wash_out(const FaultState& faults, double md) noexcept;

/// Factor on the wall's friction at `md`.
inline double friction_factor(const FaultState& faults, double md) noexcept
{
  return md >= faults.friction_from ? faults.friction_factor : 1.0;
}

/// Factor of faults and bed.
inline double friction_factor(const State& state, double md) noexcept
{
  return friction_factor(state.faults, md) * bed_friction(state.cuttings, md);
}

/// Into what find_in_hole() has found, and whether it still touches.
void put_faults_on_wall(const Model& model, const State& state, const Stage& stage, Workspace& work) noexcept;
/// Into what find_guides() has.
void put_faults_on_guides(const State& state, Stage& stage) noexcept;

}  // namespace drill_rig_sim

#endif
