// SPDX-License-Identifier: BSD-3-Clause
#include "drill_losses.h"

#include <cstdio>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/survey.h"

namespace drill_rig_sim
{
namespace
{
constexpr Printed::InSI megapascal{"%.2f", "MPa", 1e-6}, cubic_metres_a_second{"%g", "m3/s"};

std::string loss_text(double si, const Printed& printed)
{
  return printed(si, Dimension::pressure, megapascal);
}

void print_curve(const Scene& scene)
{
  const Rheology curve = curve_of(*scene.rheology, scene.mud.viscosity);
  std::printf("rheology    yield stress %.3g Pa, consistency %.3g Pa s^n, index %.3g; plastic viscosity %.3g mPa s",
              curve.yield_stress, curve.consistency, curve.index, 1e3 * plastic_viscosity(curve));
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

void print_density_at(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, double md, const char* place,
                      const Printed& printed)
{
  const double pressure = annulus_share(mud, mesh, scene.start.bit_depth - md) * mud.losses.annulus;
  const double density =
      equivalent_circulating_density(scene.mud.density, pressure, -Survey(scene.well.survey).at(md).position.z());
  std::printf(" %s at %s%s", printed(density, Dimension::density, {"%.0f", "kg/m3"}).c_str(),
              printed(md, Dimension::length, {"%.0f", "m"}).c_str(), place);
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
  std::printf("\n");
}
}  // namespace

void print_losses(const Scene& scene, const Mesh& mesh, const MudCircuit& mud, const Printed& printed)
{
  const LossesAtLargestFlow& losses = mud.losses;
  if (scene.rheology) print_curve(scene);
  std::printf("losses      at %s: ", printed(mud.circuit.nominal_flow, Dimension::flow, cubic_metres_a_second).c_str());
  if (!scene.rig.mud_pump.surface_lines.empty()) std::printf("surface lines %s, ", loss_text(losses.lines, printed).c_str());
  std::printf("bore %s", loss_text(losses.bore, printed).c_str());
  print_motor(scene, printed);
  std::printf(", bit %s, annulus %s; stand pipe %s", loss_text(losses.bit, printed).c_str(),
              loss_text(losses.annulus, printed).c_str(),
              loss_text(losses.lines + losses.bore + losses.bit + losses.annulus, printed).c_str());
  std::printf(mud.circuit.law.any() ? "\n" : " by pressure_coefficient\n");
  if (scene.rheology) print_densities(scene, mesh, mud, printed);
}

}  // namespace drill_rig_sim
