// SPDX-License-Identifier: BSD-3-Clause
#include "string_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drill_rig_sim
{
namespace
{
bool all_finite(const std::vector<double>& values)
{
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool all_finite(const std::vector<Eigen::Vector3d>& points)
{
  return std::all_of(points.begin(), points.end(), [](const Eigen::Vector3d& p) { return p.allFinite(); });
}

bool ascending(const std::vector<double>& values)
{
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(a < b); }) == values.end();
}
}  // namespace

std::string problem_of(const StringData& d)
{
  if (d.size() < 2) return "the string has " + std::to_string(d.size()) + " nodes, needed are two";
  const std::pair<const char*, const std::vector<double>*> arrays[] = {{"md", &d.md},
                                                                       {"from_bit", &d.from_bit},
                                                                       {"tension", &d.tension},
                                                                       {"torque", &d.torque},
                                                                       {"bending_moment", &d.bending_moment},
                                                                       {"bending_stress", &d.bending_stress},
                                                                       {"contact_force", &d.contact_force},
                                                                       {"contact_side", &d.contact_side},
                                                                       {"spin_speed", &d.spin_speed},
                                                                       {"buckling_factor", &d.buckling}};
  for (const auto& [name, values] : arrays)
  {
    if (values->size() != d.size())
      return std::string(name) + " has " + std::to_string(values->size()) + " entries, position " + std::to_string(d.size());
    if (!all_finite(*values)) return std::string(name) + " holds a number that is not finite";
  }
  if (d.guided.size() != d.size())
    return "guided has " + std::to_string(d.guided.size()) + " entries, position " + std::to_string(d.size());
  if (!all_finite(d.position)) return "position holds a number that is not finite";
  if (!ascending(d.from_bit)) return "from_bit does not go up the string";
  return {};
}

std::vector<double> side_force(const StringData& d)
{
  std::vector<double> result(d.size());
  for (std::size_t i = 0; i < d.size(); ++i)
  {
    const double below = d.from_bit[i > 0 ? i - 1 : i], above = d.from_bit[std::min(i + 1, d.size() - 1)];
    result[i] = d.contact_force[i] / (0.5 * (above - below));
  }
  return result;
}

double RigData::hole_radius(double md) const noexcept
{
  if (section_radius.empty()) return 0.1;
  const auto below = std::upper_bound(section_bottom.begin(), section_bottom.end(), md);
  return section_radius[std::min(static_cast<std::size_t>(below - section_bottom.begin()), section_radius.size() - 1)];
}

std::size_t RigData::layer_at(double tvd) const noexcept
{
  if (layer_base.empty()) return 0;
  const auto below = std::upper_bound(layer_base.begin(), layer_base.end(), tvd);
  return std::min(static_cast<std::size_t>(below - layer_base.begin()), layer_base.size() - 1);
}

double RigData::casing_shoe() const noexcept
{
  return section_bottom.size() > 1 ? section_bottom[section_bottom.size() - 2] : 0.0;
}

std::string problem_of(const RigData& d)
{
  if (d.parts.empty()) return "there are no parts";
  for (const PartData& part : d.parts)
    if (!(part.radius > 0.0 && std::isfinite(part.radius) && part.widest >= part.radius && std::isfinite(part.widest) &&
          part.length >= 0.0 && std::isfinite(part.length)))
      return "part " + part.name + " has a diameter or a length that cannot be";
  if (d.section_bottom.size() != d.section_radius.size())
    return "sections have " + std::to_string(d.section_bottom.size()) + " bottoms and " +
           std::to_string(d.section_radius.size()) + " diameters";
  if (!all_finite(d.section_radius) || !ascending(d.section_bottom)) return "sections do not go down";
  if (!ascending(d.layer_base)) return "layers do not go down";
  if (d.station_md.size() != d.stations.size())
    return "stations have " + std::to_string(d.station_md.size()) + " depths and " + std::to_string(d.stations.size()) +
           " places";
  if (!all_finite(d.stations) || !all_finite(d.plan)) return "a place of the plan is not finite";
  if (!std::isfinite(d.crown_height) || d.crown_height <= 0.0) return "crown_height is not above 0";
  return {};
}

std::vector<double> part_bounds(const std::vector<PartData>& parts, double total_length)
{
  std::vector<double> bounds{0.0};
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const bool last = i + 1 == parts.size();
    bounds.push_back(last ? std::max(bounds.back(), total_length)
                          : std::min(bounds.back() + parts[i].length, std::max(total_length, 0.0)));
  }
  return bounds;
}

}  // namespace drill_rig_sim
