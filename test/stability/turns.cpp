// SPDX-License-Identifier: BSD-3-Clause
// Many turns of the top drive, and one full turn with each element.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/math/visit.h"
#include "jobs.h"
#include "ride.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kTurnsPerSecond = 1000.0 / 60.0;
constexpr double kSettled = 120.0;      // the spin-up has died away [s]
constexpr double kDriftAllowed = 1e-8;  // of the torque in any element, relative
constexpr double kTurnsAllowed = 0.01;  // of what the drive was told
constexpr double kOffAllowed = 1e-6;    // torque of one element against another's: the string hangs straight

/// Largest difference of torque in an element, relative to the largest torque.
double drift(const std::vector<double>& before, const std::vector<double>& after)
{
  double scale = 0.0, most = 0.0;
  for (std::size_t e = 0; e < before.size(); ++e)
  {
    scale = std::max(scale, std::abs(before[e]));
    most = std::max(most, std::abs(after[e] - before[e]));
  }
  return most / scale;
}

/// A second from a snapshot, twice: the same bits, in every field of the state?
bool repeats(Ride& ride)
{
  const auto snapshot = ride.simulator().save();
  ride.go(1.0, 0.1);
  const auto first = ride.simulator().save();
  ride.simulator().restore(*snapshot);
  ride.go(1.0, 0.1);
  const auto second = ride.simulator().save();
  return ride.going() && to_bytes(*first) == to_bytes(*second);
}

void many_turns(const Choice& choice, double turns, Rows& rows)
{
  Row row = row_of("turns", text("%g turns of the top drive", turns), choice, "torque drift");
  const double step = workable_step("turns", choice, default_step);
  Ride ride(load_scene("turns", {}, choice, step), is_default(choice) ? 500e6 : 32e6);
  if (!ride.go(kSettled, 0.1))
  {
    row.verdict = ride.verdict();
    row.text = ride.message();
    return rows.add(row);
  }
  const auto before = ride.simulator().save();
  ride.go(turns / kTurnsPerSecond, 0.1);
  const auto after = ride.simulator().save();
  const double turned = (after->mechanics.nodes[0].spin_angle - before->mechanics.nodes[0].spin_angle) / (2.0 * pi);
  row.figure = drift(before->forces.torque, after->forces.torque);
  row.text = text("step %g s; %.0f turns; meter torque %.9g before; %.9g N m after", step, turned, before->truth.torque,
                  after->truth.torque);
  const bool same = repeats(ride);
  if (ride.going()) row.text += same ? "; repeats bit by bit from a snapshot" : "; does not repeat bit by bit";
  const bool right = row.figure < kDriftAllowed && std::abs(turned / turns - 1.0) < kTurnsAllowed && same;
  conclude(row, ride.verdict(), right, ride.message());
  rows.add(row);
}

/// Three turns at 60 rpm: torque against the default's at every 0.05 s.
void full_turn(Rows& rows)
{
  const std::vector<std::string> slow{"program[0].top_drive_speed_rpm=60"};
  std::vector<double> reference;
  for (const Choice& choice : all_elements())
  {
    Ride ride(load_scene("turns", slow, choice, 0.002));
    double worst = 0.0, largest = 0.0, at = 0.0;
    for (std::size_t k = 0; k < 80 && ride.go(0.05, 0.05); ++k)
    {
      if (!is_default(choice) && k == reference.size()) break;  // the default came no farther
      if (is_default(choice)) reference.push_back(ride.now().torque);
      const double off = std::abs(ride.now().torque - reference[k]);
      largest = std::max(largest, std::abs(reference[k]));
      if (off > worst) at = ride.now().top_drive_angle / (2.0 * pi);
      worst = std::max(worst, off);
    }
    Row row = row_of("full turn", "three turns of the string", choice, "turns made");
    row.figure = ride.now().top_drive_angle / (2.0 * pi);
    row.text = worst > 0.0 ? text("torque off by up to %.3g N m of %.3g at %.2f turns", worst, largest, at) : "";
    conclude(row, ride.verdict(), worst <= kOffAllowed * largest && row.figure >= 3.0, ride.message());
    rows.add(row);
  }
}
}  // namespace

void add_turn_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Choice& choice : methods(fast))
  {
    const double turns = is_default(choice) ? (fast ? 1e4 : 1e5) : 1e4;
    jobs.push_back({"turns/" + choice.method, [choice, turns](Rows& rows) { many_turns(choice, turns, rows); }});
  }
  jobs.push_back({"full_turn", full_turn});
}

}  // namespace drill_rig_sim
