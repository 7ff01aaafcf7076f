// SPDX-License-Identifier: BSD-3-Clause
// Cells of the pressure waves, and what they hold.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/pressure_waves.h"

namespace drill_rig_sim
{
namespace
{
constexpr double longest_tick = 0.03, shortest_tick = 0.005;  // [s]
constexpr double cells_wanted = 50.0, fewest_cells = 2.0;
}  // namespace

double wave_tick(double length, double wave_speed) noexcept
{
  const double wanted = std::clamp(length / (cells_wanted * wave_speed), shortest_tick, longest_tick);
  return length / wave_speed / std::max(fewest_cells, std::round(length / (wave_speed * wanted)));
}

WaveLine wave_line(const std::vector<WaveStretch>& stretches, std::size_t cells, double tick, double bulk_modulus)
{
  double length = 0.0;
  for (const WaveStretch& stretch : stretches) length += stretch.length;
  const double cell = length / static_cast<double>(cells);
  std::vector<double> volume(cells, 0.0), displaced(cells, 0.0);
  std::vector<std::vector<WaveLine::Share>> shares(cells + 1);
  WaveLine out;
  out.nodes.resize(cells + 1);
  const auto add_share = [&](std::size_t node, std::size_t section, double share)
  {
    for (WaveLine::Share& one : shares[node])
      if (one.section == section) return static_cast<void>(one.share += share);
    shares[node].push_back({section, share});
  };
  double from = 0.0;  // in half cells: half cell 2 k and 2 k + 1 are of cell k, half cell i belongs to node (i + 1)/2
  for (const WaveStretch& stretch : stretches)
  {
    const double to = from + stretch.length / (0.5 * cell);
    for (std::size_t i = static_cast<std::size_t>(from); i < 2 * cells && static_cast<double>(i) < to; ++i)
    {
      const double inside = (std::min(to, static_cast<double>(i + 1)) - std::max(from, static_cast<double>(i))) * 0.5 * cell;
      const double share = inside / stretch.length;
      const std::size_t node = (i + 1) / 2;
      volume[i / 2] += share * stretch.volume;
      displaced[i / 2] += inside / cell * stretch.outside;
      add_share(node, stretch.section, inside / stretch.section_length);
      out.nodes[std::clamp<std::size_t>(node, 1, cells - 1)].gel += share * stretch.gel;
    }
    from = to;
  }
  for (std::size_t k = 0; k < cells; ++k) out.impedance.push_back(tick * bulk_modulus / volume[k]);
  out.outside = displaced;
  for (std::size_t j = 0; j <= cells; ++j)
  {
    out.nodes[j].first = out.shares.size();
    out.shares.insert(out.shares.end(), shares[j].begin(), shares[j].end());
    out.nodes[j].last = out.shares.size();
  }
  return out;
}

PressureWaveState waves_at_rest(const PressureWaves& waves, double time, double strokes)
{
  PressureWaveState out;
  if (!waves.any()) return out;
  out.time = time;
  out.strokes = strokes;
  out.gas = waves.spec.dampener_volume;
  for (auto* wave : {&out.bore_with, &out.bore_against}) wave->assign(waves.bore.cells(), 0.0);
  for (auto* wave : {&out.annulus_with, &out.annulus_against}) wave->assign(waves.annulus.cells(), 0.0);
  return out;
}

double stored_mud(const PressureWaves& waves, const PressureWaveState& state) noexcept
{
  double sum = 0.0;
  for (std::size_t k = 0; k < waves.bore.cells(); ++k) sum += waves.tick / waves.bore.impedance[k] * state.in_bore(k);
  for (std::size_t k = 0; k < waves.annulus.cells(); ++k) sum += waves.tick / waves.annulus.impedance[k] * state.in_annulus(k);
  return sum;
}

}  // namespace drill_rig_sim
