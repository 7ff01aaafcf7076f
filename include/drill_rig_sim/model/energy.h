// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_ENERGY_H
#define DRILL_RIG_SIM_MODEL_ENERGY_H

#include "drill_rig_sim/model/energy_sample.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// Energies at the increments u (6 per node) of a stage; every force adds its own.
StoredEnergy stored_energy(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work) noexcept;

/// Energies, forces by kind and rates there; the stage's accelerations must be those of the method. Allocates when `out` has not
/// been used before.
void sample_energy(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work,
                   EnergySample& out);

}  // namespace drill_rig_sim

#endif
