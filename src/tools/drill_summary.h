// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SUMMARY_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SUMMARY_H

#include <string>
#include <vector>

#include "drill_averages.h"
#include "drill_doubts.h"
#include "drill_errors.h"
#include "drill_feed.h"
#include "drill_limits.h"
#include "drill_rig_sim/crew/operations.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_units.h"

namespace drill_rig_sim
{
/// What a run took.
struct Elapsed
{
  double wall;  ///< [s]
  double cpu;   ///< [s]
};

/// What is kept of a run's frames.
struct RunRecord
{
  DrillingRecord drilling;
  LatestRecord latest;
  Doubts doubts;
  Limits limits;
  LargestErrors errors;
  FeedLimits feed;
  std::vector<double> operations_began;  ///< OperationsPlayer::began()
  OperationStatus operation;             ///< the one that the run ended in
};

/// A run's summary as a JSON object, a newline at its end. Numbers read back to the same double; what is not finite is null.
/// `readings`: it also says what the instruments show at the end.
std::string json_summary(const Simulator& simulator, const Elapsed& elapsed, const RunRecord& record, bool readings);

/// The same in two lines on standard output, and a line for each warning, each limit that was passed and each operation whose
/// speed limited the weight on bit. Texts of warnings stay in SI.
void print_summary(const Simulator& simulator, const Elapsed& elapsed, const RunRecord& record, const Printed& printed);

}  // namespace drill_rig_sim

#endif
