// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/hydraulics/mud_circuit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <utility>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
// Pa per psi, kg/m3 per lb/gal, m per ft, m3/s per gal/min
constexpr double psi = 6894.757, pound_per_gallon = 119.8264, foot = 0.3048, inch = 0.0254, gallon_per_minute = 6.30902e-5;
constexpr double narrowest = 1e-3;  // annulus and bore are never taken narrower [m]

/// What the mud loses along a metre at the pump's largest flow: by the rheology, each section worked out once, or by the rules of
/// thumb.
class Gradients
{
public:
  explicit Gradients(const MudWay& way) : way_(way)
  {
    if (way.rheology) curve_ = curve_of(*way.rheology, way.mud.viscosity);
  }

  double in_bore(double diameter)
  {
    return way_.rheology ? by_law(bore_of(diameter)) : bore_gradient(way_.mud.density, way_.pump.max_flow, diameter);
  }
  double in_annulus(double hole, double diameter)
  {
    return way_.rheology ? by_law(annulus_of(hole, diameter))
                         : annulus_gradient(way_.mud.density, way_.pump.max_flow, hole, diameter);
  }
  Passage bore_of(double diameter) const { return {std::max(diameter, narrowest), 0.0, 0.0}; }
  Passage annulus_of(double hole, double diameter) const
  {
    return {std::max(hole, diameter + narrowest), diameter, way_.rheology->eccentricity};
  }
  const Rheology& curve() const { return curve_; }

private:
  double by_law(const Passage& passage)
  {
    const auto found = known_.find({passage.outer, passage.inner});
    if (found != known_.end()) return found->second;
    return known_[{passage.outer, passage.inner}] =
               pressure_gradient(curve_, way_.mud.density, passage, way_.pump.max_flow / passage.area());
  }

  const MudWay& way_;
  Rheology curve_;
  std::map<std::pair<double, double>, double> known_;
};

/// An element's stretch of bore and annulus.
struct Stretch
{
  double bore_volume = 0.0, bore_gel = 0.0, bore_loss = 0.0;  // m3, m/m, Pa at nominal flow
  double annulus_volume = 0.0, annulus_gel = 0.0, annulus_loss = 0.0;
  double hole = 0.0;       // diameter [m]; 0 above the rotary table
  double displaced = 0.0;  // area that displaces mud as the string moves, with what clings to it [m2]

  Stretch& operator+=(const Stretch& s) noexcept
  {
    bore_volume += s.bore_volume;
    bore_gel += s.bore_gel;
    bore_loss += s.bore_loss;
    annulus_volume += s.annulus_volume;
    annulus_gel += s.annulus_gel;
    annulus_loss += s.annulus_loss;
    return *this;
  }
};

double diameter_of(double area) noexcept
{
  return std::sqrt(4.0 / pi * area);
}

Stretch stretch_of(const MudWay& way, const Mesh& mesh, std::size_t e, Gradients& gradients)
{
  const MeshElement& element = mesh.elements[e];
  const double length = element.section.length;
  Stretch out;
  if (element.bore_area > 0.0)
  {
    const double bore = diameter_of(element.bore_area);
    out.bore_volume = element.bore_area * length;
    out.bore_gel = 4.0 * length / std::max(bore, narrowest);
    out.bore_loss = gradients.in_bore(bore) * length;
  }
  const double md = way.bit_depth - mesh.middle(e);
  const double hole = way.hole[section_at(way.hole, md)].diameter, gap = hole - element.outer_diameter;
  if (md <= 0.0 || gap <= 0.0) return out;
  out.hole = hole;
  const double annulus_area = 0.25 * pi * hole * hole - element.outer_area;
  out.displaced = element.outer_area + clinging_constant(element.outer_diameter / hole) * annulus_area;
  out.annulus_volume = annulus_area * length;
  out.annulus_gel = 4.0 * length / std::max(gap, narrowest);
  out.annulus_loss = gradients.in_annulus(hole, element.outer_diameter) * length;
  return out;
}

/// Lengths of alike passages: of the bore, and of the annulus.
MudSections sections_of(const MudWay& way, const Mesh& mesh, const std::vector<Stretch>& stretches, const Gradients& gradients)
{
  MudSections out;
  const auto add = [](std::vector<PassageLength>& list, const Passage& passage, double length)
  {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const PassageLength& one)
                                    { return one.passage.outer == passage.outer && one.passage.inner == passage.inner; });
    if (found != list.end())
      found->length += length;
    else
      list.push_back({passage, length});
  };
  for (std::size_t e = 0; e < stretches.size(); ++e)
  {
    const MeshElement& element = mesh.elements[e];
    if (stretches[e].bore_loss > 0.0) add(out.bore, gradients.bore_of(diameter_of(element.bore_area)), element.section.length);
    if (stretches[e].hole > 0.0)
      add(out.annulus, gradients.annulus_of(stretches[e].hole, element.outer_diameter), element.section.length);
  }
  for (const SurfaceLine& line : way.pump.surface_lines) add(out.lines, {line.diameter, 0.0, 0.0}, line.length);
  const std::optional<BitSpec>& bit = way.string.front().bit;
  out.nozzle_area = bit ? bit->flow_area() : 0.0;
  return out;
}

