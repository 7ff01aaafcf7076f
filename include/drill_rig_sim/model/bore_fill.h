// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_BORE_FILL_H
#define DRILL_RIG_SIM_MODEL_BORE_FILL_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

/// A string that was run in on its float without being filled: air above the mud in it. Its outside displaces mud along all of
/// it, and mud inside weighs where there is some; per length, w = m g - rho g A_o + rho g A_i up to the mud's surface, without
/// the last term above it.
///
/// How far down it is empty is `mud.fill`, by the depth of the bit, as the crew leaves it. What the pump delivers fills it too:
/// that volume is taken off the air (HydraulicState::filled) until the crew fills the string. Mud that is put in or left out
/// comes from outside and goes there: the energy account counts the weight that there is at each step. Not in it: the air's
/// weight and pressure, the smaller drag of a bore without mud, and how its pressure, missing there, shortens the pipe.
namespace drill_rig_sim
{
/// Where the mud stands in the string: HydraulicState::bore_top of `state`, by the places of its nodes, and `filled`, no more
/// than there is air without it. Returns the volume of air [m3]; 0 and full_bore where the string is full.
double fill_bore(const Model& model, State& state) noexcept;

/// Height of the mud's surface in the string, at most that of the rotary table [m].
double mud_surface(const Model& model, const State& state) noexcept;

}  // namespace drill_rig_sim

#endif
