// SPDX-License-Identifier: BSD-3-Clause
// Keys of the scene file about the torque on bit.
#include "scene_keys.h"

namespace drill_rig_sim
{
const std::vector<const char*> bit_torque_words = {
#define BIT_LAW(name, ...) #name,
#include "drill_rig_sim/contact/bit_law_list.h"
};

namespace
{
constexpr const char* bit_torque_title = "Torque on bit."
#define BIT_LAW(name, limit, drag, by_cut, meaning) " " #name ": " meaning "."
#include "drill_rig_sim/contact/bit_law_list.h"
    ;

constexpr unsigned bit_laws_with(bool BitLawTraits::*trait)
{
  unsigned kinds = 0, law = 1;
  for (const BitLawTraits& traits : bit_laws)
  {
    if (traits.*trait) kinds |= law;
    law <<= 1;
  }
  return kinds;
}
constexpr unsigned drag = bit_laws_with(&BitLawTraits::drag), face = every_kind & ~drag,
                   by_cut = bit_laws_with(&BitLawTraits::by_cut);
}  // namespace

// clang-format off
const Table<BitTorqueSpec> bit_torque_keys = {"string[].torque", bit_torque_title, {
  {"model",                 "",       Choice<BitTorqueSpec>{bit_torque_words,
      [](BitTorqueSpec& t, int word) { t.model = static_cast<BitTorqueModel>(word); },
      [](const BitTorqueSpec& t) { return static_cast<int>(t.model); }},
      none, "law of the torque"},
  {"static",                "-",      &BitTorqueSpec::static_friction,     between(0.0, 5.0),
      "friction coefficient mu of the bit at rest, at least `kinetic`", no_kind, face},
  {"kinetic",               "-",      &BitTorqueSpec::kinetic_friction,    between(0.0, 5.0),
      "friction coefficient mu of the bit at high speed", no_kind, face},
  {"speed_rpm",             "rpm",    &BitTorqueSpec::speed,               between(0.1, 1000.0), "bit speed over which mu falls",
      no_kind, face},
  {"cutting_energy",        "J/m3",   &BitTorqueSpec::cutting_energy,      between(0.0, 1e10),
      "intrinsic specific energy of the rock; 0: as the drillability implies", no_kind, drag},
  {"wear_friction",         "-",      &BitTorqueSpec::wear_friction,       between(0.0, 5.0),
      "friction coefficient times bit constant of the wear flats", no_kind, drag},
  {"wear_weight",           "N",      &BitTorqueSpec::wear_weight,         between(0.0, 1e6),
      "weight on the wear flats, at most the rock's threshold", no_kind, drag},
  {"blades",                "",       &BitTorqueSpec::blades,              between(1, 12),
      "number of blades, equal and evenly spaced; each cuts below the one before it", no_kind, by_cut},
}};
// clang-format on

}  // namespace drill_rig_sim
