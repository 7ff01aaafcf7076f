// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/drive_tuning.h"

#include <algorithm>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/wave_impedance.h"

namespace drill_rig_sim
{
namespace
{
constexpr double fastest_tuned = 2.0 * pi;  // rad/s

/// Whether an oscillation is slower than `w` [rad/s]: whether a pivot of K - w^2 M is negative.
bool has_slower(const Mesh& mesh, double w)
{
  double below = 0.0, reduced = 0.0;  // stiffness of the element below; what elimination has left of a node's diagonal
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const double above = mesh.elements[e].section.torsion;
    const double diagonal = below + above - w * w * mesh.nodes[e].spin_inertia;
    reduced = e == 0 ? diagonal : diagonal - below * below / reduced;
    if (reduced < 0.0) return true;
    below = above;
  }
  return false;
}

void tune(double inertia, double damping, double stiffness_per_inertia, double stiffness_per_damping, DriveImpedance& impedance)
{
  if (impedance.damping == 0.0) impedance.damping = damping;
  if (impedance.stiffness > 0.0) return;
  const double left = inertia * (1.0 - impedance.inertia_compensation);
  impedance.stiffness = left * stiffness_per_inertia + impedance.damping * stiffness_per_damping;
}
}  // namespace

double torsional_impedance(const Mesh& mesh)
{
  return torsional_impedance(mesh.elements.back().section, mesh.nodes[mesh.nodes.size() - 2]);
}

double slowest_torsion(const Mesh& mesh)
{
  double slow = 0.0, fast = 1.0;
  while (!has_slower(mesh, fast)) fast *= 2.0;
  while (fast - slow > 1e-6 * fast)
  {
    const double middle = 0.5 * (slow + fast);
    (has_slower(mesh, middle) ? fast : slow) = middle;
  }
  return fast;
}

TopDriveSpec tuned(TopDriveSpec drive, const Mesh& mesh)
{
  const double zeta = torsional_impedance(mesh), w = std::min(slowest_torsion(mesh), fastest_tuned);
  tune(drive.inertia, 2.0 * zeta, w * w, 0.0, drive.soft_torque);
  tune(drive.inertia, zeta, 0.0, 0.125 * w, drive.z_torque);
  return drive;
}

}  // namespace drill_rig_sim
