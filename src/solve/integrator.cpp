#include "drill_rig_sim/solve/integrator.h"

#include <stdexcept>
#include <utility>

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/arkode_stepper.h"
#include "drill_rig_sim/solve/ida_integrator.h"
#include "drill_rig_sim/solve/methods/explicit_limit.h"
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
    for (const Method* method : method_table()) entries.push_back({method->name, method->description});
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

std::unique_ptr<Integrator> make_integrator(const std::string& name, std::shared_ptr<const Model> model, const State& start)
{
  if (name == reference) return std::make_unique<IdaIntegrator>(std::move(model));
  if (name == arkode) return std::make_unique<ArkodeStepper>(std::move(model));
  const Method& method = *find_method(integrator_name(name));
  if (&method == &explicit_differences) check_explicit_step(*model, start);
  return std::make_unique<Stepper>(std::move(model), method);
}

Integrator::Integrator(std::shared_ptr<const Model> model) : model_(std::move(model)), stage_(*model_), work_(*model_)
{
}

const RigForces& Integrator::find_forces(const State& state) noexcept
{
  find_string_forces(*model_, state, stage_, work_);
  return work_.result.forces;
}

}  // namespace drill_rig_sim
