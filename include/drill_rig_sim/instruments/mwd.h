// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_INSTRUMENTS_MWD_H
#define DRILL_RIG_SIM_INSTRUMENTS_MWD_H

#include <Eigen/Core>
#include <cstdint>

#include "drill_rig_sim/instruments/dynamics_tool.h"
#include "drill_rig_sim/instruments/sensor.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/instruments/telemetry.h"
#include "drill_rig_sim/scene/instruments_spec.h"

namespace drill_rig_sim
{
/// What the MWD's sensor sees, and the tools beside it.
struct SensorView
{
  double md = 0.0;                                    ///< [m]
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitZ();   ///< along the string, towards the bit
  Eigen::Vector3d scribe = Eigen::Vector3d::UnitY();  ///< across the string: the bend's direction without twist
  double spin_speed = 0.0;                            ///< of the pipe [rad/s]
  bool in_slips = false;                              ///< the slips carry the string: the block does not show the bit's depth
  double pump_strokes = 0.0;                          ///< since the start, with parts of a stroke
  SubView sub;                                        ///< what the tool of dynamics sees
};

/// Measurement while drilling: surveys by period, or after a pumps-off/on cycle when the period is 0, the faster toolface and the
/// continuous inclination; each reaches the surface late. Telemetry by pulses in the mud: nothing is sent without flow, and what
/// is on its way then waits. The survey of a cycle is taken in the quiet, quiet_time after the flow has stopped (a cycle that is
/// over earlier has none), or where that is 0 as the flow comes back. A pipe that turns faster than max_speed shows its
/// accelerometers no steady high side: no toolface.
class Mwd
{
public:
  Mwd() = default;
  Mwd(const MwdSpec& survey, const ToolfaceSpec& toolface, NoiseSource noise = {});
  /// Measures what is due at `time` [s] and returns the data that have arrived at the surface by then.
  void update(double time, double flow, const SensorView& view, MwdReading& survey, ToolfaceReading& toolface) noexcept;
  /// The last reading that has arrived.
  const InclinationReading& inclination() const noexcept { return inclination_; }

  /// What it remembers; its specification is the scene's.
  template <class V>
  void visit(V& v)
  {
    v("noise", noise_);
    v("surveys", surveys_);
    v("toolfaces", toolfaces_);
    v("inclinations", inclinations_);
    v("next_survey", next_survey_);
    v("next_toolface", next_toolface_);
    v("next_inclination", next_inclination_);
    v("flowing", flowing_);
    v("quiet_since", quiet_since_);
    v("quiet_survey", quiet_survey_);
    v("has_quiet_survey", has_quiet_survey_);
    v("inclination", inclination_);
    v("magnetic", magnetic_);
    v("survey_count", survey_count_);
    v("toolface_count", toolface_count_);
    v("inclination_count", inclination_count_);
  }

private:
  MwdReading measure(double time, const SensorView& view) noexcept;
  double measured_inclination(const SensorView& view) noexcept;
  void rest(double time, const SensorView& view) noexcept;
  void send_survey(double time, const SensorView& view) noexcept;
  void send_toolface(double time, const SensorView& view) noexcept;
  void send_inclination(double time, const SensorView& view) noexcept;

  MwdSpec survey_;
  ToolfaceSpec toolface_;
  NoiseSource noise_;
  TelemetryQueue<MwdReading> surveys_;
  TelemetryQueue<ToolfaceReading> toolfaces_;
  TelemetryQueue<InclinationReading> inclinations_;
  double next_survey_ = 0.0;
  double next_toolface_ = 0.0;
  double next_inclination_ = 0.0;
  bool flowing_ = false;
  double quiet_since_ = 0.0;  // when the flow stopped [s]
  MwdReading quiet_survey_;   // taken since then
  bool has_quiet_survey_ = false;
  InclinationReading inclination_;
  bool magnetic_ = true;
  std::uint64_t survey_count_ = 0;
  std::uint64_t toolface_count_ = 0;
  std::uint64_t inclination_count_ = 0;
};

}  // namespace drill_rig_sim

#endif
