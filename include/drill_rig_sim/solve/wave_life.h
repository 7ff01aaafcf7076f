// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_WAVE_LIFE_H
#define DRILL_RIG_SIM_SOLVE_WAVE_LIFE_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Until waves along and about a string have fallen to 1/e [s].
struct WaveLives
{
  double along, about;
};

/// How long waves live in a string, over which the steps' errors in them add up.
///
/// The mud lets them live 2 m'/c' of mass and damping per length. Where a string lies on its wall, Coulomb's friction f = mu w
/// sin(i) against its sliding at (a, t), along the hole and around it, resists a little more a by f t^2/|v|^3 of that, a little
/// more t by f a^2/|v|^3: turning pipe damps waves along it, tripped pipe those about it, pipe that slides one way none along it,
/// and pipe at rest all. |v|^2 = a^2 + t^2 + s^2, and s^2 is added to a^2 and t^2, with s = 2 cm/s: of waves that large a string
/// at rest feels the most. Nodes count by how fast they go, for a wave is not where nothing moves. Walls that push a string
/// because it is pulled round a bend are left out: less damping, finer steps.
class WaveLife
{
public:
  explicit WaveLife(const Model& model);

  /// Only by the mud, 40 s at most [s].
  const WaveLives& in_mud() const noexcept { return in_mud_; }
  /// And as the walls have it now [s].
  WaveLives now(const State& state) const noexcept;

private:
  struct Node
  {
    double mass, spin_inertia;  // [kg, kg m2]
    double friction;            // against sliding, where it lies flat [N]
    double lever;               // of that about the axis [m]
  };

  std::vector<Node> nodes_;
  WaveLives in_mud_;
};

}  // namespace drill_rig_sim

#endif
