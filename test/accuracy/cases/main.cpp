// The program behind ./test/accuracy/run: runs groups of cases, all of them unless some are named.
#include <cstdio>
#include <cstring>
#include <exception>

#include "report.h"

using namespace drill_rig_sim;

namespace
{
int usage()
{
  std::fprintf(stderr, "usage: accuracy_cases [--list | [--fast] [GROUP...]]\n");
  return 2;
}

bool wanted(const CaseGroup& group, bool fast, int named, char** names)
{
  if (named == 0) return group.fast || !fast;
  for (int k = 0; k < named; ++k)
    if (std::strcmp(names[k], group.name) == 0) return true;
  return false;
}

bool known(const char* name)
{
  for (const CaseGroup& group : case_groups())
    if (std::strcmp(name, group.name) == 0) return true;
  return false;
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0)
  {
    for (const CaseGroup& group : case_groups()) std::printf("%s%s\n", group.name, group.fast ? " fast" : "");
    return 0;
  }
  const bool fast = argc > 1 && std::strcmp(argv[1], "--fast") == 0;
  const int first = fast ? 2 : 1;
  for (int k = first; k < argc; ++k)
    if (!known(argv[k])) return usage();
  Report report;
  std::printf("case, ours, published, relative difference, bound, source\n");
  for (const CaseGroup& group : case_groups())
  {
    if (!wanted(group, fast, argc - first, argv + first)) continue;
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
  std::printf("%d lines, %d beyond their bounds\n", report.lines(), report.failed());
  return report.all_hold() ? 0 : 1;
}
