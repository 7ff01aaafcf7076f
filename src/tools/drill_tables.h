// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_TABLES_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_TABLES_H

#include <string>
#include <vector>

/// The lists of signals (scene/signal_list.h), modes (rig/top_drive_mode_list.h) and faults (scene/fault_list.h) as texts that
/// other languages and readers need.
namespace drill_rig_sim
{
struct TableText
{
  const char* name;  ///< of the option `--of`
  std::string (*text)();
};

/// What `drill reference --of` prints.
const std::vector<TableText>& table_texts();

}  // namespace drill_rig_sim

#endif
