// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_COMMAND_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_COMMAND_H

#include <exception>
#include <functional>
#include <stdexcept>

namespace CLI
{
class App;
}

/// The runner's subcommands.
namespace drill_rig_sim
{
/// What the caller asked for cannot be done; the runner prints its one line and exits with status 2.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The equations could not be solved; the runner prints its one line and exits with status 3.
class ComputationError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A run passed its tolerance without a warning, as was printed; the runner exits with status 1.
class ToleranceExceeded : public std::exception
{
};

/// A subcommand of the parser, and what it does once the command line is read. Throws SceneError, UsageError or ComputationError.
struct Command
{
  CLI::App* words;
  std::function<void()> run;
};

/// Each adds its words, options and help to the parser.
Command add_run_command(CLI::App& drill);
Command add_check_command(CLI::App& drill);
Command add_static_command(CLI::App& drill);
Command add_modes_command(CLI::App& drill);
Command add_survey_command(CLI::App& drill);
Command add_score_command(CLI::App& drill);
Command add_plot_command(CLI::App& drill);
Command add_replay_command(CLI::App& drill);
Command add_weights_command(CLI::App& drill);
Command add_calibrate_command(CLI::App& drill);
Command add_verify_command(CLI::App& drill);
Command add_reference_command(CLI::App& drill);
Command add_web_command(CLI::App& drill);
Command add_fmu_command(CLI::App& drill);
Command add_live_command(CLI::App& drill);

}  // namespace drill_rig_sim

#endif
