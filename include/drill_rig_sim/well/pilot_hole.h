// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_PILOT_HOLE_H
#define DRILL_RIG_SIM_WELL_PILOT_HOLE_H

#include <Eigen/Core>
#include <optional>

#include "drill_rig_sim/well/formation.h"
#include "drill_rig_sim/well/survey.h"
#include "drill_rig_sim/well/well_spec.h"

/// Reaming: below the hole's bottom a narrower hole, the pilot, is there already. The bit stands on a ring and widens the pilot
/// to its gauge.
///
/// With q the pilot's diameter over the bit's, the ring takes the share f of the full face's weight and torque at the same depth
/// of cut, with a lever l times the full face's,
///   drag bit, whose cutters carry weight by their width:   f = 1 - q,    l = 1 + q          (torque f l = 1 - q^2, the ring's
///   share of the rock) uniform pressure on the face (stribeck):               f = 1 - q^2,  l = (1 + q + q^2)/(1 + q)
/// from int dr, int r dr and int r^2 dr over the ring. So the rock drills as one with K/f^alpha and f F_0.
/// The bit follows the pilot, whose core gives it no hold sideways: the bottom moves along the pilot's axis, and is drawn back to
/// it over 0.3 m. Not in it: the pilot's wall, a nose in it, mud in it.
namespace drill_rig_sim
{
/// The rock of a ring for a bit whose cutters carry weight by their width (`by_width`) or by their area.
FormationLayer ring_of(FormationLayer layer, double diameter_ratio, bool by_width) noexcept;

class PilotHole
{
public:
  /// `well` is good (well_problems()); pilot_depth 0: none.
  explicit PilotHole(const WellSpec& well);

  /// Whether there is pilot hole ahead of a bottom at measured depth `depth` [m].
  bool is_ahead(double depth) const noexcept { return depth < end_; }
  /// The way from a bottom at `position` [m] and `depth` [m] to the pilot's axis 0.3 m ahead, unit; the pilot is ahead.
  Eigen::Vector3d direction(const Eigen::Vector3d& position, double depth) const noexcept;

private:
  double end_;  // measured depth [m]
  std::optional<Survey> axis_;
};

}  // namespace drill_rig_sim

#endif
