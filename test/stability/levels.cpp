// SPDX-License-Identifier: BSD-3-Clause
// Levels of the model, and steps of variable length, along the axes of the map: what is promised of the default's steps is
// promised of them.
#include "jobs.h"
#include "tumble.h"

namespace drill_rig_sim
{
namespace
{
struct Axis
{
  const char* key;
  std::vector<double> values;  ///< ends of the promised range and the default
};

/// Those of the map; the guided string has a mesh of its own, and no side to damp.
const Axis kAxes[] = {
    {"contact.stiffness", {1e5, 5e7, 1e10}}, {"contact.tangential_stiffness", {1e5, 1e9}},
    {"contact.stribeck_speed", {1e-3, 1.0}}, {"numerics.element_length", {2.0, 9.5}},
    {"mud.lateral_damping", {0.0, 2e4}},
};

struct Kind
{
  const char* name;
  std::vector<std::string> level;  ///< settings; none: beam3d, which is thrown. A guided string has no way across the hole: it is
                                   ///< lowered and turned alone
  std::vector<std::string> steps;  ///< settings
  bool fast;
};

const std::vector<Kind>& kinds()
{
  static const std::vector<std::string> hybrid{"numerics.level=hybrid", "numerics.free_length=30"},
      guided{"numerics.level=axial_torsional"};
  static const std::vector<Kind> table = {
      {"beam3d with steps variable by 5 %", {}, {"numerics.step=0", "numerics.tolerance=0.05"}, false},
      {"beam3d with steps variable by 1 %", {}, {"numerics.step=0", "numerics.tolerance=0.01"}, true},
      {"beam3d with steps variable by 0.2 %", {}, {"numerics.step=0", "numerics.tolerance=0.002"}, false},
      {"hybrid", hybrid, {}, false},
      {"hybrid with steps variable by 1 %", hybrid, {"numerics.step=0", "numerics.tolerance=0.01"}, true},
      {"axial_torsional", guided, {}, false},
      {"axial_torsional with steps variable by 1 %", guided, {"numerics.step=0", "numerics.tolerance=0.01"}, false},
      {"rigid", {"numerics.level=rigid"}, {}, false},
      {"auto by 2 %", {"numerics.level=auto"}, {}, true},
  };
  return table;
}

std::vector<std::string> with(std::vector<std::string> settings, const std::vector<std::string>& more)
{
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

void run_level(const Axis& axis, double value, bool fast, Rows& rows)
{
  const std::string setting = text("%s=%g", axis.key, value);
  const TumbleReference thrown = tumble_reference({setting}, fast);
  for (const Kind& kind : kinds())
  {
    if (fast && !kind.fast) continue;
    const std::vector<std::string> scene = with({setting}, kind.level), settings = with(scene, kind.steps);
    const TumbleReference reference = kind.level.empty() ? thrown : tumble_reference(scene, fast, lowered_and_turned);
    const bool known = passed(reference.worst().verdict);
    const Tumble run = known ? tumble(settings, default_choice(), as_the_scene_says, reference, 240e6) : reference.worst();
    Row row = row_of("levels", kind.name, default_choice(), "");
    row.value = setting;
    row.verdict = run.verdict;
    row.text = run.message;
    rows.add(row);
  }
}
}  // namespace

void add_level_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Axis& axis : kAxes)
    for (double value : axis.values)
    {
      if (fast && value != 5e7) continue;
      jobs.push_back(
          {text("levels/%s/%g", axis.key, value), [&axis, value, fast](Rows& rows) { run_level(axis, value, fast, rows); }});
    }
}

}  // namespace drill_rig_sim
