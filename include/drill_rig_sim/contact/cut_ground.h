// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_CUT_GROUND_H
#define DRILL_RIG_SIM_CONTACT_CUT_GROUND_H

#include <array>

namespace drill_rig_sim
{
/// The rock under a bit of n blades alike, over the angle from one blade to the next, 2 pi/n: all such sectors look the same.
/// Heights are counted down the hole from one fixed place, angles are the bit's since the start, unbounded. A value of fixed
/// size.
///
/// A ring of equal cells, straight between them. As the bit turns, each cell that a blade passes is lowered to the blade's
/// height, unless it lies lower already (a bit that has jumped leaves the rock as it was). A cell is written when the blade has
/// passed the next one, so that what lies ahead of the blade can be read in the same way everywhere.
struct CutGround
{
  static constexpr int cells = 256;

  double front = 0.0;                   ///< bit's angle where it has cut farthest [rad]
  double angle = 0.0;                   ///< bit's angle [rad]
  double height = 0.0;                  ///< and height [m] at the end of the last step
  double pending = 0.0;                 ///< blade's height at the last cell passed [m]
  double mean = 0.0;                    ///< of the ring: where the hole's bottom is [m]
  double flats = 0.0;                   ///< load of the bit's flats [N]
  std::array<double, cells> heights{};  ///< [m]

  template <class V>
  void visit(V& v)
  {
    v("front", front);
    v("angle", angle);
    v("height", height);
    v("pending", pending);
    v("mean", mean);
    v("flats", flats);
    v("heights", heights);
  }
};

/// Height of the rock ahead of a blade [m], and its slope [m/rad].
struct GroundHeight
{
  double value = 0.0;
  double slope = 0.0;
};

/// At the bit's angle `angle`; behind the front: at the front, without slope.
GroundHeight ground_ahead(const CutGround& ground, int blades, double angle) noexcept;

/// The bit has come to `angle` and `height`, in a straight line from where it was.
/// @return how far the ring's mean has gone down, >= 0 [m]
double cut(CutGround& ground, int blades, double angle, double height) noexcept;

}  // namespace drill_rig_sim

#endif
