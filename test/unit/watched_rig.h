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
/// Counts steps as it is told, and solves none.
class Counting : public Integrator
{
public:
  using Integrator::Integrator;
  bool advance(State&, double, const Setpoints&) noexcept override { return true; }
  void keep_balance(EnergyBalance*) noexcept override {}
  void count(std::uint64_t steps, std::uint64_t unsolved, std::uint64_t too_wrong)
  {
    counters_.steps += steps;
    counters_.convergence_failures += unsolved;
    counters_.error_test_failures += too_wrong;
  }
};

/// A string in mud that damps its waves, along and about it, to 1/e in 2 s.
inline Scene dying_in_two_seconds()
{
  Scene scene = vertical_scene(400.0, 290.0);
  scene.mud.axial_damping = 100.0;
  scene.mud.torsional_damping = 1.0;
  const WaveLives fast = WaveLife(*build_at_rest(scene).model).in_mud();
  scene.mud.axial_damping *= fast.along / 2.0;
  scene.mud.torsional_damping *= fast.about / 2.0;
  return scene;
}

struct Watched
{
  explicit Watched(const Scene& scene) : rig(build_at_rest(scene)), watch(rig.model), integrator(rig.model)
  {
    forces.tension.assign(rig.model->mesh().elements.size(), 0.0);
    forces.torque = forces.tension;
    forces.contact.assign(rig.model->mesh().nodes.size(), 0.0);
  }

  void play(double seconds, std::uint64_t unsolved_a_step = 0, std::uint64_t too_wrong_a_step = 0)
  {
    for (long k = 0; k < std::lround(seconds / frame); ++k)
    {
      watch.begin_frame(integrator, Setpoints(), true, memory);
      integrator.count(steps, unsolved_a_step, too_wrong_a_step);
      watch.end_frame(integrator, rig.state, forces, frame, false, memory);
    }
  }
  AccuracyReport after(double seconds)
  {
    play(seconds);
    return memory.report;
  }

  RigAtRest rig;
  AccuracyWatch watch;
  Counting integrator;
  AccuracyMemory memory;
  RigForces forces;
  std::uint64_t steps = 1;  // a frame
};

}  // namespace drill_rig_sim

#endif