/// Of all mud from the coldest to the warmest.
WarmRange warm_range(const MudTemperatureSpec& spec, double depth)
{
  constexpr double new_hole = 1000.0, by_friction = 20.0, boiling_brine = 300.0;  // [m], [K], [degC]
  const double ground = ground_temperature(spec, depth + new_hole), coldest = std::min({spec.inlet, spec.surface, ground});
  const double warmest = std::min(std::max({spec.inlet, spec.surface, ground}) + by_friction, boiling_brine);
  constexpr double denser = 1.1, lighter = 0.85;  // of the density
  return {{viscosity_factor(spec, warmest) / denser, viscosity_factor(spec, coldest) / lighter},
          viscosity_factor(spec, spec.inlet)};
}

/// By the rheology.
void lose_by_law(const MudWay& way, const MudSections& sections, const Gradients& gradients, MudCircuit& out)
{
  const double flow = way.pump.max_flow;
  SectionLosses& law = out.circuit.law;
  const WarmRange warm = way.temperature ? warm_range(*way.temperature, way.bit_depth) : WarmRange();
  law = section_losses(gradients.curve(), way.mud.density, sections, flow, way.temperature ? &warm : nullptr);
  const double lines = law.lines_loss(flow), bore = law.bore.at(flow).loss, inner = law.inner(flow).loss;
  out.losses = {lines, bore, inner - lines - bore, law.outer(flow, 0.0).loss};
  out.circuit.bore.loss = inner;
  out.rotation_factor = way.rheology->rotation_factor;
}

/// What pressure_coefficient leaves of the rules of thumb, the bore's first to give way.
void lose_by_coefficient(const MudPumpSpec& pump, const Stretch& all, MudCircuit& out)
{
  const double total = pump.pressure_coefficient * pump.max_flow * pump.max_flow;
  const double annulus = std::min(all.annulus_loss, total), inner = total - annulus, bore = std::min(all.bore_loss, inner);
  out.losses = {0.0, bore, inner - bore, annulus};
  out.circuit.bore.loss = inner;
}

/// The mean of what displaces mud: so much, wherever it is, makes the moving string's losses; none where nothing is lost.
double displaced_area(const std::vector<Stretch>& stretches, const MudCircuit& mud)
{
  if (mud.circuit.annulus.loss <= 0.0) return 0.0;
  double mean = 0.0;
  for (std::size_t e = 0; e < stretches.size(); ++e)
    mean += mud.annulus_here[e] * std::pow(stretches[e].displaced, mud.circuit.exponent);
  return std::pow(mean, 1.0 / mud.circuit.exponent);
}

/// Where along the string the losses lie.
void share_losses(const std::vector<Stretch>& stretches, const Stretch& all, MudCircuit& out)
{
  out.bore_above.assign(stretches.size(), 0.0);
  out.bore_here = out.annulus_above = out.annulus_here = out.bore_above;
  double bore = 0.0, annulus = 0.0;
  for (std::size_t e = stretches.size(); e-- > 0;)  // from the top down
  {
    const double bore_here = all.bore_loss > 0.0 ? stretches[e].bore_loss / all.bore_loss : 0.0;
    const double here = all.annulus_loss > 0.0 ? stretches[e].annulus_loss / all.annulus_loss : 0.0;
    out.bore_above[e] = bore + 0.5 * bore_here;
    out.bore_here[e] = bore_here;
    out.annulus_above[e] = annulus + 0.5 * here;
    out.annulus_here[e] = here;
    bore += bore_here;
    annulus += here;
  }
}

/// Number of the section that a passage is of.
std::size_t section_of(const std::vector<PassageLength>& sections, const Passage& passage)
{
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [&](const PassageLength& one)
                                  { return one.passage.outer == passage.outer && one.passage.inner == passage.inner; });
  return static_cast<std::size_t>(found - sections.begin());
}

/// Number and length of that section.
void set_section(const std::vector<PassageLength>& sections, const Passage& passage, WaveStretch& out)
{
  out.section = section_of(sections, passage);
  out.section_length = sections[out.section].length;
}

