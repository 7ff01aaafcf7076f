// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_BEAMS_H
#define DRILL_RIG_SIM_MODEL_FORCES_BEAMS_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The string's elements (string/beam_element.h) with their structural damping, and their weight in mud: a dead load that goes to
/// the ends by the element's own shape functions.
extern const Force beams;

/// Makes ready what no element writes before something is added to it: the first diagonal block, and the guided nodes beside free
/// elements.
void open_string(const StageContext& at, const ForceRows& to) noexcept;

/// Element `e` alone, where the batch kernels take those beside it: a shaft that points the bit (pointing.h). The diagonal blocks
/// of its ends are there before, its own blocks beside them it writes.
void add_beam(const StageContext& at, int e, const ForceRows& to) noexcept;
void store_beam(const StageContext& at, int e, StoredEnergy& energy) noexcept;
void sample_beam(const StageContext& at, int e, EnergySample& sample) noexcept;
/// Its tension, torque and bending moment into work.result.forces.
void find_beam_forces(const StageContext& at, int e) noexcept;

/// Forces of element `e` at the stage.
BeamForces element_forces(const StageContext& at, int e) noexcept;

}  // namespace drill_rig_sim

#endif
