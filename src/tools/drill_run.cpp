// SPDX-License-Identifier: BSD-3-Clause
#include <time.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "drill_command.h"
#include "drill_failure.h"
#include "drill_output.h"
#include "drill_progress.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_run_options.h"
#include "drill_program.h"
#include "drill_scene.h"
#include "drill_series.h"
#include "drill_summary.h"
#include "drill_witsml.h"

namespace drill_rig_sim
{
namespace
{
double cpu_time()
{
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void require_whole_frames(const char* option, const std::optional<double>& every, double frame)
{
  if (!every || std::abs(std::remainder(*every, frame)) < 1e-6 * frame) return;
  char text[128];
  std::snprintf(text, sizeof text, "%s: %g s is given, allowed: whole frames of %g s", option, *every, frame);
  throw UsageError(text);
}

/// What share of the run is over, by whatever it is nearest by.
double done(const Truth& m, double start_depth, const RunGoal& goal, const OperationStatus& operation)
{
  const double drilled = (m.hole_depth - start_depth) / (goal.depth - start_depth);
  const double operations = operation.number > 0 ? (operation.number - 1 + operation.progress) / operation.count : 0.0;
  return std::max({m.time / goal.duration, drilled, operations});
}

/// What is written during a run. All files are opened ahead, so that a long run does not end on a misspelt folder.
struct Series
{
  Series(const RunOptions& o, const Scene& scene)
      : rows(o.csv, o.every.value_or(0.1), o.readings, o.errors),
        bag(o.bag, o.every.value_or(0.1), scene, o.errors),
        log(o.witsml, scene.name, o.every.value_or(1.0), start_date_of(o.start_date).value_or(default_start_date)),
        profiles(o.profile, o.profile_every.value_or(1.0)),
        choices(o.explain)
  {
  }

  void add(const Simulator& simulator, double frame)
  {
    rows.add(simulator, frame);
    bag.add(simulator, frame);
    log.add(simulator, frame);
    profiles.add(simulator, frame);
    choices.add(simulator);
  }

  void close()
  {
    rows.close();
    bag.close();
    log.close();
    profiles.close();
    choices.close();
  }

  TimeSeries rows;
  BagSeries bag;
  WitsmlSeries log;
  ProfileSeries profiles;
  ChoiceSeries choices;
};

/// Plays the scene's program and operations up to the goal, with its series, its averages and a progress bar.
RunEnd play(Simulator& simulator, const RunGoal& goal, Series& series, RunRecord& record)
{
  const double frame = frame_of_whole_steps(frame_length, simulator.scene().numerics.step);
  const double start_depth = simulator.truth().hole_depth;
  ScenePlayer player(simulator.scene());
  Progress progress;
  series.add(simulator, frame);
  const RunEnd end = run(simulator, player, goal, frame_length,
                         [&](const Truth& m)
                         {
                           record.drilling.add(m);
                           record.latest.add(m);
                           record.doubts.add(m.time, simulator.statistics().accuracy);
                           record.errors.add(simulator);
                           record.limits.add(m, simulator.statistics().loads, simulator.scene().rig.hoisting.max_hook_load);
                           record.feed.add(simulator.scene().operations, player.operations().status(), m, simulator.readings());
                           series.add(simulator, frame);
                           progress.show(done(m, start_depth, goal, player.operations().status()), m.time, m.hole_depth);
                         });
  record.operations_began = player.operations().began();
  record.operation = player.operations().status();
  return end;
}

void run_scene(const RunOptions& options)
{
  const Scene scene = open_scene(options.scene, settings_of(options));
  const RunGoal goal = goal_of(options, scene);
  require_files_apart(options);
  const double frame = frame_of_whole_steps(frame_length, scene.numerics.step);
  require_whole_frames("--every", options.every, frame);
  require_whole_frames("--profile-every", options.profile_every, frame);
  require_program(scene, goal.duration);

  Simulator simulator = build_simulator(scene, options.seed);
  require_companion(options, simulator);
  Series series(options, scene);
  File json = open_output("--json", options.json), path = open_output("--path", options.path);
  File raw_path = open_output("--raw-path", options.raw_path);

  if (options.energy) simulator.balance_energy();
  RunRecord record;
  const auto wall_start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_time();
  const RunEnd end = play(simulator, goal, series, record);
  const Elapsed elapsed{std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count(),
                        cpu_time() - cpu_start};
  const std::string summary = json_summary(simulator, elapsed, record, options.readings);

  if (json) std::fputs(summary.c_str(), json.get());
  if (path) write_path(path.get(), simulator);
  if (raw_path) write_raw_path(raw_path.get(), simulator);
  series.close();
  close_output(std::move(json), options.json);
  close_output(std::move(path), options.path);
  close_output(std::move(raw_path), options.raw_path);
  if (end == RunEnd::failure) report_failure(simulator, summary, options.json);
  print_summary(simulator, elapsed, record, Printed(options.units));
  if (end == RunEnd::duration && std::isfinite(goal.depth))
    std::printf("the depth of --until-depth was not reached within --duration\n");
  if (end == RunEnd::trouble) report_trouble(simulator, record.operation);
  if (end == RunEnd::standstill) report_standstill(simulator, goal, record.operations_began);
}
}  // namespace

Command add_run_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand("run", "runs a scene's program as fast as possible");
  const auto options = std::make_shared<RunOptions>();
  add_options(*words, *options);
  return {words, [options] { run_scene(*options); }};
}

}  // namespace drill_rig_sim
