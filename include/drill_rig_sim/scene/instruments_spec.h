// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_INSTRUMENTS_SPEC_H
#define DRILL_RIG_SIM_SCENE_INSTRUMENTS_SPEC_H

#include <limits>

#include "drill_rig_sim/math/shown_units.h"

namespace drill_rig_sim
{
/// The outputs of the rig's gauges: those of the list of signals.
enum class Gauge
{
#define GAUGE(type, name, ...) name,
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
};
constexpr const char* gauge_names[] = {
#define GAUGE(type, name, ...) #name,
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
};
constexpr int gauge_count = sizeof gauge_names / sizeof gauge_names[0];
/// What each measures.
constexpr Dimension gauge_dimensions[gauge_count] = {
#define GAUGE(type, name, dimension, ...) Dimension::dimension,
#define GAUGE_LIKE GAUGE
#include "drill_rig_sim/scene/signal_list.h"
};

/// A gauge's errors (instruments/sensor.h).
struct SensorSpec
{
  double noise = 0.0;        ///< standard deviation [unit of the signal]
  double bias = 0.0;         ///< [unit of the signal]
  double delay = 0.0;        ///< [s]
  double filter_time = 0.0;  ///< first-order time constant [s]
  double resolution = 0.0;   ///< steps in which it shows [unit of the signal]; 0 = none
  double drift = 0.0;        ///< of the bias, a random walk: its standard deviation after a second [unit of the signal/s^0.5]
  double rate = 0.0;         ///< samples per second, each shown until the next [1/s]; 0: one each frame
  double dropout_interval = 0.0;  ///< mean time from a drop-out's end to the next [s]; 0: none
  double dropout_duration = 5.0;  ///< mean [s]
  double outlier_interval = 0.0;  ///< mean time between outliers [s]; 0: none
  double outlier_size = 0.0;      ///< by which an outlier is off, either way [unit of the signal]
};

/// Where the hook load is measured.
enum class HookLoadPlace
{
  block,     ///< between block and lines: the load itself
  dead_line  ///< at the dead line's anchor: the friction of the sheaves is in it
};

struct PressureSpec : SensorSpec
{
  double pump_noise = 0.0;  ///< amplitude of the pump's pulsation, as a share of the pressure [-]
};

struct HookLoadSpec : SensorSpec
{
  HookLoadPlace place = HookLoadPlace::dead_line;
};

/// Readings on their way from the tool to the surface at most: more are lost, as where telemetry is saturated.
constexpr int most_on_the_way = 32;

struct MwdSpec
{
  double period = 30.0;                 ///< between surveys [s]; 0 = only after a pumps-off/on cycle
  double latency = 8.0;                 ///< measurement to surface [s]
  double inclination_resolution = 0.0;  ///< [rad]
  double noise = 0.0;                   ///< standard deviation of inclination and azimuth [rad]
  double scribe_offset = 0.0;           ///< added to the sensor's toolface to name the bend's [rad]
  double quiet_time =
      0.0;  ///< period 0: the survey is taken so long after the flow has stopped, and sent when it is back [s]; 0: taken then
  double inclination_period = 0.0;  ///< between readings of the continuous inclination [s]; 0: none
};

struct ToolfaceSpec
{
  static constexpr double of_mwd = std::numeric_limits<double>::quiet_NaN();
  double period = 10.0;     ///< [s]
  double latency = 4.0;     ///< [s]
  double noise = of_mwd;    ///< standard deviation [rad]; NaN: the survey's
  double resolution = 0.0;  ///< [rad]; 0 = none
  double max_speed = 0.0;   ///< of the pipe: above it no toolface is sent [rad/s]; 0: whatever the speed
};

struct DynamicsSpec
{
  static constexpr double of_mwd = std::numeric_limits<double>::quiet_NaN();
  double period = 0.0;       ///< of its readings [s]; 0 = none
  double latency = 8.0;      ///< [s]
  double from_bit = of_mwd;  ///< so far above the bit's face [m]; NaN: the survey tool's sensor, at the bit where there is none
};

/// The errors of a gauge: hook_load has a place, stand_pipe_pressure the pump's noise too.
template <Gauge>
struct SpecOfGauge
{
  using Type = SensorSpec;
};
template <>
struct SpecOfGauge<Gauge::hook_load>
{
  using Type = HookLoadSpec;
};
template <>
struct SpecOfGauge<Gauge::stand_pipe_pressure>
{
  using Type = PressureSpec;
};

struct InstrumentsSpec
{
  MwdSpec mwd;
  ToolfaceSpec toolface;
  DynamicsSpec dynamics;
  // each gauge by its name
#define GAUGE(type, name, ...) SpecOfGauge<Gauge::name>::Type name;
#include "drill_rig_sim/scene/signal_list.h"
};

}  // namespace drill_rig_sim

#endif
