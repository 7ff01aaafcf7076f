#ifndef DRILL_RIG_SIM_SCENE_FAULT_SPEC_H
#define DRILL_RIG_SIM_SCENE_FAULT_SPEC_H

#include <string>

#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
/// What can go wrong, with the numbers that InjectFault.srv gives them. sim/faults.h says what each does.
enum class FaultKind
{
  stuck_pipe = 0,
  sensor_freeze = 1,
  sensor_bias = 2,
  sensor_noise = 3,
  brake_slip = 4,
  drive_trip = 5,
  motor_stall = 6,
  washed_out_hole = 7,
  pump_trip = 8,
  sensor_dropout = 9,
  sensor_drift = 10,
  differential_sticking = 11,
  pack_off = 12,
  friction_change = 13,
  formation_change = 14,
  washed_out_pipe = 15
};
constexpr int fault_count = 16;
constexpr const char* fault_names[fault_count] = {"stuck_pipe",     "sensor_freeze",   "sensor_bias",  "sensor_noise",
                                                  "brake_slip",     "drive_trip",      "motor_stall",  "washed_out_hole",
                                                  "pump_trip",      "sensor_dropout",  "sensor_drift", "differential_sticking",
                                                  "pack_off",       "friction_change", "formation_change", "washed_out_pipe"};

/// A fault as requested.
struct Fault
{
  FaultKind kind = FaultKind::stuck_pipe;
  double depth = 0.0;      ///< where it has a place [m MD]
  double magnitude = 0.0;  ///< in its own unit (InjectFault.srv)
  Gauge gauge = Gauge::hook_load;  ///< of a sensor's fault
};

/// Whether it is of a gauge; has a place where there must be pipe in the hole; has a magnitude.
bool is_of_gauge(FaultKind kind) noexcept;
bool needs_pipe(FaultKind kind) noexcept;
bool has_magnitude(FaultKind kind) noexcept;

/// The fault of this kind, and of the gauge that `gauge` names if it is of one. Throws std::runtime_error with one line where there is no such gauge.
Fault fault_of(FaultKind kind, const std::string& gauge, double depth, double magnitude);

/// Why a fault's magnitude makes no sense: one line, static storage; null: it does.
const char* what_is_wrong_with_magnitude(const Fault& fault) noexcept;

}  // namespace drill_rig_sim

#endif
