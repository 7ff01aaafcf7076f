// SPDX-License-Identifier: BSD-3-Clause
// Slack-off until the string buckles and coils, and pick-up until it hangs straight again: twice through the singular tangent.
#include <algorithm>
#include <cmath>

#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
struct Coil
{
  Verdict verdict = Verdict::passes;
  std::string message;
  double aside = 0.0;             ///< largest sideways displacement while it is pushed [m]
  double weight = 0.0;            ///< on the bit then, mean [N]
  double left = 0.0;              ///< largest sideways displacement after the pick-up [m]
  double hook_load_change = 0.0;  ///< after against before [N]
};

std::vector<Eigen::Vector3d> places(const Ride& ride)
{
  std::vector<Eigen::Vector3d> out;
  const auto saved = ride.simulator().save();
  for (const NodeState& node : saved->mechanics.nodes) out.push_back(node.position);
  return out;
}

/// Across the hole (which is half a degree off the vertical), of the nodes below the table.
double farthest_aside(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].z() < 0.0) most = std::max(most, (a[i] - b[i]).head<2>().norm());
  return most;
}

Coil coil(const Choice& choice, double step, double limit)
{
  Coil out;
  Ride ride(load_scene("buckling", {}, choice, step), limit);
  if (ride.going())
  {
    const std::vector<Eigen::Vector3d> straight = places(ride);
    const double hook_load = ride.now().hook_load;
    ride.go(12.0, 0.1);
    for (int k = 0; k < 30 && ride.go(0.1, 0.1); ++k) out.weight += ride.now().wob / 30.0;
    out.aside = farthest_aside(places(ride), straight);
    ride.go(25.0, 0.1);
    out.left = farthest_aside(places(ride), straight);
    out.hook_load_change = ride.now().hook_load - hook_load;
  }
  out.verdict = ride.verdict();
  out.message = ride.message();
  return out;
}

void buckle(const Choice& choice, Rows& rows)
{
  Row row = row_of("buckling", "slack-off to a coil and back", choice, "mm left");
  const Coil reference = coil(default_choice(), 5e-4, 240e6);
  const double step = workable_step("buckling", choice, default_step);
  const Coil run = coil(choice, step, 32e6);
  row.figure = 1e3 * run.left;
  row.text = text("step %g s; pushed with %.1f kN (reference %.1f); %.0f mm aside; after pick-up %.2f mm; hook load %.2f kN off",
                  step, 1e-3 * run.weight, 1e-3 * reference.weight, 1e3 * run.aside, 1e3 * run.left, 1e-3 * run.hook_load_change);
  const bool right = passed(reference.verdict) && run.aside > 0.02 && run.left < 0.005 && std::abs(run.hook_load_change) < 1e3 &&
                     std::abs(run.weight - reference.weight) < 0.1 * reference.weight;
  conclude(row, run.verdict, right, run.message);
  rows.add(row);
}
}  // namespace

void add_buckling_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Choice& choice : methods(fast))
    jobs.push_back({"buckling/" + choice.method, [choice](Rows& rows) { buckle(choice, rows); }});
}

}  // namespace drill_rig_sim
