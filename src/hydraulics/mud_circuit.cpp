#include "drill_rig_sim/hydraulics/mud_circuit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
// Pa per psi, kg/m3 per lb/gal, m per ft, m3/s per gal/min
constexpr double psi = 6894.757, pound_per_gallon = 119.8264, foot = 0.3048, inch = 0.0254, gallon_per_minute = 6.30902e-5;
constexpr double narrowest = 1e-3;  // annulus and bore are never taken narrower [m]

/// An element's stretch of bore and annulus.
struct Stretch
{
  double bore_volume = 0.0, bore_gel = 0.0, bore_loss = 0.0;           // m3, m/m, Pa at nominal flow
  double annulus_volume = 0.0, annulus_gel = 0.0, annulus_loss = 0.0;
  double hole = 0.0;  // diameter [m]; 0 above the rotary table
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

Stretch stretch_of(const MudWay& way, const Mesh& mesh, std::size_t e)
{
  const MeshElement& element = mesh.elements[e];
  const double length = element.section.length, density = way.mud.density, flow = way.pump.max_flow;
  Stretch out;
  if (element.bore_area > 0.0)
  {
    const double bore = std::sqrt(4.0 / pi * element.bore_area);
    out.bore_volume = element.bore_area * length;
    out.bore_gel = 4.0 * length / std::max(bore, narrowest);
    out.bore_loss = bore_gradient(density, flow, bore) * length;
  }
  const double md = way.bit_depth - mesh.middle(e);
  const double hole = way.hole[section_at(way.hole, md)].diameter, gap = hole - element.outer_diameter;
  if (md <= 0.0 || gap <= 0.0) return out;
  out.hole = hole;
  const double annulus_area = 0.25 * pi * hole * hole - element.outer_area;
  out.displaced = element.outer_area + clinging_constant(element.outer_diameter / hole) * annulus_area;
  out.annulus_volume = annulus_area * length;
  out.annulus_gel = 4.0 * length / std::max(gap, narrowest);
  out.annulus_loss = annulus_gradient(density, flow, hole, element.outer_diameter) * length;
  return out;
}

/// The mean of what displaces mud: so much, wherever it is, makes the moving string's losses; none where nothing is lost.
double displaced_area(const std::vector<Stretch>& stretches, const MudCircuit& mud)
{
  if (mud.circuit.annulus.loss <= 0.0) return 0.0;
  double mean = 0.0;
  for (std::size_t e = 0; e < stretches.size(); ++e) mean += mud.annulus_here[e] * std::pow(stretches[e].displaced, mud.circuit.exponent);
  return std::pow(mean, 1.0 / mud.circuit.exponent);
}

/// Where along the string the losses lie.
void share_losses(const std::vector<Stretch>& stretches, const Stretch& all, MudCircuit& out)
{
  out.bore_above.assign(stretches.size(), 0.0);
  out.annulus_above = out.annulus_here = out.bore_above;
  double bore = 0.0, annulus = 0.0;
  for (std::size_t e = stretches.size(); e-- > 0;)  // from the top down
  {
    const double bore_here = all.bore_loss > 0.0 ? stretches[e].bore_loss / all.bore_loss : 0.0;
    const double here = all.annulus_loss > 0.0 ? stretches[e].annulus_loss / all.annulus_loss : 0.0;
    out.bore_above[e] = bore + 0.5 * bore_here;
    out.annulus_above[e] = annulus + 0.5 * here;
    out.annulus_here[e] = here;
    bore += bore_here;
    annulus += here;
  }
}

/// What pressures do to an element.
void add_forces(const MudWay& way, const MeshElement& element, const Stretch& stretch, double annulus_here, MudCircuit& out)
{
  const double poisson = way.string[static_cast<std::size_t>(element.part)].poisson_ratio;
  const double per_area = (1.0 - 2.0 * poisson) / element.section.axial;
  out.stretch_by_bore.push_back(per_area * element.bore_area);
  out.stretch_by_annulus.push_back(-per_area * element.outer_area);
  out.lift.push_back(0.25 * pi * element.outer_diameter * stretch.hole * annulus_here);
}
}  // namespace

double clinging_constant(double diameter_ratio) noexcept
{
  return 0.41 + 0.1 * diameter_ratio;
}

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
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    stretches.push_back(stretch_of(way, mesh, e));
    all += stretches.back();
  }
  const MudPumpSpec& pump = way.pump;
  const double total = pump.pressure_coefficient * pump.max_flow * pump.max_flow;
  const double annulus = std::min(all.annulus_loss, total), inner = total - annulus;
  MudCircuit out;
  out.tubular_loss = all.bore_loss + all.annulus_loss;
  out.circuit.nominal_flow = pump.max_flow;
  out.circuit.exponent = pump.loss_exponent;
  out.circuit.bore = {all.bore_volume / way.mud.bulk_modulus, inner, all.bore_gel * way.mud.gel_strength};
  out.circuit.annulus = {all.annulus_volume / way.mud.bulk_modulus, annulus, all.annulus_gel * way.mud.gel_strength};
  out.bore_friction = inner > 0.0 ? std::min(1.0, all.bore_loss / inner) : 0.0;
  share_losses(stretches, all, out);
  out.displaced_area = displaced_area(stretches, out);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) add_forces(way, mesh.elements[e], stretches[e], out.annulus_here[e], out);
  return out;
}

std::string doubt_of_pressures(const MudCircuit& mud)
{
  const double lost = mud.circuit.bore.loss + mud.circuit.annulus.loss;
  if (lost <= 0.0 || mud.tubular_loss < lost) return {};
  char text[240];
  const double flow = mud.circuit.nominal_flow;
  std::snprintf(text, sizeof text,
                "bore and annulus alone would lose %.2f MPa at the pump's largest flow, %.3g m3/s: pressure_coefficient leaves nothing for the bit, one above %.3g would",
                mud.tubular_loss / 1e6, flow, mud.tubular_loss / (flow * flow));
  return text;
}

MudPressures mud_pressures(const MudCircuit& mud, const HydraulicState& state, double flow) noexcept
{
  const HydraulicCircuit& c = mud.circuit;
  const double friction = flow > 0.0 ? mud.bore_friction * c.bore.loss * std::pow(flow / c.nominal_flow, c.exponent) : 0.0;
  return {state.stand_pipe_pressure, friction, state.annulus_pressure};
}

}  // namespace drill_rig_sim
