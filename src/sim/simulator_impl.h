// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H
#define DRILL_RIG_SIM_SRC_SIM_SIMULATOR_IMPL_H

#include <cstdint>
#include <string>

#include "companions.h"
#include "crew_work.h"
#include "drill_rig_sim/sim/simulator.h"
#include "error_measurement.h"
#include "rig_actions.h"
#include "simulated_rig.h"

namespace drill_rig_sim
{
/// What a Simulator is made of.
struct Simulator::Impl
{
  Impl(const Scene& scene, std::uint64_t seed_of_noise)
      : seed(seed_of_noise),
        rig(scene, seed_of_noise),
        companions(rig),
        actions(rig, companions),
        crew(rig, actions),
        error(rig, companions)
  {
  }

  template <class Setpoint>
  CommandResult command(const Setpoint& c) noexcept;

  const std::uint64_t seed;
  std::string choice;  // why level auto is what it is; empty for other levels
  SimulatedRig rig;
  Companions companions;  // led by the rig
  RigActions actions;
  CrewWork crew;
  ErrorMeasurement error;
};

}  // namespace drill_rig_sim

#endif
