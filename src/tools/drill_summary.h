#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_SUMMARY_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_SUMMARY_H

#include <string>

#include "drill_averages.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
/// What a run took.
struct Elapsed
{
  double wall;  ///< [s]
  double cpu;   ///< [s]
};

/// A run's summary as a JSON object, a newline at its end. Numbers read back to the same double; what is not finite is null.
/// `readings`: it also says what the instruments show at the end.
std::string json_summary(const Simulator& simulator, const Elapsed& elapsed, const DrillingRecord& record, bool readings);

/// The same in two lines on standard output.
void print_summary(const Simulator& simulator, const Elapsed& elapsed, const DrillingRecord& record);

}  // namespace drill_rig_sim

#endif
