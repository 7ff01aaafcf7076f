// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_SIGNAL_ROWS_H
#define DRILL_RIG_SIM_INSTRUMENTS_SIGNAL_ROWS_H

#include <vector>

#include "drill_rig_sim/math/shown_units.h"
#include "drill_rig_sim/instruments/signals.h"

/// The list of signals (scene/signal_list.h) as rows, for writers of files and tables.
namespace drill_rig_sim
{
/// Where a signal belongs.
enum class SignalOf
{
  both,     ///< truth and readings: messages RigTruth and RigState
  truth,    ///< RigTruth
  reading,  ///< RigState
  bit       ///< BitTruth
};

struct SignalRow
{
  const char* name;
  SignalOf of;
  bool by_gauge;      ///< with errors of its own
  const char* type;   ///< in messages; "": in files only
  const char* field;  ///< in messages
  Dimension dimension;
  const char* quantity;  ///< the dimension in a word, "force"
  const char* mnemonic;  ///< in WITSML files; "": none
  int item;              ///< in record 01 of WITS level 0; 0: none
  const char* meaning;
  const char* reading;                     ///< how the reading is made; "": there is none
  double (*in_truth)(const Truth&);        ///< flags are 0 or 1; null: not of the truth
  double (*in_readings)(const Readings&);  ///< NaN until zeroed; null: not of the readings
};

/// In the order of the list.
const std::vector<SignalRow>& signal_rows();
/// The unit in messages and files, "rad/s"; "" for flags and numbers without one.
const char* unit_of(const SignalRow& row) noexcept;

}  // namespace drill_rig_sim

#endif
