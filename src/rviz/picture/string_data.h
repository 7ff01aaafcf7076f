// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_STRING_DATA_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_STRING_DATA_H

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace drill_rig_sim
{
/// What DrillstringState says, node by node, bit first; in its units.
struct StringData
{
  std::vector<double> md, from_bit, tension, torque, bending_moment, bending_stress, contact_force, contact_side, spin_speed,
      buckling;
  std::vector<std::uint8_t> guided;
  std::vector<Eigen::Vector3d> position;
  std::size_t size() const noexcept { return position.size(); }
};

/// Why these data cannot be drawn, one line: fewer than two nodes, arrays of different lengths, numbers that are not finite,
/// nodes that do not go up the string. Empty where they can.
std::string problem_of(const StringData& data);

/// Contact force of each node over the length of string that it stands for, half of the way to each neighbour [N/m]. As
/// problem_of() has passed it.
std::vector<double> side_force(const StringData& data);

enum class PartKind : std::uint8_t
{
  bit,
  mud_motor,
  collar,
  stabilizer,
  mwd,
  pipe,
  rotary_steerable
};

/// A part of the string as it is drawn; lengths in m.
struct PartData
{
  std::string name;
  PartKind kind = PartKind::collar;
  double length = 0.0;  ///< 0: up to the top drive
  double joint_length = 0.0;
  double radius = 0.0;  ///< of its body
  double widest = 0.0;  ///< radius over blades, sleeve, tool joints
};

/// What RigDescription says.
struct RigData
{
  std::vector<PartData> parts;  ///< bit first
  double bend = 0.0, bit_to_bend = 0.0, bit_to_sleeve = 0.0;
  std::vector<double> section_bottom, section_radius;
  std::vector<double> layer_base;
  std::vector<double> station_md;
  std::vector<Eigen::Vector3d> stations, plan;
  double crown_height = 46.0;
  int sheaves = 5;

  /// Of the hole at a measured depth; 0.1 m where there are no sections.
  double hole_radius(double md) const noexcept;
  /// Index of the rock's layer at a true vertical depth.
  std::size_t layer_at(double tvd) const noexcept;
  /// Measured depth down to which the hole is drawn as cased: the bottom of the last section but one, for a scene does not say;
  /// 0: nothing.
  double casing_shoe() const noexcept;
};

/// As problem_of() above: no parts, a radius not above 0, sections or layers that do not go down, places that are not finite.
std::string problem_of(const RigData& data);

/// Where each part begins, bit's face first, and in the end where the last one ends: at `total_length` of the string [m].
std::vector<double> part_bounds(const std::vector<PartData>& parts, double total_length);

}  // namespace drill_rig_sim

#endif
