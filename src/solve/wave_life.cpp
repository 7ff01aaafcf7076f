// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/solve/wave_life.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
namespace
{
constexpr double longest_life = 40.0;  // errors are judged over a minute, in which those of undamped waves grow from nothing [s]
constexpr double small = 0.02;         // speed of a wave [m/s]

/// `inertia` moves against `damping` [kg, N s/m; kg m2, N m s].
double life_of_waves(double inertia, double damping) noexcept
{
  return damping * longest_life > 2.0 * inertia ? 2.0 * inertia / damping : longest_life;
}
}  // namespace

WaveLife::WaveLife(const Model& model)
{
  const Mesh& mesh = model.mesh();
  const Scene& scene = model.scene();
  double mass = 0.0, spin_inertia = 0.0, mud_along = 0.0, mud_about = 0.0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const MeshNode& node = mesh.nodes[i];
    const auto half_below = [&](std::size_t e) { return 0.5 * model.element_weight(static_cast<int>(e), -1.0, 0.0, full_bore); };
    const double weight = (i > 0 ? half_below(i - 1) : 0.0) + (i + 1 < mesh.nodes.size() ? half_below(i) : 0.0);
    const std::size_t section = section_at(scene.well.sections, scene.start.bit_depth - node.from_bit);
    const double lever = node.friction_radius > 0.0 ? node.friction_radius : node.contact_radius;
    nodes_.push_back({node.mass, node.spin_inertia, scene.well.sections[section].friction * weight, lever});
    mass += node.mass;
    spin_inertia += node.spin_inertia;
    mud_along += node.mud_along;
    mud_about += node.mud_about;
  }
  in_mud_ = {life_of_waves(mass, mud_along), life_of_waves(spin_inertia, mud_about)};
}

WaveLives WaveLife::now(const State& state) const noexcept
{
  double inertia_along = 0.0, inertia_about = 0.0, damping_along = 0.0, damping_about = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
  {
    const Node& node = nodes_[i];
    const Eigen::Vector3d axis = x_axis(state.nodes[i].orientation);
    const double a = state.nodes[i].rate.velocity.dot(axis), t = state.nodes[i].rate.spin * node.lever;
    const double along = a * a + small * small, around = t * t + small * small, slides = std::sqrt(along + t * t);
    const double friction = node.friction * std::hypot(axis.x(), axis.y()) * along * around / (slides * slides * slides);
    inertia_along += along * node.mass;
    inertia_about += around * node.spin_inertia;
    damping_along += friction;
    damping_about += friction * node.lever * node.lever;
  }
  return {1.0 / (1.0 / in_mud_.along + 0.5 * damping_along / inertia_along),
          1.0 / (1.0 / in_mud_.about + 0.5 * damping_about / inertia_about)};
}

}  // namespace drill_rig_sim
