// SPDX-License-Identifier: BSD-3-Clause
// Every key of the scene file, set to a value of its own, is found in its field and in the field's unit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/well/survey.h"
#include "expected_keys.h"
#include "scene_of_all_keys.h"

namespace test_scene_keys
{
using namespace drill_rig_sim;

namespace
{
/// Where the first station of a survey lies that is tied in.
Eigen::Vector3d tied_in_at_400()
{
  const Scene scene = parse_scene(scene_of_all_keys, "all_keys.yaml",
                                  {"well.stations=[[400, 3, 4], [900, 5, 6]]", "well.tie_in={north: 12, east: -9, tvd: 399}"});
  return (1e6 * Survey(scene.well.survey).at(400.0).position).array().round() / 1e6;  // found to round-off
}

std::vector<Expected> of_well()
{
  return {
      {"", "name", [](const Scene& s) { return number(s.name == "all_keys"); }, 1.0},
      {"well", "stations", [](const Scene& s) { return s.well.survey.at(1).md; }, 400.0},
      {"well", "stations", [](const Scene& s) { return s.well.survey.at(1).inclination; }, 3.0 * degree},
      {"well", "stations", [](const Scene& s) { return s.well.survey.at(1).azimuth; }, 4.0 * degree},
      // of a well of their own: a sound hole needs all three together
      {"well.tie_in", "north", [](const Scene&) { return tied_in_at_400().y(); }, 12.0},
      {"well.tie_in", "east", [](const Scene&) { return tied_in_at_400().x(); }, -9.0},
      {"well.tie_in", "tvd", [](const Scene&) { return -tied_in_at_400().z(); }, 399.0},
      {"well", "hole_depth", [](const Scene& s) { return s.well.hole_depth; }, 801.0},
      {"well", "project", [](const Scene& s) { return number(s.well.project == Projection::curvature); }, 1.0},
      {"well", "pilot_depth", [](const Scene& s) { return s.well.pilot_depth; }, 851.0},
      {"well", "pilot_diameter", [](const Scene& s) { return s.well.pilot_diameter; }, 0.21},
      {"well", "sections", [](const Scene& s) { return double(s.well.sections.size()); }, 2.0},
      {"well.sections[]", "to", [](const Scene& s) { return s.well.sections.at(0).to; }, 301.0},
      {"well.sections[]", "diameter", [](const Scene& s) { return s.well.sections.at(0).diameter; }, 0.35},
      {"well.sections[]", "friction", [](const Scene& s) { return s.well.sections.at(0).friction; }, 0.21},
      {"well.sections[]", "static_ratio", [](const Scene& s) { return s.well.sections.at(0).static_ratio; }, 1.25},
      {"well.sections[]", "stribeck_speed", [](const Scene& s) { return s.well.sections.at(0).stribeck_speed; }, 0.061},
      {"", "formation", [](const Scene& s) { return double(s.formation.size()); }, 2.0},
      {"formation[]", "to_tvd", [](const Scene& s) { return s.formation.at(0).to_tvd; }, 501.0},
      {"formation[]", "drillability", [](const Scene& s) { return s.formation.at(0).drillability; }, 1.1e-8},
      {"formation[]", "weight_exponent", [](const Scene& s) { return s.formation.at(0).weight_exponent; }, 1.2},
      {"formation[]", "speed_exponent", [](const Scene& s) { return s.formation.at(0).speed_exponent; }, 0.7},
      {"formation[]", "threshold", [](const Scene& s) { return s.formation.at(0).threshold; }, 1301.0},
      {"formation[]", "dip_deg", [](const Scene& s) { return s.formation.at(0).dip; }, 14.0 * degree},
      {"formation[]", "strike_deg", [](const Scene& s) { return s.formation.at(0).strike; }, 15.0 * degree},
      {"formation[]", "anisotropy", [](const Scene& s) { return s.formation.at(0).anisotropy; }, 0.16},
      {"formation[]", "friction", [](const Scene& s) { return s.formation.at(0).friction; }, 0.23},
      {"mud", "density", [](const Scene& s) { return s.mud.density; }, 1181.0},
      {"mud", "viscosity", [](const Scene& s) { return s.mud.viscosity; }, 0.031},
      {"mud", "axial_damping", [](const Scene& s) { return s.mud.axial_damping; }, 0.19},
      {"mud", "lateral_damping", [](const Scene& s) { return s.mud.lateral_damping; }, 21.0},
      {"mud", "torsional_damping", [](const Scene& s) { return s.mud.torsional_damping; }, 2.2e-4},
      {"mud", "drag_coefficient", [](const Scene& s) { return s.mud.drag_coefficient; }, 1.4},
      {"mud", "bulk_modulus", [](const Scene& s) { return s.mud.bulk_modulus; }, 1.51e9},
      {"mud", "gel_strength", [](const Scene& s) { return s.mud.gel_strength; }, 4.7},
      {"mud", "added_mass", [](const Scene& s) { return s.mud.added_mass; }, 1.23},
      {"mud", "fill", [](const Scene& s) { return s.mud.fill.at(1).level; }, 203.5},
  };
}

/// Contact of a part, and a tool that shakes the string.
std::vector<Expected> of_part_extras()
{
  return {
      {"string[]", "oscillation_force", [](const Scene& s) { return s.string.at(2).oscillation_force; }, 14001.0},
      {"string[]", "oscillation_frequency", [](const Scene& s) { return s.string.at(2).oscillation_frequency; }, 0.17},
      {"string[].contact", "stiffness", [](const Scene& s) { return s.string.at(2).contact->stiffness; }, 5.1e7},
      {"string[].contact", "exponent", [](const Scene& s) { return s.string.at(2).contact->exponent; }, 1.52},
      {"string[].contact", "damping", [](const Scene& s) { return s.string.at(2).contact->damping; }, 0.32},
  };
}

std::vector<Expected> of_string()
{
  return {
      {"", "string", [](const Scene& s) { return double(s.string.size()); }, 7.0},
      {"string[]", "name", [](const Scene& s) { return number(s.string.at(2).name == "c1"); }, 1.0},
      {"string[]", "type", [](const Scene& s) { return number(s.string.at(3).type == PartType::stabilizer); }, 1.0},
      {"string[]", "length", [](const Scene& s) { return s.string.at(1).length; }, 8.4},
      {"string[]", "joints", [](const Scene& s) { return s.string.at(2).joints; }, 2.0},
      {"string[]", "joints", [](const Scene& s) { return s.string.at(6).joints; }, 0.0},
      {"string[]", "joint_length", [](const Scene& s) { return s.string.at(2).joint_length; }, 9.1},
      {"string[]", "joint_length", [](const Scene& s) { return s.string.at(2).length; }, 18.2},
      {"string[]", "outer_diameter", [](const Scene& s) { return s.string.at(2).outer_diameter; }, 0.203},
      {"string[]", "inner_diameter", [](const Scene& s) { return s.string.at(2).inner_diameter; }, 0.072},
      {"string[]", "linear_mass", [](const Scene& s) { return s.string.at(2).linear_mass; }, 221.0},
      {"string[]", "yield_strength", [](const Scene& s) { return s.string.at(2).yield_strength; }, 9.31e8},
      {"string[]", "make_up_torque", [](const Scene& s) { return s.string.at(2).make_up_torque; }, 4.1e4},
      {"string[]", "young_modulus", [](const Scene& s) { return s.string.at(2).young_modulus; }, 2.01e11},
      {"string[]", "poisson_ratio", [](const Scene& s) { return s.string.at(2).poisson_ratio; }, 0.28},
      {"string[]", "axial_stiffness", [](const Scene& s) { return s.string.at(4).stiffness.axial; }, 5.61e9},
      {"string[]", "bending_stiffness", [](const Scene& s) { return s.string.at(4).stiffness.bending; }, 1.65e7},
      {"string[]", "torsional_stiffness", [](const Scene& s) { return s.string.at(4).stiffness.torsional; }, 1.27e7},
      {"string[]", "polar_inertia", [](const Scene& s) { return s.string.at(4).polar_inertia; }, 1.26},
      {"string[]", "density", [](const Scene& s) { return s.string.at(2).density; }, 7801.0},
      {"string[]", "friction_radius", [](const Scene& s) { return s.string.at(2).friction_radius; }, 0.081},
      {"string[]", "contact", [](const Scene& s) { return s.string.at(2).contact.has_value(); }, 1.0},
      {"string[]", "tool_joint_diameter", [](const Scene& s) { return s.string.at(6).pipe->tool_joint_diameter; }, 0.169},
      {"string[]", "blade_diameter", [](const Scene& s) { return s.string.at(3).stabilizer->blade_diameter; }, 0.3081},
      {"string[]", "speed_lag", [](const Scene& s) { return s.string.at(0).bit->speed_lag; }, 0.31},
      {"string[]", "gauge_length", [](const Scene& s) { return s.string.at(0).bit->gauge_length; }, 0.15},
      {"string[]", "gauge_clearance", [](const Scene& s) { return s.string.at(0).bit->gauge_clearance; }, 4.3e-4},
      {"string[]", "squeeze_film_damping", [](const Scene& s) { return s.string.at(0).bit->squeeze_film_damping; }, 41000.0},
      {"string[]", "squeeze_film_damping", [](const Scene& s) { return s.string.at(3).stabilizer->squeeze_film_damping; },
       42000.0},
      {"string[]", "sensor_offset", [](const Scene& s) { return s.string.at(4).mwd->sensor_offset; }, 4.6},
      {"string[]", "mass", [](const Scene& s) { return s.string.at(0).bit->mass; }, 91.0},
      {"string[]", "diameter", [](const Scene& s) { return s.string.at(0).bit->diameter; }, 0.3112},
      {"string[]", "side_cutting", [](const Scene& s) { return s.string.at(0).bit->side_cutting; }, 0.12},
      {"string[]", "torque", [](const Scene& s) { return s.string.at(0).bit->torque.static_friction; }, 0.61},
      {"string[].torque", "model",
       [](const Scene& s) { return number(s.string.at(0).bit->torque.model == BitTorqueModel::stribeck); }, 1.0},
      {"string[].torque", "static", [](const Scene& s) { return s.string.at(0).bit->torque.static_friction; }, 0.61},
      {"string[].torque", "kinetic", [](const Scene& s) { return s.string.at(0).bit->torque.kinetic_friction; }, 0.41},
      {"string[].torque", "speed_rpm", [](const Scene& s) { return s.string.at(0).bit->torque.speed; }, 31.0 * rpm},
      {"string[]", "bottom", [](const Scene& s) { return s.string.at(0).bit->bottom.stiffness; }, 1.1e9},
      {"string[].bottom", "stiffness", [](const Scene& s) { return s.string.at(0).bit->bottom.stiffness; }, 1.1e9},
      {"string[].bottom", "exponent", [](const Scene& s) { return s.string.at(0).bit->bottom.exponent; }, 1.51},
      {"string[].bottom", "damping", [](const Scene& s) { return s.string.at(0).bit->bottom.damping; }, 1.01},
      {"string[]", "bend_deg", [](const Scene& s) { return s.string.at(1).motor->bend; }, 1.3 * degree},
      {"string[]", "bit_to_bend", [](const Scene& s) { return s.string.at(1).motor->bit_to_bend; }, 2.1},
      {"string[]", "sleeve_diameter", [](const Scene& s) { return s.string.at(1).motor->sleeve_diameter; }, 0.3079},
      {"string[]", "bit_to_sleeve", [](const Scene& s) { return s.string.at(1).motor->bit_to_sleeve; }, 1.05},
      {"string[]", "displacement_per_rev", [](const Scene& s) { return s.string.at(1).motor->displacement_per_rev; }, 0.025},
      {"string[]", "curve_exponent", [](const Scene& s) { return s.string.at(1).motor->curve_exponent; }, 3.9},
      {"string[]", "efficiency", [](const Scene& s) { return s.string.at(1).motor->efficiency; }, 0.85},
      {"string[]", "stall_torque", [](const Scene& s) { return s.string.at(1).motor->stall_torque; }, 12100.0},
  };
}

std::vector<Expected> of_rig()
{
  return {
      {"rig.hoisting", "sheaves", [](const Scene& s) { return s.rig.hoisting.sheaves; }, 6.0},
      {"rig.hoisting", "line_ea", [](const Scene& s) { return s.rig.hoisting.line_ea; }, 4.1e7},
      {"rig.hoisting", "crown_height", [](const Scene& s) { return s.rig.hoisting.crown_height; }, 47.0},
      {"rig.hoisting", "fixed_length", [](const Scene& s) { return s.rig.hoisting.fixed_length; }, 61.0},
      {"rig.hoisting", "block_mass", [](const Scene& s) { return s.rig.hoisting.block_mass; }, 17600.0},
      {"rig.hoisting", "sheave_efficiency", [](const Scene& s) { return s.rig.hoisting.sheave_efficiency; }, 0.97},
      {"rig", "plc_latency", [](const Scene& s) { return s.rig.plc_latency; }, 0.21},
      {"rig.hoisting", "latency", [](const Scene& s) { return s.rig.hoisting.latency; }, 0.31},
      {"rig.hoisting", "rail_friction", [](const Scene& s) { return s.rig.hoisting.rail_friction; }, 0.04},
      {"rig.hoisting", "line_damping", [](const Scene& s) { return s.rig.hoisting.line_damping; }, 0.05},
      {"rig.hoisting", "max_speed", [](const Scene& s) { return s.rig.hoisting.max_speed; }, 1.6},
      {"rig.hoisting", "max_acceleration", [](const Scene& s) { return s.rig.hoisting.max_acceleration; }, 0.6},
      {"rig.hoisting", "max_hook_load", [](const Scene& s) { return s.rig.hoisting.max_hook_load; }, 2.6e6},
      {"rig.hoisting", "lowest_block_height", [](const Scene& s) { return s.rig.hoisting.lowest_block_height; }, 1.1},
      {"rig.hoisting", "highest_block_height", [](const Scene& s) { return s.rig.hoisting.highest_block_height; }, 41.0},
      {"rig.hoisting", "connection_time", [](const Scene& s) { return s.rig.hoisting.connection_time; }, 171.0},
      {"rig.hoisting", "stand_joints", [](const Scene& s) { return s.rig.hoisting.stand_joints; }, 2.0},
      {"rig.top_drive", "inertia", [](const Scene& s) { return s.rig.top_drive.inertia; }, 2600.0},
      {"rig.top_drive", "proportional_gain", [](const Scene& s) { return s.rig.top_drive.proportional_gain; }, 20001.0},
      {"rig.top_drive", "integral_gain", [](const Scene& s) { return s.rig.top_drive.integral_gain; }, 5001.0},
      {"rig.top_drive", "max_torque", [](const Scene& s) { return s.rig.top_drive.max_torque; }, 50001.0},
      {"rig.top_drive", "max_speed_rpm", [](const Scene& s) { return s.rig.top_drive.max_speed; }, 221.0 * rpm},
      {"rig.top_drive", "max_power", [](const Scene& s) { return s.rig.top_drive.max_power; }, 750001.0},
      {"rig.top_drive", "gearbox_friction", [](const Scene& s) { return s.rig.top_drive.gearbox_friction; }, 1001.0},
      {"rig.top_drive", "brake_torque", [](const Scene& s) { return s.rig.top_drive.brake_torque; }, 50001.0},
      {"rig.top_drive", "meter_stiffness", [](const Scene& s) { return s.rig.top_drive.meter_stiffness; }, 1.1e6},
      {"rig.top_drive", "max_acceleration_rpm", [](const Scene& s) { return s.rig.top_drive.max_acceleration; }, 71.0 * rpm},
      {"rig.top_drive", "soft_torque", [](const Scene& s) { return s.rig.top_drive.soft_torque.damping; }, 801.0},
      {"rig.top_drive.soft_torque", "damping", [](const Scene& s) { return s.rig.top_drive.soft_torque.damping; }, 801.0},
      {"rig.top_drive.soft_torque", "stiffness", [](const Scene& s) { return s.rig.top_drive.soft_torque.stiffness; }, 3951.0},
      {"rig.top_drive.soft_torque", "inertia_compensation",
       [](const Scene& s) { return s.rig.top_drive.soft_torque.inertia_compensation; }, 0.11},
      {"rig.top_drive", "z_torque", [](const Scene& s) { return s.rig.top_drive.z_torque.damping; }, 401.0},
      {"rig.top_drive.z_torque", "damping", [](const Scene& s) { return s.rig.top_drive.z_torque.damping; }, 401.0},
      {"rig.top_drive.z_torque", "stiffness", [](const Scene& s) { return s.rig.top_drive.z_torque.stiffness; }, 61.0},
      {"rig.top_drive.z_torque", "inertia_compensation",
       [](const Scene& s) { return s.rig.top_drive.z_torque.inertia_compensation; }, 0.91},
      {"rig.mud_pump", "max_flow", [](const Scene& s) { return s.rig.mud_pump.max_flow; }, 0.061},
      {"rig.mud_pump", "flow_ramp", [](const Scene& s) { return s.rig.mud_pump.flow_ramp; }, 0.011},
      {"rig.mud_pump", "stroke_volume", [](const Scene& s) { return s.rig.mud_pump.stroke_volume; }, 0.0161},
      {"rig.mud_pump", "loss_exponent", [](const Scene& s) { return s.rig.mud_pump.loss_exponent; }, 1.83},
      {"rig.mud_pump", "relief_pressure", [](const Scene& s) { return s.rig.mud_pump.relief_pressure; }, 3.51e7},
      {"rig.mud_pump", "pressure_coefficient", [](const Scene& s) { return s.rig.mud_pump.pressure_coefficient; }, 4.1e9},
      {"rig.heave", "amplitude", [](const Scene& s) { return s.rig.heave.amplitude; }, 1.1},
      {"rig.heave", "period", [](const Scene& s) { return s.rig.heave.period; }, 11.0},
  };
}

std::vector<Expected> of_contact_and_start()
{
  return {
      {"contact", "stiffness", [](const Scene& s) { return s.contact.law.stiffness; }, 5.3e7},
      {"contact", "exponent", [](const Scene& s) { return s.contact.law.exponent; }, 1.53},
      {"contact", "damping", [](const Scene& s) { return s.contact.law.damping; }, 0.33},
      {"contact", "stribeck_speed", [](const Scene& s) { return s.contact.stribeck_speed; }, 0.051},
      {"contact", "static_ratio", [](const Scene& s) { return s.contact.static_ratio; }, 1.21},
      {"contact", "stribeck_curve", [](const Scene& s) { return number(s.contact.stribeck_curve == StribeckCurve::exponential); },
       1.0},
      {"contact", "growth_at_rest", [](const Scene& s) { return s.contact.growth.per_fold; }, 0.03},
      {"contact", "growth_time", [](const Scene& s) { return s.contact.growth.time; }, 1.7},
      {"contact", "growth_limit", [](const Scene& s) { return s.contact.growth.limit; }, 0.43},
      {"contact", "assembly_stiffness", [](const Scene& s) { return s.contact.assembly_stiffness; }, 2.1e10},
      {"contact", "tangential_stiffness", [](const Scene& s) { return s.contact.tangential_stiffness; }, 5.4e6},
      {"contact", "tangential_damping", [](const Scene& s) { return s.contact.tangential_damping; }, 0.26},
      {"trajectory", "stage_two_length", [](const Scene& s) { return s.trajectory.stage_two_length; }, 0.11},
      {"start", "bit_depth", [](const Scene& s) { return s.start.bit_depth; }, 801.0},
      {"start", "block_height", [](const Scene& s) { return s.start.block_height; }, 35.0},
      {"start", "weight_on_bit", [](const Scene& s) { return s.start.weight_on_bit; }, 1001.0},
      {"start", "torque_on_bit", [](const Scene& s) { return s.start.torque_on_bit; }, 101.0},
      {"start", "toolface_deg", [](const Scene& s) { return s.start.toolface; }, 11.0 * degree},
  };
}

std::vector<Expected> of_numerics()
{
  return {
      {"", "needs", [](const Scene& s) { return static_cast<double>(s.needs); }, 10.0},
      {"numerics", "level", [](const Scene& s) { return number(s.numerics.level == Level::beam3d); }, 1.0},
      {"numerics", "integrator", [](const Scene& s) { return number(s.numerics.integrator == IntegratorKind::trbdf2); }, 1.0},
      {"numerics", "element", [](const Scene& s) { return number(s.numerics.element == ElementKind::corotational); }, 1.0},
      {"numerics", "kernel", [](const Scene& s) { return number(s.numerics.kernel == Kernel::scalar); }, 1.0},
      {"numerics", "step", [](const Scene& s) { return s.numerics.step; }, 0.004},
      {"numerics", "element_length", [](const Scene& s) { return s.numerics.element_length; }, 9.7},
      {"numerics", "pushed_element_length", [](const Scene& s) { return s.numerics.pushed_element_length; }, 4.6},
      {"numerics", "guided_element_length", [](const Scene& s) { return s.numerics.guided_element_length; }, 19.1},
      {"numerics", "free_length", [](const Scene& s) { return s.numerics.free_length; }, 57.5},
      {"numerics", "tolerance", [](const Scene& s) { return s.numerics.tolerance; }, 0.012},
      {"numerics", "companion", [](const Scene& s) { return static_cast<double>(s.numerics.companion); }, 3.0},
      {"numerics", "judge", [](const Scene& s) { return static_cast<double>(s.numerics.judge); }, 1.0},
      {"numerics", "refinement", [](const Scene& s) { return s.numerics.refinement; }, 1.7},
      {"numerics", "reference_tolerance", [](const Scene& s) { return s.numerics.reference_tolerance; }, 1.1e-6},
      {"numerics", "reference_order", [](const Scene& s) { return s.numerics.reference_order; }, 3.0},
      {"numerics", "reference_index", [](const Scene& s) { return s.numerics.reference_index; }, 3.0},
      {"numerics", "newton_tolerance", [](const Scene& s) { return s.numerics.newton_tolerance; }, 1.2e-6},
      {"numerics", "structural_damping", [](const Scene& s) { return s.numerics.structural_damping; }, 1.3e-4},
      {"", "connections", [](const Scene& s) { return number(s.connections == Connections::off); }, 1.0},
      {"", "program", [](const Scene& s) { return double(s.program.size()); }, 7.0},
      {"program[]", "at", [](const Scene& s) { return s.program.at(0).at; }, 1.5},
      {"program[]", "block_velocity", [](const Scene& s) { return s.program.at(0).block_velocity; }, -0.01},
      {"program[]", "top_drive_speed_rpm", [](const Scene& s) { return s.program.at(0).top_drive_speed; }, 54.0 * rpm},
      {"program[]", "top_drive_torque", [](const Scene& s) { return s.program.at(1).top_drive_torque; }, 1234.0},
      {"program[]", "flow", [](const Scene& s) { return s.program.at(0).flow; }, 0.046},
      {"program[]", "top_drive_brake", [](const Scene& s) { return s.program.at(1).top_drive_brake; }, 1.0},
      {"program[]", "brake", [](const Scene& s) { return s.program.at(1).brake; }, 1.0},
      {"program[]", "brake", [](const Scene& s) { return s.program.at(2).brake; }, 0.0},
      {"program[]", "ramp", [](const Scene& s) { return s.program.at(2).ramp; }, 6.5},
      {"program[]", "stuck_at", [](const Scene& s) { return s.program.at(2).stuck_at; }, 701.0},
      {"program[]", "free", [](const Scene& s) { return s.program.at(3).free; }, 1.0},
      {"program[]", "slips", [](const Scene& s) { return s.program.at(3).slips; }, 1.0},
      {"program[]", "connection", [](const Scene& s) { return s.program.at(3).connection; }, -2.0},
      {"program[]", "free_length", [](const Scene& s) { return s.program.at(3).free_length; }, 57.0},
      {"program[]", "fault",
       [](const Scene& s) { return number(s.program.at(5).fault == static_cast<int>(FaultKind::pack_off)); }, 1.0},
      {"program[]", "fault_depth", [](const Scene& s) { return s.program.at(5).fault_depth; }, 501.0},
      {"program[]", "fault_magnitude", [](const Scene& s) { return s.program.at(5).fault_magnitude; }, 20001.0},
      {"program[]", "fault_target",
       [](const Scene& s) { return number(s.program.at(6).fault_gauge == static_cast<int>(Gauge::flow)); }, 1.0},
      {"program[]", "clear_fault",
       [](const Scene& s) { return number(s.program.at(6).clear_fault == static_cast<int>(FaultKind::sensor_freeze)); }, 1.0},
      {"rig.hoisting", "min_hook_load", [](const Scene& s) { return s.rig.hoisting.min_hook_load; }, 51001.0},
      {"rig.hoisting", "trip_hook_load", [](const Scene& s) { return s.rig.hoisting.trip_hook_load; }, 1.9e6},
      {"rig.mud_pump", "trip_pressure", [](const Scene& s) { return s.rig.mud_pump.trip_pressure; }, 3.41e7},
      {"program[]", "top_drive_mode", [](const Scene& s) { return static_cast<double>(s.program.at(4).top_drive_mode); }, 5.0},
      {"program[]", "top_drive_angle_deg", [](const Scene& s) { return s.program.at(4).top_drive_angle; }, 1801.0 * degree},
      {"program[]", "amplitude_right_deg", [](const Scene& s) { return s.program.at(4).amplitude_right; }, 721.0 * degree},
      {"program[]", "amplitude_left_deg", [](const Scene& s) { return s.program.at(4).amplitude_left; }, 361.0 * degree},
      {"program[]", "top_drive_torque_limit", [](const Scene& s) { return s.program.at(4).torque_limit; }, 9001.0},
  };
}

std::vector<Expected> all_expected()
{
  std::vector<Expected> all;
  for (const auto& part : {of_well(), of_string(), of_part_extras(), of_rig(), of_contact_and_start(), of_numerics(),
                           of_instruments(), of_operations()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Block and key of every row of the scene reference.
std::set<std::pair<std::string, std::string>> documented_keys()
{
  std::set<std::pair<std::string, std::string>> keys;
  std::istringstream lines(scene_reference());
  std::string line, block;
  while (std::getline(lines, line))
  {
    if (line.rfind("### `", 0) == 0)
      block = line.substr(5, line.rfind('`') - 5);
    else if (line.rfind("### ", 0) == 0)
      block = "";
    else if (line.rfind("| `", 0) == 0)
      keys.insert({block, line.substr(3, line.find('`', 3) - 3)});
  }
  return keys;
}
}  // namespace

TEST(SceneKeys, everyValueIsInItsFieldAndUnit)
{
  const Scene scene = parse_scene(scene_of_all_keys, "all_keys.yaml");
  for (const Expected& e : all_expected())
    EXPECT_NEAR(e.field(scene), e.value, 1e-14 * std::abs(e.value)) << e.block << "." << e.key;
}

// Keys that exclude others stand in scenes of their own; a block is tested by its keys, that of a survey's file in
// test_scene_survey.cpp.
TEST(SceneKeys, noKeyIsForgotten)
{
  const std::set<std::pair<std::string, std::string>> apart = {{"well", "survey"},
                                                               {"trajectory", "stage_two_steps"},
                                                               {"string[].torque", "cutting_energy"},
                                                               {"string[].torque", "wear_friction"},
                                                               {"string[].torque", "wear_weight"},
                                                               {"string[].torque", "blades"},
                                                               {"string[]", "bit_to_pivot"},
                                                               {"string[]", "tilt_deg"},
                                                               {"string[]", "nozzles"},
                                                               {"string[]", "nozzle_area"},
                                                               {"rig.mud_pump", "surface_lines"},
                                                               {"mud", "rheology"},        // test_scene_rheology.cpp
                                                               {"mud", "cuttings"},        // test_scene_cuttings.cpp
                                                               {"mud", "pressure_waves"},  // test_scene_pressure_waves.cpp
                                                               {"mud", "temperature"}};    // test_scene_temperature.cpp
  std::set<std::pair<std::string, std::string>> expected = apart;
  std::set<std::string> blocks;
  for (const Expected& e : all_expected()) expected.insert({e.block, e.key}), blocks.insert(e.block);
  const auto documented = documented_keys();
  EXPECT_GT(documented.size(), 100u);
  for (const auto& [block, key] : documented)
  {
    const std::string inside = block.empty() ? key : block + "." + key;
    if (block.rfind("well.survey", 0) == 0 || block == "mud.rheology" || block == "mud.cuttings" ||
        block == "mud.pressure_waves" || block == "mud.temperature")
      continue;
    const bool is_block =
        std::any_of(blocks.begin(), blocks.end(), [&](const std::string& b) { return b.rfind(inside, 0) == 0; });
    EXPECT_TRUE(expected.count({block, key}) || is_block) << inside << " is not tested";
  }
}

TEST(SceneKeys, thatExcludeOthersAreInTheirFieldsToo)
{
  std::string text = scene_of_all_keys;
  const auto replace = [&text](const std::string& what, const std::string& by)
  {
    ASSERT_NE(text.find(what), std::string::npos) << what;
    text.replace(text.find(what), what.size(), by);
  };
  replace("stage_two_length: 0.11", "stage_two_steps: 12");
  replace("{model: stribeck, static: 0.61, kinetic: 0.41, speed_rpm: 31.0}",
          "{model: regenerative, cutting_energy: 1.25e8, wear_friction: 0.62, wear_weight: 601.0, blades: 7}");
  replace("bottom: {stiffness: 1.1e9, exponent: 1.51, damping: 1.01}", "");
  replace("weight_exponent: 1.2, speed_exponent: 0.7, ", "");
  replace("  pilot_depth: 851.0\n  pilot_diameter: 0.21\n", "");
  replace("drillability: 1.7e-8", "drillability: 1.7e-8, threshold: 602.0");
  replace("bit_to_pads: 48.5, pad_force: 15001.0", "bit_to_pivot: 48.6, tilt_deg: 0.71");
  const Scene scene = parse_scene(text, "all_keys.yaml");
  EXPECT_EQ(scene.trajectory.stage_two_steps, 12);
  EXPECT_EQ(scene.string.at(5).steerable->bit_to_pivot, 48.6);
  EXPECT_NEAR(scene.string.at(5).steerable->tilt, 0.71 * degree, 1e-16);
  const BitTorqueSpec& torque = scene.string.at(0).bit->torque;
  EXPECT_EQ(torque.model, BitTorqueModel::regenerative);
  EXPECT_EQ(torque.blades, 7);
  EXPECT_EQ(torque.cutting_energy, 1.25e8);
  EXPECT_EQ(torque.wear_friction, 0.62);
  EXPECT_EQ(torque.wear_weight, 601.0);
}

// What a line of the program leaves out is not a number, not a zero.
TEST(SceneKeys, whatALineOfTheProgramLeavesOutIsUnset)
{
  const Scene scene = parse_scene(scene_of_all_keys, "all_keys.yaml");
  EXPECT_TRUE(std::isnan(scene.program.at(0).top_drive_torque));
  EXPECT_TRUE(std::isnan(scene.program.at(0).brake));
  EXPECT_TRUE(std::isnan(scene.program.at(1).block_velocity));
  EXPECT_TRUE(std::isnan(scene.program.at(1).top_drive_speed));
  EXPECT_TRUE(std::isnan(scene.program.at(1).flow));
  EXPECT_TRUE(std::isnan(scene.program.at(1).stuck_at));
  EXPECT_TRUE(std::isnan(scene.program.at(1).free));
  EXPECT_EQ(0.0, scene.program.at(1).ramp);
}
}  // namespace test_scene_keys
