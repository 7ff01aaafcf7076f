// SPDX-License-Identifier: BSD-3-Clause
// The default in the corners of the promised range, where all axes are at an end together.
#include "jobs.h"
#include "tumble.h"

namespace drill_rig_sim
{
namespace
{
struct Corner
{
  const char* name;
  const char* key;
  double low, high;
};

const Corner kAxes[] = {
    {"contact stiffness", "contact.stiffness", 1e5, 1e8},    {"bristle stiffness", "contact.tangential_stiffness", 1e5, 1e9},
    {"Stribeck speed", "contact.stribeck_speed", 1e-3, 1.0}, {"element length", "numerics.element_length", 2.0, 9.5},
    {"lateral damping", "mud.lateral_damping", 20.0, 2e4},
};
constexpr int kCorners = 1 << 5;
const double kStep = default_step;

void run_corner(int corner, bool fast, Rows& rows)
{
  std::vector<std::string> settings;
  std::string signs;
  for (int k = 0; k < 5; ++k)
  {
    const bool high = corner >> k & 1;
    settings.push_back(text("%s=%g", kAxes[k].key, high ? kAxes[k].high : kAxes[k].low));
    signs += text("%s%s %g", k ? "; " : "", kAxes[k].name, high ? kAxes[k].high : kAxes[k].low);
  }
  const TumbleReference reference = tumble_reference(settings, fast);
  const Tumble run =
      passed(reference.worst().verdict) ? tumble(settings, default_choice(), kStep, reference, 80e6) : reference.worst();
  Row row = row_of("corners", signs, default_choice(), "s");
  row.verdict = run.verdict;
  row.figure = kStep;
  row.text = run.message;
  rows.add(row);
}
}  // namespace

void add_corner_jobs(bool fast, std::vector<Job>& jobs)
{
  // Harder walls are left out: with soft bristles the pipe then chatters from wall to wall, a chatter that 5 ms steps end too
  // soon. even parity: half of the corners, every pair of ends in some of them
  for (int corner = 0; corner < kCorners; ++corner)
  {
    if (__builtin_popcount(static_cast<unsigned>(corner)) % 2 != 0) continue;
    const bool short_elements = (corner & 8) == 0;
    if (fast && short_elements) continue;
    jobs.push_back({text("corners/%d", corner), [corner, fast](Rows& rows) { run_corner(corner, fast, rows); }});
  }
}

}  // namespace drill_rig_sim
