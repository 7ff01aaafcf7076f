// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_GUIDED_STRING_H
#define DRILL_RIG_SIM_MODEL_FORCES_GUIDED_STRING_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// All laws of the guided nodes and of the elements between two of them, in their two coordinates: stretch and twist with
/// structural damping, inertia, weight, mud's drag along and about the string, and the wall's friction, a soft string's:
///   the load on the wall   P, what acts on the node across the hole, = N_a c_a + N_b c_b + weight + what a free neighbour's beam
///   gives, N_a, N_b the tensions of the elements above and below, c their directions across the hole (Johancsik, Friesen,
///   Dawson, J. Petroleum Technology 36 (1984), SPE 11380, with vectors for inclination and azimuth alike); the bending of a pipe
///   that follows its hole is left out; the wall's normal force  N = sqrt(Q^2 - F_c^2), Q = |P|: friction around the pipe, F_c,
///   carries its share as the pipe climbs. F_c is that of the step's start, at most what slips; with steady rotation it is mu_t
///   N, hence N = Q/sqrt(1 + mu_t^2).
/// The pipe's friction has the lever of its joints' ends. What other forces do to a node, force r and slope K in six coordinates,
/// counts as T^t r and T^t K T (guides.h), and r across the hole is part of P: behind all of them in the list. In statics the
/// string slides steadily (Stage::sliding).
extern const Force guided_string;
/// Of a guided bit's gauge what loads the motor, for the bit: before it.
extern const Force guided_gauge;

}  // namespace drill_rig_sim

#endif
