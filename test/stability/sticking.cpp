// SPDX-License-Identifier: BSD-3-Clause
// Pipe that friction holds on a slope stays where it is.
#include <algorithm>
#include <cmath>

#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kSet = 60.0;            // let go, bounced and at rest [s]
constexpr double kCreepAllowed = 10e-6;  // [m]

void stick(const Choice& choice, double seconds, Rows& rows)
{
  Row row = row_of("sticking", text("%g s on a slope of 20 deg", seconds), choice, "um");
  const double step = workable_step("slope", choice, 0.01);
  Ride ride(load_scene("slope", {}, choice, step), is_default(choice) ? 500e6 : 160e6);
  ride.go(kSet, 0.1);
  if (ride.going())
  {
    const std::uint64_t halved = ride.rejected();
    const Eigen::Vector3d place = ride.now().bit_position;
    double furthest = 0.0, last = 0.0;
    while (ride.now().time < kSet + seconds - 0.5 && ride.go(1.0, 0.1))
    {
      last = (ride.now().bit_position - place).norm();
      furthest = std::max(furthest, last);
    }
    row.figure = 1e6 * furthest;
    row.text = text(
        "bit moved by %.3g um at most; %.3g um at the end of %.0f s; step %g s; %llu steps halved when it was let go; %llu after",
        1e6 * furthest, 1e6 * last, ride.now().time - kSet, step, static_cast<unsigned long long>(halved),
        static_cast<unsigned long long>(ride.rejected() - halved));
    row.verdict = furthest > kCreepAllowed ? Verdict::fails_creep : ride.verdict();
  }
  else
    row.verdict = ride.verdict();
  row.text += (row.text.empty() || ride.message().empty() ? "" : "; ") + ride.message();
  rows.add(row);
}
}  // namespace

void add_sticking_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Choice& choice : methods(fast))
  {
    const double seconds = fast ? 120.0 : 3600.0;
    jobs.push_back({"sticking/" + choice.method, [choice, seconds](Rows& rows) { stick(choice, seconds, rows); }});
  }
}

}  // namespace drill_rig_sim
