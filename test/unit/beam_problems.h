// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_BEAM_PROBLEMS_H
#define DRILL_RIG_SIM_TEST_BEAM_PROBLEMS_H

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "beam_chain.h"
#include "symmetric_modes.h"

/// Beams with known answers, as chains of any kind of element.
namespace drill_rig_sim
{
/// Solves at every one of `steps` equal parts of the load that `set` applies; throws if one does not converge.
inline void load_in_steps(BeamChain& chain, int steps, const std::function<void(BeamChain&, double part)>& set)
{
  for (int k = 1; k <= steps; ++k)
  {
    set(chain, static_cast<double>(k) / steps);
    if (!chain.solve())
      throw std::runtime_error("no equilibrium at " + std::to_string(k) + "/" + std::to_string(steps) + " of the load");
  }
}

/// Tip of the inextensible cantilever under a dead lateral tip force, P L^2/(E I) = load: drop and shortening over L.
/// Elliptic integrals (Bisshopp and Drucker 1945): with p^2 = (1 + sin tip)/2 and sin phi = 1/(p sqrt 2),
/// sqrt(load) = K(p) - F(p, phi), drop/L = 1 - 2 (E(p) - E(p, phi))/sqrt(load), horizontal place of the tip/L = sqrt(2 sin tip /
/// load).
struct Elastica
{
  double drop, shortening;
};
inline Elastica elastica(double load)
{
  double low = std::sqrt(0.5) + 1e-12, high = 1.0 - 1e-12;
  double phi = 0.0;
  for (int k = 0; k < 200; ++k)
  {
    const double p = 0.5 * (low + high);
    phi = std::asin(std::sqrt(0.5) / p);
    (std::comp_ellint_1(p) - std::ellint_1(p, phi) < std::sqrt(load) ? low : high) = p;
  }
  const double p = low;
  const double root = std::sqrt(load);
  return {1.0 - 2.0 * (std::comp_ellint_2(p) - std::ellint_2(p, phi)) / root, 1.0 - std::sqrt(2.0 * (2.0 * p * p - 1.0) / load)};
}

/// The 45 degree bend of Bathe and Bolourchi (1979), as a polygon of straight elements along the arc: radius 100, unit square
/// section, E 1e7, nu 0, torsion constant taken as the polar moment. Clamped at the origin along y, bent towards x, tip force up
/// z.
inline BeamChain bend_45(int count)
{
  const double step = 0.25 * pi / count;
  const double young = 1e7;
  auto along = [](double angle) { return Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * pi - angle, Eigen::Vector3d::UnitZ())); };
  BeamChain chain;
  chain.nodes.resize(count + 1);
  for (int i = 0; i <= count; ++i)
  {
    const double angle = i * step;
    chain.nodes[i].position = Eigen::Vector3d(100.0 * (1.0 - std::cos(angle)), 100.0 * std::sin(angle), 0.0);
    chain.nodes[i].orientation = along(angle);
  }
  chain.nodes[0].held.fill(true);
  BeamChain::Element e;
  e.section = section_of(200.0 * std::sin(0.5 * step), young, young / 12.0, 0.5 * young / 6.0, 0.5 * young * 5.0 / 6.0);
  e.upper = Eigen::Quaterniond(Eigen::AngleAxisd(-0.5 * step, Eigen::Vector3d::UnitZ()));
  e.lower = Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * step, Eigen::Vector3d::UnitZ()));
  chain.elements.assign(count, e);
  return chain;
}
inline Eigen::Vector3d bend_45_tip(BeamChain chain, double force)
{
  load_in_steps(chain, 6, [&](BeamChain& c, double part) { c.tip().force.z() = part * force; });
  return chain.tip().position;
}

/// Angle that the chain turns through about z, from its first node to its last, whole turns counted.
inline double turned_about_z(const BeamChain& chain)
{
  double angle = 0.0;
  for (std::size_t i = 1; i < chain.nodes.size(); ++i)
  {
    const Eigen::Vector3d from = x_axis(chain.nodes[i - 1].orientation), to = x_axis(chain.nodes[i].orientation);
    angle += std::atan2(from.cross(to).z(), from.dot(to));
  }
  return angle;
}

/// Number of ways the chain, in equilibrium under its load, can buckle: negative eigenvalues of its tangent.
inline int unstable_modes(BeamChain chain)
{
  Eigen::MatrixXd tangent = chain.free_tangent();
  // scaling leaves the signs alone, and the axial stiffness no longer drowns the bending
  const Eigen::VectorXd scale = tangent.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  tangent = scale.asDiagonal() * (0.5 * (tangent + tangent.transpose())).eval() * scale.asDiagonal();
  return static_cast<int>((modes_of(tangent).values.array() < 0.0).count());
}

/// The load between `low` and `high` above which the chain has more than `modes` unstable ones, to 1e-6. `loaded` makes the chain
/// in equilibrium.
inline double critical_load(const std::function<BeamChain(double load)>& loaded, int modes, double low, double high)
{
  while (high - low > 1e-6 * high)
  {
    const double middle = 0.5 * (low + high);
    (unstable_modes(loaded(middle)) > modes ? high : low) = middle;
  }
  return low;
}

/// A straight column along x under an axial force, + compression; its length as unloaded 10, E I 1e6.
struct StraightColumn
{
  static constexpr double length = 10.0, bending = 1e6, axial = 1e13;
  std::array<bool, 6> foot, head;  ///< held; the head's axial motion is free
  static constexpr std::array<bool, 6> clamped{{true, true, true, true, true, true}},
      pinned{{true, true, true, true, false, false}}, guided{{false, true, true, true, true, true}},
      sliding{{false, true, true, false, false, false}}, free{{false, false, false, false, false, false}};

  BeamChain loaded(const BeamKind& kind, int count, double force) const
  {
    BeamChain chain = BeamChain::cantilever(count, section_of(length / count, axial, bending, 1e6, 0.3 * axial));
    chain.kind = &kind;
    chain.nodes[0].held = foot;
    chain.tip().held = head;
    // straight and compressed: in equilibrium by construction
    for (auto& node : chain.nodes) node.position.x() *= 1.0 - force / axial;
    chain.tip().force.x() = -force;
    return chain;
  }
};

/// A vertical pipe under its weight in a plane, hinged in the hole's bottom, which carries `weight`, and hinged at `above` over
/// the neutral point. Along x, which points down.
struct HangingPipe
{
  double bending = 1.0, axial = 1.0, linear_weight = 1.0;  ///< [N m2], [N], in mud [N/m]
  double above = 1.0;                                      ///< [m]

  BeamChain loaded(const BeamKind& kind, double element_length, double weight) const
  {
    const double length = above + weight / linear_weight;
    const int count = static_cast<int>(std::ceil(length / element_length));
    const double l = length / count;
    BeamChain chain = BeamChain::cantilever(count, section_of(l, axial, bending, 0.8 * bending, 0.2 * axial));
    chain.kind = &kind;
    for (auto& node : chain.nodes) node.held = {false, false, true, true, true, false};
    chain.nodes[0].held[0] = chain.nodes[0].held[1] = chain.tip().held[1] = true;
    for (auto& element : chain.elements) element.load.x() = linear_weight * l;
    chain.tip().force.x() = -weight;
    // straight, in equilibrium: every element stretched by the mean of what hangs below it
    for (int i = 1; i <= count; ++i)
    {
      const double below = (count - i + 0.5) * l * linear_weight - weight;
      chain.nodes[i].position.x() = chain.nodes[i - 1].position.x() + l * (1.0 + below / axial);
    }
    return chain;
  }
};

}  // namespace drill_rig_sim

#endif
