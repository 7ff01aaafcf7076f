// SPDX-License-Identifier: BSD-3-Clause
#include "drill_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
struct Shown
{
  Dimension dimension;
  Printed::InSI si;
};
const Shown shown[output_count] = {
    {Dimension::force, {"%.1f", "kN", 1e-3}},          {Dimension::torque, {"%.2f", "kN m", 1e-3}},
    {Dimension::force, {"%.1f", "kN", 1e-3}},          {Dimension::penetration, {"%.2f", "m/h", 3600.0}},
    {Dimension::rotation, {"%.1f", "rpm", 1.0 / rpm}}, {Dimension::pressure, {"%.2f", "MPa", 1e-6}}};

/// Names of the outputs in needs that have this verdict.
std::string with_verdict(const Verification& verification, Verification::Verdict verdict)
{
  std::string names;
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    if (verification.needed(output) && verification.verdict(output) == verdict)
      names += (names.empty() ? "" : ", ") + std::string(output_traits[i].name);
  }
  return names;
}

/// Of the outputs in needs that have this verdict, when the first is wrong [s].
double wrong_from(const Verification& verification, Verification::Verdict verdict)
{
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    if (verification.needed(output) && verification.verdict(output) == verdict)
      first = std::min(first, verification.finding(output).wrong_from);
  }
  return first;
}

void print_warned(const Verification& verification, double tolerance)
{
  const Verification::Verdict warned = Verification::Verdict::warned;
  std::printf("wrong, and warned of: %s, by more than %g %% from %.0f s on; a warning came at %.0f s\n",
              with_verdict(verification, warned).c_str(), 100.0 * tolerance, wrong_from(verification, warned),
              verification.warned_from());
}

bool is_judged_by_statistics(const Verification& verification, Output output)
{
  return verification.needed(output) && !std::isnan(verification.finding(output).parted_from);
}

std::string vibrating(const Verification& verification)
{
  std::string names;
  for (std::size_t i = 0; i < output_count; ++i)
    if (is_judged_by_statistics(verification, static_cast<Output>(i)))
      names += (names.empty() ? "" : ", ") + std::string(output_traits[i].name);
  return names;
}

/// Of their statistics, the largest difference of each kind [-].
StatisticDifferences largest_of_statistics(const Verification& verification)
{
  StatisticDifferences most;
  for (std::size_t i = 0; i < output_count; ++i)
  {
    if (!is_judged_by_statistics(verification, static_cast<Output>(i))) continue;
    const StatisticDifferences off = verification.finding(static_cast<Output>(i)).statistics;
    most = {std::max(most.mean, off.mean), std::max(most.deviation, off.deviation), std::max(most.extremes, off.extremes),
            std::max(most.period, off.period)};
  }
  return most;
}

void print_right(const Verification& verification, double tolerance)
{
  const std::string names = vibrating(verification);
  if (names.empty())
  {
    std::printf("right: over any 3 s no output in needs is off by more than %g %% of its range\n", 100.0 * tolerance);
    return;
  }
  const StatisticDifferences off = largest_of_statistics(verification);
  std::printf(
      "right in statistics: %s vibrate, and from %.0f s on their momentary values are one sample of many; over 30 s the mean is "
      "off by at most %.2g %% of the range, the deviation by %.2g %%, the extremes by %.2g %%, the period by %.2g %%\n",
      names.c_str(), verification.parted_from(), 100.0 * off.mean, 100.0 * off.deviation, 100.0 * off.extremes,
      100.0 * off.period);
}
}  // namespace

void print_findings(const Verification& verification, const Printed& printed)
{
  std::printf("%-20s %14s %14s %12s %9s %12s\n", "output", "mean", "finest mean", "worst 3 s", "at", "finest error");
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    const Verification::Finding found = verification.finding(output);
    const auto value = [&](double si) { return printed(si, shown[i].dimension, shown[i].si); };
    std::printf("%-20s %14s %14s %10.2f %% %7.0f s %10.2f %%%s\n", traits_of(output).name, value(found.mean).c_str(),
                value(found.finest_mean).c_str(), 100.0 * found.worst, found.worst_until, 100.0 * found.own,
                verification.needed(output) ? "" : "  (not in needs)");
  }
}

void print_verdict(const Verification& verification, double tolerance, const std::string& not_measured)
{
  using Verdict = Verification::Verdict;
  const std::string names = with_verdict(verification, verification.verdict());
  switch (verification.verdict())
  {
    case Verdict::right:
      print_right(verification, tolerance);
      break;
    case Verdict::warned:
      print_warned(verification, tolerance);
      break;
    case Verdict::missed:
      std::printf("wrong without a warning: %s, by more than %g %% from %.0f s on%s\n", names.c_str(), 100.0 * tolerance,
                  wrong_from(verification, Verdict::missed),
                  not_measured.empty() ? "" : ("; its error was not measured: " + not_measured).c_str());
      break;
    case Verdict::unknown:
      if (!with_verdict(verification, Verdict::warned).empty()) print_warned(verification, tolerance);
      std::printf(
          "not known: the finer runs differ too much in %s for a verdict at %g %%; its momentary values are one sample, averages "
          "over minutes may be reliable\n",
          names.c_str(), 100.0 * tolerance);
      break;
  }
}

nlohmann::ordered_json json_of(const Simulator& simulator, const FinerPair& pair)
{
  const Verification& verification = pair.findings();
  nlohmann::ordered_json out{{"scene", simulator.scene().name},
                             {"verdict", word_of(verification.verdict())},
                             {"tolerance", simulator.scene().numerics.tolerance},
                             {"refined", {pair.times(), pair.times() * pair.times()}},
                             {"simulated_s", simulator.truth().time},
                             {"warned_from", verification.warned_from()},
                             {"not_measured", simulator.statistics().not_measured}};
  for (const OutputTraits& traits : output_traits)
    visit(verification, static_cast<Output>(&traits - output_traits.data()),
          [&](const char* name, const auto& value) { out["outputs"][traits.name][name] = value; });
  return out;
}

}  // namespace drill_rig_sim
