// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/mud_damping.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
constexpr double wave_frequency = 2.0 * pi * 1.0;   // along and about the string [rad/s]
constexpr double swing_frequency = 2.0 * pi * 5.0;  // across it [rad/s]
constexpr double narrowest = 1e-3;                  // gap that pipe in the middle of its hole leaves [m]
constexpr double closest_fit = 2.0 / 3.0;           // (D/D_h)^2

/// Weighted means over a node's share.
struct Share
{
  MudDamping sum;  // times length
  double length = 0.0;

  void add(const MudDamping& drag, double more) noexcept
  {
    sum.along += more * drag.along;
    sum.across += more * drag.across;
    sum.about += more * drag.about;
    length += more;
  }
};

double given_or(double given, double by_viscosity) noexcept
{
  return std::isnan(given) ? by_viscosity : given;
}
}  // namespace

MudDamping mud_damping(const MudSpec& mud, double outer, double inner, double hole) noexcept
{
  if (!(mud.density > 0.0 && mud.viscosity > 0.0)) return {};
  const std::complex<double> k = std::complex<double>(1.0, 1.0) * std::sqrt(0.5 * mud.density * wave_frequency / mud.viscosity);
  const double gap = std::max(0.5 * (hole - outer), narrowest);
  const double annulus = mud.viscosity * std::real(k / std::tanh(k * gap));
  const double bore = mud.viscosity * std::real(k * std::tanh(k * (0.5 * inner)));
  const double fit = std::min(outer * outer / (hole * hole), closest_fit);
  const double layer = std::sqrt(0.5 * mud.density * mud.viscosity * swing_frequency);
  MudDamping drag;
  drag.along = pi * (outer * annulus + inner * bore);
  drag.about = 0.25 * pi * (outer * outer * outer * annulus + inner * inner * inner * bore);
  drag.across = 2.0 * pi * outer * layer * (1.0 + fit * std::sqrt(fit)) / ((1.0 - fit) * (1.0 - fit));
  return drag;
}

void set_mud_damping(const MudSpec& mud, const std::function<double(double)>& hole_diameter, Mesh& mesh)
{
  std::vector<Share> shares(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const MeshElement& element = mesh.elements[e];
    const MudDamping drag =
        mud_damping(mud, element.outer_diameter, 2.0 * std::sqrt(element.bore_area / pi), hole_diameter(mesh.middle(e)));
    for (Share* share : {&shares[e], &shares[e + 1]}) share->add(drag, 0.5 * element.section.length);
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    MeshNode& node = mesh.nodes[i];
    const MudDamping& sum = shares[i].sum;
    const double length = shares[i].length;
    node.mud_along = node.length * given_or(mud.axial_damping, sum.along / length);
    node.mud_across = node.length * given_or(mud.lateral_damping, sum.across / length);
    node.mud_about = node.length * given_or(mud.torsional_damping, sum.about / length);
  }
}

}  // namespace drill_rig_sim
