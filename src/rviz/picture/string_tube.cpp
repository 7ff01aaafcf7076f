// SPDX-License-Identifier: BSD-3-Clause
#include "string_tube.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double box = 0.40, taper = 0.06;  // of a tool joint above a joint's end, and of the cones beside it [m]
constexpr double pin = 0.26;                // below it [m]
constexpr double half_sleeve = 0.3;         // of a motor [m]

void add_step(std::vector<OutlinePoint>& outline, double from, double to, double radius, double wide)
{
  outline.insert(outline.end(), {{from - taper, radius}, {from, wide}, {to, wide}, {to + taper, radius}});
}

void add_part(const PartData& part, double bottom, double top, double bit_to_sleeve, bool joints,
              std::vector<OutlinePoint>& outline)
{
  outline.push_back({bottom, part.radius});
  if (part.kind == PartKind::mud_motor && bit_to_sleeve > 0.0)
    add_step(outline, bit_to_sleeve - half_sleeve, bit_to_sleeve + half_sleeve, part.radius, part.widest);
  if (joints && part.kind == PartKind::pipe && part.widest > part.radius && part.joint_length > 2.0)
  {
    const int ends = std::max(0, static_cast<int>(std::ceil((top - box - taper - bottom) / part.joint_length)) - 1);
    for (int k = 1; k <= ends; ++k)
    {
      const double end = bottom + k * part.joint_length;
      add_step(outline, end - pin, end + box, part.radius, part.widest);
    }
  }
  outline.push_back({top, part.radius});
}

double radius_at(const std::vector<OutlinePoint>& outline, double s)
{
  const auto above =
      std::upper_bound(outline.begin(), outline.end(), s, [](double x, const OutlinePoint& p) { return x < p.from_bit; });
  if (above == outline.begin()) return outline.front().radius;
  if (above == outline.end()) return outline.back().radius;
  const OutlinePoint &a = *(above - 1), &b = *above;
  return a.radius + (s - a.from_bit) / (b.from_bit - a.from_bit) * (b.radius - a.radius);
}
}  // namespace

Between between(const std::vector<double>& from_bit, double s) noexcept
{
  const auto above = std::upper_bound(from_bit.begin() + 1, from_bit.end() - 1, s);
  const auto node = static_cast<std::size_t>(above - from_bit.begin()) - 1;
  return {node, (s - from_bit[node]) / (from_bit[node + 1] - from_bit[node])};
}

std::vector<OutlinePoint> outline_of(const RigData& rig, double total_length, bool joints)
{
  const std::vector<double> bounds = part_bounds(rig.parts, total_length);
  std::vector<OutlinePoint> outline;
  for (std::size_t i = 0; i < rig.parts.size(); ++i)
    if (rig.parts[i].kind != PartKind::bit && bounds[i + 1] > bounds[i])
      add_part(rig.parts[i], bounds[i], bounds[i + 1], rig.bit_to_sleeve, joints, outline);
  if (outline.empty() && !rig.parts.empty())
    outline = {{0.0, rig.parts.front().radius}, {total_length, rig.parts.front().radius}};
  const auto lower = [](const OutlinePoint& a, const OutlinePoint& b) { return a.from_bit < b.from_bit; };
  std::stable_sort(outline.begin(), outline.end(), lower);
  return outline;
}

void StringTube::shape(const RigData& rig, const std::vector<double>& from_bit, bool joints)
{
  if (from_bit == from_bit_ && joints == joints_) return;
  from_bit_ = from_bit;
  joints_ = joints;
  places_.clear();
  const std::vector<OutlinePoint> outline = outline_of(rig, from_bit.back(), joints);
  std::size_t next = 0;
  const auto add = [&](double s, double radius)
  {
    const Between at = between(from_bit, s);
    places_.push_back({at.node, at.share, radius});
  };
  for (const double node : from_bit)
  {
    for (; next < outline.size() && outline[next].from_bit <= node; ++next) add(outline[next].from_bit, outline[next].radius);
    if (node > outline.front().from_bit) add(node, radius_at(outline, node));
  }
}

std::vector<DrawnNode> StringTube::place(const StringData& data, const HoleAxis& axis, double exaggeration)
{
  std::vector<DrawnNode> nodes(data.size());
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    nodes[i].axis = axis.nearest(data.position[i], data.md[i]);
    nodes[i].position = exaggerated(nodes[i].axis, data.position[i], exaggeration);
  }
  return nodes;
}

const std::vector<Ring>& StringTube::rings(const std::vector<DrawnNode>& nodes, const std::vector<double>& values,
                                           const std::function<Color(double)>& color, double thickness)
{
  rings_.clear();
  for (const Place& place : places_)
  {
    const DrawnNode &a = nodes[place.node], &b = nodes[place.node + 1];
    const double u = place.share, w = 1.0 - u;
    Ring ring;
    ring.center = w * a.position + u * b.position;
    // up the string as the rings go: side x other points along them
    ring.side = (w * a.axis.side + u * b.axis.side).normalized();
    ring.other = ring.side.cross((w * a.axis.tangent + u * b.axis.tangent).normalized());
    ring.radius = thickness * place.radius;
    ring.color = color(w * values[place.node] + u * values[place.node + 1]);
    rings_.push_back(ring);
  }
  return rings_;
}

}  // namespace drill_rig_sim
