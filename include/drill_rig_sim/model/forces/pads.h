// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_PADS_H
#define DRILL_RIG_SIM_MODEL_FORCES_PADS_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The pads of a rotary steerable tool push it to one side of the hole with a force F that stays while the tool turns (constant
/// within a step, so it has no tangent), and rub on the wall that they press on with as much.
///
/// Symbols, constant within a step: t the section normal, n = -F/|F| from the tool to where the pads press, c = t x n around the
/// hole, R the pads' lever: the hole's radius, or the part's friction_radius; x, r the node's displacement and rotation since the
/// start of the step.
///   surface     s = (t.x - R c.r, c.x + R t.r) along the hole and around it: R n is the arm
///   friction    f(s, ds/dt) of |F|, with the wall's mu, Stribeck curve, bristle and rest there (contact/surface_friction.h)
///   on the tool f_1 t + f_2 c, and as a moment -R f_1 c + R f_2 t
/// A tool that turns is braked by mu |F| R and pushed by mu |F| to the right of F, looking downhole. Pads on a sleeve that does
/// not turn: a friction_radius of 1 mm, say; they then rub only along the hole.
///
/// Left out: the pads' stroke, and the ripple of one pad after the other.
extern const Force pads;

/// What pushes and rubs during a step: Stage::pads.
void find_pads(const Model& model, const State& state, const Setpoints& setpoints, Stage& stage) noexcept;

}  // namespace drill_rig_sim

#endif
