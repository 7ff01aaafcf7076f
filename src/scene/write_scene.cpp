// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/write_scene.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "scene_keys.h"

namespace drill_rig_sim
{
namespace
{
/// As few digits as give the number back.
std::string written(double number)
{
  char text[32];
  for (const int digits : {15, 16, 17})
  {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number) break;
  }
  return text;
}

/// The number in another unit that gives `number` back to the last bit, where there is one, else to rounding.
std::string written_in(double unit, double number)
{
  const double about = number / unit;
  for (const double near : {about, std::nextafter(about, HUGE_VAL), std::nextafter(about, -HUGE_VAL)})
    if (near * unit == number) return written(near);
  return written(about);
}

/// Between quotes.
std::string written(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + "\"";
}

std::string entry(const std::string& key, const std::string& value)
{
  return key + ": " + value;
}

/// What is not empty, with commas between.
std::string joined(const std::vector<std::string>& entries)
{
  std::string out;
  for (const std::string& one : entries)
    if (!one.empty()) out += (out.empty() ? "" : ", ") + one;
  return out;
}

/// A block of these entries, empty without any.
std::string block(const std::string& key, const std::string& entries)
{
  return entries.empty() ? "" : entry(key, "{" + entries + "}");
}

bool same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// A row's value in YAML; empty where it is the default's, unless `all` are asked for.
template <class Spec>
std::string value_of(const Key<Spec>& key, Spec& spec, Spec& defaults, bool all)
{
  const auto number = [&](double value, double usual)
  { return all || !same(value, usual) ? written_in(unit_of(key.name), value) : ""; };
  if (const auto* field = std::get_if<double Spec::*>(&key.field)) return number(spec.*(*field), defaults.*(*field));
  if (const auto* inside = std::get_if<Inside<Spec>>(&key.field)) return number(inside->ref(spec), inside->ref(defaults));
  if (const auto* field = std::get_if<int Spec::*>(&key.field))
    return all || spec.*(*field) != defaults.*(*field) ? std::to_string(spec.*(*field)) : "";
  if (const auto* field = std::get_if<std::string Spec::*>(&key.field))
    return all || spec.*(*field) != defaults.*(*field) ? written(spec.*(*field)) : "";
  if (const auto* flag = std::get_if<Flag<Spec>>(&key.field))
    return all || !same(spec.*(flag->member), defaults.*(flag->member)) ? (spec.*(flag->member) != 0.0 ? "true" : "false") : "";
  if (const auto* fill = std::get_if<CountOrFill<Spec>>(&key.field))
    return spec.*(fill->member) == 0 ? "fill" : std::to_string(spec.*(fill->member));
  if (const auto* choice = std::get_if<Choice<Spec>>(&key.field))
    return all || choice->get(spec) != choice->get(defaults) ? choice->words[static_cast<std::size_t>(choice->get(spec))] : "";
  if (const auto* set = std::get_if<WordSet<Spec>>(&key.field))
  {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < set->words.size(); ++i)
      if (spec.*(set->member) & (1u << i)) words.push_back(set->words[i]);
    return spec.*(set->member) != defaults.*(set->member) ? "[" + joined(words) + "]" : "";
  }
  return "";
}

/// The rows of a table that are not as by default, those of another kind left out.
template <class Spec>
std::string entries_of(
    const Table<Spec>& table, Spec spec, Spec defaults = Spec(), unsigned kinds = every_kind,
    const std::function<bool(const std::string&)>& left_out = [](const std::string&) { return false; })
{
  std::vector<std::string> entries;
  for (const Key<Spec>& key : table.keys)
  {
    if (!(key.kinds & kinds) || left_out(key.name)) continue;
    const std::string value = value_of(key, spec, defaults, (key.required & kinds) != 0u);
    if (!value.empty()) entries.push_back(entry(key.name, value));
  }
  return joined(entries);
}

template <class Spec>
std::string block_of(const std::string& key, const Table<Spec>& table, const Spec& spec, const Spec& defaults = Spec())
{
  return block(key, entries_of(table, spec, defaults));
}

/// Lines of a list; `write` gives an item's entries.
template <class Item, class Write>
std::string list_of(const std::string& key, const std::vector<Item>& items, const Write& write, const std::string& before = "")
{
  if (items.empty()) return "";
  std::string out = before + key + ":\n";
  for (const Item& item : items) out += before + "  - " + write(item) + "\n";
  return out;
}

std::string lines_of(const std::string& text)
{
  return text.empty() ? "" : text + "\n";
}

std::string torque_of(const BitTorqueSpec& torque)
{
  return block("torque", entries_of(bit_torque_keys, torque, BitTorqueSpec(), kind(torque.model)));
}

/// A part of this type with nothing said of it.
PartSpec default_part(const PartSpec& part)
{
  PartSpec out;
  if (part.bit) out.bit.emplace();
  if (part.motor) out.motor.emplace();
  if (part.stabilizer) out.stabilizer.emplace();
  if (part.mwd) out.mwd.emplace();
  if (part.pipe) out.pipe.emplace();
  if (part.steerable) out.steerable.emplace();
  return out;
}

std::string nozzles_of(const BitSpec& bit)
{
  std::vector<std::string> diameters;
  for (const double diameter : bit.nozzles) diameters.push_back(written(diameter) + " m");
  return diameters.empty() ? "" : entry("nozzles", "[" + joined(diameters) + "]");
}

