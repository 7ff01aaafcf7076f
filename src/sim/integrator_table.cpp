// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/sim/integrator_table.h"

#include <utility>

#include "drill_rig_sim/compared/arkode_stepper.h"
#include "drill_rig_sim/compared/explicit_limit.h"
#include "drill_rig_sim/reference/ida_integrator.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
const std::vector<IntegratorEntry>& integrator_table()
{
  static const std::vector<IntegratorEntry> table = []
  {
    std::vector<IntegratorEntry> entries;
    for (const Method* method : method_table()) entries.push_back({method->kind, method->name, method->description});
    entries.push_back(
        {IntegratorKind::arkode_dirk, "arkode_dirk", "TR-BDF2 by SUNDIALS ARKODE with our linear solver, for comparison"});
    entries.push_back({IntegratorKind::ida, "ida",
                       "the reference: the rig as a DAE with multipliers, variable order and step by SUNDIALS IDA; slow"});
    return entries;
  }();
  return table;
}

const IntegratorEntry& find_integrator(IntegratorKind kind) noexcept
{
  for (const IntegratorEntry& entry : integrator_table())
    if (kind == entry.kind) return entry;
  return integrator_table().front();
}

std::unique_ptr<Integrator> make_integrator(IntegratorKind kind, std::shared_ptr<const Model> model, const State& start)
{
  if (kind == IntegratorKind::ida) return std::make_unique<IdaIntegrator>(std::move(model));
  if (kind == IntegratorKind::arkode_dirk) return std::make_unique<ArkodeStepper>(std::move(model));
  const Method& method = find_method(kind);
  if (kind == IntegratorKind::central_differences) check_explicit_step(*model, start);
  return std::make_unique<Stepper>(std::move(model), method);
}

}  // namespace drill_rig_sim