/// The sections of the elements.
void number_sections(const Mesh& mesh, const std::vector<Stretch>& stretches, const MudSections& sections,
                     const Gradients& gradients, MudCircuit& out)
{
  out.bore_section.assign(stretches.size(), MudCircuit::no_section);
  out.annulus_section = out.bore_section;
  for (std::size_t e = 0; e < stretches.size(); ++e)
  {
    const MeshElement& element = mesh.elements[e];
    if (stretches[e].bore_loss > 0.0)
      out.bore_section[e] = section_of(sections.bore, gradients.bore_of(diameter_of(element.bore_area)));
    if (stretches[e].hole > 0.0)
      out.annulus_section[e] = section_of(sections.annulus, gradients.annulus_of(stretches[e].hole, element.outer_diameter));
  }
}

/// The cell of each middle of a line's stretches, in their order.
std::vector<std::size_t> cells_of(const std::vector<WaveStretch>& stretches, std::size_t cells)
{
  double length = 0.0, from = 0.0;
  for (const WaveStretch& stretch : stretches) length += stretch.length;
  std::vector<std::size_t> out;
  for (const WaveStretch& stretch : stretches)
  {
    out.push_back(
        std::min(cells - 1, static_cast<std::size_t>((from + 0.5 * stretch.length) / length * static_cast<double>(cells))));
    from += stretch.length;
  }
  return out;
}

/// Cells of bore and annulus for pressure waves.
PressureWaves waves_of(const MudWay& way, const Mesh& mesh, const std::vector<Stretch>& stretches, const MudSections& sections,
                       const Gradients& gradients, double gel)
{
  std::vector<WaveStretch> bore, annulus;  // downwards, upwards
  std::vector<std::size_t> in_bore, in_annulus;
  for (std::size_t e = 0; e < stretches.size(); ++e)
  {
    const MeshElement& element = mesh.elements[e];
    const Stretch& s = stretches[e];
    if (s.bore_loss > 0.0)
    {
      WaveStretch down{element.section.length, s.bore_volume, 0.0, s.bore_gel * gel};
      set_section(sections.bore, gradients.bore_of(diameter_of(element.bore_area)), down);
      bore.insert(bore.begin(), down);
      in_bore.insert(in_bore.begin(), e);
    }
    if (s.hole <= 0.0) continue;
    WaveStretch up{element.section.length, s.annulus_volume, element.outer_area, s.annulus_gel * gel};
    set_section(sections.annulus, gradients.annulus_of(s.hole, element.outer_diameter), up);
    annulus.push_back(up);
    in_annulus.push_back(e);
  }
  PressureWaves out;
  if (bore.empty() || annulus.empty()) return out;
  const auto length_of = [](const std::vector<WaveStretch>& line)
  {
    double sum = 0.0;
    for (const WaveStretch& stretch : line) sum += stretch.length;
    return sum;
  };
  const double speed = std::sqrt(way.mud.bulk_modulus / way.mud.density);
  out.spec = *way.waves;
  out.density = way.mud.density;
  out.tick = wave_tick(length_of(bore), speed);
  const auto cells = [&](const std::vector<WaveStretch>& line)
  { return static_cast<std::size_t>(std::max(2.0, std::round(length_of(line) / (speed * out.tick)))); };
  out.bore = wave_line(bore, cells(bore), out.tick, way.mud.bulk_modulus);
  out.annulus = wave_line(annulus, cells(annulus), out.tick, way.mud.bulk_modulus);
  out.bore_losses = bore_section_losses(gradients.curve(), way.mud.density, sections, way.pump.max_flow);
  out.bore_cell.assign(stretches.size(), out.bore.cells() - 1);  // the bit's own is the lowest
  out.annulus_cell.assign(stretches.size(), PressureWaves::no_cell);
  const std::vector<std::size_t> bore_cells = cells_of(bore, out.bore.cells()),
                                 annulus_cells = cells_of(annulus, out.annulus.cells());
  for (std::size_t k = 0; k < bore.size(); ++k) out.bore_cell[in_bore[k]] = bore_cells[k];
  for (std::size_t k = 0; k < annulus.size(); ++k) out.annulus_cell[in_annulus[k]] = annulus_cells[k];
  return out;
}

/// What pressures do to an element.
void add_forces(const MudWay& way, const MeshElement& element, const Stretch& stretch, double annulus_here, MudCircuit& out)
{
  const double poisson = way.string[static_cast<std::size_t>(element.part)].poisson_ratio;
  const double per_area = (1.0 - 2.0 * poisson) / element.section.axial;
  out.stretch_by_bore.push_back(per_area * element.bore_area);
  out.stretch_by_annulus.push_back(-per_area * element.outer_area);
  out.lift.push_back(0.25 * pi * element.outer_diameter * stretch.hole * annulus_here);
  out.speed_weight.push_back(0.5 * out.lift.back() / element.section.length);
}
}  // namespace

