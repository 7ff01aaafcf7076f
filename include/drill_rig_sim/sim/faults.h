#ifndef DRILL_RIG_SIM_SIM_FAULTS_H
#define DRILL_RIG_SIM_SIM_FAULTS_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

/// What goes wrong on a rig. A fault lives in the State, so that snapshots hold it.
namespace drill_rig_sim
{
/// The formation grips the node of the string that is nearest to measured depth `md` [m], where it is now, within an element's length; the
/// shaft is never gripped. `bit_depth`: of the bit's face [m MD]. False, and nothing changed: no pipe in the hole there, or `md` is no number.
bool stick_pipe(const Model& model, double bit_depth, double md, State& state) noexcept;
/// It lets go.
void free_pipe(State& state) noexcept;

}  // namespace drill_rig_sim

#endif
