// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/hole_nodes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "drill_rig_sim/well/well_checks.h"

namespace drill_rig_sim
{
namespace
{
// A measured depth where a node must be, and the section that its radius and friction come from.
struct Anchor
{
  double md;
  std::size_t section;
  bool at_bit = false;  // the hole's end, cut by the bit
};

void check(const WellSpec& spec, double bit_radius)
{
  const ProblemList problems = well_problems(spec);
  if (!problems.empty()) throw std::invalid_argument(problems.front().key + ": " + problems.front().text);
  if (!(bit_radius > 0.0 && std::isfinite(bit_radius)))
    throw std::invalid_argument("well: the bit's radius " + metres(bit_radius) + " must be positive");
}

// Two anchors where one section gives way to the next, and the hole's end.
std::vector<Anchor> section_anchors(const WellSpec& spec, double top, double bit_radius)
{
  std::vector<Anchor> anchors{{top, 0}};
  std::size_t last = 0;
  for (; spec.sections[last].to + 2.0 * section_step < spec.hole_depth; ++last)  // the last one reaches the hole's depth
  {
    anchors.push_back({spec.sections[last].to, last});
    anchors.push_back({spec.sections[last].to + section_step, last + 1});
  }
  const bool bit_differs = std::abs(0.5 * spec.sections[last].diameter - bit_radius) > 1e-9;
  if (bit_differs) anchors.push_back({spec.hole_depth - section_step, last});
  anchors.push_back({spec.hole_depth, last, true});
  return anchors;
}

// The stations between the anchors; one closer to an anchor than the section step would only make a sliver of a segment.
std::vector<Anchor> with_stations(const std::vector<Anchor>& anchors, const Survey& survey)
{
  std::vector<Anchor> all;
  int station = 0;
  for (std::size_t i = 0; i + 1 < anchors.size(); ++i)
  {
    all.push_back(anchors[i]);
    for (; station < survey.size() && survey.station(station).md < anchors[i + 1].md; ++station)
    {
      const double md = survey.station(station).md;
      if (md > anchors[i].md + section_step && md < anchors[i + 1].md - section_step) all.push_back({md, anchors[i + 1].section});
    }
  }
  all.push_back(anchors.back());
  return all;
}

WellNode node_at(const PathPoint& p, double radius, double friction, std::size_t section)
{
  return {p.md, p.position, p.tangent.normalized(), radius, friction, static_cast<double>(section)};
}
}  // namespace

std::vector<WellNode> place_nodes(const WellSpec& spec, const Survey& survey, double bit_radius)
{
  check(spec, bit_radius);
  const std::vector<Anchor> anchors = with_stations(section_anchors(spec, survey.first_md(), bit_radius), survey);
  std::vector<WellNode> nodes;
  for (std::size_t i = 0; i < anchors.size(); ++i)
  {
    const HoleSection& section = spec.sections[anchors[i].section];
    const double radius = anchors[i].at_bit ? bit_radius : 0.5 * section.diameter;
    if (i > 0)
    {
      const double from = anchors[i - 1].md;
      const double length = anchors[i].md - from;
      const double curvature = survey.curvature(survey.arc_at(0.5 * (from + anchors[i].md)));
      const double pieces = std::ceil(std::pow(std::pow(curvature, 3) * std::pow(length, 4) / (384.0 * hermite_tolerance), 0.25));
      for (int k = 1; k < pieces; ++k)
        nodes.push_back(node_at(survey.at(from + length * k / pieces), radius, section.friction, anchors[i].section));
    }
    nodes.push_back(node_at(survey.at(anchors[i].md), radius, section.friction, anchors[i].section));
  }
  return nodes;
}

}  // namespace drill_rig_sim
