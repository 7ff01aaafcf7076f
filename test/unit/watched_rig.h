// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_WATCHED_RIG_H
#define DRILL_RIG_SIM_TEST_WATCHED_RIG_H

#include <cmath>

#include "drill_rig_sim/sim/accuracy_watch.h"
#include "drill_rig_sim/solve/start.h"
#include "playing.h"
#include "test_scenes.h"

/// A rig that stands as its test says, and the watch over its accuracy.
namespace drill_rig_sim
{
struct Watched
{
  explicit Watched(const Scene& scene) : rig(build_at_rest(scene))
  {
    forces.tension.assign(rig.model->mesh().elements.size(), 0.0);
    forces.torque = forces.tension;
    forces.contact.assign(rig.model->mesh().nodes.size(), 0.0);
  }

  AccuracyReport after(double seconds)
  {
    for (long k = 0; k < std::lround(seconds / frame); ++k) watch_model(*rig.model, rig.state, forces, frame, memory);
    return memory.report;
  }

  RigAtRest rig;
  AccuracyMemory memory;
  RigForces forces;
};

}  // namespace drill_rig_sim

#endif
