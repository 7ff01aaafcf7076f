// SPDX-License-Identifier: BSD-3-Clause
#include "drill_losses.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drill_rig_sim/hydraulics/cuttings.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/well/directions.h"
#include "drill_rig_sim/well/survey.h"

namespace drill_rig_sim
{
namespace
{
constexpr Printed::InSI megapascal{"%.2f", "MPa", 1e-6}, cubic_metres_a_second{"%g", "m3/s"};
constexpr double reported_from = 0.2e6;  // difference of the annulus's losses: 4 kN of lift on 5 in pipe in an 8 1/2 in hole [Pa]

std::string loss_text(double si, const Printed& printed)
{
  return printed(si, Dimension::pressure, megapascal);
}

void print_curve(const Scene& scene, const Printed& printed)
{
  const Rheology curve = curve_of(*scene.rheology, scene.mud.viscosity);
  constexpr Printed::InSI pascal{"%.3g", "Pa"}, millipascal_second{"%.3g", "mPa s", 1e3};
  std::printf("rheology    yield stress %s, consistency %.3g Pa s^n, index %.3g; plastic viscosity %s",
              printed(curve.yield_stress, Dimension::shear_stress, pascal).c_str(), curve.consistency, curve.index,
              printed(plastic_viscosity(curve), Dimension::viscosity, millipascal_second).c_str());
  if (scene.rheology->eccentricity > 0.0) std::printf("; string %g off the middle of its hole", scene.rheology->eccentricity);
  std::printf("\n");
}

/// Of the motor at its stall torque.
void print_motor(const Scene& scene, const Printed& printed)
{
  for (const PartSpec& part : scene.string)
    if (part.motor)
      std::printf(", motor 0 to %s by its torque", loss_text(mud_motor_stall_pressure(*part.motor), printed).c_str());
}

/// @param factor  on the annulus's losses
void print_density_at(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, double md, const char* place,
                      const Printed& printed, double factor = 1.0)
{
  const double pressure = factor * annulus_share(mud, mesh, scene.start.bit_depth - md) * mud.losses.annulus;
  const double density =
      equivalent_circulating_density(scene.mud.density, pressure, -Survey(scene.well.survey).at(md).position.z());
  std::printf(" %s at %s%s", printed(density, Dimension::density, {"%.0f", "kg/m3"}).c_str(),
              printed(md, Dimension::length, {"%.0f", "m"}).c_str(), place);
}

/// Of a mud without a rheology: what its viscosity makes of the annulus's loss, where the rule of thumb is far from it.
void print_rule_of_thumb(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, const Printed& printed)
{
  if (scene.mud.viscosity <= 0.0) return;
  Scene viscous = scene;
  viscous.rheology.emplace().law = RheologyLaw::newtonian;
  const double loss = mud_circuit(viscous, mesh).losses.annulus;
  if (std::abs(loss - mud.losses.annulus) < reported_from) return;
  std::printf("            the annulus's loss is a rule of thumb, %s by mud.viscosity: for ECD and hook load set mud.rheology\n",
              loss_text(loss, printed).c_str());
}

void print_densities(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, const Printed& printed)
{
  std::printf("ecd         at that flow:");
  for (const HoleSection& section : scene.well.sections)
  {
    if (section.to >= scene.start.bit_depth) break;
    print_density_at(scene, mesh, mud, section.to, ",", printed);
  }
  print_density_at(scene, mesh, mud, scene.start.bit_depth, ", the bit", printed);
  if (mud.rotation_factor != 1.0)
  {
    std::printf("; with 120 rpm");
    print_density_at(scene, mesh, mud, scene.start.bit_depth, ", the bit", printed, mud.rotation_factor);
  }
  std::printf("\n");
}

/// The flow below which cuttings gather somewhere, and where that is.
struct CriticalFlow
{
  double flow = 0.0;         // [m3/s]
  double md = 0.0;           // [m]
  double inclination = 0.0;  // [rad]
};

CriticalFlow critical_flow(const Scene& scene, const Mesh& mesh, double rop, double rotation)
{
  const CuttingsFluid fluid{curve_of(*scene.rheology, scene.mud.viscosity), scene.mud.density, *scene.cuttings};
  const Survey survey(scene.well.survey);
  CriticalFlow most;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const double md = scene.start.bit_depth - mesh.middle(e), pipe = mesh.elements[e].outer_diameter;
    const double hole = scene.well.sections[section_at(scene.well.sections, md)].diameter;
    if (md <= 0.0 || hole <= pipe) continue;
    const CuttingsCell cell{{hole, pipe, 0.0}, mesh.elements[e].section.length, inclination_of(survey.at(md).tangent)};
    const double flow = critical_cuttings_speed(fluid, cell, rop, rotation) * cell.passage.area();
    if (flow > most.flow) most = {flow, md, cell.inclination};
  }
  return most;
}

void print_cuttings(const Scene& scene, const Mesh& mesh, const Printed& printed)
{
  constexpr double rop = 20.0 / 3600.0;
  constexpr Printed::InSI three_digits{"%.3g", "m3/s"};
  std::printf("cuttings    gather at %s below a flow of", printed(rop, Dimension::penetration, {"%.0f", "m/h", 3600.0}).c_str());
  CriticalFlow least;
  for (const double turns : {0.0, 60.0, 120.0})
  {
    least = critical_flow(scene, mesh, rop, turns * rpm);
    std::printf("%s %s at %.0f rpm (%s, %.0f deg)", turns > 0.0 ? "," : "",
                printed(least.flow, Dimension::flow, three_digits).c_str(), turns,
                printed(least.md, Dimension::length, {"%.0f", "m"}).c_str(), least.inclination / degree);
  }
  std::printf("\n");
  const double most = scene.rig.mud_pump.max_flow;
  if (least.flow > most)
    std::printf("            the pump's largest flow, %s, is less: keep the rate of penetration lower\n",
                printed(most, Dimension::flow, three_digits).c_str());
}

/// Where the relief valve keeps the pump from its largest flow.
void print_relief(const Scene& scene, const LossesAtLargestFlow& losses, const Printed& printed)
{
  const double relief = scene.rig.mud_pump.relief_pressure;
  if (losses.lines + losses.bore + losses.bit + losses.annulus <= relief) return;
  std::printf(
      "            more than rig.mud_pump.relief_pressure, %s: the relief valve opens below that flow; set "
      "rig.mud_pump.max_flow to what the well is drilled with\n",
      loss_text(relief, printed).c_str());
}
}  // namespace

