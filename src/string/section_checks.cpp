// SPDX-License-Identifier: BSD-3-Clause
#include "section_checks.h"

#include <algorithm>

#include "cuts.h"

namespace drill_rig_sim
{
namespace
{
constexpr double largest_poisson_ratio = 0.49;
constexpr double round_off = 1e-9;

/// Half of the widest place [m].
double widest_radius(const PartSpec& part)
{
  return 0.5 * std::max(joint_end_diameter(part), part.stabilizer ? part.stabilizer->blade_diameter : 0.0);
}

void check_stiffness(const PartSpec& part, std::size_t i, ProblemList& problems)
{
  const StiffnessSpec& given = part.stiffness;
  const int keys = (given.axial > 0.0) + (given.bending > 0.0) + (given.torsional > 0.0);
  if (keys == 0) return;
  if (keys < 3)
  {
    problems.emplace_back(
        item_key("string", i),
        "axial_stiffness, bending_stiffness and torsional_stiffness belong together, needed: all three or none");
    return;
  }
  // all material at the rim: I = A D^2/8
  const double most = given.axial * part.outer_diameter * part.outer_diameter / 8.0;
  if (given.bending > most * (1.0 + round_off))
    problems.emplace_back(item_key("string", i, "bending_stiffness"),
                          plain(given.bending) +
                              " N m2 is more than possible with axial_stiffness and outer_diameter, allowed: up to " +
                              plain(most) + " N m2");
  // J = 2 I of every circular section: EI/GJ = 1 + nu
  const double least = given.bending / (1.0 + largest_poisson_ratio);
  if (given.torsional > given.bending * (1.0 + round_off) || given.torsional < least * (1.0 - round_off))
    problems.emplace_back(item_key("string", i, "torsional_stiffness"),
                          plain(given.torsional) +
                              " N m2 does not match bending_stiffness (their ratio is 1 + Poisson's ratio), allowed: " +
                              plain(least) + " to " + plain(given.bending) + " N m2");
}

void check_inertia(const PartSpec& part, std::size_t i, ProblemList& problems)
{
  const double radius = widest_radius(part), most = part.linear_mass * radius * radius;
  if (part.polar_inertia > most * (1.0 + round_off))
    problems.emplace_back(item_key("string", i, "polar_inertia"),
                          plain(part.polar_inertia) +
                              " kg m2/m is more than possible with linear_mass and the diameters, allowed: up to " + plain(most) +
                              " kg m2/m");
}

void check_lever(const PartSpec& part, std::size_t i, ProblemList& problems)
{
  const double most = widest_radius(part);
  if (part.friction_radius > most * (1.0 + round_off))
    problems.emplace_back(
        item_key("string", i, "friction_radius"),
        metres(part.friction_radius) + " lies outside the part, allowed: up to half its widest diameter, " + metres(most));
}
}  // namespace

void check_sections(const std::vector<PartSpec>& parts, ProblemList& problems)
{
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    check_stiffness(parts[i], i, problems);
    check_inertia(parts[i], i, problems);
    check_lever(parts[i], i, problems);
  }
}

}  // namespace drill_rig_sim
