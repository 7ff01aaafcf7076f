// SPDX-License-Identifier: BSD-3-Clause
// The program behind ./test/stability/run: runs jobs and prints their rows as CSV.
#include <cstdio>
#include <cstring>
#include <exception>

#include "jobs.h"

using namespace drill_rig_sim;

namespace drill_rig_sim
{
std::vector<Job> all_jobs(bool fast)
{
  // the longest first, so that none is left alone at the end
  std::vector<Job> jobs;
  for (auto add : {add_day_jobs, add_turn_jobs, add_sticking_jobs, add_map_jobs, add_level_jobs, add_corner_jobs,
                   add_buckling_jobs, add_impact_jobs, add_well_jobs, add_index3_jobs, add_outside_jobs})
    add(fast, jobs);
  return jobs;
}
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  const bool fast = argc > 1 && std::strcmp(argv[1], "--fast") == 0;
  const int first = fast ? 2 : 1;
  const std::vector<Job> jobs = all_jobs(fast);
  if (argc == first + 1 && std::strcmp(argv[first], "--list") == 0)
  {
    for (const Job& job : jobs) std::printf("%s\n", job.name.c_str());
    return 0;
  }
  Rows rows;
  Rows::print_header();
  int matched = 0;
  for (const Job& job : jobs)
  {
    bool wanted = argc == first;
    for (int k = first; k < argc; ++k) wanted = wanted || job.name == argv[k];
    if (!wanted) continue;
    ++matched;
    try
    {
      job.run(rows);
    }
    catch (const std::exception& problem)
    {
      std::fprintf(stderr, "%s: %s\n", job.name.c_str(), problem.what());
      return 3;
    }
  }
  if (matched == 0)
  {
    std::fprintf(stderr, "usage: stability_map [--fast] [--list | JOB...]\n");
    return 2;
  }
  return rows.promises_kept() ? 0 : 1;
}
