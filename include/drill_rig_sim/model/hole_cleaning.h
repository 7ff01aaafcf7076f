// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_HOLE_CLEANING_H
#define DRILL_RIG_SIM_MODEL_HOLE_CLEANING_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

/// Cuttings between bit and flow line, where the scene has mud.cuttings: laws of hydraulics/cuttings.h in some hundred cells of
/// one length along the hole, once a second.
///
/// - What the bit drills, its face times the progress of the hole's bottom (of a ring around a pilot hole), enters the cell of
/// the
///   bit. Flow and rotation are the means over the second: return flow, and turns of the top drive; a motor alone does not stir.
/// - What is suspended weighs on the annulus: g (rho_s - rho) times share, over the vertical depth. ECD and stand-pipe pressure
///   follow.
/// - A bed narrows the annulus: the losses grow by a factor, that of the pressure gradients with and without it at the present
///   flow, at the mean speed in the open area and with a hydraulic diameter that shrinks with it.
/// - A bed rubs on the pipe: the wall's friction has the factor 1 + F_b/(mu w sin I), w the pipe's weight in mud per length, mu
///   the wall's coefficient, F_b of (7) there. So pipe that lies by its weight has the drag F_b more, along and around the hole;
///   where a curve or compression presses it harder, the bed's part grows in proportion. None on a wall without friction.
///
/// Cells are a hundredth of the hole long, at least 10 m: what returns from the bit spreads by about a tenth of its way. There is
/// room for 1 km of new hole; beyond it the last cell grows. Not in it: buoyancy by cuttings, 0.2 % of the string's weight for
/// each per cent of them.
namespace drill_rig_sim
{
constexpr double cuttings_period = 1.0;  ///< [s]

/// Gives a state without cuttings its cells; none without mud.cuttings.
void begin_cuttings(const Model& model, State& state);
/// After an accepted step [s]: collects, and once a second advances the cells. Does not allocate.
void advance_cuttings(const Model& model, double step, State& state) noexcept;

/// Factor of a bed on the wall's friction at measured depth `md` [m], in straight lines between the cells' middles.
double bed_friction(const CuttingsState& cuttings, double md) noexcept;

/// Volume of rock in the hole, suspended and in the bed [m3].
double cuttings_in_hole(const CuttingsState& cuttings) noexcept;

}  // namespace drill_rig_sim

#endif
