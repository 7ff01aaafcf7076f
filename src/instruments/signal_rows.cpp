// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/signal_rows.h"

#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
namespace
{
template <class T>
constexpr const char* message_type = "float64";
template <>
constexpr const char* message_type<bool> = "bool";
template <>
constexpr const char* message_type<int> = "int32";
template <>
constexpr const char* message_type<unsigned> = "uint32";
}  // namespace

// a row of the list becomes a row here
// clang-format off
#define ROW(type, name, by_gauge, dimension, mnemonic, item, meaning, reading, shown)                                      \
  {#name, SignalOf::both, by_gauge, message_type<type>, #name, Dimension::dimension, #dimension, mnemonic, item, meaning,  \
   reading, [](const Truth& t) { return static_cast<double>(t.name); },                                                    \
   [](const Readings& r) { return static_cast<double>(shown); }},
#define BOTH(type, name, dimension, mnemonic, item, meaning, reading) \
  ROW(type, name, false, dimension, mnemonic, item, meaning, reading, r.name)
#define GAUGE(type, name, dimension, mnemonic, item, meaning, reading) \
  ROW(type, name, true, dimension, mnemonic, item, meaning, reading, r.name)
#define GAUGE_LIKE GAUGE
#define ZEROED(type, name, dimension, mnemonic, item, meaning, reading) \
  ROW(type, name, false, dimension, mnemonic, item, meaning, reading, r.zeroed(r.name))
#define TRUTH(type, name, dimension, meaning)                                                                             \
  {#name, SignalOf::truth, false, message_type<type>, #name, Dimension::dimension, #dimension, "", 0, meaning, "",         \
   [](const Truth& t) { return static_cast<double>(t.name); }, nullptr},
#define READING(type, name, dimension, meaning, how)                                                                      \
  {#name, SignalOf::reading, false, message_type<type>, #name, Dimension::dimension, #dimension, "", 0, meaning, how,      \
   nullptr, [](const Readings& r) { return static_cast<double>(r.name); }},
#define BIT(name, field, dimension, value, meaning)                                                                       \
  {#name, SignalOf::bit, false, "float64", #field, Dimension::dimension, #dimension, "", 0, meaning, "",                   \
   [](const Truth& t) -> double { return value; }, nullptr},
#define BIT_FILE(name, dimension, value, meaning)                                                                         \
  {#name, SignalOf::bit, false, "", "", Dimension::dimension, #dimension, "", 0, meaning, "",                              \
   [](const Truth& t) -> double { return value; }, nullptr},
// clang-format on

const std::vector<SignalRow>& signal_rows()
{
  static const std::vector<SignalRow> rows = {
#include "drill_rig_sim/scene/signal_list.h"
  };
  return rows;
}
#undef ROW

const char* unit_of(const SignalRow& row) noexcept
{
  return row.dimension == Dimension::number ? "" : si_name(row.dimension);
}

}  // namespace drill_rig_sim
