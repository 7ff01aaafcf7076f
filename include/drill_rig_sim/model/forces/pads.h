#ifndef DRILL_RIG_SIM_MODEL_FORCES_PADS_H
#define DRILL_RIG_SIM_MODEL_FORCES_PADS_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The pads of a rotary steerable tool push it to one side of the hole with a force that stays while the tool turns (Stage::pad_force, constant
/// within a step, so it has no tangent).
extern const Force pads;

}  // namespace drill_rig_sim

#endif