std::string part_of(const PartSpec& part)
{
  const auto left_out = [&](const std::string& key)
  { return part.joints == 1 ? key == "joints" || key == "joint_length" : key == "length"; };
  std::vector<std::string> entries = {entries_of(part_keys, part, default_part(part), kind(part.type), left_out)};
  if (part.contact) entries.push_back(entry("contact", "{" + entries_of(part_contact_keys, *part.contact) + "}"));
  if (part.bit) entries.push_back(nozzles_of(*part.bit));
  if (part.bit) entries.push_back(torque_of(part.bit->torque));
  if (part.bit) entries.push_back(block_of("bottom", bit_bottom_keys, part.bit->bottom, BitSpec().bottom));
  return "{" + joined(entries) + "}";
}

/// Rows of two numbers, empty without any.
template <class Row>
std::string rows_of(const char* key, const std::vector<Row>& list, double Row::*first, double Row::*second)
{
  std::vector<std::string> rows;
  rows.reserve(list.size());
  for (const Row& row : list) rows.push_back("[" + joined({written(row.*first), written(row.*second)}) + "]");
  return rows.empty() ? "" : entry(key, "[" + joined(rows) + "]");
}

std::string well_of(const WellSpec& well)
{
  std::string out = "well:\n";
  for (const Key<WellSpec>& key : well_keys.keys)
  {
    WellSpec spec = well, defaults;
    const std::string value = value_of(key, spec, defaults, false);
    if (!value.empty()) out += "  " + entry(key.name, value) + "\n";
  }
  out += list_of(
      "stations", well.survey,
      [](const SurveyStation& s) {
        return "[" + joined({written(s.md), written_in(degree, s.inclination), written_in(degree, s.azimuth)}) + "]";
      },
      "  ");
  return out + list_of(
                   "sections", well.sections, [](const HoleSection& s) { return "{" + entries_of(section_keys, s) + "}"; }, "  ");
}

std::string mud_of(const Scene& scene)
{
  const MudSpec& mud = scene.mud;
  const std::optional<RheologySpec>& rheology = scene.rheology;
  const std::string fill = rows_of("fill", mud.fill, &FillLevel::bit_depth, &FillLevel::level);
  if (!rheology) return block("mud", joined({entries_of(mud_keys, mud), fill}));
  const std::string cuttings = scene.cuttings ? entry("cuttings", "{" + entries_of(cuttings_keys, *scene.cuttings) + "}") : "";
  const std::optional<PressureWavesSpec>& given = scene.pressure_waves;
  const std::string waves = given ? entry("pressure_waves", "{" + entries_of(pressure_waves_keys, *given) + "}") : "";
  const std::string temperature =
      scene.temperature ? entry("temperature", "{" + entries_of(temperature_keys, *scene.temperature) + "}") : "";
  const std::string readings = rows_of("readings", rheology->readings, &ViscometerReading::speed, &ViscometerReading::dial);
  const std::string curve = joined({entries_of(rheology_keys, *rheology, RheologySpec(), kind(rheology->law)), readings});
  return block("mud", joined({entries_of(mud_keys, mud), fill, block("rheology", curve), cuttings, waves, temperature}));
}

std::string pump_of(const MudPumpSpec& pump)
{
  return block("mud_pump", joined({entries_of(mud_pump_keys, pump),
                                   rows_of("surface_lines", pump.surface_lines, &SurfaceLine::length, &SurfaceLine::diameter)}));
}

std::string rig_of(const RigSpec& rig)
{
  const TopDriveSpec usual;
  const std::string drive = joined({entries_of(top_drive_keys, rig.top_drive),
                                    block_of("soft_torque", soft_torque_keys, rig.top_drive.soft_torque, usual.soft_torque),
                                    block_of("z_torque", z_torque_keys, rig.top_drive.z_torque, usual.z_torque)});
  return block("rig", joined({block_of("hoisting", hoisting_keys, rig.hoisting), block("top_drive", drive), pump_of(rig.mud_pump),
                              block_of("heave", heave_keys, rig.heave), entries_of(rig_keys, rig)}));
}

std::string instruments_of(const InstrumentsSpec& instruments)
{
  const InstrumentsSpec usual;
  const std::string gauges = joined({
#define GAUGE(type, name, ...) block_of(#name, keys_of(instruments.name), instruments.name, usual.name),
#include "drill_rig_sim/scene/signal_list.h"
  });
  return block("instruments",
               joined({block_of("mwd", mwd_keys, instruments.mwd), block_of("toolface", toolface_keys, instruments.toolface),
                       block_of("dynamics", dynamics_keys, instruments.dynamics), block("surface", gauges)}));
}

std::string operation_of(const Operation& operation)
{
  return "{" + entries_of(operation_keys, operation, default_operation(operation.kind), kind(operation.kind)) + "}";
}
}  // namespace

std::string write_scene(const Scene& scene)
{
  std::string out;
  for (const Key<Scene>& key : scene_keys.keys)
  {
    Scene spec = scene, defaults;
    const std::string value = value_of(key, spec, defaults, key.required != no_kind);
    if (!value.empty()) out += entry(key.name, value) + "\n";
  }
  out += well_of(scene.well);
  out += list_of("formation", scene.formation,
                 [](const FormationLayer& layer) { return "{" + entries_of(layer_keys, layer) + "}"; });
  out += lines_of(mud_of(scene));
  out += list_of("string", scene.string, part_of);
  out += lines_of(rig_of(scene.rig));
  out += lines_of(block_of("contact", contact_keys, scene.contact));
  out += lines_of(block_of("trajectory", trajectory_keys, scene.trajectory));
  out += lines_of(block_of("start", start_keys, scene.start));
  out += lines_of(block_of("numerics", numerics_keys, scene.numerics));
  out += lines_of(instruments_of(scene.instruments));
  out += list_of("program", scene.program, [](const ProgramStep& step) { return "{" + entries_of(program_keys, step) + "}"; });
  return out + list_of("operations", scene.operations, operation_of);
}

}  // namespace drill_rig_sim
