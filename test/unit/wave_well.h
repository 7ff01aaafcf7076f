// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_WAVE_WELL_H
#define DRILL_RIG_SIM_TEST_WAVE_WELL_H

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/hydraulics/pressure_waves.h"
#include "drill_rig_sim/hydraulics/pump_strokes.h"
#include "drill_rig_sim/math/units.h"

/// Plain pipe in a plain hole, for tests of pressure waves against closed forms.
namespace drill_rig_sim::wave_well
{
constexpr double density = 1200.0, bulk_modulus = 1.4e9, length = 1080.12345, diameter = 0.1086;
constexpr double hole = 0.2159, outside = 0.127, largest_flow = 0.06;
const double wave_speed = std::sqrt(bulk_modulus / density);
const Rheology water = {0.0, 1e-3, 1.0}, bingham = {5.0, 0.02, 1.0};

inline double disc(double d)
{
  return 0.25 * pi * d * d;
}

/// Plain pipe in a plain hole.
struct Well
{
  MudPumpSpec pump;
  HydraulicCircuit circuit;
  PressureWaves waves;
  WaveLoads loads;
  HydraulicState mud;
  PressureWaveState state;
  double flow = 0.0, time = 0.0, returned = 0.0;

  /// @param friction  factor on the losses of pipe and annulus
  explicit Well(const Rheology& law = water, double friction = 1.0, double nozzle_area = 4e-4, double gel = 0.0)
  {
    pump.flow_ramp = 1e6;
    pump.relief_pressure = 1e9;
    MudSections sections;
    sections.bore = {{{diameter, 0.0, 0.0}, friction * length}};
    sections.annulus = {{{hole, outside, 0.0}, friction * length}};
    sections.nozzle_area = nozzle_area;
    circuit.nominal_flow = pump.max_flow = largest_flow;
    circuit.law = section_losses(law, density, sections, largest_flow);
    waves.spec.cylinders = 0;
    waves.spec.dampener_volume = 0.0;
    waves.density = density;
    waves.tick = wave_tick(length, wave_speed);
    const std::size_t cells = static_cast<std::size_t>(std::lround(length / wave_speed / waves.tick));
    const auto line = [&](double area, double displaced)
    {
      const std::vector<WaveStretch> stretches = {{0.3 * length, 0.3 * length * area, displaced, 0.3 * gel, 0, length},
                                                  {0.7 * length, 0.7 * length * area, displaced, 0.7 * gel, 0, length}};
      return wave_line(stretches, cells, waves.tick, bulk_modulus);
    };
    waves.bore = line(disc(diameter), 0.0);
    waves.annulus = line(around(), disc(outside));
    waves.bore_losses = bore_section_losses(law, density, sections, largest_flow);
    waves.bore_cell = {cells - 1, cells / 2, 0};
    waves.annulus_cell = {0, cells / 2, cells - 1};
    state = waves_at_rest(waves, 0.0, 0.0);
  }

  static double around() { return disc(hole) - disc(outside); }
  double bore_impedance() const { return density * wave_speed / disc(diameter); }
  double travel() const { return length / wave_speed; }
  /// A tick at a commanded flow.
  void tick(double commanded)
  {
    advance_pressure_waves(pump, circuit, waves, commanded, loads, time, waves.tick, flow, mud, state);
    time += waves.tick;
    returned += state.return_flow * waves.tick;
  }
  /// At a commanded flow until a time [s]; calls look() behind each tick.
  template <class Look>
  void run(double commanded, double until, const Look& look)
  {
    while (time + 0.5 * waves.tick < until)
    {
      tick(commanded);
      look();
    }
  }
  void run(double commanded, double until)
  {
    run(commanded, until, [] {});
  }
  /// Compression of mud and gas.
  double held() const { return stored_mud(waves, state) + waves.spec.dampener_volume - state.gas; }
};
}  // namespace drill_rig_sim::wave_well

#endif
