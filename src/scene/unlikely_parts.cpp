// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_parts.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double steel = 7850.0;                           // [kg/m3]
constexpr double lightest_bit = 0.05, heaviest_bit = 1.5;  // of a steel cylinder of its length and gauge; carbide is heavier
constexpr double most_flow_area = 0.15;                    // of the bit's face: nozzles, or a bore without them
constexpr double most_bit_friction = 2.5;
constexpr double longest_joint = 15.0;                                                 // range 3 ends at 14.6 m
constexpr double longest_motor = 15.0, longest_stabilizer = 5.0, farthest_bend = 4.5;  // [m]
constexpr double least_bend = 0.1 * degree;
constexpr double weakest_pipe = 1.4e8;     // [Pa]
constexpr double least_pad_force = 300.0;  // [N]
constexpr double least_gap = 1e-3;         // around a body, for the mud [m]
constexpr double least_displacement = 0.3,
                 most_displacement = 12.0;                // over the cube of the diameter; 0.7 (one lobe) to 5 in catalogues
constexpr double least_stall = 0.2e6, most_stall = 40e6;  // pressure across a stalled motor [Pa]

void add_bit(const PartSpec& part, const std::string& key, std::vector<SizedNumber>& all)
{
  const BitSpec& bit = *part.bit;
  const double face = 0.25 * pi * bit.diameter * bit.diameter, solid = steel * face * part.length;
  all.push_back({key + "length", part.length, 0.0, 3.0, "m", "bits are long (up to 1 m)"});
  if (part.length <= 3.0)
    all.push_back(
        {key + "mass", bit.mass, lightest_bit * solid, heaviest_bit * solid, "kg", "a bit of its diameter and length weighs"});
  all.push_back({key + (bit.nozzles.empty() ? "nozzle_area" : "nozzles"), bit.flow_area(), 0.0, most_flow_area * face, "m2",
                 "a bit of its diameter has open to the mud"});
  if (!traits_of(bit.torque.model).drag)
    all.push_back({key + "torque.static", bit.torque.static_friction, 0.0, most_bit_friction, "", "bits have (0.2 to 1.2)"});
}

void add_motor(const PartSpec& part, const std::string& key, std::vector<SizedNumber>& all)
{
  const MotorSpec& motor = *part.motor;
  all.push_back({key + "length", part.length, 0.0, longest_motor, "m", "motors are long (3 to 12 m)"});
  all.push_back(
      {key + "bit_to_bend", motor.bit_to_bend, 0.0, farthest_bend, "m", "the bend of motors is above the bit (0.8 to 3 m)"});
  if (motor.bend > 0.0)
    all.push_back(
        {key + "bend_deg", motor.bend / degree, least_bend / degree, any_size, "deg", "motors are bent by (0.3 to 3 deg)"});
  const double cube = part.outer_diameter * part.outer_diameter * part.outer_diameter;
  all.push_back({key + "displacement_per_rev", motor.displacement_per_rev, least_displacement * cube, most_displacement * cube,
                 "m3/rev", "a motor of its outer_diameter displaces"});
  const double by_pressure = motor.pressure_displacement() / (2.0 * pi);
  all.push_back({key + "stall_torque", motor.stall_torque, least_stall * by_pressure, most_stall * by_pressure, "N m",
                 "a motor of its displacement_per_rev has (it stalls at 2 to 15 MPa)"});
}

void add_lengths(const PartSpec& part, const std::string& key, std::vector<SizedNumber>& all)
{
  const bool has_joints =
      part.type == PartType::collar || (part.pipe && part.pipe->tool_joint_diameter > 1.02 * part.outer_diameter);
  if (has_joints && part.joints != 1)
    all.push_back({key + "joint_length", part.joint_length, 0.0, longest_joint, "m", "joints are long (5 to 14.6 m)"});
  if (part.stabilizer)
    all.push_back({key + "length", part.length, 0.0, longest_stabilizer, "m", "stabilizers are long (1 to 3 m)"});
}

void add_body(const PartSpec& part, const std::string& key, double bit_diameter, std::vector<SizedNumber>& all)
{
  const bool is_joint = part.pipe && part.pipe->tool_joint_diameter > part.outer_diameter;
  all.push_back({key + (is_joint ? "tool_joint_diameter" : "outer_diameter"),
                 is_joint ? part.pipe->tool_joint_diameter : part.outer_diameter, 0.0, bit_diameter - 2.0 * least_gap, "m",
                 "leaves the mud a way up in the hole that the bit drills"});
}

void add_pipe(const PartSpec& part, const std::string& key, std::vector<SizedNumber>& all)
{
  all.push_back({key + "yield_strength", part.yield_strength, weakest_pipe, any_size, "Pa",
                 "pipe stands (200 MPa to 1.2 GPa; 135 ksi are 931 MPa)"});
  if (part.make_up_torque > 0.0 && part.outer_diameter > 0.06)
    all.push_back(
        {key + "make_up_torque", part.make_up_torque, 300.0, any_size, "N m", "joints are made up with (2 to 100 kN m)"});
}

void add_steerable(const SteerableSpec& tool, const std::string& key, std::vector<SizedNumber>& all)
{
  if (tool.pad_force > 0.0)
    all.push_back({key + "pad_force", tool.pad_force, least_pad_force, any_size, "N", "pads push with (5 to 30 kN)"});
  if (tool.tilt > 0.0)
    all.push_back(
        {key + "tilt_deg", tool.tilt / degree, least_bend / degree, any_size, "deg", "tools tilt their bit by (0.3 to 1 deg)"});
}
}  // namespace

std::vector<SizedNumber> part_sizes(const Scene& scene)
{
  std::vector<SizedNumber> all;
  for (std::size_t i = 0; i < scene.string.size(); ++i)
  {
    const PartSpec& part = scene.string[i];
    const std::string key = "string[" + std::to_string(i) + "].";
    if (part.bit) add_bit(part, key, all);
    if (part.motor) add_motor(part, key, all);
    if (part.steerable) add_steerable(*part.steerable, key, all);
    if (part.pipe) add_pipe(part, key, all);
    add_lengths(part, key, all);
    if (!part.bit) add_body(part, key, scene.string.front().bit->diameter, all);
  }
  return all;
}

}  // namespace drill_rig_sim
