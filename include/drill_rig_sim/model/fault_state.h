// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FAULT_STATE_H
#define DRILL_RIG_SIM_MODEL_FAULT_STATE_H

#include <Eigen/Core>

namespace drill_rig_sim
{
/// A drag at a place of the hole, on whatever pipe is there (forces/place_drag.h).
struct DragState
{
  double amount =
      0.0;          ///< of a pack-off its force [N], of differential sticking overpressure times length [N/m]; 0: there is none
  double md = 0.0;  ///< of the place [m]
  Eigen::Vector2d bristle = Eigen::Vector2d::Zero();  ///< of what it holds, along the hole and around it [m]
  double rest = 0.0;                                  ///< how long the pipe has stood there [s]

  template <class V>
  void visit(V& v)
  {
    v("amount", amount);
    v("md", md);
    v("bristle", bristle);
    v("rest", rest);
  }
};

/// What is wrong with rig and hole, but for the stuck point and the gauges.
struct FaultState
{
  double friction_factor = 1.0;      ///< on the wall's friction from friction_from down [-]
  double friction_from = 0.0;        ///< [m MD]
  double drillability_factor = 1.0;  ///< on the rock's [-]
  double washed_out_by = 0.0;        ///< of the hole: its diameter is larger by that in the middle of a wash-out [m]; 0: none
  double washed_out_at = 0.0;        ///< that middle [m MD]
  DragState pack_off, sticking;
  double leak_area = 0.0;      ///< of a hole in the pipe [m2]; 0: none
  double leak_from_bit = 0.0;  ///< so far from the bit's face [m]
  double brake_holds = 0.0;    ///< the most that the winch's brake does [N]; 0: whatever hangs on it
  bool motor_locked = false;
  bool drive_tripped = false;
  bool pump_tripped = false;

  /// Whether the wall is another than the well's.
  bool at_wall() const noexcept { return friction_factor != 1.0 || washed_out_by > 0.0; }

  template <class V>
  void visit(V& v)
  {
    v("friction_factor", friction_factor);
    v("friction_from", friction_from);
    v("drillability_factor", drillability_factor);
    v("washed_out_by", washed_out_by);
    v("washed_out_at", washed_out_at);
    v("pack_off", pack_off);
    v("sticking", sticking);
    v("leak_area", leak_area);
    v("leak_from_bit", leak_from_bit);
    v("brake_holds", brake_holds);
    v("motor_locked", motor_locked);
    v("drive_tripped", drive_tripped);
    v("pump_tripped", pump_tripped);
  }
};

}  // namespace drill_rig_sim

#endif
