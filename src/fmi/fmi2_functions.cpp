// SPDX-License-Identifier: BSD-3-Clause
// The C functions of FMI 2.0 for co-simulation (Functional Mock-up Interface 2.0.4, 2.1 and 4.2), over FmuRig.
#include <cctype>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "fmi2.h"
#include "fmu_rig.h"
#include "model_description.h"

#define FMI_EXPORT extern "C" __attribute__((visibility("default")))

namespace
{
using drill_rig_sim::fmi::FmuRig;
using drill_rig_sim::fmi::VariableType;

struct Instance
{
  std::string name;
  fmi2CallbackFunctions callbacks{};
  bool logging = false;
  std::unique_ptr<FmuRig> rig;
  double start = 0.0;        // [s]
  std::string last_warning;  // that was written to the log
  bool terminated = false;
};

void say(const Instance& i, fmi2Status status, const std::string& text)
{
  if (i.callbacks.logger == nullptr || (status == fmi2Warning && !i.logging)) return;
  i.callbacks.logger(i.callbacks.componentEnvironment, i.name.c_str(), status,
                     status == fmi2Warning ? "logStatusWarning" : "logStatusError", "%s", text.c_str());
}

/// Runs what may throw; no exception leaves the library.
template <class Work>
fmi2Status guarded(fmi2Component component, const Work& work)
{
  if (component == nullptr) return fmi2Error;
  Instance& i = *static_cast<Instance*>(component);
  try
  {
    return work(i);
  }
  catch (const std::exception& error)
  {
    say(i, fmi2Error, error.what());
  }
  return fmi2Error;
}

template <class Value>
fmi2Status get(fmi2Component component, const fmi2ValueReference* references, std::size_t count, Value* values,
               std::initializer_list<VariableType> types)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   for (std::size_t k = 0; k < count; ++k) values[k] = static_cast<Value>(i.rig->get(references[k], types));
                   return fmi2OK;
                 });
}

template <class Value>
fmi2Status set(fmi2Component component, const fmi2ValueReference* references, std::size_t count, const Value* values,
               std::initializer_list<VariableType> types)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   for (std::size_t k = 0; k < count; ++k) i.rig->set(references[k], types, static_cast<double>(values[k]));
                   return fmi2OK;
                 });
}

fmi2Status not_available(fmi2Component component, const char* function)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   say(i, fmi2Error, std::string(function) + " is not available");
                   return fmi2Error;
                 });
}

/// The path of a URI of the form file:///path, with its escapes resolved.
std::string path_of(const std::string& uri)
{
  const std::string scheme = "file:";
  std::size_t k = uri.compare(0, scheme.size(), scheme) == 0 ? scheme.size() : 0;
  if (uri.compare(k, 3, "///") == 0) k += 2;
  std::string path;
  for (; k < uri.size(); ++k)
  {
    const bool escape = uri[k] == '%' && k + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[k + 1])) &&
                        std::isxdigit(static_cast<unsigned char>(uri[k + 2]));
    path += escape ? static_cast<char>(std::stoi(uri.substr(k + 1, 2), nullptr, 16)) : uri[k];
    if (escape) k += 2;
  }
  return path;
}
}  // namespace

FMI_EXPORT const char* fmi2GetTypesPlatform()
{
  return "default";
}

FMI_EXPORT const char* fmi2GetVersion()
{
  return "2.0";
}

