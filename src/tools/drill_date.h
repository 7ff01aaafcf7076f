// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_DATE_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_DATE_H

#include <ctime>
#include <optional>
#include <string>

namespace drill_rig_sim
{
constexpr std::time_t default_start_date = 946684800;  ///< 2000-01-01T00:00:00Z since 1970 [s]; the same in drill_rig_sim.wits0

/// Seconds since 1970 of a date as 2024-05-17 or 2024-05-17T06:30:00Z, by UTC, of the years 1970 to 2199. Nothing for any other
/// text.
std::optional<std::time_t> start_date_of(const std::string& text);

/// 2000-01-01T00:00:00.000Z at a simulated time [s], 0 being `start`; always as many characters.
std::string date_at(std::time_t start, double time);

}  // namespace drill_rig_sim

#endif
