// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_OPTIONS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_OPTIONS_H

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

/// The kinds of options that the subcommands have, on top of CLI11: names in full (no abbreviations), `--name VALUE` or
/// `--name=VALUE`; where an option is given twice, the last counts.
namespace drill_rig_sim
{
/// The one file that a command reads.
CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& value, const std::string& meaning);

/// A text that is not empty. One that starts with two dashes is refused: it is the next option, and a value was forgotten.
CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& value, const std::string& placeholder,
                      const std::string& meaning);

/// A number from `low` to `high`.
CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value, double low, double high,
                        const std::string& placeholder, const std::string& meaning);

/// `--set KEY=VALUE`, as often as wanted.
CLI::Option* add_settings(CLI::App& command, std::vector<std::string>& settings);

/// What the parser complains of, in one line: command, option, what is wrong, what is allowed.
std::string problem_of(const CLI::App& drill, const CLI::ParseError& error);

}  // namespace drill_rig_sim

#endif