void print_losses(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, const Printed& printed)
{
  const LossesAtLargestFlow& losses = mud.losses;
  if (scene.rheology) print_curve(scene, printed);
  std::printf("losses      at %s: ", printed(mud.circuit.nominal_flow, Dimension::flow, cubic_metres_a_second).c_str());
  if (!scene.rig.mud_pump.surface_lines.empty()) std::printf("surface lines %s, ", loss_text(losses.lines, printed).c_str());
  std::printf("bore %s", loss_text(losses.bore, printed).c_str());
  print_motor(scene, printed);
  std::printf(", bit %s, annulus %s; stand pipe %s", loss_text(losses.bit, printed).c_str(),
              loss_text(losses.annulus, printed).c_str(),
              loss_text(losses.lines + losses.bore + losses.bit + losses.annulus, printed).c_str());
  if (!mud.circuit.law.any())
    std::printf(losses.bit > 0.0 ? " by pressure_coefficient"
                                 : " by pressure_coefficient, to which the losses are cut: it is too small");
  std::printf("\n");
  print_relief(scene, losses, printed);
  if (scene.rheology)
    print_densities(scene, mesh, mud, printed);
  else
    print_rule_of_thumb(scene, mesh, mud, printed);
  if (scene.cuttings) print_cuttings(scene, mesh, printed);
}

}  // namespace drill_rig_sim
