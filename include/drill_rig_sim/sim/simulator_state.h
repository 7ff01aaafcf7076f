#ifndef DRILL_RIG_SIM_SIM_SIMULATOR_STATE_H
#define DRILL_RIG_SIM_SIM_SIMULATOR_STATE_H

#include <limits>
#include <utility>

#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/sim/instruments.h"
#include "drill_rig_sim/sim/measurements.h"

namespace drill_rig_sim
{
/// Everything that the next frame of a Simulator depends on. A copy is a snapshot.
struct SimulatorState
{
  SimulatorState(State start, RigForces at_start) : mechanics(std::move(start)), forces(std::move(at_start)) {}

  State mechanics;
  RigForces forces;  ///< of the last step: measurements only
  Setpoints setpoints;
  bool command_clamped = false;
  /// When [s]; infinity: never yet, so that its silence is no lost stream.
  double last_winch_command = std::numeric_limits<double>::infinity();
  double last_drive_command = std::numeric_limits<double>::infinity();
  bool timed_out = false;
  bool tared = false;
  double tare_hook_load = 0.0;  ///< [N]
  double tare_pressure = 0.0;   ///< [Pa]
  NoiseSource noise;
  Sensor hook_load_sensor;
  Sensor torque_sensor;
  Sensor pressure_sensor;
  Mwd mwd;
  Measurements measurements;
};

}  // namespace drill_rig_sim

#endif
