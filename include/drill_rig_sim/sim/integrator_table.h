// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_INTEGRATOR_TABLE_H
#define DRILL_RIG_SIM_SIM_INTEGRATOR_TABLE_H

#include <memory>
#include <vector>

#include "drill_rig_sim/solve/integrator.h"

namespace drill_rig_sim
{
/// What `numerics.integrator` can name.
struct IntegratorEntry
{
  IntegratorKind kind;
  const char* name;
  const char* description;
};

/// All integrators, the default first.
const std::vector<IntegratorEntry>& integrator_table();

/// Builds an integrator of the table for a model and the state that it starts from.
/// Throws std::runtime_error with one line (what, what is allowed) for a scene that it cannot integrate.
std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, std::shared_ptr<const Model> model, const State& start);

/// The table's entry; automatic: the default's.
const IntegratorEntry& find_integrator(IntegratorKind kind) noexcept;

}  // namespace drill_rig_sim

#endif
