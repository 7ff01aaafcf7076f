// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_LISTS_H
#define DRILL_RIG_SIM_MODEL_FORCES_LISTS_H

#include <array>

#include "drill_rig_sim/model/forces/beams.h"
#include "drill_rig_sim/model/forces/bit.h"
#include "drill_rig_sim/model/forces/guide_rail.h"
#include "drill_rig_sim/model/forces/guided_string.h"
#include "drill_rig_sim/model/forces/hoisting.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/forces/mud_drag.h"
#include "drill_rig_sim/model/forces/oscillator.h"
#include "drill_rig_sim/model/forces/pads.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/model/forces/squeeze_film.h"
#include "drill_rig_sim/model/forces/stuck_point.h"
#include "drill_rig_sim/model/forces/top_drive.h"
#include "drill_rig_sim/model/forces/wall.h"

namespace drill_rig_sim
{
/// Some forces, in order.
struct ForceList
{
  const Force* const* first;
  const Force* const* last;

  const Force* const* begin() const noexcept { return first; }
  const Force* const* end() const noexcept { return last; }
};

/// All forces, at all levels, in dynamics and in statics. A new force is a file and a line here, between `beams` and
/// `guided_string`. Order: beams first, they write the tangent's blocks; the bit behind the wall, whose force it reads; the
/// guided string behind all that acts on its nodes; the rail last, it overwrites rows. Sums are rounded in this order, to the
/// last digit.
inline constexpr std::array force_table = {
    &beams, &mud_drag, &inertia,    &squeeze_film, &wall,     &span_wall, &guided_gauge,  &bit_on_bottom, &stuck_point,
    &slips, &pads,     &place_drag, &oscillator,   &hoisting, &top_drive, &guided_string, &guide_rail,
};
inline constexpr ForceList all_forces = {force_table.data(), force_table.data() + force_table.size()};

/// evaluate() (&Force::add) or evaluate_static() (&Force::add_static) with these forces instead of all: tests and trials of a new
/// one.
void evaluate_forces(const ForceList& forces, Force::Add Force::*use, const StageContext& at, const double* u, double* residual,
                     BlockTridiagonal* tangent) noexcept;

}  // namespace drill_rig_sim

#endif
