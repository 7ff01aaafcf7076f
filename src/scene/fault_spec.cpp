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
