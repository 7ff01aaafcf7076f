// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STABILITY_JOBS_H
#define DRILL_RIG_SIM_STABILITY_JOBS_H

#include <functional>
#include <string>
#include <vector>

#include "verdict.h"

namespace drill_rig_sim
{
/// A piece of the run that needs no other; two of them run side by side.
struct Job
{
  std::string name;
  std::function<void(Rows&)> run;
};

/// All of them; `fast`: those of the fast subset, with the default method and less simulated time.
std::vector<Job> all_jobs(bool fast);

// Each file adds its own.
void add_map_jobs(bool fast, std::vector<Job>& jobs);       ///< largest stable step along an axis
void add_level_jobs(bool fast, std::vector<Job>& jobs);     ///< levels and variable steps at the ends of the axes
void add_corner_jobs(bool fast, std::vector<Job>& jobs);    ///< the default in the corners of the promised range
void add_turn_jobs(bool fast, std::vector<Job>& jobs);      ///< 10^5 turns; one full turn with each element
void add_sticking_jobs(bool fast, std::vector<Job>& jobs);  ///< an hour on a slope
void add_buckling_jobs(bool fast, std::vector<Job>& jobs);  ///< through the singular tangent and back
void add_impact_jobs(bool fast, std::vector<Job>& jobs);    ///< the bit hits bottom at 2 m/s
void add_well_jobs(bool fast, std::vector<Job>& jobs);      ///< doglegs, vertical, horizontal, beyond
void add_index3_jobs(bool fast, std::vector<Job>& jobs);    ///< a DAE of index 3 at very small steps
void add_day_jobs(bool fast, std::vector<Job>& jobs);       ///< slow drilling for a day
void add_outside_jobs(bool fast, std::vector<Job>& jobs);   ///< outside the range: a clear diagnostic

}  // namespace drill_rig_sim

#endif
