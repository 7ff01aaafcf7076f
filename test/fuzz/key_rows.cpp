// SPDX-License-Identifier: BSD-3-Clause
#include "key_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drill_rig_sim/math/unit_table.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "text_changes.h"

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
template <class Spec>
KeyRow row_of(const Key<Spec>& key, int table)
{
  KeyRow row;
  row.table = table;
  row.key = key.name;
  row.allowed = key.allowed;
  row.unit = plain_unit(key.unit);
  if (std::get_if<int Spec::*>(&key.field)) row.kind = ValueKind::whole;
  if (std::get_if<std::string Spec::*>(&key.field)) row.kind = ValueKind::text;
  if (std::get_if<Nested>(&key.field)) row.kind = ValueKind::block;
  if (std::get_if<Flag<Spec>>(&key.field))
  {
    row.kind = ValueKind::word;
    row.words = {"true", "false"};
  }
  if (std::get_if<CountOrFill<Spec>>(&key.field))
  {
    row.kind = ValueKind::whole;
    row.words = {"fill"};
  }
  if (const auto* choice = std::get_if<Choice<Spec>>(&key.field))
  {
    row.kind = ValueKind::word;
    row.words.assign(choice->words.begin(), choice->words.end());
  }
  if (row.key == "integrator")
  {
    row.kind = ValueKind::word;
    row.words = {"auto"};
    for (const IntegratorEntry& entry : integrator_table()) row.words.emplace_back(entry.name);
  }
  return row;
}

template <class... Tables>
std::vector<KeyRow> rows_of(const Tables&... tables)
{
  std::vector<KeyRow> rows;
  int number = 0;
  const auto add = [&](const auto& table)
  {
    for (const auto& key : table.keys) rows.push_back(row_of(key, number));
    ++number;
  };
  (add(tables), ...);
  return rows;
}

double inside(const Range& range, Random& random)
{
  const bool wide = range.low >= 0.0 && range.high > 1e3 * std::max(range.low, 1e-3);
  if (!wide || random.one_in(3)) return random.between(range.low, range.high);
  const double least = std::log(std::max(range.low, 1e-6 * range.high));
  return std::exp(random.between(least, std::log(range.high)));
}

double beyond(const Range& range, Random& random)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (random.below(5))
  {
    case 0:
      return std::nextafter(range.low, -infinity);
    case 1:
      return std::nextafter(range.high, infinity);
    case 2:
      return range.low - std::abs(range.high - range.low);
    case 3:
      return range.high + std::abs(range.high - range.low);
    default:
      return random.wild(range.high);
  }
}

double draw_number(const Range& range, Random& random)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (random.below(10))
  {
    case 0:
      return range.low;
    case 1:
      return range.high;
    case 2:
      return std::nextafter(range.low, infinity);
    case 3:
      return std::nextafter(range.high, -infinity);
    case 4:
      return beyond(range, random);
    default:
      return inside(range, random);
  }
}
/// A number with its unit: of its quantity, now and then of another.
std::string draw_number_with_unit(const KeyRow& row, Random& random)
{
  const double number = draw_number(row.allowed, random);
  const UnitFamily* family = random.one_in(10) ? &unit_families()[random.below(unit_families().size())] : family_of(row.unit);
  if (!family) return spelled(number);
  const UnitName& unit = family->units[random.below(family->units.size())];
  const UnitName* own = find_unit(*family, row.unit).unit;
  return spelled(static_cast<double>(number * (own ? own->si : 1.0L) / unit.si + unit.zero)) + (random.one_in(4) ? "" : " ") +
         unit.name;
}
}  // namespace

const std::vector<KeyRow>& key_rows()
{
  static const std::vector<KeyRow> rows =
      rows_of(scene_keys, well_keys, survey_keys, survey_columns_keys, survey_column_keys, survey_quality_keys, tie_in_keys,
              section_keys, layer_keys, mud_keys, part_keys, part_contact_keys, bit_bottom_keys, bit_torque_keys, rig_keys,
              hoisting_keys, top_drive_keys, soft_torque_keys, z_torque_keys, mud_pump_keys, contact_keys, trajectory_keys,
              start_keys, numerics_keys, instruments_keys, mwd_keys, toolface_keys, dynamics_keys, surface_keys, hook_load_keys,
              pressure_keys, sensor_keys, program_keys);
  return rows;
}

std::string draw_value(const KeyRow& row, Random& random)
{
  static const std::vector<std::string> nonsense = {"",     "~",      "[]",        "{}",    "x", "'1'",    "1e999", "0x10",
                                                    "5 in", "1 tonf", "\"9 ppg\"", "3 m m", "-", "[1, 2]", "{a: 1}"};
  if (random.one_in(30)) return nonsense[random.below(nonsense.size())];
  switch (row.kind)
  {
    case ValueKind::number:
      if (random.one_in(5)) return draw_number_with_unit(row, random);
      return spelled(draw_number(row.allowed, random));
    case ValueKind::whole:
      if (!row.words.empty() && random.one_in(3)) return row.words[0];
      return spelled(random.one_in(10) ? beyond(row.allowed, random) : std::round(inside(row.allowed, random)));
    case ValueKind::word:
      return row.words[random.below(row.words.size())];
    case ValueKind::text:
      return "name_" + std::to_string(random.below(3));
    default:
      return random.one_in(2) ? "{}" : "[]";
  }
}

}  // namespace fuzz
}  // namespace drill_rig_sim
