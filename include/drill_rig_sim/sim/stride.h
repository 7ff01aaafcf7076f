// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_STRIDE_H
#define DRILL_RIG_SIM_SIM_STRIDE_H

#include <cstdint>

#include "drill_rig_sim/rig/setpoints.h"

namespace drill_rig_sim
{
/// A step that is longer than a frame (numerics.step 0), while the frames in it are shown. SimulatorState::mechanics stays at its
/// start until its last frame; its end is worked out once and held beside the state, as start, length and set points determine it
/// to the last bit. Frames between show what lies between (model/interpolate.h). A command acts at its own frame all the same:
/// the stride is then taken anew from its start, up to that frame, with the set points that it had.
struct Stride
{
  double length = 0.0;       ///< a whole number of frames; 0: none is under way [s]
  double played = 0.0;       ///< of it, up to the last frame's end [s]
  std::uint64_t steady = 0;  ///< frames since the set points last changed: no stride is longer, so that a busy controller costs
                             ///< no work that is thrown away
  Setpoints setpoints;       ///< of the last frame

  template <class V>
  void visit(V& v)
  {
    v("length", length);
    v("played", played);
    v("steady", steady);
    v("setpoints", setpoints);
  }
};

}  // namespace drill_rig_sim

#endif
