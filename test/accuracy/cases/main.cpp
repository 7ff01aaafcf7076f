// SPDX-License-Identifier: BSD-3-Clause
// The program behind ./test/accuracy/run: runs groups of cases, all of them unless some are named.
//   --fast         the short ones that need no data but their own
//   --fast-data    the short ones that need ../shared/data
// Exit status: 0 all hold, 1 one does not, 2 wrong usage, 3 a group broke off, 77 all that were run hold, others were skipped.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "report.h"

using namespace drill_rig_sim;

namespace
{
int usage()
{
  std::fprintf(stderr, "usage: accuracy_cases [--list | --fast | --fast-data | GROUP...]\n");
  return 2;
}

constexpr int kSkipped = 77;

bool wanted(const CaseGroup& group, const std::vector<std::string>& words)
{
  if (words.empty()) return true;
  if (words.front() == "--fast") return group.when == When::fast;
  if (words.front() == "--fast-data") return group.when == When::fast_with_data;
  return std::find(words.begin(), words.end(), group.name) != words.end();
}

bool known(const std::string& name)
{
  for (const CaseGroup& group : case_groups())
    if (name == group.name) return true;
  return false;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words.front() == "--list")
  {
    for (const CaseGroup& group : case_groups()) std::printf("%s\n", group.name);
    return 0;
  }
  const bool option = words.size() == 1 && (words.front() == "--fast" || words.front() == "--fast-data");
  if (!option && !std::all_of(words.begin(), words.end(), known)) return usage();
  Report report;
  std::printf("case, ours, published, relative difference, bound, source\n");
  for (const CaseGroup& group : case_groups())
  {
    if (!wanted(group, words)) continue;
    try
    {
      group.run(report);
    }
    catch (const std::exception& problem)
    {
      std::printf("%s: %s\n", group.name, problem.what());
      return 3;
    }
  }
  std::printf("%d lines, %d beyond their bounds, %d skipped\n", report.lines(), report.failed(), report.skipped());
  return !report.all_hold() ? 1 : report.skipped() > 0 ? kSkipped : 0;
}