double annulus_gradient(double density, double flow, double hole_diameter, double diameter) noexcept
{
  const double gap = hole_diameter - diameter;
  if (gap <= 0.0) return 0.0;
  const double speed = flow / (0.25 * pi * gap * (hole_diameter + diameter));
  return 2.0 * annulus_friction * density * speed * speed / std::max(gap, narrowest);
}

double bore_gradient(double density, double flow, double diameter) noexcept
{
  return 6.1e-5 * psi / foot * (density / pound_per_gallon) * std::pow(flow / gallon_per_minute, 1.86) /
         std::pow(std::max(diameter, narrowest) / inch, 4.86);
}

MudCircuit mud_circuit(const MudWay& way, const Mesh& mesh)
{
  std::vector<Stretch> stretches;
  Stretch all;
  Gradients gradients(way);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    stretches.push_back(stretch_of(way, mesh, e, gradients));
    all += stretches.back();
  }
  MudCircuit out;
  out.tubular_loss = all.bore_loss + all.annulus_loss;
  out.circuit.nominal_flow = way.pump.max_flow;
  out.circuit.exponent = way.pump.loss_exponent;
  const MudSections sections = way.rheology ? sections_of(way, mesh, stretches, gradients) : MudSections();
  way.rheology ? lose_by_law(way, sections, gradients, out) : lose_by_coefficient(way.pump, all, out);
  const double inner = out.circuit.bore.loss;
  // of a gel, what the law has as its yield stress is no more
  const double gel = way.rheology ? std::max(0.0, way.mud.gel_strength - gradients.curve().yield_stress) : way.mud.gel_strength;
  out.circuit.bore = {all.bore_volume / way.mud.bulk_modulus, inner, all.bore_gel * gel};
  out.circuit.annulus = {all.annulus_volume / way.mud.bulk_modulus, out.losses.annulus, all.annulus_gel * gel};
  out.bore_friction = inner > 0.0 ? out.losses.bore / inner : 0.0;
  share_losses(stretches, all, out);
  if (way.rheology && way.temperature) number_sections(mesh, stretches, sections, gradients, out);
  if (way.rheology && way.waves) out.waves = waves_of(way, mesh, stretches, sections, gradients, gel);
  out.displaced_area = way.rheology ? out.circuit.law.displaced_area : displaced_area(stretches, out);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    add_forces(way, mesh.elements[e], stretches[e], out.annulus_here[e], out);
  const double lift = std::accumulate(out.lift.begin(), out.lift.end(), 0.0);
  for (double& weight : out.speed_weight) weight /= lift > 0.0 ? lift : 1.0;
  return out;
}

std::string doubt_of_pressures(const MudCircuit& mud)
{
  const double lost = mud.circuit.bore.loss + mud.circuit.annulus.loss;
  if (mud.circuit.law.any() || lost <= 0.0 || mud.tubular_loss < lost) return {};
  char text[240];
  const double flow = mud.circuit.nominal_flow;
  std::snprintf(text, sizeof text,
                "at the pump's largest flow, %.3g m3/s, bore and annulus lose %.2f MPa: rig.mud_pump.pressure_coefficient is too "
                "small for any pressure drop at the bit; use more than %.3g",
                flow, mud.tubular_loss / 1e6, mud.tubular_loss / (flow * flow));
  return text;
}

double annulus_share(const MudCircuit& mud, const Mesh& mesh, double from_bit) noexcept
{
  for (std::size_t e = 0; e < mud.annulus_here.size(); ++e)
  {
    const double lower = mesh.nodes[e].from_bit, upper = mesh.nodes[e + 1].from_bit;
    if (from_bit > upper) continue;
    const double inside = std::max(0.0, from_bit - lower) / (upper - lower);
    return mud.annulus_above[e] + (0.5 - inside) * mud.annulus_here[e];
  }
  return 0.0;
}

MudPressures mud_pressures(const MudCircuit& mud, const HydraulicState& state, double flow, const LossPlaces* warm,
                           double head) noexcept
{
  const HydraulicCircuit& c = mud.circuit;
  const double annulus = state.annulus_pressure - head;
  if (flow <= 0.0) return {state.stand_pipe_pressure, 0.0, 0.0, annulus};
  if (c.law.any()) return {state.stand_pipe_pressure, c.law.lines_loss(flow), c.law.in_bore(flow, warm).loss, annulus};
  return {state.stand_pipe_pressure, 0.0, mud.bore_friction * c.bore.loss * std::pow(flow / c.nominal_flow, c.exponent), annulus};
}

MudPressures wave_pressures(const HydraulicState& state, const PressureWaveState& waves, double load, double head) noexcept
{
  MudPressures out;
  out.stand_pipe = state.stand_pipe_pressure;
  out.annulus = state.annulus_pressure - head;
  out.load = load;
  out.waves = &waves;
  return out;
}

}  // namespace drill_rig_sim
