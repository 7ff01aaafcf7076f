// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_PUMP_STROKES_H
#define DRILL_RIG_SIM_HYDRAULICS_PUMP_STROKES_H

namespace drill_rig_sim
{
/// Volume that a pump has delivered after a number of strokes, over stroke_volume: grows by 1 a stroke. A stroke is a turn of the
/// crank, in which each of n pistons delivers 1/n. Crank and rod, rod six times as long as the crank: three pistons deliver
/// between 0.83 and 1.06 of their mean (Miller, The Reciprocating Pump, 1987: 17 % below, 6 % above), n times a stroke.
/// @param cylinders  n; 0: evenly
double delivered_strokes(double strokes, int cylinders) noexcept;

}  // namespace drill_rig_sim

#endif
