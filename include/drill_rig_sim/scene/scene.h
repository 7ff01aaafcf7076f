// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SCENE_SCENE_H
#define DRILL_RIG_SIM_SCENE_SCENE_H

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/hydraulics/mud_pump.h"
#include "drill_rig_sim/hydraulics/cuttings.h"
#include "drill_rig_sim/hydraulics/pressure_waves.h"
#include "drill_rig_sim/hydraulics/rheology.h"
#include "drill_rig_sim/hydraulics/warm_mud.h"
#include "drill_rig_sim/rig/heave.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/rig/top_drive.h"
#include "drill_rig_sim/scene/fault_spec.h"
#include "drill_rig_sim/scene/instruments_spec.h"
#include "drill_rig_sim/scene/needs.h"
#include "drill_rig_sim/scene/numerics_spec.h"
#include "drill_rig_sim/scene/operation.h"
#include "drill_rig_sim/string/mud.h"
#include "drill_rig_sim/string/part.h"
#include "drill_rig_sim/well/formation.h"
#include "drill_rig_sim/well/well_spec.h"

/// What the user asked for: plain structs that mirror the scene file key by key, each beside the law that it belongs to.
/// Units are SI and radians throughout; a YAML key that ends in `_deg` or `_rpm` loses that suffix here and
/// holds radians or rad/s. A Scene that came from read_scene() has been checked; inside, values are trusted.
namespace drill_rig_sim
{
struct RigSpec
{
  HoistingSpec hoisting;
  TopDriveSpec top_drive;
  MudPumpSpec mud_pump;
  HeaveSpec heave;
  double plc_latency = 0.0;  ///< dead time of all set points in the rig's controller [s]
};

struct StartSpec
{
  double bit_depth = 0.0;      ///< [m MD]
  double block_height = 30.0;  ///< top-drive shaft above the rotary table [m]
  double weight_on_bit = 0.0;  ///< [N]
  double torque_on_bit = 0.0;  ///< [N m]
  double toolface = 0.0;       ///< of the bend, after the equilibrium [rad]
};

enum class Connections
{
  off,
  automatic
};

/// One line of the scene's program: set points and faults at a simulated time; NaN means "not set by this line".
struct ProgramStep
{
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  double at = 0.0;    ///< simulated time [s]
  double ramp = 0.0;  ///< time over which this line's velocity, speed, torque and flow are reached, in a straight line [s]
  double block_velocity = unset;                           ///< [m/s], + up; releases the brake
  double top_drive_speed = unset;                          ///< [rad/s]
  double top_drive_torque = unset;                         ///< [N m]: torque mode
  int top_drive_mode = -1;                                 ///< a TopDriveMode; -1: by the others
  double top_drive_angle = unset;                          ///< of the shaft: angle mode, or the middle of oscillate [rad]
  double amplitude_right = unset, amplitude_left = unset;  ///< of oscillate [rad]
  double torque_limit = unset;                             ///< [N m]; 0 = the rig's
  double flow = unset;                                     ///< [m3/s]
  double steering_toolface = unset;                        ///< of a rotary steerable tool [rad]
  double steering_ratio = unset;                           ///< 0 .. 1
  double top_drive_brake = unset;                          ///< 1 sets, 0 releases
  double brake = unset;                                    ///< the winch's: 1 sets, 0 releases
  double stuck_at = unset;                                 ///< the hole grips the pipe there [m MD]
  double free = unset;                                     ///< 1: it lets go
  int fault = -1;                                          ///< a FaultKind that begins; -1: none
  double fault_depth = 0.0;                                ///< of it [m MD]
  double fault_magnitude = 0.0;                            ///< in its own unit
  int fault_gauge = -1;                                    ///< of it or of the one that ends: a Gauge
  int clear_fault = -1;                                    ///< a FaultKind that ends; -1: none
  double slips = unset;                                    ///< 1 sets, 0 pulls
  double connection = unset;                               ///< joints to be added; < 0: to be taken away
  double free_length = unset;  ///< nodes up to here above the bit's face are free, those above it guided [m]
};

struct Scene
{
  std::string name;
  std::string file;                  ///< where it was read from; empty if built in code
  std::vector<std::string> remarks;  ///< of how its files were read, one line each, to be reported; part of no hash
  WellSpec well;
  std::vector<FormationLayer> formation;
  MudSpec mud;
  std::optional<RheologySpec> rheology;             ///< the file's mud.rheology; none: losses by pressure_coefficient
  std::optional<PressureWavesSpec> pressure_waves;  ///< the file's mud.pressure_waves, with a rheology only; none: two volumes
  std::optional<CuttingsSpec> cuttings;             ///< the file's mud.cuttings, with a rheology only; none: mud stays clean
  std::optional<MudTemperatureSpec> temperature;    ///< the file's mud.temperature, with a rheology only; none: mud stays alike
  std::vector<PartSpec> string;
  RigSpec rig;
  ContactSpec contact;
  TrajectorySpec trajectory;
  StartSpec start;
  NumericsSpec numerics;
  InstrumentsSpec instruments;
  unsigned needs = every_need;  ///< sum of Need
  Connections connections = Connections::off;
  std::vector<ProgramStep> program;
  std::vector<Operation> operations;
};

}  // namespace drill_rig_sim

#endif
