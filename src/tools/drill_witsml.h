// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_WITSML_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_WITSML_H

#include <ctime>
#include <string>

#include "drill_date.h"
#include "drill_output.h"
#include "drill_series.h"

namespace drill_rig_sim
{
/// What the gauges show during a run, as a log of WITSML 1.4.1.1 (Energistics, obj_log.xsd) by date and time. Curves by
/// the names and units that the field uses: BITDEP and DMEA [m], BLOCKCOMP [m], HKLD and WOB [kN], TORQUE [kN.m], SURF_RPM [rpm],
/// ROP [m/h], FLOWIN [L/min], SPP [kPa], DIFP [kPa].
class WitsmlSeries
{
public:
  /// Opens the file, none where the name is empty. `well`: the scene's name: letters, digits and _. `every`: between rows [s].
  /// Throws UsageError with one line if it cannot be written. `start`: the date of simulated time 0, since 1970 [s].
  WitsmlSeries(const std::string& name, const std::string& well, double every, std::time_t start);
  /// Adds a row where one is due; `frame`: since the last call [s].
  void add(const Simulator& simulator, double frame);
  /// Ends the log. Throws ComputationError with one line if not all of it reached the disk.
  void close();

private:
  void write_head(const std::string& well);

  std::string name_;
  File file_;
  Beat beat_;
  std::time_t start_;
  double last_ = 0.0;    // time of the last row [s]
  long end_place_ = -1;  // in the file, of the last row's time: known at the end alone
};

}  // namespace drill_rig_sim

#endif
