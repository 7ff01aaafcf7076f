// SPDX-License-Identifier: BSD-3-Clause
#include "drill_run_options.h"

#include <cstdio>
#include <utility>

#include "drill_command.h"
#include "drill_date.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double longest_run = 30.0 * 86400.0;  // simulated [s]
constexpr double after_program = 60.0;          // simulated [s] that a run goes on after the program's end by default
constexpr double after_operations = 0.0;        // and after its operations
constexpr double patience = 600.0;              // simulated [s] that a run until a depth waits for new hole after the program
constexpr double deepest = 20000.0;             // measured depth [m]
constexpr double largest_seed = 9e15;           // a double holds every whole number up to it

std::string problem_of_level(const std::string& level)
{
  for (const char* known : {"rigid", "axial_torsional", "hybrid", "beam3d", "auto"})
    if (level == known) return "";
  return "'" + level + "' is unknown, allowed: rigid, axial_torsional, hybrid, beam3d or auto";
}

std::string problem_of_seed(const std::string& seed)
{
  std::uint64_t number = 0;
  const bool digits = !seed.empty() && seed.find_first_not_of("0123456789") == std::string::npos;
  if (digits && CLI::detail::lexical_cast(seed, number) && static_cast<double>(number) <= largest_seed) return "";
  return "'" + seed + "' is not allowed, needed: a whole number from 0 to 9e15";
}

std::string problem_of_date(const std::string& date)
{
  if (start_date_of(date)) return "";
  return "'" + date + "' is not allowed, needed: a UTC date from 1970 to 2199, such as 2024-05-17 or 2024-05-17T06:30:00Z";
}

void add_scene_options(CLI::App& command, RunOptions& options)
{
  add_text(command, "--level", options.level, "L", "level of the model instead of the scene's")->check(problem_of_level);
  add_text(command, "--integrator", options.integrator, "I", "stepper instead of the scene's");
  add_text(command, "--step", options.step, "H", "physics step instead of the scene's [s]");
  add_text(command, "--element-length", options.element_length, "M", "longest element instead of the scene's [m]");
  add_settings(command, options.settings);
  add_seed(command, options);
}

void add_output_options(CLI::App& command, RunOptions& options)
{
  add_text(command, "--csv", options.csv, "FILE", "writes time series");
  add_text(command, "--bag", options.bag, "FILE", "writes the topics that the node publishes of measurements");
  add_text(command, "--witsml", options.witsml, "FILE",
           "writes the instruments' readings as a log of WITSML 1.4.1.1, by default a row each second");
  add_text(command, "--start-date", options.start_date, "DATE",
           "date of simulated time 0 in --witsml, UTC; default 2000-01-01T00:00:00Z")
      ->check(problem_of_date);
  add_number(command, "--every", options.every, 1e-4, 1e6, "S",
             "time between rows of the time series or the bag's measurements; whole frames, default 0.1");
  add_text(command, "--profile", options.profile, "FILE", "writes forces along the string during the run");
  add_number(command, "--profile-every", options.profile_every, 1e-4, 1e6, "S", "time between these, whole frames, default 1");
  add_text(command, "--json", options.json, "FILE", "writes a summary");
  command.add_flag("--readings", options.readings, "adds the instruments' readings to time series and summary")
      ->disable_flag_override();
  command.add_flag("--errors", options.errors, "adds measured errors and the companion's truth to --csv, the latter to --bag")
      ->disable_flag_override();
  command.add_flag("--energy", options.energy, "keeps an energy balance; the summary shows it [J]")->disable_flag_override();
  add_units(command, options.units);
  add_text(command, "--explain", options.explain, "FILE", "writes which model was used and why, a row for each change");
  add_text(command, "--path", options.path, "FILE", "writes the well's corrected path");
  add_text(command, "--raw-path", options.raw_path, "FILE", "writes the uncorrected path of the last metres");
}
}  // namespace

void add_seed(CLI::App& command, RunOptions& options)
{
  command.add_option("--seed", options.seed, "seed of the sensors' noise")->type_name("N")->take_last()->check(problem_of_seed);
}

void add_goal_options(CLI::App& command, RunOptions& options, const std::string& scene)
{
  add_file(command, "SCENE", options.scene, scene);
  add_number(command, "--duration", options.duration, 1e-3, longest_run, "S",
             "simulated seconds; default: until depth, until the operations are over, or 60 s after the program's end");
  add_number(command, "--until-depth", options.until_depth, 0.0, deepest, "MD",
             "stop when the hole is this deep [m], or has not grown for 600 s after the program or in an operation");
}

void add_options(CLI::App& command, RunOptions& options)
{
  add_goal_options(command, options);
  add_scene_options(command, options);
  add_output_options(command, options);
}

std::vector<std::string> settings_of(const RunOptions& options)
{
  std::vector<std::string> settings = options.settings;
  const std::pair<const char*, const std::string&> keys[] = {{"level", options.level},
                                                             {"integrator", options.integrator},
                                                             {"step", options.step},
                                                             {"element_length", options.element_length}};
  for (const auto& key : keys)
  {
    if (!key.second.empty()) settings.push_back(std::string("numerics.") + key.first + "=" + key.second);
  }
  return settings;
}

void require_companion(const RunOptions& options, const Simulator& simulator)
{
  if (!options.errors) return;
  if (options.csv.empty() && options.bag.empty()) throw UsageError("--errors: needs --csv or --bag");
  if (simulator.companions() == 0)
    throw UsageError("--errors: the run has no companion, needed: one, as by --set numerics.companion=finer");
}

void require_files_apart(const RunOptions& options)
{
  const std::pair<const char*, const std::string&> files[] = {
      {"--csv", options.csv},   {"--bag", options.bag},         {"--witsml", options.witsml}, {"--profile", options.profile},
      {"--json", options.json}, {"--explain", options.explain}, {"--path", options.path},     {"--raw-path", options.raw_path}};
  for (const auto& one : files)
  {
    if (is_same_file(one.second, options.scene))
      throw UsageError(std::string(one.first) + ": " + one.second + " is the scene file, needed: another file");
    for (const auto& other : files)
    {
      if (&other < &one && is_same_file(one.second, other.second))
        throw UsageError(std::string(one.first) + ": " + one.second + " is the file of " + other.first +
                         ", needed: another file");
    }
  }
}

RunGoal goal_of(const RunOptions& options, const Scene& scene)
{
  RunGoal goal;
  const bool open = options.until_depth || !scene.operations.empty();
  goal.duration = options.duration.value_or(open ? longest_run : program_end(scene.program) + after_program);
  if (!scene.operations.empty() && !options.duration) goal.patience = patience;
  if (!scene.operations.empty() && !options.duration && !options.until_depth) goal.goes_on = after_operations;
  if (!options.until_depth) return goal;
  goal.depth = *options.until_depth;
  goal.patience = patience;
  if (goal.depth < scene.well.hole_depth)
  {
    char problem[128];
    std::snprintf(problem, sizeof problem,
                  "--until-depth: '%g' is not allowed, needed: a number from the hole's depth, %g, to %g", goal.depth,
                  scene.well.hole_depth, deepest);
    throw UsageError(problem);
  }
  return goal;
}

}  // namespace drill_rig_sim
