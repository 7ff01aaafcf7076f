// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_OSCILLATOR_H
#define DRILL_RIG_SIM_MODEL_FORCES_OSCILLATOR_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// A tool that shakes the string along its axis by pulses of the mud's pressure, against friction in slides: F = F_0 sin(2 pi f
/// t) on its node, + towards the bit, while mud flows; t is the simulated time. F_0 is `oscillation_force` [N], f is
/// `oscillation_frequency` [Hz] of the part. Both do not depend on the flow, and the pulses do not run along the mud. The force
/// depends on time only, so it has no tangent; at rest it is left out. The harmonic force is an assumption.
extern const Force oscillator;

}  // namespace drill_rig_sim

#endif
