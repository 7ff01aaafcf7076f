#include "drill_rig_sim/scene/fault_spec.h"

#include <cmath>
#include <stdexcept>

namespace drill_rig_sim
{
bool is_of_gauge(FaultKind kind) noexcept
{
  switch (kind)
  {
    case FaultKind::sensor_freeze:
    case FaultKind::sensor_bias:
    case FaultKind::sensor_noise:
    case FaultKind::sensor_dropout:
    case FaultKind::sensor_drift:
      return true;
    default:
      return false;
  }
}

bool needs_pipe(FaultKind kind) noexcept
{
  switch (kind)
  {
    case FaultKind::stuck_pipe:
    case FaultKind::differential_sticking:
    case FaultKind::pack_off:
    case FaultKind::washed_out_pipe:
      return true;
    default:
      return false;
  }
}

bool has_magnitude(FaultKind kind) noexcept
{
  switch (kind)
  {
    case FaultKind::stuck_pipe:
    case FaultKind::sensor_freeze:
    case FaultKind::sensor_dropout:
    case FaultKind::drive_trip:
    case FaultKind::pump_trip:
    case FaultKind::motor_stall:
      return false;
    default:
      return true;
  }
}

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
  const double m = fault.magnitude;
  if (!std::isfinite(m)) return "magnitude: must be finite";
  const auto within = [m](double most, const char* otherwise) { return m > 0.0 && m <= most ? nullptr : otherwise; };
  switch (fault.kind)
  {
    case FaultKind::sensor_bias:
    case FaultKind::sensor_drift:
      return m != 0.0 && std::abs(m) <= 1e9 ? nullptr : "magnitude: allowed is anything but 0 up to 1e9 units of the signal either way (per second: drift)";
    case FaultKind::sensor_noise: return within(1e9, "magnitude: allowed is above 0, up to 1e9 units of the signal");
    case FaultKind::brake_slip: return within(5e7, "magnitude: allowed is above 0, up to 5e7 N");
    case FaultKind::washed_out_hole: return within(1.0, "magnitude: allowed is above 0, up to 1 m");
    case FaultKind::washed_out_pipe: return within(0.01, "magnitude: allowed is above 0, up to 0.01 m2");
    case FaultKind::differential_sticking: return within(1e9, "magnitude: allowed is above 0, up to 1e9 N/m");
    case FaultKind::pack_off: return within(1e7, "magnitude: allowed is above 0, up to 1e7 N");
    case FaultKind::friction_change: return m >= 0.0 && m <= 10.0 ? nullptr : "magnitude: allowed is 0 to 10 times";
    case FaultKind::formation_change: return m >= 1e-3 && m <= 1e3 ? nullptr : "magnitude: allowed is 0.001 to 1000 times";
    default: return nullptr;
  }
}

}  // namespace drill_rig_sim
