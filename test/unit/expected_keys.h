// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_EXPECTED_KEYS_H
#define DRILL_RIG_SIM_TEST_EXPECTED_KEYS_H

#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene.h"

/// What the keys of scene_of_all_keys are expected to be; here those of instruments and operations.
namespace drill_rig_sim
{
struct Expected
{
  const char* block;  // as the scene reference calls it
  const char* key;
  std::function<double(const Scene&)> field;
  double value;  // SI, radians
};

inline double number(bool same)
{
  return same ? 1.0 : 0.0;
}

inline std::vector<Expected> of_instruments()
{
  std::vector<Expected> all = {
      {"instruments.mwd", "period", [](const Scene& s) { return s.instruments.mwd.period; }, 32.0},
      {"instruments.mwd", "latency", [](const Scene& s) { return s.instruments.mwd.latency; }, 8.1},
      {"instruments.mwd", "inclination_resolution_deg", [](const Scene& s) { return s.instruments.mwd.inclination_resolution; },
       0.13 * degree},
      {"instruments.mwd", "noise_deg", [](const Scene& s) { return s.instruments.mwd.noise; }, 0.06 * degree},
      {"instruments.mwd", "scribe_offset_deg", [](const Scene& s) { return s.instruments.mwd.scribe_offset; }, 17.0 * degree},
      {"instruments.dynamics", "period", [](const Scene& s) { return s.instruments.dynamics.period; }, 17.1},
      {"instruments.dynamics", "latency", [](const Scene& s) { return s.instruments.dynamics.latency; }, 7.3},
      {"instruments.dynamics", "from_bit", [](const Scene& s) { return s.instruments.dynamics.from_bit; }, 21.7},
      {"instruments.mwd", "quiet_time", [](const Scene& s) { return s.instruments.mwd.quiet_time; }, 7.1},
      {"instruments.mwd", "inclination_period", [](const Scene& s) { return s.instruments.mwd.inclination_period; }, 21.3},
      {"instruments.toolface", "noise_deg", [](const Scene& s) { return s.instruments.toolface.noise; }, 0.51 * degree},
      {"instruments.toolface", "resolution_deg", [](const Scene& s) { return s.instruments.toolface.resolution; }, 2.8 * degree},
      {"instruments.toolface", "max_speed_rpm", [](const Scene& s) { return s.instruments.toolface.max_speed; }, 12.1 * rpm},
      {"instruments.toolface", "period", [](const Scene& s) { return s.instruments.toolface.period; }, 10.1},
      {"instruments.toolface", "latency", [](const Scene& s) { return s.instruments.toolface.latency; }, 4.1},
      {"instruments.surface.stand_pipe_pressure", "pump_noise",
       [](const Scene& s) { return s.instruments.stand_pipe_pressure.pump_noise; }, 0.031},
      {"instruments.surface.hook_load", "place",
       [](const Scene& s) { return number(s.instruments.hook_load.place == HookLoadPlace::block); }, 1.0},
  };
  using Get = std::function<const SensorSpec&(const Scene&)>;
  const std::pair<const char*, Get> gauges[] = {
#define GAUGE(type, name, ...) \
  {#name, [](const Scene& s) -> const SensorSpec& { return s.instruments.name; }},
#include "drill_rig_sim/scene/signal_list.h"
  };
  const std::pair<const char*, double SensorSpec::*> keys[] = {{"noise", &SensorSpec::noise},
                                                               {"bias", &SensorSpec::bias},
                                                               {"delay", &SensorSpec::delay},
                                                               {"filter_time", &SensorSpec::filter_time},
                                                               {"resolution", &SensorSpec::resolution},
                                                               {"drift", &SensorSpec::drift},
                                                               {"rate", &SensorSpec::rate},
                                                               {"dropout_interval", &SensorSpec::dropout_interval},
                                                               {"dropout_duration", &SensorSpec::dropout_duration},
                                                               {"outlier_interval", &SensorSpec::outlier_interval},
                                                               {"outlier_size", &SensorSpec::outlier_size}};
  for (std::size_t g = 0; g < std::size(gauges); ++g)
    for (int k = 0; k < static_cast<int>(std::size(keys)); ++k)
    {
      const Get get = gauges[g].second;
      const auto member = keys[k].second;
      const auto field = [get, member](const Scene& s) { return get(s).*member; };
      const double value = static_cast<double>(g + 1) + 0.1 * (k + 1);
      const char* const own = g == static_cast<std::size_t>(Gauge::hook_load) ? "instruments.surface.hook_load"
                              : g == static_cast<std::size_t>(Gauge::stand_pipe_pressure)
                                  ? "instruments.surface.stand_pipe_pressure"
                                  : "instruments.surface.*";
      all.push_back({own, keys[k].first, field, value});
      all.push_back({"instruments.surface", gauges[g].first, field, value});
    }
  return all;
}

inline std::vector<Expected> of_operations()
{
  return {
      {"", "operations", [](const Scene& s) { return double(s.operations.size()); }, 12.0},
      {"operations[]", "do", [](const Scene& s) { return number(s.operations.at(8).kind == OperationKind::ream); }, 1.0},
      {"operations[]", "flow", [](const Scene& s) { return s.operations.at(0).flow; }, 0.044},
      {"operations[]", "ramp", [](const Scene& s) { return s.operations.at(0).ramp; }, 7.5},
      {"operations[]", "time", [](const Scene& s) { return s.operations.at(0).time; }, 3.1},
      {"operations[]", "speed_rpm", [](const Scene& s) { return s.operations.at(1).rotary_speed; }, 61.0 * rpm},
      {"operations[]", "speed", [](const Scene& s) { return s.operations.at(2).speed; }, 0.11},
      {"operations[]", "to_depth", [](const Scene& s) { return s.operations.at(2).to_depth; }, 795.0},
      {"operations[]", "distance", [](const Scene& s) { return s.operations.at(2).distance; }, 5.1},
      {"operations[]", "overpull", [](const Scene& s) { return s.operations.at(2).overpull; }, 81000.0},
      {"operations[]", "weight", [](const Scene& s) { return s.operations.at(4).weight; }, 6100.0},
      {"operations[]", "toolface_deg", [](const Scene& s) { return s.operations.at(6).toolface; }, 91.0 * degree},
      {"operations[]", "amplitude_right_deg", [](const Scene& s) { return s.operations.at(6).amplitude_right; }, 181.0 * degree},
      {"operations[]", "amplitude_left_deg", [](const Scene& s) { return s.operations.at(6).amplitude_left; }, 182.0 * degree},
      {"operations[]", "times", [](const Scene& s) { return double(s.operations.at(8).times); }, 2.0},
      {"operations[]", "remove", [](const Scene& s) { return s.operations.at(11).remove; }, 1.0},
      {"operations[]", "ratio", [](const Scene& s) { return s.operations.at(10).ratio; }, 0.62},
      {"program[]", "steering_toolface_deg", [](const Scene& s) { return s.program.at(4).steering_toolface; }, 92.0 * degree},
      {"program[]", "steering_ratio", [](const Scene& s) { return s.program.at(4).steering_ratio; }, 0.61},
      {"string[]", "bit_to_pads", [](const Scene& s) { return s.string.at(5).steerable->bit_to_pads; }, 48.5},
      {"string[]", "pad_force", [](const Scene& s) { return s.string.at(5).steerable->pad_force; }, 15001.0},
      {"string[]", "downlink_bit_time", [](const Scene& s) { return s.string.at(5).steerable->downlink_bit_time; }, 13.1},
  };
}

}  // namespace drill_rig_sim

#endif
