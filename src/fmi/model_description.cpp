// SPDX-License-Identifier: BSD-3-Clause
#include "model_description.h"

#include <tinyxml2.h>

#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace drill_rig_sim::fmi
{
namespace
{
using Printer = tinyxml2::XMLPrinter;

/// A unit in powers of the SI's.
struct BaseUnit
{
  int kg, m, s, rad, kelvin = 0;
  double offset = 0.0;  // of its zero
};

const std::map<std::string, BaseUnit>& base_units()
{
  static const std::map<std::string, BaseUnit> units = {
      {"N", {1, 1, -2, 0}},     {"N m", {1, 2, -2, 0}},   {"Pa", {1, -1, -2, 0}},  {"m", {0, 1, 0, 0}},
      {"m/s", {0, 1, -1, 0}},   {"m3", {0, 3, 0, 0}},     {"m3/s", {0, 3, -1, 0}}, {"rad", {0, 0, 0, 1}},
      {"rad/s", {0, 0, -1, 1}}, {"kg/m3", {1, -3, 0, 0}}, {"1/s", {0, 0, -1, 0}},  {"degC", {0, 0, 0, 0, 1, 273.15}},
  };
  return units;
}

void write_base_unit(const BaseUnit& unit, Printer& out)
{
  out.OpenElement("BaseUnit");
  for (const auto& [name, power] :
       {std::pair{"kg", unit.kg}, {"m", unit.m}, {"s", unit.s}, {"rad", unit.rad}, {"K", unit.kelvin}})
    if (power != 0) out.PushAttribute(name, power);
  if (unit.offset != 0.0) out.PushAttribute("offset", unit.offset);
  out.CloseElement();
}

void write_units(Printer& out)
{
  std::set<std::string> used;
  for (const Variable& v : variables())
    if (*v.unit != '\0') used.insert(v.unit);
  out.OpenElement("UnitDefinitions");
  for (const std::string& name : used)
  {
    out.OpenElement("Unit");
    out.PushAttribute("name", name.c_str());
    const auto unit = base_units().find(name);
    if (unit != base_units().end()) write_base_unit(unit->second, out);
    out.CloseElement();
  }
  out.CloseElement();
}

void write_types(Printer& out)
{
  out.OpenElement("TypeDefinitions");
  out.OpenElement("SimpleType");
  out.PushAttribute("name", "TopDriveMode");
  out.OpenElement("Enumeration");
  for (int mode = 0; mode < top_drive_mode_count; ++mode)
  {
    out.OpenElement("Item");
    out.PushAttribute("name", top_drive_modes[mode].word);
    out.PushAttribute("value", mode);
    out.PushAttribute("description", top_drive_modes[mode].meaning);
    out.CloseElement();
  }
  for (int open = 0; open < 3; ++open) out.CloseElement();
}

void write_log_categories(Printer& out)
{
  out.OpenElement("LogCategories");
  for (const char* name : {"logStatusWarning", "logStatusError"})
  {
    out.OpenElement("Category");
    out.PushAttribute("name", name);
    out.CloseElement();
  }
  out.CloseElement();
}

std::string number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string start_value(const Variable& v, const Inputs& start)
{
  const double value = v.get(start);
  if (v.type == VariableType::boolean) return value != 0.0 ? "true" : "false";
  return v.type == VariableType::real ? number(value) : std::to_string(static_cast<int>(value));
}

void write_type(const Variable& v, const Inputs& start, Printer& out)
{
  constexpr const char* elements[] = {"Real", "Integer", "Boolean", "Enumeration"};
  out.OpenElement(elements[static_cast<int>(v.type)]);
  if (v.type == VariableType::drive_mode) out.PushAttribute("declaredType", "TopDriveMode");
  if (*v.unit != '\0') out.PushAttribute("unit", v.unit);
  if (v.get != nullptr) out.PushAttribute("start", start_value(v, start).c_str());
  out.CloseElement();
}

void write_variables(const Inputs& start, Printer& out)
{
  constexpr const char* causality[] = {"parameter", "input", "output"};
  out.OpenElement("ModelVariables");
  for (std::size_t i = 0; i < variables().size(); ++i)
  {
    const Variable& v = variables()[i];
    const bool fixed = v.causality == Causality::parameter;
    out.OpenElement("ScalarVariable");
    out.PushAttribute("name", v.name.c_str());
    out.PushAttribute("valueReference", static_cast<unsigned>(i));
    out.PushAttribute("description", v.meaning.c_str());
    out.PushAttribute("causality", causality[static_cast<int>(v.causality)]);
    out.PushAttribute("variability", fixed ? "fixed" : v.type == VariableType::real ? "continuous" : "discrete");
    write_type(v, start, out);
    out.CloseElement();
  }
  out.CloseElement();
}

/// Indices count from 1 there.
void write_structure(Printer& out)
{
  out.OpenElement("ModelStructure");
  for (const char* list : {"Outputs", "InitialUnknowns"})
  {
    out.OpenElement(list);
    for (std::size_t i = 0; i < variables().size(); ++i)
    {
      if (variables()[i].causality != Causality::output) continue;
      out.OpenElement("Unknown");
      out.PushAttribute("index", static_cast<unsigned>(i + 1));
      out.CloseElement();
    }
    out.CloseElement();
  }
  out.CloseElement();
}

void write_co_simulation(Printer& out)
{
  out.OpenElement("CoSimulation");
  out.PushAttribute("modelIdentifier", model_identifier);
  out.PushAttribute("canHandleVariableCommunicationStepSize", true);
  out.PushAttribute("canNotUseMemoryManagementFunctions", true);
  out.PushAttribute("canGetAndSetFMUstate", true);
  out.CloseElement();
}
}  // namespace

std::string guid()
{
  char text[40];
  std::snprintf(text, sizeof text, "{drill_rig_sim-%016llx}", static_cast<unsigned long long>(variables_hash()));
  return text;
}

std::string model_description(const std::string& model, const Inputs& start)
{
  Printer out;
  out.PushHeader(false, true);
  out.OpenElement("fmiModelDescription");
  out.PushAttribute("fmiVersion", "2.0");
  out.PushAttribute("modelName", model.c_str());
  out.PushAttribute("guid", guid().c_str());
  out.PushAttribute("description", "a drilling rig with its string, hole and rock");
  out.PushAttribute("generationTool", "drill_rig_sim");
  out.PushAttribute("variableNamingConvention", "structured");
  write_co_simulation(out);
  write_units(out);
  write_types(out);
  write_log_categories(out);
  out.OpenElement("DefaultExperiment");
  out.PushAttribute("startTime", "0");
  out.PushAttribute("stepSize", number(1.0 / start.rate).c_str());
  out.CloseElement();
  write_variables(start, out);
  write_structure(out);
  out.CloseElement();
  return out.CStr();
}

}  // namespace drill_rig_sim::fmi
