// SPDX-License-Identifier: BSD-3-Clause
#include "drill_temperature.h"

#include <cstdio>
#include <string>

#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/scene/scene_mesh.h"
#include "drill_rig_sim/sim/simulator_state.h"

namespace drill_rig_sim
{
namespace
{
constexpr double hours = 6.0;

std::string degrees(double temperature, const Printed& printed)
{
  return printed(temperature, Dimension::temperature, {"%.1f", "degC"});
}

std::string density_at(const Scene& scene, double pressure, double depth, const Printed& printed)
{
  return printed(equivalent_circulating_density(scene.mud.density, pressure, depth), Dimension::density, {"%.0f", "kg/m3"});
}

/// Of the mud around the bit, and of the reference.
void print_viscosity(const Scene& scene, double temperature, const Printed& printed)
{
  const double viscosity = plastic_viscosity(curve_of(*scene.rheology, scene.mud.viscosity));
  const auto shown = [&](double value) { return printed(value, Dimension::viscosity, {"%.3g", "mPa s", 1e3}); };
  std::printf("            then plastic viscosity %s at the bit (%s at %s)",
              shown(viscosity * viscosity_factor(*scene.temperature, temperature)).c_str(), shown(viscosity).c_str(),
              printed(scene.temperature->rheology_temperature, Dimension::temperature, {"%g", "degC"}).c_str());
}
}  // namespace

void print_temperature(const Simulator& simulator, const Printed& printed)
{
  const Scene& scene = simulator.scene();
  if (!scene.temperature) return;
  const auto start = simulator.save();
  const Model model(scene, build_mesh(scene, start->string.length));
  const double depth = -simulator.truth().bit_position.z(), flow = scene.rig.mud_pump.max_flow;
  State pumped = start->mechanics;
  circulate(model, flow, 3600.0 * hours, pumped);
  const TemperatureState &before = start->mechanics.temperature, &now = pumped.temperature;
  const SectionLosses& law = model.mud().circuit.law;
  const double friction = law.outer(flow, 0.0, &now.losses).loss;
  const double stand_pipe = law.inner(flow, &now.losses).loss + friction + now.heads.annulus - now.heads.bore;
  std::printf("temperature %s in the rock at the bit; after %g h at %s: %s at the bit, %s in the flow line\n",
              degrees(ground_temperature(*scene.temperature, depth), printed).c_str(), hours,
              printed(flow, Dimension::flow, {"%g", "m3/s"}).c_str(), degrees(now.bit, printed).c_str(),
              degrees(now.flow_line, printed).c_str());
  print_viscosity(scene, now.bit, printed);
  std::printf(", stand pipe %s, ecd %s; at rest at the start %s\n",
              printed(stand_pipe, Dimension::pressure, {"%.2f", "MPa", 1e-6}).c_str(),
              density_at(scene, now.heads.annulus + friction, depth, printed).c_str(),
              density_at(scene, before.heads.annulus, depth, printed).c_str());
}

}  // namespace drill_rig_sim
