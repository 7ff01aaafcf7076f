#ifndef DRILL_RIG_SIM_MODEL_FORCES_LISTS_H
#define DRILL_RIG_SIM_MODEL_FORCES_LISTS_H

#include <array>

#include "drill_rig_sim/model/forces/beams.h"
#include "drill_rig_sim/model/forces/bit.h"
#include "drill_rig_sim/model/forces/free_string.h"
#include "drill_rig_sim/model/forces/guide_rail.h"
#include "drill_rig_sim/model/forces/guided_string.h"
#include "drill_rig_sim/model/forces/hoisting.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/forces/mud_drag.h"
#include "drill_rig_sim/model/forces/pads.h"
#include "drill_rig_sim/model/forces/place_drag.h"
#include "drill_rig_sim/model/forces/slips.h"
#include "drill_rig_sim/model/forces/span_wall.h"
#include "drill_rig_sim/model/forces/squeeze_film.h"
#include "drill_rig_sim/model/forces/stuck_point.h"
#include "drill_rig_sim/model/forces/top_drive.h"
#include "drill_rig_sim/model/forces/wall.h"

/// Which forces make which problem. A new force is a file and a place in these lists. Order matters where a comment says so, and to the
/// last digit: sums are rounded in this order.
namespace drill_rig_sim
{
/// Dynamics. Beams first: they write the tangent's blocks; the guided string behind all that acts on its nodes; the rail last: it overwrites rows.
inline const std::array<const Force*, 16> dynamic_forces = {&beams,         &mud_drag,    &inertia, &squeeze_film, &wall,       &span_wall, &guided_gauge,  &bit_on_bottom,
                                                            &stuck_point,   &slips,       &pads,    &place_drag,   &hoisting,   &top_drive, &guided_string, &guide_rail};
/// The same by batch kernels.
inline const std::array<const Force*, 14> batched_forces = {&free_string, &squeeze_film, &wall,       &span_wall, &guided_gauge, &bit_on_bottom,  &stuck_point,
                                                            &slips,       &pads,         &place_drag, &hoisting,  &top_drive,    &guided_string, &guide_rail};
/// Statics, inertia for continuation.
inline const std::array<const Force*, 8> static_forces = {&beams,       &inertia,     &sliding_wall,          &sliding_span_wall,
                                                          &resting_bit, &stuck_point, &sliding_guided_string, &held_top};
/// What has results of its own at a solution, beside the residual.
inline const std::array<const Force*, 10> forces_with_results = {&beams_at_guides, &wall,       &span_wall, &guided_gauge, &bit_on_bottom,
                                                                 &pads,            &place_drag, &hoisting,  &top_drive,    &guided_string};
/// For those who integrate bodies themselves: on the string, and at its contacts.
inline const std::array<const Force*, 3> string_forces = {&beams, &mud_drag, &span_wall};
inline const std::array<const Force*, 5> contact_forces = {&squeeze_film, &wall, &bit_on_bottom, &stuck_point, &pads};

}  // namespace drill_rig_sim

#endif
