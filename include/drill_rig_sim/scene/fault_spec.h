// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_FAULT_SPEC_H
#define DRILL_RIG_SIM_SCENE_FAULT_SPEC_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drill_rig_sim/math/shown_units.h"
#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
/// What can go wrong, with the numbers that InjectFault.srv gives them. sim/faults.h says what each does.
enum class FaultKind
{
#define FAULT(name, ...) name,
#include "drill_rig_sim/scene/fault_list.h"
};

/// What a fault's `depth` means.
enum class FaultPlace
{
  nowhere,
  in_pipe,  ///< there must be pipe in the hole
  in_hole,
  from_there_down  ///< 0: all of the hole
};

enum class FaultTarget
{
  nothing,
  gauge
};

/// A fault's `magnitude`.
struct FaultMagnitude
{
  const char* label;    ///< for displays; null: it has none
  Dimension dimension;  ///< count: that of the gauge
  bool per_second;      ///< in units of the dimension per second
  double least, most;   ///< allowed [SI]
  bool without_least;   ///< `least` itself is not allowed
  double usual;         ///< for displays to begin with [SI]
  const char* refusal;  ///< one line that says what is allowed
};

constexpr FaultMagnitude no_magnitude{nullptr, Dimension::number, false, 0.0, 0.0, false, 0.0, nullptr};
constexpr FaultMagnitude above_0(const char* label, Dimension dimension, double most, double usual, const char* refusal)
{
  return {label, dimension, false, 0.0, most, true, usual, refusal};
}
constexpr FaultMagnitude factor(double least, double most, double usual, const char* refusal)
{
  return {"factor", Dimension::number, false, least, most, false, usual, refusal};
}
/// Of a gauge, either way; 0 would be no fault.
constexpr FaultMagnitude of_signal(const char* label, bool per_second = false)
{
  return {label,      Dimension::count,
          per_second, -1e9,
          1e9,        false,
          0.0,        "magnitude: allowed is anything but 0 up to 1e9 units of the signal either way (per second: drift)"};
}

struct FaultTraits
{
  const char* word;   ///< of the scene file
  const char* label;  ///< for displays
  FaultPlace place;
  bool by_ida;  ///< the integrator `ida` has it
  FaultTarget target;
  FaultMagnitude magnitude;
};

/// By FaultKind.
constexpr FaultTraits fault_traits[] = {
#define FAULT(name, label, place, by_ida, target, magnitude) \
  {#name, label, FaultPlace::place, by_ida, FaultTarget::target, magnitude},
#include "drill_rig_sim/scene/fault_list.h"
};
constexpr int fault_count = sizeof fault_traits / sizeof fault_traits[0];
constexpr const FaultTraits& traits_of(FaultKind kind) noexcept
{
  return fault_traits[static_cast<int>(kind)];
}

/// A fault as requested.
struct Fault
{
  FaultKind kind = FaultKind::stuck_pipe;
  double depth = 0.0;              ///< where it has a place [m MD]
  double magnitude = 0.0;          ///< in its own unit (InjectFault.srv)
  Gauge gauge = Gauge::hook_load;  ///< of a sensor's fault
};

/// Whether it is of a gauge; has a place where there must be pipe in the hole; has a magnitude.
constexpr bool is_of_gauge(FaultKind kind) noexcept
{
  return traits_of(kind).target == FaultTarget::gauge;
}
constexpr bool needs_pipe(FaultKind kind) noexcept
{
  return traits_of(kind).place == FaultPlace::in_pipe;
}
constexpr bool has_magnitude(FaultKind kind) noexcept
{
  return traits_of(kind).magnitude.label != nullptr;
}

/// The fault of this kind, and of the gauge that `gauge` names if it is of one. Throws std::runtime_error with one line where
/// there is no such gauge.
Fault fault_of(FaultKind kind, const std::string& gauge, double depth, double magnitude);

/// Throws std::runtime_error with one line where a fault has a number or a gauge, as requested, that faults of this kind do not
/// have.
void require_only_what_applies(FaultKind kind, const std::string& gauge, double depth, double magnitude);

/// Which faults are under way.
struct ActiveFaults
{
  std::uint32_t of_rig = 0;                            ///< a bit for each FaultKind
  std::array<std::uint32_t, gauge_count> of_gauges{};  ///< the same of each Gauge
};
/// By their words of the scene file, those of gauges as "sensor_bias of hook_load", in the order of the list.
std::vector<std::string> words_of(const ActiveFaults& faults);

/// Why a fault's magnitude makes no sense: one line, static storage; null: it does.
const char* what_is_wrong_with_magnitude(const Fault& fault) noexcept;

}  // namespace drill_rig_sim

#endif
