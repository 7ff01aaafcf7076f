// SPDX-License-Identifier: BSD-3-Clause
// The bit runs onto hard rock at 2 m/s.
#include <algorithm>
#include <cmath>

#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kImpulseTo = 1.85;  // the bit hits at 1.67 s [s]
constexpr double kEnd = 2.4;

struct Blow
{
  Verdict verdict = Verdict::passes;
  std::string message;
  double peak = 0.0;     ///< of the weight on bit, at the steps' ends [N]
  double impulse = 0.0;  ///< of the first 0.2 s or so, to a fixed time [N s]
  double speed = 0.0;    ///< of the bit before [m/s]
  double deepest = 0.0;  ///< of the bit below the hole's bottom [m]
};

Blow strike(const Choice& choice, double step, double limit)
{
  Blow out;
  Ride ride(load_scene("impact", {}, choice, step), limit);
  double hit = 1e9;
  while (ride.going() && ride.now().time < kEnd - 1e-9 && ride.go(step, step))
  {
    const Truth& m = ride.now();
    if (m.wob > 0.0 && hit > 1e8) hit = m.time;
    if (m.time < hit) out.speed = m.bit_velocity.norm();
    if (m.time < kImpulseTo) out.impulse += m.wob * step;
    out.peak = std::max(out.peak, m.wob);
    out.deepest = std::max(out.deepest, m.bit_depth - m.hole_depth);
  }
  out.verdict = ride.verdict();
  out.message = ride.message();
  return out;
}

void impact(const Choice& choice, Rows& rows)
{
  Row row = row_of("impact", "bit on hard rock at 2 m/s", choice, "peak / reference");
  const Blow reference = strike(default_choice(), 2e-5, 240e6);
  const double step = workable_step("impact", choice, default_step);
  const Blow run = strike(choice, step, 32e6);
  row.figure = run.peak / reference.peak;
  row.text =
      text("step %g s; hits at %.2f m/s; peak %.0f kN (reference %.0f); impulse to 1.85 s %.2f kN s (%.2f); %.1f mm deep (%.1f)",
           step, run.speed, 1e-3 * run.peak, 1e-3 * reference.peak, 1e-3 * run.impulse, 1e-3 * reference.impulse,
           1e3 * run.deepest, 1e3 * reference.deepest);
  const bool right = passed(reference.verdict) && std::abs(run.speed - 2.0) < 0.05 &&
                     std::abs(run.peak / reference.peak - 1.0) < 0.3 && std::abs(run.impulse / reference.impulse - 1.0) < 0.1 &&
                     run.deepest < 2.0 * reference.deepest;
  conclude(row, run.verdict, right, run.message);
  rows.add(row);
}
}  // namespace

void add_impact_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Choice& choice : methods(fast))
    jobs.push_back({"impact/" + choice.method, [choice](Rows& rows) { impact(choice, rows); }});
}

}  // namespace drill_rig_sim
