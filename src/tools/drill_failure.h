// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_FAILURE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_FAILURE_H

#include <string>
#include <vector>

#include "drill_rig_sim/sim/run.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// A run has failed: saves the last good state and throws ComputationError with one line (where, when, what, the files' names).
/// The state is `summary` in `json_name`, already written unless that is empty (then in drill_failed.json, here), and the forces
/// along the string beside it, in <the name without .json>_string.csv.
[[noreturn]] void report_failure(const Simulator& simulator, const std::string& summary, const std::string& json_name);

/// The hole has stopped growing before the goal's depth, or the operation under way gets nowhere: throws ComputationError with
/// one line (where, how deep, since when). `operations_began`: OperationsPlayer::began().
[[noreturn]] void report_standstill(const Simulator& simulator, const RunGoal& goal, const std::vector<double>& operations_began);

/// The operation under way was given up: throws ComputationError with one line (which, when, why).
[[noreturn]] void report_trouble(const Simulator& simulator, const OperationStatus& operation);

}  // namespace drill_rig_sim

#endif