FMI_EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                         const fmi2CallbackFunctions* functions, fmi2Boolean, fmi2Boolean logging)
{
  if (functions == nullptr) return nullptr;
  try
  {
    auto i = std::make_unique<Instance>();
    i->name = name != nullptr ? name : "";
    i->callbacks = *functions;
    i->logging = logging != 0;
    try
    {
      if (type != fmi2CoSimulation) throw std::runtime_error("the FMU is for co-simulation only");
      if (guid == nullptr || drill_rig_sim::fmi::guid() != guid)
        throw std::runtime_error("modelDescription.xml and the library are not of the same FMU: the guid must be " +
                                 drill_rig_sim::fmi::guid());
      if (resources == nullptr) throw std::runtime_error("the location of the resources must be given: scene.yaml lies there");
      i->rig = std::make_unique<FmuRig>(path_of(resources));
    }
    catch (const std::exception& error)
    {
      say(*i, fmi2Error, error.what());
      return nullptr;
    }
    return i.release();
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

FMI_EXPORT void fmi2FreeInstance(fmi2Component component)
{
  delete static_cast<Instance*>(component);
}

FMI_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean logging, std::size_t, const fmi2String*)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   i.logging = logging != 0;
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean, fmi2Real)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   i.start = start;
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component component)
{
  return guarded(component,
                 [](Instance& i)
                 {
                   i.rig->begin_initialisation(i.start);
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component component)
{
  return guarded(component,
                 [](Instance& i)
                 {
                   i.rig->end_initialisation();
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2Terminate(fmi2Component component)
{
  return guarded(component,
                 [](Instance& i)
                 {
                   i.terminated = true;
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2Reset(fmi2Component component)
{
  return guarded(component,
                 [](Instance& i)
                 {
                   i.rig->reset();
                   i.terminated = false;
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                  fmi2Real* values)
{
  return get(component, references, count, values, {VariableType::real});
}

FMI_EXPORT fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                     fmi2Integer* values)
{
  return get(component, references, count, values, {VariableType::integer, VariableType::drive_mode});
}

FMI_EXPORT fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                     fmi2Boolean* values)
{
  return get(component, references, count, values, {VariableType::boolean});
}

FMI_EXPORT fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference*, std::size_t count, fmi2String*)
{
  return count == 0 ? fmi2OK : not_available(component, "fmi2GetString");
}

FMI_EXPORT fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                  const fmi2Real* values)
{
  return set(component, references, count, values, {VariableType::real});
}

FMI_EXPORT fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                     const fmi2Integer* values)
{
  return set(component, references, count, values, {VariableType::integer, VariableType::drive_mode});
}

FMI_EXPORT fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference* references, std::size_t count,
                                     const fmi2Boolean* values)
{
  return set(component, references, count, values, {VariableType::boolean});
}

FMI_EXPORT fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference*, std::size_t count, const fmi2String*)
{
  return count == 0 ? fmi2OK : not_available(component, "fmi2SetString");
}

FMI_EXPORT fmi2Status fmi2DoStep(fmi2Component component, fmi2Real now, fmi2Real duration, fmi2Boolean)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   if (i.terminated) throw std::runtime_error("fmi2DoStep: the FMU is terminated; needed: fmi2Reset");
                   std::string warning;
                   for (const std::string& line : i.rig->step(now, duration)) warning += (warning.empty() ? "" : "; ") + line;
                   if (!warning.empty() && warning != i.last_warning) say(i, fmi2Warning, warning);
                   i.last_warning = warning;
                   return warning.empty() ? fmi2OK : fmi2Warning;
                 });
}

FMI_EXPORT fmi2Status fmi2CancelStep(fmi2Component component)
{
  return not_available(component, "fmi2CancelStep");
}

FMI_EXPORT fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*)
{
  return fmi2Discard;  // for steps that are computed in the background
}

FMI_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value)
{
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  return guarded(component,
                 [&](Instance& i)
                 {
                   *value = i.rig->time();
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*)
{
  return fmi2Discard;
}

FMI_EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component, fmi2StatusKind kind, fmi2Boolean* value)
{
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = 0;
  return fmi2OK;
}

FMI_EXPORT fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*)
{
  return fmi2Discard;
}

FMI_EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference*, std::size_t,
                                                  const fmi2Integer*, const fmi2Real*)
{
  return not_available(component, "fmi2SetRealInputDerivatives");
}

FMI_EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference*, std::size_t,
                                                   const fmi2Integer*, fmi2Real*)
{
  return not_available(component, "fmi2GetRealOutputDerivatives");
}

FMI_EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference*, std::size_t,
                                                   const fmi2ValueReference*, std::size_t, const fmi2Real*, fmi2Real*)
{
  return not_available(component, "fmi2GetDirectionalDerivative");
}

FMI_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   auto saved = std::make_unique<FmuRig::Saved>(i.rig->save());
                   delete static_cast<FmuRig::Saved*>(*state);
                   *state = saved.release();
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state)
{
  return guarded(component,
                 [&](Instance& i)
                 {
                   if (state == nullptr) throw std::runtime_error("there is no state to go back to");
                   i.rig->restore(*static_cast<FmuRig::Saved*>(state));
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state)
{
  return guarded(component,
                 [&](Instance&)
                 {
                   delete static_cast<FmuRig::Saved*>(*state);
                   *state = nullptr;
                   return fmi2OK;
                 });
}

FMI_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate, std::size_t*)
{
  return not_available(component, "fmi2SerializedFMUstateSize");
}

FMI_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate, fmi2Byte*, std::size_t)
{
  return not_available(component, "fmi2SerializeFMUstate");
}

FMI_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte*, std::size_t, fmi2FMUstate*)
{
  return not_available(component, "fmi2DeSerializeFMUstate");
}
