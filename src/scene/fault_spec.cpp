// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/scene/fault_spec.h"

#include <cmath>
#include <stdexcept>

namespace drill_rig_sim
{
Fault fault_of(FaultKind kind, const std::string& gauge, double depth, double magnitude)
{
  Fault fault{kind, depth, magnitude};
  if (!is_of_gauge(kind)) return fault;
  std::string names;
  for (int k = 0; k < gauge_count; ++k)
  {
    fault.gauge = static_cast<Gauge>(k);
    if (gauge == gauge_names[k]) return fault;
    names += (k == 0 ? "" : k + 1 < gauge_count ? ", " : " or ") + std::string(gauge_names[k]);
  }
  throw std::runtime_error("target is not the name of a gauge; allowed is " + names);
}

void require_only_what_applies(FaultKind kind, const std::string& gauge, double depth, double magnitude)
{
  const FaultTraits& fault = traits_of(kind);
  const auto refuse = [&](const char* field, const char* allowed)
  { throw std::runtime_error(std::string(field) + " has no effect on " + fault.word + "; allowed is " + allowed); };
  if (fault.place == FaultPlace::nowhere && depth != 0.0) refuse("depth", "0");
  if (!has_magnitude(kind) && magnitude != 0.0) refuse("magnitude", "0");
  if (!is_of_gauge(kind) && !gauge.empty()) refuse("target", "an empty one");
}

std::vector<std::string> words_of(const ActiveFaults& faults)
{
  std::vector<std::string> words;
  for (int k = 0; k < fault_count; ++k)
  {
    if (faults.of_rig >> k & 1u) words.emplace_back(fault_traits[k].word);
    for (int g = 0; g < gauge_count; ++g)
      if (faults.of_gauges[static_cast<std::size_t>(g)] >> k & 1u)
        words.push_back(std::string(fault_traits[k].word) + " of " + gauge_names[g]);
  }
  return words;
}

const char* what_is_wrong_with_magnitude(const Fault& fault) noexcept
{
  if (!has_magnitude(fault.kind)) return nullptr;
  const FaultMagnitude& allowed = traits_of(fault.kind).magnitude;
  const double m = fault.magnitude;
  if (!std::isfinite(m)) return "magnitude: must be finite";
  const bool within = m >= allowed.least && m <= allowed.most && !(allowed.without_least && m == allowed.least);
  return within && !(allowed.least < 0.0 && m == 0.0) ? nullptr : allowed.refusal;
}

}  // namespace drill_rig_sim
