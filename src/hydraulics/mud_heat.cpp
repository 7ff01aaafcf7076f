// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/mud_heat.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
/// x = a + b y, y an unknown that is found later.
struct Linear
{
  double a = 0.0, b = 0.0;

  double at(double y) const noexcept { return a + b * y; }
};

/// Heat from the rock into the annulus, G (theta - T_a).
struct WallHeat
{
  double conductance = 0.0;  // G [W/K]
  double drive = 0.0;        // G theta [W]
};

double bore_capacity(const HeatMud& mud, const HeatCell& cell) noexcept
{
  return mud.capacity() * cell.bore_volume + steel_heat * cell.steel;
}

double ring_capacity(const HeatMud& mud, const HeatCell& cell, std::size_t k) noexcept
{
  return mud.rock.capacity[k] * cell.hole_radius * cell.hole_radius * cell.length;
}

/// Between annulus and first ring: film and rock [W/K].
double wall_conductance(const HeatMud& mud, const HeatCell& cell) noexcept
{
  const double film = mud.spec.wall_coefficient * 2.0 * pi * cell.hole_radius, rock = mud.rock.wall;
  return film > 0.0 ? cell.length * film * rock / (film + rock) : 0.0;
}

/// Of a ring's unknown by the one inside it, from the outermost inwards: T_k = a_k + b_k T_k-1. The b depend on no temperature.
void ring_slopes(const HeatMud& mud, const HeatCell& cell, double step, std::array<double, rock_rings>& slope,
                 std::array<double, rock_rings>& sum) noexcept
{
  for (std::size_t k = rock_rings; k-- > 0;)
  {
    const double inside = k > 0 ? mud.rock.conductance[k - 1] * cell.length : wall_conductance(mud, cell);
    const double outside = mud.rock.conductance[k] * cell.length * (k + 1 < rock_rings ? 1.0 - slope[k + 1] : 1.0);
    sum[k] = ring_capacity(mud, cell, k) / step + inside + outside;
    slope[k] = inside / sum[k];
  }
}

/// (3) from outside in. Leaves the a_k in the place of the temperatures.
WallHeat eliminate_rock(const HeatMud& mud, const HeatCell& cell, double step, double* ring) noexcept
{
  std::array<double, rock_rings> slope, sum;
  ring_slopes(mud, cell, step, slope, sum);
  double beyond = cell.ground;
  for (std::size_t k = rock_rings; k-- > 0;)
    beyond = ring[k] = (ring_capacity(mud, cell, k) / step * ring[k] + mud.rock.conductance[k] * cell.length * beyond) / sum[k];
  const double wall = wall_conductance(mud, cell);
  return {wall * (1.0 - slope[0]), wall * ring[0]};
}

/// And back, where the annulus's temperature is known.
void find_rock(const HeatMud& mud, const HeatCell& cell, double step, double annulus, double* ring) noexcept
{
  std::array<double, rock_rings> slope, sum;
  ring_slopes(mud, cell, step, slope, sum);
  double inside = annulus;
  for (std::size_t k = 0; k < rock_rings; ++k) inside = ring[k] += slope[k] * inside;
}

/// theta of (4): what of a cell's mean is the temperature at its inlet.
double inlet_share(double exchanged, double carried) noexcept
{
  if (carried <= 0.0) return 0.0;
  const double n = exchanged / carried;
  return n < 1e-4 ? 0.5 - n / 12.0 : 1.0 / n - 1.0 / std::expm1(n);
}

/// Coefficients of a cell's balances.
struct CellBalance
{
  double pipe = 0.0, carried = 0.0;              // H_p, W [W/K]
  double bore_held = 0.0, annulus_held = 0.0;    // capacities over the step [W/K]
  double bore_inlet = 0.0, annulus_inlet = 0.0;  // theta
  WallHeat wall;

  double bore_mean(double inlet, double outlet) const noexcept { return outlet + bore_inlet * (inlet - outlet); }
  double annulus_mean(double inlet, double outlet) const noexcept { return outlet + annulus_inlet * (inlet - outlet); }
};

CellBalance balance_of(const HeatMud& mud, const HeatCell& cell, double step, double carried, const WallHeat& wall) noexcept
{
  CellBalance out;
  out.pipe = mud.spec.pipe_coefficient * cell.pipe_surface;
  out.carried = carried;
  out.bore_held = bore_capacity(mud, cell) / step;
  out.annulus_held = mud.capacity() * cell.annulus_volume / step;
  out.bore_inlet = inlet_share(out.pipe, carried);
  out.annulus_inlet = inlet_share(out.pipe + wall.conductance, carried);
  out.wall = wall;
  return out;
}

/// A cell's temperatures at its outlets, by that at the annulus's inlet.
struct CellTemperatures
{
  Linear bore, annulus;
};

