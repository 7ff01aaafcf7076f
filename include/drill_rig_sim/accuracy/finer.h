#ifndef DRILL_RIG_SIM_ACCURACY_FINER_H
#define DRILL_RIG_SIM_ACCURACY_FINER_H

#include "drill_rig_sim/scene/scene.h"

namespace drill_rig_sim
{
/// Numerics that represent more and cut finer, of a scene whose level and step are chosen: free nodes all along the string, elements and steps
/// `times` as short. A method of one step keeps its method; numerics of another level than free nodes' own become those of level beam3d.
NumericsSpec finer(const Scene& scene, double times);

}  // namespace drill_rig_sim

#endif
