// What the simulator shows of the string: quantities along it, and the places of its parts.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/well/directions.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

Between find_between(const Mesh& mesh, double from_bit) noexcept
{
  const auto& nodes = mesh.nodes;
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), from_bit, [](double s, const MeshNode& n) { return s < n.from_bit; });
  const int upper = std::clamp(static_cast<int>(above - nodes.begin()), 1, static_cast<int>(nodes.size()) - 1);
  const double low = nodes[upper - 1].from_bit, high = nodes[upper].from_bit;
  return {upper - 1, (from_bit - low) / (high - low)};
}

namespace
{
/// Effective tension to true axial force: the mud's pressure outside and in the bore, hydrostatic.
double true_axial_force(double effective, const MeshElement& e, double mud_density, double depth) noexcept
{
  const double pressure = mud_density * standard_gravity * std::max(depth, 0.0);
  return effective - pressure * (e.outer_area - e.bore_area);
}

/// An element's quantity at node i: the mean of the elements that meet there.
double at_node(const std::vector<double>& elements, std::size_t i) noexcept
{
  if (i == 0) return elements.front();
  if (i == elements.size()) return elements.back();
  return 0.5 * (elements[i - 1] + elements[i]);
}
}  // namespace

void Simulator::profile(StringProfile& out) const
{
  const Mesh& mesh = impl_->rig.system->mesh();
  const SystemForces& forces = impl_->state.forces;
  const SystemState& s = impl_->state.mechanics;
  const std::size_t n = s.nodes.size();
  for (auto* values : {&out.md, &out.from_bit, &out.tension, &out.true_axial_force, &out.torque, &out.bending_moment,
                       &out.contact_force, &out.contact_side, &out.spin_speed, &out.radius})
    values->resize(n);
  out.position.resize(n);
  out.contact_vector.resize(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const NodeState& node = s.nodes[i];
    const HoleSite site = s.well.locate(node.position, node.segment);
    const MeshElement& element = mesh.elements[std::min(i, mesh.elements.size() - 1)];
    out.md[i] = site.md;
    out.from_bit[i] = mesh.nodes[i].from_bit;
    out.position[i] = node.position;
    out.tension[i] = at_node(forces.tension, i);
    out.true_axial_force[i] = true_axial_force(out.tension[i], element, impl_->scene.mud.density, -node.position.z());
    out.torque[i] = at_node(forces.torque, i);
    out.bending_moment[i] = forces.bending_moment[i];
    out.contact_force[i] = forces.contact[i];
    out.contact_vector[i] = forces.wall[i];
    out.contact_side[i] =
        forces.contact[i] > 0.0 ? angle_about(site.tangent, high_side(site.tangent), node.position - site.centre) : 0.0;
    out.spin_speed[i] = node.rate.spin;
    out.radius[i] = 0.5 * element.outer_diameter;
  }
}

void Simulator::part_poses(int every, std::vector<PartPose>& out) const
{
  const Mesh& mesh = impl_->rig.system->mesh();
  const std::vector<NodeState>& nodes = impl_->state.mechanics.nodes;
  std::size_t used = 0;
  auto add = [&](double from_bit) -> PartPose&
  {
    if (used == out.size()) out.emplace_back();
    PartPose& pose = out[used++];
    const Between at = find_between(mesh, from_bit);
    const NodeState& low = nodes[at.lower];
    const NodeState& high = nodes[at.lower + 1];
    pose.position = low.position + at.share * (high.position - low.position);
    pose.orientation = low.orientation.slerp(std::clamp(at.share, 0.0, 1.0), high.orientation).normalized();
    return pose;
  };
  for (std::size_t p = 0; p < impl_->scene.string.size(); ++p)
    if (impl_->scene.string[p].type != PartType::pipe) add(mesh.part_bottom[p]).name = impl_->scene.string[p].name;
  out.front().orientation = impl_->state.measurements.bit_orientation;
  int joint = 0;
  double lower = 0.0;
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
  {
    if (!mesh.nodes[i].joint_end) continue;
    const bool pipe = impl_->scene.string[mesh.nodes[i].part].type == PartType::pipe;
    if (pipe && joint++ % std::max(every, 1) == 0) add(lower).name = "pipe_" + std::to_string(joint - 1);
    lower = mesh.nodes[i].from_bit;
  }
  out.resize(used);
}

}  // namespace drill_rig_sim
