// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "drill_rig_sim/scene/read_scene.h"
#include "problems.h"
#include "scene_keys.h"

namespace drill_rig_sim
{
namespace
{
template <class Spec>
std::string default_of(const Key<Spec>& key, Spec defaults)
{
  if (key.required != no_kind) return "**required**";
  if (key.computed_default) return key.computed_default;
  if (const auto* field = std::get_if<double Spec::*>(&key.field)) return plain(defaults.*(*field) / unit_of(key.name));
  if (const auto* field = std::get_if<Inside<Spec>>(&key.field)) return plain(field->ref(defaults) / unit_of(key.name));
  if (const auto* field = std::get_if<int Spec::*>(&key.field)) return plain(defaults.*(*field));
  if (const auto* field = std::get_if<std::string Spec::*>(&key.field)) return defaults.*(*field);
  if (const auto* field = std::get_if<CountOrFill<Spec>>(&key.field)) return plain(defaults.*(field->member));
  if (const auto* field = std::get_if<Choice<Spec>>(&key.field))
    return field->words[static_cast<std::size_t>(field->get(defaults))];
  if (std::get_if<WordSet<Spec>>(&key.field)) return "all";
  return "";
}

template <class Spec>
std::string allowed_of(const Key<Spec>& key)
{
  if (std::get_if<std::string Spec::*>(&key.field)) return "text";
  if (std::get_if<Nested>(&key.field)) return "";
  if (std::get_if<Flag<Spec>>(&key.field)) return "true, false";
  if (std::get_if<CountOrFill<Spec>>(&key.field)) return to_text(key.allowed) + ", fill";
  if (const auto* field = std::get_if<Choice<Spec>>(&key.field)) return to_text(field->words);
  if (const auto* field = std::get_if<WordSet<Spec>>(&key.field)) return "list of " + to_text(field->words);
  return to_text(key.allowed);
}

std::string kinds_text(unsigned kinds, const std::vector<const char*>& words)
{
  std::vector<const char*> named;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    if (kinds & (1u << i)) named.push_back(words[i]);
  }
  return named.size() == words.size() ? "" : to_text(named) + ": ";
}

template <class Spec>
void write(std::ostream& out, const Table<Spec>& table, const std::vector<const char*>& kinds = {}, const Spec& defaults = Spec{})
{
  out << "\n### " << (table.block[0] ? "`" + std::string(table.block) + "`" : "Top level") << "\n\n" << table.meaning << "\n\n";
  out << "| key | unit | default | allowed | meaning |\n| --- | --- | --- | --- | --- |\n";
  for (const Key<Spec>& key : table.keys)
  {
    out << "| `" << key.name << "` | " << key.unit << " | " << default_of(key, defaults) << " | " << allowed_of(key) << " | "
        << kinds_text(key.kinds, kinds) << key.meaning << " |\n";
  }
}
}  // namespace

std::string scene_reference()
{
  std::ostringstream out;
  write(out, scene_keys);
  write(out, well_keys);
  write(out, survey_keys);
  write(out, survey_columns_keys);
  write(out, survey_column_keys);
  write(out, survey_quality_keys);
  write(out, tie_in_keys);
  write(out, section_keys);
  write(out, layer_keys);
  write(out, mud_keys);
  write(out, rheology_keys, rheology_words);
  write(out, cuttings_keys);
  write(out, pressure_waves_keys);
  write(out, temperature_keys);
  PartSpec part;
  part.bit.emplace();
  part.motor.emplace();
  part.stabilizer.emplace();
  part.mwd.emplace();
  part.pipe.emplace();
  part.steerable.emplace();
  write(out, part_keys, part_type_words, part);
  write(out, part_contact_keys);
  write(out, bit_bottom_keys, {}, BitSpec{}.bottom);
  write(out, bit_torque_keys, bit_torque_words);
  write(out, rig_keys);
  write(out, hoisting_keys);
  write(out, top_drive_keys);
  write(out, soft_torque_keys, {}, TopDriveSpec{}.soft_torque);
  write(out, z_torque_keys, {}, TopDriveSpec{}.z_torque);
  write(out, mud_pump_keys);
  write(out, heave_keys);
  write(out, contact_keys);
  write(out, trajectory_keys);
  write(out, start_keys);
  write(out, numerics_keys);
  write(out, instruments_keys);
  write(out, mwd_keys);
  write(out, toolface_keys);
  write(out, dynamics_keys);
  write(out, surface_keys);
  write(out, hook_load_keys);
  write(out, pressure_keys);
  write(out, sensor_keys);
  write(out, program_keys);
  write(out, operation_keys, operation_words);
  return out.str();
}

}  // namespace drill_rig_sim
