// SPDX-License-Identifier: BSD-3-Clause
// Gives the files and folders on the command line to a fuzz target, one after the other, without libFuzzer: what was found once
// stays tested with every compiler. Each input may take 10 s of processor time and 1 GB; with sanitizers ten times as long.
#include <dirent.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "counters.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{
#ifdef __SANITIZE_ADDRESS__
constexpr int longest = 100;  // [s]
#else
constexpr int longest = 10;  // [s]
#endif
constexpr rlim_t most_memory = 1u << 30;  // [bytes]

/// A file itself, or the files in a folder.
std::vector<std::string> files_of(const std::string& place)
{
  DIR* folder = opendir(place.c_str());
  if (!folder) return {place};
  std::vector<std::string> files;
  while (const dirent* entry = readdir(folder))
  {
    if (entry->d_name[0] != '.') files.push_back(place + "/" + entry->d_name);
  }
  closedir(folder);
  std::sort(files.begin(), files.end());
  return files;
}

/// The default action of the timer's signal ends the program.
void limit_time()
{
  itimerval timer{};
  timer.it_value.tv_sec = longest;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

/// A sanitizer maps far more than it uses.
void limit_memory()
{
#ifndef __SANITIZE_ADDRESS__
  const rlimit limit{most_memory, most_memory};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

/// False if it cannot be read.
bool replay(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) return false;
  std::fprintf(stderr, "%s\n", file.c_str());  // the last one named is the one that ended the program
  limit_time();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  return true;
}
}  // namespace

int main(int argc, char** argv)
{
  limit_memory();
  for (int i = 1; i < argc; ++i)
  {
    for (const std::string& file : files_of(argv[i]))
    {
      if (replay(file)) continue;
      std::fprintf(stderr, "%s: cannot be read, needed: files or folders of inputs\n", file.c_str());
      return 2;
    }
  }
  const drill_rig_sim::fuzz::Counters& c = drill_rig_sim::fuzz::counters();
  std::printf("%llu inputs: %llu refused, %llu not buildable, %llu too large, %llu accepted of which %llu failed\n",
              static_cast<unsigned long long>(c.inputs), static_cast<unsigned long long>(c.refused),
              static_cast<unsigned long long>(c.unbuildable), static_cast<unsigned long long>(c.too_large),
              static_cast<unsigned long long>(c.accepted), static_cast<unsigned long long>(c.failed));
  return c.inputs > 0 ? 0 : 2;
}
