// SPDX-License-Identifier: BSD-3-Clause
// A day of slow drilling: nothing grows that must not.
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "drill_rig_sim/well/wellbore.h"
#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kRate = 0.35e-3;        // [m/s]
constexpr double kSettled = 600.0;       // on bottom, drilling at the feed rate [s]
constexpr double kNodesPerMetre = 10.0;  // stage II leaves a node every 0.1 m
constexpr double kMemoryAllowed = 1.0;   // [MB]
constexpr double kBalance = 5e-3;        // of the throughput, as for every scene

double resident_megabytes()
{
#ifdef __SANITIZE_ADDRESS__
  return 0.0;  // AddressSanitizer keeps back what is freed
#endif
  long pages = 0, resident = 0;
  FILE* file = std::fopen("/proc/self/statm", "r");
  const bool told = file && std::fscanf(file, "%ld %ld", &pages, &resident) == 2;
  if (file) std::fclose(file);
  return told ? 1e-6 * static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) : NAN;
}

/// Mean weight on bit over a minute.
double mean_weight(Ride& ride)
{
  double sum = 0.0;
  int count = 0;
  for (; count < 60 && ride.go(1.0, 0.1); ++count) sum += ride.now().wob;
  return sum / std::max(count, 1);
}

void drill(const Choice& choice, double seconds, Rows& rows)
{
  Row row = row_of("slow drilling", text("%.3g h at 0.35 mm/s", seconds / 3600.0), choice, "m drilled");
  const double step = workable_step("day", choice, 0.02);
  Ride ride(load_scene("day", {}, choice, step), is_default(choice) ? 1600e6 : 32e6);
  ride.go(kSettled, 0.1);
  const double weight = mean_weight(ride);
  if (!ride.going())
  {
    row.verdict = ride.verdict();
    row.text = ride.message();
    return rows.add(row);
  }
  const double depth = ride.now().hole_depth, memory = resident_megabytes(), begin = ride.now().time;
  const int nodes = ride.simulator().wellbore().node_count();
  ride.simulator().balance_energy();
  ride.go(0.5 * (seconds - begin), 0.1);
  const double closure_middle = ride.simulator().energy().closure();
  ride.go(seconds - ride.now().time - 60.0, 0.1);
  const double weight_end = mean_weight(ride);
  const double drilled = ride.now().hole_depth - depth, expected = kRate * (ride.now().time - begin);
  const int grown = ride.simulator().wellbore().node_count() - nodes;
  const double memory_grown = resident_megabytes() - memory;
  row.figure = drilled;
  row.text = text(
      "step %g s; fed %.4f m; WOB %.1f N in the first minutes and %.1f N in the last; %d hole nodes for %.2f m; memory %+.2f MB",
      step, expected, weight, weight_end, grown, drilled, memory_grown);
  const double closure = ride.simulator().energy().closure();
  row.text += text("; energy balance open by %.2e of the throughput at half time and %.2e at the end", closure_middle, closure);
  const bool right = std::abs(drilled - expected) < 1e-3 * expected && std::abs(weight_end - weight) < 0.01 * weight &&
                     std::abs(grown - kNodesPerMetre * drilled) <= 2.0 && memory_grown < kMemoryAllowed &&
                     ride.simulator().energy().throughput() > 0.0 && std::abs(closure_middle) < kBalance &&
                     std::abs(closure) < kBalance;
  conclude(row, ride.verdict(), right, ride.message());
  rows.add(row);
}
}  // namespace

void add_day_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Choice& choice : methods(fast))
  {
    const double seconds = is_default(choice) && !fast ? 86400.0 : 3600.0;
    jobs.push_back({"day/" + choice.method, [choice, seconds](Rows& rows) { drill(choice, seconds, rows); }});
  }
}

}  // namespace drill_rig_sim
