// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_RECORD_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_RECORD_H

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What the commands that read a rig's record have in common: its files and the part of it that counts.
namespace drill_rig_sim
{
struct RecordOptions
{
  std::string record, columns, from, to;
  std::vector<std::string> more, left_out;
};

/// The positional RECORD.
void add_record(CLI::App& command, RecordOptions& options);

/// Which files and columns, and which part.
void add_record_options(CLI::App& command, RecordOptions& options);

/// Of all but RECORD, for a program in Python.
std::vector<std::string> words_of(const RecordOptions& options);

}  // namespace drill_rig_sim

#endif
