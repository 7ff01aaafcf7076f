// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_PYTHON_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_PYTHON_H

#include <initializer_list>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace drill_rig_sim
{
/// The folder of this program; empty where the system does not say it.
std::filesystem::path runner_folder();

/// Becomes Python, which runs a module of drill_rig_sim with these words and whose exit status is the runner's. Throws UsageError
/// where package or Python is missing.
[[noreturn]] void become_python(const std::string& module, const std::vector<std::string>& words);

/// The same with these words, options by name where they were given (add_word) and files.
[[noreturn]] void become_python(const std::string& module, std::vector<std::string> words,
                                std::initializer_list<std::pair<const char*, std::string>> options,
                                const std::vector<std::string>& files);

/// Python in a process of its own: waits for its end. Its exit status.
int run_python(const std::string& module, const std::vector<std::string>& words);

/// Adds an option that was given, as --name=value, for a value may begin with a dash. An empty one was not.
void add_word(std::vector<std::string>& words, const char* name, const std::string& value);

}  // namespace drill_rig_sim

#endif
