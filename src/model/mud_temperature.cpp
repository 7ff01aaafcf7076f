// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/mud_temperature.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/place_drag.h"

namespace drill_rig_sim
{
namespace
{
constexpr double heat_cells = 200.0;
constexpr double shortest_heat_cell = 10.0;  // [m]
constexpr double hole_to_come = 1000.0;      // [m]
constexpr double least_length = 0.01;        // of the lowest cell [m]

/// The hole with the string in it, as cells.
class HeatColumn
{
public:
  HeatColumn(const Model& model, const State& state) noexcept
      : model_(model), state_(state), bit_depth_(depth_of_bit(model, state)), hole_depth_(state.well.hole_depth())
  {
    count_ = cell_at(hole_depth_) + 1;
    flown_ = std::min(cell_at(bit_depth_) + 1, count_);
    find_hole();
    for (std::size_t e = 0; e < model.mesh().elements.size(); ++e) add_string(e);
  }

  std::size_t count() const noexcept { return count_; }
  std::size_t flown() const noexcept { return flown_; }
  const HeatCell* cells() const noexcept { return cells_.data(); }
  /// True vertical depths of a cell's ends, the lower one not below the bit's [m].
  double top(std::size_t i) const noexcept { return depth_[i]; }
  double foot(std::size_t i) const noexcept { return i + 1 == flown_ ? bit_tvd_ : depth_[i + 1]; }

  /// Of the mud around the bit: its difference from the ground goes over from that of the cell above to that of the bit's cell as
  /// the bit goes through this. So nothing jumps when mud begins to flow, the bit moves or the hole grows: outlets do not, and
  /// what rests below the bit has no part in it.
  double annulus_at_bit(const std::vector<double>& annulus) const noexcept
  {
    const auto over_ground = [&](std::size_t i) { return annulus[i] - cells_[i].ground; };
    const std::size_t here = flown_ - 1, above = here > 0 ? here - 1 : 0;
    const double share = std::clamp(bit_depth_ / length() - static_cast<double>(here), 0.0, 1.0);
    return ground_temperature(model_.heat()->spec, bit_tvd_) + share * over_ground(here) + (1.0 - share) * over_ground(above);
  }

  /// Puts what friction dissipates at a flow into the cells; returns what bit and motor do [W].
  double heat_by_friction(double flow) noexcept
  {
    if (flow <= 0.0) return 0.0;
    const MudCircuit& mud = model_.mud();
    const LossPlaces& places = state_.temperature.losses;
    bore_power_ = flow * mud.circuit.law.in_bore(flow, &places).loss;
    annulus_power_ = flow * mud.circuit.law.outer(flow, 0.0, &places).loss;
    for (std::size_t e = 0; e < mud.bore_here.size(); ++e) add_power(e);
    const MotorSpec* motor = model_.motor();
    const double over_motor = motor ? mud_motor_pressure(flow, motor->pressure_displacement(), motor_load(model_, state_)) : 0.0;
    return flow * (mud.circuit.law.nozzles(flow, &places) + over_motor);
  }

  /// Calls at(cell, share) for each cell that an element lies in, by its share of the element's length.
  template <class At>
  void each_cell_of(std::size_t e, const At& at) const noexcept
  {
    const double lower = bit_depth_ - model_.mesh().nodes[e].from_bit, upper = bit_depth_ - model_.mesh().nodes[e + 1].from_bit;
    if (lower <= 0.0) return;
    for (std::size_t i = std::min(cell_at(std::max(upper, 0.0)), flown_ - 1);; ++i)
    {
      const double from = std::max(upper, static_cast<double>(i) * length());
      const double to = i + 1 == flown_ ? lower : std::min(lower, static_cast<double>(i + 1) * length());
      if (to > from) at(i, (to - from) / (lower - upper));
      if (i + 1 == flown_ || to >= lower) return;
    }
  }

private:
  double length() const noexcept { return state_.temperature.cell_length; }
  std::size_t cell_at(double md) const noexcept
  {
    const std::size_t last = state_.temperature.heat.bore.size() - 1;
    return std::min(static_cast<std::size_t>(std::max(md, 0.0) / length()), last);
  }

  void find_hole() noexcept
  {
    const MudTemperatureSpec& spec = model_.heat()->spec;
    int segment = state_.nodes.front().segment;
    const auto tvd = [&](double md) { return -state_.well.at(md, segment).position.z(); };
    bit_tvd_ = tvd(bit_depth_);
    depth_[0] = 0.0;
    for (std::size_t i = 0; i < count_; ++i)
    {
      const double top = static_cast<double>(i) * length(), foot = i + 1 == count_ ? hole_depth_ : top + length();
      HeatCell& cell = cells_[i];
      cell.length = std::max(foot - top, least_length);
      cell.hole_radius = state_.well.at(0.5 * (top + foot), segment).radius;
      cell.annulus_volume = pi * cell.hole_radius * cell.hole_radius * cell.length;
      depth_[i + 1] = tvd(foot);
      cell.ground = ground_temperature(spec, 0.5 * (depth_[i] + depth_[i + 1]));
    }
  }

