// SPDX-License-Identifier: BSD-3-Clause
#include "counters.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <new>

namespace drill_rig_sim
{
namespace fuzz
{
namespace
{
Counters* in_file(const char* name)
{
  const int file = open(name, O_RDWR | O_CREAT, 0644);
  if (file < 0 || ftruncate(file, sizeof(Counters)) != 0) return nullptr;
  void* place = mmap(nullptr, sizeof(Counters), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return place == MAP_FAILED ? nullptr : new (place) Counters;
}

Counters* place_of_counters()
{
  const char* name = std::getenv("FUZZ_COUNTS");
  if (!name) return new Counters;
  Counters* counters = in_file(name);
  check(counters, std::string("FUZZ_COUNTS: cannot write ") + name);
  return counters;
}
}  // namespace

Counters& counters()
{
  static Counters* const place = place_of_counters();
  return *place;
}

void check(bool good, const std::string& what)
{
  if (good) return;
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

void check_refusal(const std::string& line)
{
  check(!line.empty(), "refused without a word");
  for (const char c : line)
    check(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "a refusal holds a control character: " + line);
}

}  // namespace fuzz
}  // namespace drill_rig_sim
