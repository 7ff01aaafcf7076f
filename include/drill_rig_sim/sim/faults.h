#ifndef DRILL_RIG_SIM_SIM_FAULTS_H
#define DRILL_RIG_SIM_SIM_FAULTS_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

/// What goes wrong on a rig. A fault lives in the State, so that snapshots hold it.
namespace drill_rig_sim
{
/// Whether there is pipe in the hole at measured depth `md` [m]: above 0 (the rotary table), not below the bit's face at `bit_depth` [m MD].
bool is_in_hole(double md, double bit_depth) noexcept;
/// The formation grips the node of the string that is nearest to measured depth `md` [m], where it is now: half an element off at most, or
/// the uppermost in the hole; the shaft is never gripped. `bit_depth`: of the bit's face [m MD]. Needs pipe in the hole at `md`.
void stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept;
/// It lets go.
void free_pipe(State& state) noexcept;

}  // namespace drill_rig_sim

#endif