  void add_string(std::size_t e) noexcept
  {
    const MeshElement& element = model_.mesh().elements[e];
    each_cell_of(e,
                 [&](std::size_t i, double share)
                 {
                   const double length = share * element.section.length;
                   HeatCell& cell = cells_[i];
                   cell.bore_volume += length * element.holds;
                   cell.annulus_volume = std::max(0.0, cell.annulus_volume - length * element.outer_area);
                   cell.steel += length * element.linear_mass;
                   cell.pipe_surface += length * pi * element.outer_diameter;
                 });
  }

  void add_power(std::size_t e) noexcept
  {
    const double in_bore = model_.mud().bore_here[e], in_annulus = model_.mud().annulus_here[e];
    each_cell_of(e,
                 [&](std::size_t i, double share)
                 {
                   cells_[i].bore_power += share * in_bore * bore_power_;
                   cells_[i].annulus_power += share * in_annulus * annulus_power_;
                 });
  }

  const Model& model_;
  const State& state_;
  double bit_depth_, hole_depth_, bit_tvd_ = 0.0;  // [m]
  double bore_power_ = 0.0, annulus_power_ = 0.0;  // [W]
  std::size_t count_ = 0, flown_ = 0;
  std::array<HeatCell, most_heat_cells> cells_ = {};
  std::array<double, most_heat_cells + 1> depth_ = {};
};

/// A hole that rests, or new hole, which is filled by the mud above it.
void open_cells(const HeatColumn& column, bool at_rest, TemperatureState& t) noexcept
{
  HeatState& heat = t.heat;
  for (; t.opened < static_cast<int>(column.count()); ++t.opened)
  {
    const auto i = static_cast<std::size_t>(t.opened);
    const double ground = column.cells()[i].ground, mud = at_rest || i == 0 ? ground : heat.annulus_mean[i - 1];
    for (auto* along : {&heat.bore, &heat.annulus, &heat.bore_mean, &heat.annulus_mean}) (*along)[i] = mud;
    for (std::size_t k = 0; k < rock_rings; ++k) heat.rock[rock_rings * i + k] = ground;
  }
}

/// What temperature and pressure make of a column of mud down to the bit, by cell.
struct WarmColumn
{
  std::array<double, most_heat_cells> factor;   // on the flow curve
  std::array<double, most_heat_cells> density;  // over the reference's
  double head = 0.0;                            // over the reference's weight [Pa]

