// SPDX-License-Identifier: BSD-3-Clause
#include "scene_keys.h"

// Keys of the instruments.
namespace drill_rig_sim
{
const std::vector<const char*> hook_load_place_words = {"block", "dead_line"};

const char* unit_of(Gauge gauge) noexcept
{
  return si_name(gauge_dimensions[static_cast<int>(gauge)]);
}

namespace
{
// clang-format off
/// What every gauge has; of Spec, because a gauge may have more.
template <class Spec>
std::vector<Key<Spec>> gauge_rows()
{
  return {
  {"noise",                 "signal", &Spec::noise,                        between(0.0, 1e9),    "standard deviation"},
  {"bias",                  "signal", &Spec::bias,                         between(-1e9, 1e9),   "constant error"},
  {"delay",                 "s",      &Spec::delay,                        between(0.0, 60.0),   "dead time"},
  {"filter_time",           "s",      &Spec::filter_time,                  between(0.0, 60.0),   "first-order time constant"},
  {"resolution",            "signal", &Spec::resolution,                   between(0.0, 1e9),
      "steps in which it shows; 0: none"},
  {"drift",                 "signal/s^0.5", &Spec::drift,                  between(0.0, 1e9),
      "of the bias, a random walk from 0: its standard deviation after a second; after t seconds sqrt(t) times that"},
  {"rate",                  "1/s",    &Spec::rate,                         between(0.0, 1e4),
      "samples per second, each shown until the next; 0: one each frame"},
  {"dropout_interval",      "s",      &Spec::dropout_interval,             between(0.0, 1e7),
      "mean time from the end of a drop-out to the next: it then shows its last reading, and `lost_gauges` of `rig_state` "
      "reports it; 0: none"},
  {"dropout_duration",      "s",      &Spec::dropout_duration,             between(0.001, 1e7),
      "mean time that a drop-out lasts"},
  {"outlier_interval",      "s",      &Spec::outlier_interval,             between(0.0, 1e7),
      "mean time between outliers, single samples that are off by `outlier_size` up or down; 0: none"},
  {"outlier_size",          "signal", &Spec::outlier_size,                 between(0.0, 1e9),
      "by which an outlier is off; needed with `outlier_interval`"},
  };
}

template <class Spec>
std::vector<Key<Spec>> joined(std::vector<Key<Spec>> first, const std::vector<Key<Spec>>& then)
{
  first.insert(first.end(), then.begin(), then.end());
  return first;
}
}  // namespace

const Table<InstrumentsSpec> instruments_keys = {"instruments", "What the sensors make of the truth.", {
  {"mwd",                   "",       Nested{},                            none,                 "survey tool"},
  {"toolface",              "",       Nested{},                            none,                 "toolface between surveys"},
  {"dynamics",              "",       Nested{},                            none,                 "tool of downhole dynamics"},
  {"surface",               "",       Nested{},                            none,                 "gauges of the rig"},
}};

const Table<MwdSpec> mwd_keys = {"instruments.mwd",
    "Survey tool in the string's `mwd` part; at the bit's face where there is none.", {
  {"period",                "s",      &MwdSpec::period,                    between(0.0, 3600.0),
      "between surveys; 0: only after the pumps went off and on"},
  {"latency",               "s",      &MwdSpec::latency,                   between(0.0, 600.0),  "from measurement to surface"},
  {"inclination_resolution_deg", "deg", &MwdSpec::inclination_resolution,  between(0.0, 5.0),    "0: exact"},
  {"noise_deg",             "deg",    &MwdSpec::noise,                     between(0.0, 5.0),
      "standard deviation of inclination, azimuth and, unless that has its own, toolface"},
  {"scribe_offset_deg",     "deg",    &MwdSpec::scribe_offset,             between(-360.0, 360.0),
      "added to the sensor's toolface to name the bend's"},
  {"quiet_time",            "s",      &MwdSpec::quiet_time,                between(0.0, 3600.0),
      "with `period: 0`: the survey is taken so long after the flow has stopped, and sent when it is back; 0: taken as it comes "
      "back"},
  {"inclination_period",    "s",      &MwdSpec::inclination_period,        between(0.0, 3600.0),
      "between readings of the continuous inclination, with the survey's latency, resolution and noise, while the pipe turns "
      "too; 0: none"},
}};

const Table<ToolfaceSpec> toolface_keys = {"instruments.toolface", "Toolface sent between surveys.", {
  {"period",                "s",      &ToolfaceSpec::period,               above(0.0, 600.0),    "between readings"},
  {"latency",               "s",      &ToolfaceSpec::latency,              between(0.0, 600.0),  "from measurement to surface"},
  {"noise_deg",             "deg",    &ToolfaceSpec::noise,                between(0.0, 90.0),   "standard deviation", no_kind,
      every_kind, "of `mwd`"},
  {"resolution_deg",        "deg",    &ToolfaceSpec::resolution,           between(0.0, 90.0),
      "steps in which it is sent; 0: none"},
  {"max_speed_rpm",         "rpm",    &ToolfaceSpec::max_speed,            between(0.0, 1000.0),
      "of the pipe at the sensor: while it turns faster no toolface is sent; 0: it is sent whatever the speed"},
}};

const Table<DynamicsSpec> dynamics_keys = {"instruments.dynamics", "A tool in the string that measures weight, torque, bending, "
    "speed and shocks, and sends means and extremes: topic `downhole/dynamics`.", {
  {"period",                "s",      &DynamicsSpec::period,               between(0.0, 600.0),
      "of its readings; 0: there is none"},
  {"latency",               "s",      &DynamicsSpec::latency,              between(0.0, 600.0),  "from measurement to surface"},
  {"from_bit",              "m",      &DynamicsSpec::from_bit,             between(0.0, 20000.0),
      "distance above the bit's face, below the rotary table", no_kind, every_kind, "the survey tool's sensor"},
}};

const Table<InstrumentsSpec> surface_keys = {"instruments.surface", "Gauges of the rig.", {
#define GAUGE(type, name, dimension, mnemonic, item, meaning, reading) {#name, unit_of(Gauge::name), Nested{}, none, reading},
#include "drill_rig_sim/scene/signal_list.h"
}};

const Table<HookLoadSpec> hook_load_keys = {"instruments.surface.hook_load", "What `hook_load` of `rig_state` is read from.",
    joined<HookLoadSpec>({
  {"place",                 "",       Choice<HookLoadSpec>{hook_load_place_words,
      [](HookLoadSpec& h, int word) { h.place = static_cast<HookLoadPlace>(word); },
      [](const HookLoadSpec& h) { return static_cast<int>(h.place); }},
      none, "dead_line: the anchor's sensor, the sheaves' friction is in its signal; block: the load itself"},
}, gauge_rows<HookLoadSpec>())};

const Table<PressureSpec> pressure_keys = {"instruments.surface.stand_pipe_pressure",
    "What `stand_pipe_pressure` of `rig_state` is read from.", joined<PressureSpec>({
  {"pump_noise",            "-",      &PressureSpec::pump_noise,           between(0.0, 0.5),
      "amplitude of the pump's pulsation as a share of the pressure, three times a stroke (triplex pump); `filter_time` damps "
      "it; `differential_pressure` of `rig_state` has it too"},
}, gauge_rows<PressureSpec>())};

const Table<SensorSpec> sensor_keys = {"instruments.surface.*", "Any gauge, in the unit of its signal.",
    gauge_rows<SensorSpec>()};
// clang-format on

}  // namespace drill_rig_sim
