#include "drill_rig_sim/solve/integrator.h"

#include <stdexcept>

#include "drill_rig_sim/solve/arkode_stepper.h"
#include "drill_rig_sim/solve/explicit_limit.h"
#include "drill_rig_sim/solve/ida_integrator.h"
#include "drill_rig_sim/solve/stepper.h"

namespace drill_rig_sim
{
namespace
{
constexpr const char* arkode = "arkode_dirk";
constexpr const char* reference = "ida";
}  // namespace

const std::vector<IntegratorEntry>& integrator_table()
{
  static const std::vector<IntegratorEntry> table = []
  {
    std::vector<IntegratorEntry> entries;
    for (const Method& method : method_table()) entries.push_back({method.name, method.description});
    entries.push_back({arkode, "TR-BDF2 by SUNDIALS ARKODE with our linear solver, for comparison"});
    entries.push_back(
        {reference, "the reference: the rig as a DAE with multipliers, variable order and step by SUNDIALS IDA; slow"});
    return entries;
  }();
  return table;
}

const char* integrator_name(const std::string& name)
{
  for (const IntegratorEntry& entry : integrator_table())
    if (name == entry.name || name == "auto") return entry.name;
  std::string allowed = "auto";
  for (const IntegratorEntry& entry : integrator_table()) allowed += std::string(", ") + entry.name;
  throw std::runtime_error("numerics.integrator: '" + name + "' is unknown, allowed: " + allowed);
}

std::unique_ptr<Integrator> make_integrator(const std::string& name, System& system, const SystemState& start)
{
  if (name == reference) return std::make_unique<IdaIntegrator>(system);
  if (name == arkode) return std::make_unique<ArkodeStepper>(system);
  const Method& method = *find_method(integrator_name(name));
  if (method.step == step_explicit) check_explicit_step(system, start);
  return std::make_unique<Stepper>(system, method);
}

}  // namespace drill_rig_sim
