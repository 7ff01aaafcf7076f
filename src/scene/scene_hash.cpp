// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/scene_hash.h"

#include "drill_rig_sim/math/hash.h"
#include "scene_keys.h"

namespace drill_rig_sim
{
namespace
{
/// Goes through the blocks of a scene as the reader does.
class SceneHasher
{
public:
  std::uint64_t value() const { return hash_; }

  void add(const Scene& scene)
  {
    add_keys(scene_keys, scene);
    add_well(scene.well);
    for (const FormationLayer& layer : scene.formation) add_keys(layer_keys, layer);
    add_keys(mud_keys, scene.mud);
    for (const FillLevel& row : scene.mud.fill)
      for (const double value : {row.bit_depth, row.level}) add_number(value);
    add_rheology(scene.rheology);
    if (scene.cuttings) add_keys(cuttings_keys, *scene.cuttings);
    if (scene.pressure_waves) add_keys(pressure_waves_keys, *scene.pressure_waves);
    if (scene.temperature) add_keys(temperature_keys, *scene.temperature);
    for (const PartSpec& part : scene.string) add_part(part);
    add_keys(rig_keys, scene.rig);
    add_keys(hoisting_keys, scene.rig.hoisting);
    add_keys(top_drive_keys, scene.rig.top_drive);
    add_keys(soft_torque_keys, scene.rig.top_drive.soft_torque);
    add_keys(z_torque_keys, scene.rig.top_drive.z_torque);
    add_keys(mud_pump_keys, scene.rig.mud_pump);
    for (const SurfaceLine& line : scene.rig.mud_pump.surface_lines)
      for (const double value : {line.length, line.diameter}) add_number(value);
    add_keys(heave_keys, scene.rig.heave);
    add_keys(contact_keys, scene.contact);
    add_keys(trajectory_keys, scene.trajectory);
    add_keys(start_keys, scene.start);
    add_numerics(scene.numerics);
    add_instruments(scene.instruments);
    for (const ProgramStep& step : scene.program) add_keys(program_keys, step);
    for (const Operation& operation : scene.operations) add_keys(operation_keys, operation, kind(operation.kind));
  }

private:
  void add_well(const WellSpec& well)
  {
    add_keys(well_keys, well);
    for (const SurveyStation& station : well.survey)
      for (const double value : {station.md, station.inclination, station.azimuth}) add_number(value);
    for (const HoleSection& section : well.sections) add_keys(section_keys, section);
  }

  void add_rheology(const std::optional<RheologySpec>& rheology)
  {
    add_number(rheology.has_value());
    if (!rheology) return;
    add_keys(rheology_keys, *rheology, kind(rheology->law));
    for (const ViscometerReading& reading : rheology->readings)
      for (const double value : {reading.speed, reading.dial}) add_number(value);
  }

  void add_part(const PartSpec& part)
  {
    add_keys(part_keys, part, kind(part.type));
    add_number(part.contact.has_value());
    if (part.contact) add_keys(part_contact_keys, *part.contact);
    if (!part.bit) return;
    for (const double diameter : part.bit->nozzles) add_number(diameter);
    add_keys(bit_bottom_keys, part.bit->bottom);
    add_keys(bit_torque_keys, part.bit->torque);
  }

  /// Without the kernel, of which a rig is as much the same as another machine's: by auto it may be another too.
  void add_numerics(NumericsSpec numerics)
  {
    numerics.kernel = Kernel::automatic;
    add_keys(numerics_keys, numerics);
  }

  void add_instruments(const InstrumentsSpec& instruments)
  {
    add_keys(mwd_keys, instruments.mwd);
    add_keys(toolface_keys, instruments.toolface);
    add_keys(dynamics_keys, instruments.dynamics);
#define GAUGE(type, name, ...) add_keys(keys_of(instruments.name), instruments.name);
#include "drill_rig_sim/scene/signal_list.h"
  }

  template <class Spec>
  void add_keys(const Table<Spec>& table, Spec spec, unsigned kinds = every_kind)
  {
    for (const Key<Spec>& key : table.keys)
      if (key.kinds & kinds) add_key(key, spec);
  }

  template <class Spec>
  void add_key(const Key<Spec>& key, Spec& spec)
  {
    if (const auto* number = std::get_if<double Spec::*>(&key.field)) return add_number(spec.*(*number));
    if (const auto* inside = std::get_if<Inside<Spec>>(&key.field)) return add_number(inside->ref(spec));
    if (const auto* count = std::get_if<int Spec::*>(&key.field)) return add_number(spec.*(*count));
    if (const auto* set = std::get_if<WordSet<Spec>>(&key.field)) return add_number(spec.*(set->member));
    if (const auto* fill = std::get_if<CountOrFill<Spec>>(&key.field)) return add_number(spec.*(fill->member));
    if (const auto* flag = std::get_if<Flag<Spec>>(&key.field)) return add_number(spec.*(flag->member));
    if (const auto* choice = std::get_if<Choice<Spec>>(&key.field)) return add_number(choice->get(spec));
    if (const auto* text = std::get_if<std::string Spec::*>(&key.field))
    {
      const std::string& value = spec.*(*text);
      hash_ = hash_bytes(value.data(), value.size() + 1, hash_);
    }
  }

  void add_number(double number)
  {
    hash_ = hash_bytes(&number, sizeof number, hash_);
  }

  std::uint64_t hash_ = hash_bytes("", 0);
};
}  // namespace

std::uint64_t scene_hash(const Scene& scene)
{
  SceneHasher hasher;
  hasher.add(scene);
  return hasher.value();
}

SceneStart scene_start(Scene scene)
{
  const double bit_depth = scene.start.bit_depth;
  scene.start.bit_depth = 0.0;
  return {scene_hash(scene), bit_depth};
}

}  // namespace drill_rig_sim
