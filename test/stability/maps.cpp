// SPDX-License-Identifier: BSD-3-Clause
// The largest stable step of each method, and of each element, along five axes; and the default at the shortest steps promised.
#include <cstdio>

#include "jobs.h"
#include "tumble.h"

namespace drill_rig_sim
{
namespace
{
struct Axis
{
  const char* name;
  const char* key;  ///< of the scene
  std::vector<double> values;
  double promised_low, promised_high;
  bool with_elements;
};

const std::vector<Axis>& axes()
{
  static const std::vector<Axis> table = {
      {"contact_stiffness", "contact.stiffness", {1e5, 1e6, 1e7, 5e7, 1e8, 1e9, 1e10}, 1e5, 1e10, true},
      {"bristle_stiffness", "contact.tangential_stiffness", {1e4, 1e5, 1e6, 5e6, 1e7, 1e8, 1e9}, 1e5, 1e9, false},
      {"stribeck_speed", "contact.stribeck_speed", {1e-3, 1e-2, 5e-2, 0.2, 1.0}, 1e-3, 1.0, false},
      {"element_length", "numerics.element_length", {0.5, 1.0, 2.0, 4.75, 9.5, 19.0}, 0.5, 19.0, true},
      {"lateral_damping", "mud.lateral_damping", {0.0, 2.0, 20.0, 200.0, 2e3, 2e4}, 0.0, 2e4, false},
  };
  return table;
}

/// README.md beside this promises this step and shorter ones, down to the last of kShortSteps.
constexpr double kPromisedStep = 0.01;
/// Down to here the map goes on where the default's passing is promised: a shorter step may fail where longer ones pass.
constexpr double kMappedTo = 1e-3;
/// What the map, which goes down from the longest, does not reach.
constexpr double kShortSteps[] = {1e-4, 1e-5};

bool is_promised(const Axis& axis, double value)
{
  return value >= axis.promised_low && value <= axis.promised_high;
}

std::vector<std::string> settings_for(const Axis& axis, double value)
{
  std::vector<std::string> settings{text("%s=%g", axis.key, value)};
  // an element is no longer than a joint
  if (std::string(axis.name) == "element_length" && value > 9.5) settings.push_back(text("string[1].joint_length=%g", value));
  return settings;
}

/// From the longest step down: the first that passes and whose next shorter one passes too, and of those tried below it none
/// fails.
Row map_point(const Axis& axis, double value, const Choice& choice, const TumbleReference& reference)
{
  Row row;
  row.group = "map";
  row.name = axis.name;
  row.value = text("%g", value);
  row.method = choice.method;
  row.element = choice.element;
  row.unit = "s";
  const bool promised = is_default(choice) && is_promised(axis, value);
  if (promised) row.promise = Promise::passes;
  const std::vector<std::string> settings = settings_for(axis, value);
  double by_halving = 0.0, plain = 0.0, last_any = 0.0, last_plain = 0.0;
  std::string above;
  Verdict failure = Verdict::fails_wrong;
  for (double step : step_ladder())
  {
    if (plain > 0.0 && (!promised || step < kMappedTo)) break;
    const Tumble run = tumble(settings, choice, step, reference, is_default(choice) ? 200e6 : 64e6);
    if (run.verdict == Verdict::too_slow)
    {
      if (above.empty()) failure = run.verdict;
      above += text("%s%g s too slow", above.empty() ? "" : "; at ", step);
      if (choice.method != reference_method && !promised) break;  // shorter steps are slower still; the reference chooses its own
      by_halving = plain = last_any = last_plain = 0.0;
      continue;
    }
    if (!passed(run.verdict))
    {
      failure = run.verdict;
      by_halving = plain = 0.0;  // nothing above a failure counts
      above = text("%g s %s (%s)", step, words(run.verdict), run.message.c_str());
    }
    if (passed(run.verdict) && last_any > 0.0 && by_halving == 0.0) by_halving = last_any;
    last_any = passed(run.verdict) ? step : 0.0;
    if (run.verdict == Verdict::passes && last_plain > 0.0 && plain == 0.0) plain = last_plain;
    last_plain = run.verdict == Verdict::passes ? step : 0.0;
  }
  row.figure = plain > 0.0 ? plain : last_plain;
  if (by_halving == 0.0) by_halving = last_any;
  const double wanted = promised ? kPromisedStep : step_ladder().back();
  row.verdict = row.figure >= wanted ? Verdict::passes : by_halving >= wanted ? Verdict::passes_by_halving : failure;
  row.text = (by_halving > row.figure ? text("by halving %g s; ", by_halving) : "") +
             (above.empty() ? "passes at every step tried" : "at " + above);
  return row;
}

/// Without a reference nothing can be judged: that a reference cannot be had breaks the promise, whatever was promised of the
/// rest.
Row failed_reference(const char* group, const Axis& axis, double value, const Tumble& run)
{
  Row row;
  row.group = group;
  row.name = axis.name;
  row.value = text("%g", value);
  row.method = "reference";
  row.unit = "s";
  row.promise = Promise::passes;
  row.verdict = run.verdict;
  row.text = run.message;
  return row;
}

void run_point(const Axis& axis, double value, bool fast, Rows& rows)
{
  const TumbleReference reference = tumble_reference(settings_for(axis, value), fast);
  if (!passed(reference.worst().verdict)) return rows.add(failed_reference("map", axis, value, reference.worst()));
  std::vector<Choice> choices = methods(fast);
  if (!fast && axis.with_elements)
    for (const Choice& choice : all_elements())
      if (!is_default(choice)) choices.push_back(choice);
  for (const Choice& choice : choices) rows.add(map_point(axis, value, choice, reference));
}

/// The default's shortest steps, over a time that they can afford.
void run_short_steps(const Axis& axis, double value, bool fast, Rows& rows)
{
  const std::vector<std::string> settings = settings_for(axis, value);
  const TumbleReference reference = tumble_reference(settings, fast, first_bounces);
  if (!passed(reference.worst().verdict)) return rows.add(failed_reference("short steps", axis, value, reference.worst()));
  Row row = row_of("short steps", axis.name, default_choice(), "s");
  row.value = text("%g", value);
  for (double step : kShortSteps)
  {
    const Tumble run = tumble(settings, default_choice(), step, reference, 240e6);
    row.verdict = run.verdict;
    row.text = run.message;
    if (!passed(run.verdict)) break;
    row.figure = step;
  }
  rows.add(row);
}
}  // namespace

void add_map_jobs(bool fast, std::vector<Job>& jobs)
{
  for (const Axis& axis : axes())
    for (double value : axis.values)
    {
      const bool end = value == axis.promised_low || value == axis.promised_high;
      if (fast && !end) continue;
      jobs.push_back(
          {text("map/%s/%g", axis.name, value), [&axis, value, fast](Rows& rows) { run_point(axis, value, fast, rows); }});
      const bool dear = axis.key == std::string("numerics.element_length") && value < 2.0;
      if (is_promised(axis, value) && !(fast && dear))
        jobs.push_back({text("short_steps/%s/%g", axis.name, value),
                        [&axis, value, fast](Rows& rows) { run_short_steps(axis, value, fast, rows); }});
    }
}

}  // namespace drill_rig_sim