  WarmColumn(const HeatMud& mud, const HeatColumn& column, const std::vector<double>& temperature) noexcept
  {
    double pressure = 0.0, reference = 0.0;
    for (std::size_t i = 0; i < column.flown(); ++i)
    {
      const double weight = standard_gravity * mud.density * (column.foot(i) - column.top(i));
      factor[i] = viscosity_factor(mud.spec, temperature[i]);
      density[i] = density_ratio(mud.spec, temperature[i], pressure + 0.5 * weight);  // at the cell's middle
      pressure += density[i] * weight;
      reference += weight;
    }
    head = pressure - reference;
  }
};

void find_place(const LossFamily& losses, const SectionMean& mean, LossPlace& out) noexcept
{
  if (mean.length > 0.0) out = losses.place(mean.factor / mean.length, mean.density / mean.length);
}

void clear_means(std::vector<SectionMean>& means) noexcept
{
  for (SectionMean& mean : means) mean = SectionMean();
}

/// Adds an element to the means of its section.
void add_to_mean(const HeatColumn& column, const WarmColumn& mud, std::size_t e, double length, SectionMean& mean) noexcept
{
  column.each_cell_of(e,
                      [&](std::size_t i, double share)
                      {
                        mean.length += share * length;
                        mean.factor += share * length * mud.factor[i];
                        mean.density += share * length * mud.density[i];
                      });
}

/// What the temperatures make of losses and weights.
void take_effects(const Model& model, const HeatColumn& column, TemperatureState& t) noexcept
{
  const MudCircuit& mud = model.mud();
  const WarmColumn bore(*model.heat(), column, t.heat.bore_mean), annulus(*model.heat(), column, t.heat.annulus_mean);
  const std::size_t bottom = column.flown() - 1;
  t.heads = {bore.head, annulus.head};
  t.bit = column.annulus_at_bit(t.heat.annulus);
  t.flow_line = t.heat.annulus.front();
  t.losses.bit_density = bore.density[bottom];
  clear_means(t.in_bore);
  clear_means(t.in_annulus);
  for (std::size_t e = 0; e < mud.bore_section.size(); ++e)
  {
    const double length = model.mesh().elements[e].section.length;
    if (mud.bore_section[e] != MudCircuit::no_section) add_to_mean(column, bore, e, length, t.in_bore[mud.bore_section[e]]);
    if (mud.annulus_section[e] != MudCircuit::no_section)
      add_to_mean(column, annulus, e, length, t.in_annulus[mud.annulus_section[e]]);
  }
  const SectionLosses& law = mud.circuit.law;
  for (std::size_t i = 0; i < t.in_bore.size(); ++i) find_place(law.warm_bore[i], t.in_bore[i], t.losses.bore[i]);
  for (std::size_t i = 0; i < t.in_annulus.size(); ++i) find_place(law.annulus[i].warm, t.in_annulus[i], t.losses.annulus[i]);
}

/// One step of the cells at a flow [m3/s].
void advance_column(const Model& model, double flow, double step, State& state) noexcept
{
  TemperatureState& t = state.temperature;
  HeatColumn column(model, state);
  open_cells(column, false, t);
  const double by_bit = column.heat_by_friction(flow);
  advance_heat(*model.heat(), column.cells(), column.count(), column.flown(), {flow, by_bit, step}, t.heat);
  take_effects(model, column, t);
}
}  // namespace

void begin_temperature(const Model& model, State& state)
{
  TemperatureState& t = state.temperature;
  t = TemperatureState();
  if (!model.heat()) return;
  const double depth = state.well.hole_depth();
  t.cell_length = std::max(depth / heat_cells, shortest_heat_cell);
  const std::size_t cells =
      std::min(static_cast<std::size_t>(std::ceil((depth + hole_to_come) / t.cell_length)), most_heat_cells);
  for (auto* along : {&t.heat.bore, &t.heat.annulus, &t.heat.bore_mean, &t.heat.annulus_mean}) along->assign(cells, 0.0);
  t.heat.rock.assign(rock_rings * cells, 0.0);
  open_cells(HeatColumn(model, state), true, t);
  renew_temperature(model, state);
  circulate(model, model.scene().rig.mud_pump.max_flow, model.heat()->spec.circulated, state);
  state.hydraulics.annulus_pressure = t.heads.annulus;
}

void advance_temperature(const Model& model, double step, State& state) noexcept
{
  TemperatureState& t = state.temperature;
  if (!t.any()) return;
  t.elapsed += step;
  t.pumped += state.flow * step;
  if (t.elapsed < temperature_period) return;
  advance_column(model, std::max(0.0, t.pumped / t.elapsed), t.elapsed, state);
  t.elapsed = t.pumped = 0.0;
}

void renew_temperature(const Model& model, State& state)
{
  TemperatureState& t = state.temperature;
  if (!t.any()) return;
  const SectionLosses& law = model.mud().circuit.law;
  t.in_bore.assign(law.warm_bore.size(), SectionMean());
  t.in_annulus.assign(law.annulus.size(), SectionMean());
  t.losses.bore.assign(t.in_bore.size(), LossPlace());
  t.losses.annulus.assign(t.in_annulus.size(), LossPlace());
  take_effects(model, HeatColumn(model, state), t);
}

void circulate(const Model& model, double flow, double time, State& state) noexcept
{
  constexpr double most_steps = 1000.0, usual_step = 60.0;  // [s]
  if (!state.temperature.any() || time <= 0.0) return;
  const double steps = std::clamp(std::ceil(time / usual_step), 1.0, most_steps);
  for (int k = 0; k < static_cast<int>(steps); ++k) advance_column(model, flow, time / steps, state);
}

bool fits_temperature(const Model& model, const TemperatureState& temperature) noexcept
{
  if (!model.heat()) return !temperature.any();
  const SectionLosses& law = model.mud().circuit.law;
  const HeatState& heat = temperature.heat;
  const std::size_t cells = heat.bore.size();
  const auto has = [&](const std::vector<double>& along, std::size_t size) { return along.size() == size; };
  return cells > 0 && cells <= most_heat_cells && temperature.cell_length > 0.0 && temperature.opened > 0 &&
         static_cast<std::size_t>(temperature.opened) <= cells && has(heat.annulus, cells) && has(heat.bore_mean, cells) &&
         has(heat.annulus_mean, cells) && has(heat.rock, rock_rings * cells) &&
         temperature.in_bore.size() == law.warm_bore.size() && temperature.in_annulus.size() == law.annulus.size() &&
         temperature.losses.bore.size() == law.warm_bore.size() && temperature.losses.annulus.size() == law.annulus.size();
}

}  // namespace drill_rig_sim
