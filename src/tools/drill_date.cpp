// SPDX-License-Identifier: BSD-3-Clause
#include "drill_date.h"

#include <cmath>
#include <cstdio>

namespace drill_rig_sim
{
namespace
{
constexpr const char* day_and_time = "%Y-%m-%dT%H:%M:%S";

std::string text_of(std::time_t seconds, const char* format)
{
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[40];
  std::strftime(text, sizeof text, format, &parts);
  return text;
}
}  // namespace

/// What is no such date, as February 30, comes back as another text.
std::optional<std::time_t> start_date_of(const std::string& text)
{
  const std::string whole = text.size() == 10 ? text + "T00:00:00Z" : text;
  std::tm parts{};
  const char* rest = strptime(whole.c_str(), day_and_time, &parts);
  if (!rest || std::string(rest) != "Z" || parts.tm_year < 70 || parts.tm_year > 299) return std::nullopt;
  const std::time_t seconds = timegm(&parts);
  if (text_of(seconds, day_and_time) + "Z" != whole) return std::nullopt;
  return seconds;
}

std::string date_at(std::time_t start, double time)
{
  const long long milliseconds = std::llround(1e3 * time);
  char fraction[16];
  std::snprintf(fraction, sizeof fraction, ".%03dZ", static_cast<int>(milliseconds % 1000));
  return text_of(start + static_cast<std::time_t>(milliseconds / 1000), day_and_time) + fraction;
}

}  // namespace drill_rig_sim
