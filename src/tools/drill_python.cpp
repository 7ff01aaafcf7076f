// SPDX-License-Identifier: BSD-3-Clause
#include "drill_python.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "drill_command.h"

namespace drill_rig_sim
{
namespace fs = std::filesystem;

fs::path runner_folder()
{
  std::error_code unreadable;
  return fs::read_symlink("/proc/self/exe", unreadable).parent_path();
}

namespace
{

/// The folder of Python's packages that belongs to this program: both lie in the devel space, or in one install space.
/// Throws UsageError where its drill_rig_sim has no such module.
std::string python_folder(const std::string& module)
{
  std::error_code unreadable;
  const fs::path folder = runner_folder() / DRILL_RIG_SIM_PYTHON_FOLDER;
  const fs::path file = folder / "drill_rig_sim" / (module + ".py");
  if (!fs::exists(file, unreadable))
    throw UsageError(file.lexically_normal().string() + " is missing; build or install the complete package");
  return folder.lexically_normal().string();
}
}  // namespace

void become_python(const std::string& module, const std::vector<std::string>& words)
{
  const char* before = std::getenv("PYTHONPATH");
  const std::string path = python_folder(module) + (before == nullptr || *before == '\0' ? "" : std::string(":") + before);
  setenv("PYTHONPATH", path.c_str(), 1);
  setenv("PYTHONDONTWRITEBYTECODE", "1", 0);
  std::vector<std::string> line = {"python3", "-m", "drill_rig_sim." + module};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  arguments.reserve(line.size() + 1);
  for (std::string& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(DRILL_RIG_SIM_PYTHON, arguments.data());
  throw UsageError(std::string(DRILL_RIG_SIM_PYTHON) + " cannot be started: " + std::strerror(errno));
}

void become_python(const std::string& module, std::vector<std::string> words,
                   std::initializer_list<std::pair<const char*, std::string>> options, const std::vector<std::string>& files)
{
  for (const auto& [name, value] : options) add_word(words, name, value);
  words.emplace_back("--");  // a file's name may begin with a dash
  words.insert(words.end(), files.begin(), files.end());
  become_python(module, words);
}

int run_python(const std::string& module, const std::vector<std::string>& words)
{
  std::fflush(nullptr);  // what was printed comes first, and once
  const pid_t child = fork();
  if (child < 0) throw UsageError(std::string(DRILL_RIG_SIM_PYTHON) + " cannot be started: " + std::strerror(errno));
  if (child == 0)
  {
    try
    {
      become_python(module, words);
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "drill: %s\n", error.what());
    }
    std::fflush(stderr);
    _exit(2);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return 3;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
}

void add_word(std::vector<std::string>& words, const char* name, const std::string& value)
{
  if (!value.empty()) words.push_back(std::string(name) + "=" + value);
}

}  // namespace drill_rig_sim
