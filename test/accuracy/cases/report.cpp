// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <cmath>
#include <cstdio>

namespace drill_rig_sim
{
void Report::add(const CaseLine& line)
{
  const double off = line.ours - line.published;
  const double difference = line.absolute ? off : off / std::abs(line.published);
  print(line, difference, std::isfinite(difference) && std::abs(difference) <= line.bound);
}

void Report::add_band(const std::string& name, double ours, double low, double high, const std::string& source)
{
  const double nearer = std::abs(ours - low) < std::abs(ours - high) ? low : high;
  char band[64];
  std::snprintf(band, sizeof band, " (band %.6g to %.6g)", low, high);
  const CaseLine line{name, ours, nearer, 0.0, source + band, false};
  print(line, (ours - nearer) / std::abs(nearer), ours >= low && ours <= high);
}

void Report::skip(const std::string& name, const std::string& why)
{
  ++skipped_;
  std::printf("%s, skipped, , , , %s\n", name.c_str(), why.c_str());
  std::fflush(stdout);
}

void Report::print(const CaseLine& line, double difference, bool holds)
{
  ++lines_;
  if (!holds) ++failed_;
  std::printf("%s, %.7g, %.7g, %.2e%s, %g, %s%s\n", line.name.c_str(), line.ours, line.published, difference,
              line.absolute ? " abs" : "", line.bound, line.source.c_str(), holds ? "" : " FAILED");
  std::fflush(stdout);
}

}  // namespace drill_rig_sim