/// (1) and (2) of a cell.
/// @param above  temperature at the bore's inlet by that at the annulus's outlet
CellTemperatures solve_cell(const CellBalance& c, const HeatCell& cell, const Linear& above, double bore, double annulus) noexcept
{
  const double from_bore = c.pipe * (1.0 - c.bore_inlet), from_inlet = c.pipe * c.bore_inlet;
  const double wetted = c.pipe + c.wall.conductance;
  const double bore_sum = c.bore_held + c.carried + from_bore, moved = c.carried - from_inlet;
  // T_b = fixed + by_outlet T_a + by_inlet T_a,below
  double fixed = bore, by_outlet = 0.0, by_inlet = 0.0;
  if (bore_sum > 0.0)
  {
    fixed = (c.bore_held * bore + cell.bore_power + moved * above.a) / bore_sum;
    by_outlet = (moved * above.b + c.pipe * (1.0 - c.annulus_inlet)) / bore_sum;
    by_inlet = c.pipe * c.annulus_inlet / bore_sum;
  }
  const double sum = c.annulus_held + c.carried + wetted * (1.0 - c.annulus_inlet) - from_inlet * above.b - from_bore * by_outlet;
  const double known = c.annulus_held * annulus + c.wall.drive + cell.annulus_power + from_inlet * above.a + from_bore * fixed;
  CellTemperatures out{{fixed, 0.0}, {annulus, 0.0}};
  if (sum <= 0.0) return out;  // no mud there, and no heat that comes or goes
  out.annulus = {known / sum, (c.carried - wetted * c.annulus_inlet + from_bore * by_inlet) / sum};
  out.bore = {fixed + by_outlet * out.annulus.a, by_outlet * out.annulus.b + by_inlet};
  return out;
}
}  // namespace

RockGrid rock_grid(const MudTemperatureSpec& spec)
{
  RockGrid out;
  const double per_log = 2.0 * pi * spec.rock_conductivity, stored = pi * spec.rock_conductivity / spec.rock_diffusivity;
  double inner = 1.0, width = first_ring, middle = 1.0;
  for (std::size_t k = 0; k < rock_rings; ++k)
  {
    const double outer = inner + width, next = std::sqrt(inner * outer);
    (k > 0 ? out.conductance[k - 1] : out.wall) = per_log / std::log(next / middle);
    out.capacity[k] = stored * (outer * outer - inner * inner);
    middle = next;
    inner = outer;
    width *= ring_growth;
  }
  out.conductance.back() = per_log / std::log(inner / middle);
  return out;
}

void advance_heat(const HeatMud& mud, const HeatCell* cells, std::size_t count, std::size_t flown, const HeatFlow& flow,
                  HeatState& state) noexcept
{
  std::array<CellBalance, most_heat_cells> balance;
  std::array<CellTemperatures, most_heat_cells> by_inlet;
  Linear above{mud.spec.inlet, 0.0};
  for (std::size_t i = 0; i < count; ++i)
  {
    const WallHeat wall = eliminate_rock(mud, cells[i], flow.step, &state.rock[rock_rings * i]);
    balance[i] = balance_of(mud, cells[i], flow.step, i < flown ? mud.capacity() * flow.flow : 0.0, wall);
    by_inlet[i] = solve_cell(balance[i], cells[i], above, state.bore[i], state.annulus[i]);
    above = by_inlet[i].bore;
  }
  const double by_bit = flow.flow > 0.0 ? flow.bit_power / (mud.capacity() * flow.flow) : 0.0;  // [K]
  double below = 0.0;                                                                           // at rest it counts for nothing
  for (std::size_t i = count; i-- > 0;)
  {
    const CellTemperatures& cell = by_inlet[i];
    if (i + 1 == flown) below = (cell.bore.a + by_bit) / (1.0 - cell.bore.b);  // the annulus is fed from the bore
    state.bore[i] = cell.bore.at(below);
    state.annulus[i] = cell.annulus.at(below);
    state.annulus_mean[i] = balance[i].annulus_mean(below, state.annulus[i]);
    find_rock(mud, cells[i], flow.step, state.annulus_mean[i], &state.rock[rock_rings * i]);
    below = state.annulus[i];
  }
  for (std::size_t i = 0; i < flown; ++i)
    state.bore_mean[i] = balance[i].bore_mean(i > 0 ? state.bore[i - 1] : mud.spec.inlet, state.bore[i]);
  for (std::size_t i = flown; i < count; ++i)  // a string that is run in there is filled by the mud that it finds
  {
    state.bore[i] = state.annulus[i];
    state.bore_mean[i] = state.annulus_mean[i];
  }
}

double stored_heat(const HeatMud& mud, const HeatCell* cells, std::size_t count, const HeatState& state) noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    sum += bore_capacity(mud, cells[i]) * state.bore[i] + mud.capacity() * cells[i].annulus_volume * state.annulus[i];
    for (std::size_t k = 0; k < rock_rings; ++k) sum += ring_capacity(mud, cells[i], k) * state.rock[rock_rings * i + k];
  }
  return sum;
}

double heat_from_ground(const HeatMud& mud, const HeatCell* cells, std::size_t count, const HeatState& state) noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    sum += mud.rock.conductance.back() * cells[i].length * (cells[i].ground - state.rock[rock_rings * i + rock_rings - 1]);
  return sum;
}

}  // namespace drill_rig_sim
