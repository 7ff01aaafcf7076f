// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_RUN_OPTIONS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_RUN_OPTIONS_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/sim/run.h"

namespace CLI
{
class App;
}

namespace drill_rig_sim
{
/// Of a run's frames, rounded to whole steps: as the node's default, simulated [s].
constexpr double frame_length = 0.01;

/// The options of `drill run`. Names of files are empty where nothing is to be written.
struct RunOptions
{
  std::string scene;
  std::vector<std::string> settings;
  std::string level, integrator, step, element_length;  ///< keys of the scene under another name; empty: the scene's
  std::optional<double> duration;                       ///< [s]
  std::optional<double> until_depth;                    ///< measured depth [m]
  std::optional<double> every;                          ///< between rows of the time series, and measurements of the bag [s]
  std::optional<double> profile_every;                  ///< between profiles along the string [s]
  std::uint64_t seed = 0;
  std::string start_date;    ///< of simulated time 0; empty: default_start_date
  std::string units = "si";  ///< of the summary that is printed
  std::string csv, bag, witsml, profile, json, explain, path, raw_path;
  bool readings = false;  ///< series and summary hold the instruments' readings beside the truth
  bool errors = false;    ///< time series and bag hold the companion's truth, the series measured errors too
  bool energy = false;
};

/// Adds the scene and where its run ends to the command. They are read when the command line is. `scene`: what is said of the
/// file.
void add_goal_options(CLI::App& command, RunOptions& options, const std::string& scene = "the scene's file");

/// Adds the seed of the sensors' noise.
void add_seed(CLI::App& command, RunOptions& options);

/// Adds all of them.
void add_options(CLI::App& command, RunOptions& options);

/// Settings of the scene as read_scene() takes them: those of --set, then the options that are keys under another name.
std::vector<std::string> settings_of(const RunOptions& options);

/// Throws UsageError with one line if --errors has no file to go into, or the run no companion.
void require_companion(const RunOptions& options, const Simulator& simulator);

/// Throws UsageError with one line if two of the files to be written are one.
void require_files_apart(const RunOptions& options);

/// Where the run ends. Throws UsageError with one line if the scene's hole is deeper than --until-depth already.
RunGoal goal_of(const RunOptions& options, const Scene& scene);

}  // namespace drill_rig_sim

#endif
