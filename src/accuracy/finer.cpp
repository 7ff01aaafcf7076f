#include "drill_rig_sim/accuracy/finer.h"

namespace drill_rig_sim
{
NumericsSpec finer(const Scene& scene, double times)
{
  NumericsSpec numerics = scene.numerics;
  numerics.level = Level::beam3d;
  numerics.guided_element_length = numerics.free_length = 0.0;
  numerics.refinement *= times;
  return numerics;
}

}  // namespace drill_rig_sim
