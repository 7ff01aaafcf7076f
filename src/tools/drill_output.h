// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_OUTPUT_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_OUTPUT_H

#include <cstdio>
#include <memory>
#include <string>

#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
struct CloseFile
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// The same file under two names; false where one is empty, and for /dev/null, which takes everything.
bool is_same_file(const std::string& one, const std::string& other);

/// Opens a file for writing, none where the name is empty. Throws UsageError with one line that names the option and the file.
File open_output(const char* option, const std::string& name);

/// Closes it, if there is one. Throws ComputationError with one line if not all of it reached the disk.
void close_output(File file, const std::string& name);

/// A comma and a number; the comma only where the number is not finite: nothing was measured, or it has no zero yet.
void write_cell(std::FILE* file, int digits, double value);

/// Forces along the string: the columns of `drill static --csv`, angles in degrees where the name of a column does.
void write_profile(std::FILE* file, const StringProfile& p);
/// The same at several times: the columns of write_profile() with the simulated time [s] before them.
void write_profile_series_header(std::FILE* file);
void write_profile_series_rows(std::FILE* file, double time, const StringProfile& p);

/// The run's CSV: SI units, radians. By hand, as all tables here: their cells are numbers, so that nothing needs quoting, and
/// each column has its own number of digits. `with_errors`: and what the companion (numerics.companion) measures: the errors
/// measured beside it, error_hook_load and so on, as shares, and its own truth, companion_hook_load and so on.
void write_csv_header(std::FILE* file, bool with_readings, bool with_errors = false);
/// `readings`, `measured` (whose errors and companion): null where the header has none. Surface WOB and differential pressure are
/// empty until they have been zeroed, errors and companion once that no longer goes along.
void write_csv_row(std::FILE* file, const Truth& m, const Readings* readings, const Simulator* measured = nullptr);

/// The corrected well, its nodes and then its bottom: md,east,north,up,inclination,azimuth,radius.
void write_path(std::FILE* file, const Simulator& simulator);

/// The uncorrected path of the last metres: east,north,up.
void write_raw_path(std::FILE* file, const Simulator& simulator);

}  // namespace drill_rig_sim

#endif
