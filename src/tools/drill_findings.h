// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_FINDINGS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_FINDINGS_H

#include <nlohmann/json.hpp>
#include <string>

#include "drill_rig_sim/sim/finer_pair.h"
#include "drill_units.h"

/// What `drill verify` has found, printed and as JSON.
namespace drill_rig_sim
{
/// A line an output.
void print_findings(const Verification& verification, const Printed& printed);

/// A line. `not_measured`: why the run's error was not, in which case no warning could come; empty where it was.
void print_verdict(const Verification& verification, double tolerance, const std::string& not_measured);

/// All of it; what is not finite is written as null.
nlohmann::ordered_json json_of(const Simulator& simulator, const FinerPair& pair);

}  // namespace drill_rig_sim

#endif
