// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/App.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "drill_command.h"
#include "drill_findings.h"
#include "drill_options.h"
#include "drill_output.h"
#include "drill_progress.h"
#include "drill_recorded.h"
#include "drill_rig_sim/sim/finer_pair.h"
#include "drill_rig_sim/sim/run.h"
#include "drill_run_options.h"
#include "drill_scene.h"
#include "drill_units.h"
#include "drill_verified_scores.h"

namespace drill_rig_sim
{
namespace
{
struct VerifyOptions
{
  RunOptions run;
  std::optional<double> times;
  std::string scene, name_space;  // of a bag
  bool score = false;
  ScoreOptions judged_by;
  std::string units = "si";
};

/// What goes along with a run, frame by frame.
struct Beside
{
  Beside(Simulator& simulator, const VerifyOptions& options) : pair(simulator, options.times.value_or(usual_refinement))
  {
    if (options.score) scores.emplace();
  }

  void add(const Simulator& simulator, double frame, double duration)
  {
    pair.add(simulator, frame);
    if (scores) scores->add(simulator, pair, frame);
    progress.show(simulator.truth().time / duration, simulator.truth().time, simulator.truth().hole_depth);
  }

  FinerPair pair;
  std::optional<VerifiedScores> scores;
  Progress progress;
};

/// Of a scene by its program, or of a bag; nothing else is asked of either.
struct Played
{
  Scene scene;
  std::optional<RecordedRun> recorded;
};

RecordedRun open_bag(const VerifyOptions& options)
{
  try
  {
    return read_recorded_run(options.run.scene, options.name_space);
  }
  catch (const std::runtime_error& error)
  {
    throw UsageError(error.what());
  }
}

/// The scene that a bag was recorded of: --scene, or what the bag holds.
Scene scene_of(const RecordedRun& recorded, const VerifyOptions& options)
{
  if (!options.scene.empty()) return open_scene(options.scene, settings_of(options.run));
  if (recorded.scene.empty()) throw UsageError(options.run.scene + ": holds no scene (topic scene), needed: --scene FILE");
  Scene scene = parse_scene(recorded.scene, "scene of " + options.run.scene, settings_of(options.run));
  print_remarks(scene.remarks);
  return scene;
}

Played open_played(const VerifyOptions& options)
{
  if (!is_bag(options.run.scene))
  {
    if (!options.scene.empty() || !options.name_space.empty())
      throw UsageError("--scene, --namespace: allowed only with a bag (.bag)");
    return {open_scene(options.run.scene, settings_of(options.run)), std::nullopt};
  }
  if (options.run.until_depth) throw UsageError("--until-depth: not allowed with a bag, allowed: --duration");
  RecordedRun recorded = open_bag(options);
  Scene scene = scene_of(recorded, options);
  return {std::move(scene), std::move(recorded)};
}

RunEnd play_scene(Simulator& simulator, const RunGoal& goal, Beside& beside)
{
  ScenePlayer player(simulator.scene());
  const double frame = frame_of_whole_steps(frame_length, simulator.scene().numerics.step);
  return run(simulator, player, goal, frame_length, [&](const Truth&) { beside.add(simulator, frame, goal.duration); });
}

RunEnd play_bag(Simulator& simulator, const VerifyOptions& options, const RecordedRun& recorded, Beside& beside)
{
  RecordedPlayer player(options.run.scene, recorded, simulator.scene());
  const double duration = std::min(options.run.duration.value_or(player.duration()), player.duration());
  return player.play(simulator, duration, [&](const Truth&) { beside.add(simulator, player.frame(), duration); });
}

/// Without --score none of its options has a meaning.
void require_score(const VerifyOptions& options)
{
  if (!words_of(options.judged_by).empty() && !options.score)
    throw UsageError("--plan, --bit-diameter, --wob, --toolface: need --score");
}

void print(const Simulator& simulator, const VerifyOptions& options, const FinerPair& pair)
{
  std::printf("%s: %.1f s compared with two finer models (beam3d, elements and steps %g and %g times shorter)\n",
              simulator.scene().name.c_str(), simulator.truth().time, pair.times(), pair.times() * pair.times());
  print_findings(pair.findings(), Printed(options.units));
  print_verdict(pair.findings(), simulator.scene().numerics.tolerance, simulator.statistics().not_measured);
}

void verify(const VerifyOptions& options)
{
  require_score(options);
  const Played played = open_played(options);
  const RunGoal goal = goal_of(options.run, played.scene);
  File json = open_output("--json", options.run.json);
  Simulator simulator = build_simulator(played.scene, options.run.seed);
  Beside beside(simulator, options);
  const RunEnd end =
      played.recorded ? play_bag(simulator, options, *played.recorded, beside) : play_scene(simulator, goal, beside);
  if (end == RunEnd::failure)
    throw ComputationError(options.run.scene + ": after " + std::to_string(simulator.truth().time) +
                           " s: " + simulator.failure());
  print(simulator, options, beside.pair);
  nlohmann::ordered_json found = json_of(simulator, beside.pair);
  if (beside.scores) found["scores"] = nlohmann::ordered_json::parse(beside.scores->compare(options.judged_by, options.units));
  if (json) std::fputs((found.dump(2) + "\n").c_str(), json.get());
  close_output(std::move(json), options.run.json);
  if (beside.pair.findings().verdict() == Verification::Verdict::missed) throw ToleranceExceeded();
}
}  // namespace

Command add_verify_command(CLI::App& drill)
{
  CLI::App* words = drill.add_subcommand(
      "verify",
      "compares a scene's run, or a bag's, with two finer models and reports its error; exit status 1: wrong without a warning");
  const auto options = std::make_shared<VerifyOptions>();
  add_goal_options(*words, options->run,
                   "the scene's file; or a bag (.bag) of drill run, or recorded of a node from its start on");
  add_settings(*words, options->run.settings);
  add_seed(*words, options->run);
  add_number(*words, "--times", options->times, least_refinement, most_refinement, "N",
             "refinement of elements and steps of the finer model, squared for the finest; default 2");
  add_text(*words, "--scene", options->scene, "FILE", "the scene of a bag that does not contain it");
  add_text(*words, "--namespace", options->name_space, "NS", "namespace of the rig, where a bag has several");
  words->add_flag("--score", options->score, "compares the scores of drill score for the three runs, by its options:")
      ->disable_flag_override();
  add_score_options(*words, options->judged_by);
  add_text(*words, "--json", options->run.json, "FILE", "writes the findings");
  add_units(*words, options->units);
  return {words, [options] { verify(*options); }};
}

}  // namespace drill_rig_sim
