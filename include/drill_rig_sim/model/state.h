// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_STATE_H
#define DRILL_RIG_SIM_MODEL_STATE_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "drill_rig_sim/contact/cut_ground.h"
#include "drill_rig_sim/hydraulics/hydraulics.h"
#include "drill_rig_sim/hydraulics/pressure_waves.h"
#include "drill_rig_sim/model/cuttings_state.h"
#include "drill_rig_sim/model/fault_state.h"
#include "drill_rig_sim/model/temperature_state.h"
#include "drill_rig_sim/rig/heave.h"
#include "drill_rig_sim/rig/top_drive.h"
#include "drill_rig_sim/well/wellbore.h"

namespace drill_rig_sim
{
/// A vector of a node's six coordinates, with the rotation in two parts. The section normal n splits it: tilt (across n) and spin
/// (about n). Both survive a change of n without mixing, and spin is a plain scalar, so any number of turns is as good as none.
struct NodeRate
{
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();      ///< world axes, across n [rad/s]
  double spin = 0.0;                                   ///< [rad/s]

  template <class V>
  void visit(V& v)
  {
    v("velocity", velocity);
    v("tilt", tilt);
    v("spin", spin);
  }
};

/// One node of the string at an instant.
struct NodeState
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world; x towards the bit
  double spin_angle = 0.0;                                          ///< turned since the start, unbounded [rad]
  NodeRate rate;
  Eigen::Vector3d bristle =
      Eigen::Vector3d::Zero();  ///< of the sticking friction, world axes; of a guided node along the hole, around it, and 0 [m]
  double rest = 0.0;            ///< how long that friction has stuck [s]
  int segment = -1;             ///< hole segment of the last contact search
  bool guided = false;          ///< confined to the hole (model/guides.h); then also:
  double md = 0.0;              ///< where in it [m]
  Eigen::Vector3d side = Eigen::Vector3d::Zero();  ///< of the hole's centre that it lies on, across the hole [m]

  template <class V>
  void visit(V& v)
  {
    v("position", position);
    v("orientation", orientation);
    v("spin_angle", spin_angle);
    v("rate", rate);
    v("bristle", bristle);
    v("rest", rest);
    v("segment", segment);
    v("guided", guided);
    v("md", md);
    v("side", side);
  }
};

/// Where the pipe between two nodes touches the wall.
struct SpanState
{
  double twist = 0.0;         ///< lower end relative to upper, only between two guided nodes [rad]
  double free_stretch = 0.0;  ///< what a change of level has made of the element's length without tension (levels.h) [-]
  Eigen::Vector3d bristle = Eigen::Vector3d::Zero();  ///< of the sticking friction at the element's middle, world axes [m]
  double rest = 0.0;                                  ///< how long that friction has stuck [s]
  int segment = -1;                                   ///< hole segment of the last contact search

  template <class V>
  void visit(V& v)
  {
    v("twist", twist);
    v("free_stretch", free_stretch);
    v("bristle", bristle);
    v("rest", rest);
    v("segment", segment);
  }
};

/// A quantity of the past that a method keeps: six coordinates per node, in the axes of the present section normals, and the
/// rotor's.
struct PastQuantity
{
  std::vector<NodeRate> nodes;
  double rotor = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("nodes", nodes);
    v("rotor", rotor);
  }
};

/// What a method of time stepping remembers of earlier steps. Which quantities, and in which order, is the method's own affair;
/// every state has room for this number, so that no step allocates.
struct MethodMemory
{
  static constexpr int room = 3;

  double last_step = 0.0;  ///< length of the step before; 0: nothing is remembered, a multistep method starts anew [s]
  std::vector<PastQuantity> past;

  template <class V>
  void visit(V& v)
  {
    v("last_step", last_step);
    v("past", past);
  }
};

/// Least and largest value so far.
struct ValueRange
{
  double least = 0.0, largest = 0.0;

  void add(double value) noexcept
  {
    if (value < least) least = value;
    if (value > largest) largest = value;
  }
  double span() const noexcept { return largest - least; }

  template <class V>
  void visit(V& v)
  {
    v("least", least);
    v("largest", largest);
  }
};

/// What the control of the step's length remembers (solve/step_control.h): the step that it wants next, and what the outputs have
/// ranged over, by which their errors are judged.
struct StepMemory
{
  double wanted = 0.0;                ///< 0: nothing is known yet [s]
  bool begun = false;                 ///< the ranges stand
  ValueRange hook_load, torque, wob;  ///< [N, N m, N]
  ValueRange bit_speed;               ///< [rad/s]

  template <class V>
  void visit(V& v)
  {
    v("wanted", wanted);
    v("begun", begun);
    v("hook_load", hook_load);
    v("torque", torque);
    v("wob", wob);
    v("bit_speed", bit_speed);
  }
};

/// Drill line, winch and block.
struct HoistState
{
  double line_length = 0.0;  ///< unstretched strung length L_0 [m]
  double winch_speed = 0.0;  ///< of the block, as paid out [m/s], + up
  double sheave_slip = 0.0;  ///< how far the sheaves' friction has built up: -1 lowering, 1 raising
  bool limited = false;
  bool at_stop = false;          ///< the winch stands at the block's lowest or highest place
  double rail_deflection = 0.0;  ///< of what the rail's friction holds the block by [m]
  FloorMotion floor;             ///< of the rotary table (rig/heave.h)
  double at_sea = 0.0;           ///< since the waves began, whatever the clock says [s]

  template <class V>
  void visit(V& v)
  {
    v("line_length", line_length);
    v("winch_speed", winch_speed);
    v("sheave_slip", sheave_slip);
    v("limited", limited);
    v("at_stop", at_stop);
    v("rail_deflection", rail_deflection);
    v("floor_height", floor.height);
    v("floor_speed", floor.speed);
    v("at_sea", at_sea);
  }
};

/// Bit, rock and motor.
struct BitState
{
  double twist = 0.0;         ///< bristle of the torque on bit [rad]
  double motor_speed = 0.0;   ///< of the bit relative to the string [rad/s]
  double motor_torque = 0.0;  ///< on the motor's rotor [N m]
  double turned = 0.0;        ///< by the motor since the start [rad]
  double mean_speed = 0.0;    ///< of the bit, behind its speed by the lag [rad/s]
  bool stalled = false;
  Eigen::Vector3d rock_velocity = Eigen::Vector3d::Zero();  ///< of the hole's bottom in the last step [m/s]

  template <class V>
  void visit(V& v)
  {
    v("twist", twist);
    v("motor_speed", motor_speed);
    v("motor_torque", motor_torque);
    v("turned", turned);
    v("mean_speed", mean_speed);
    v("stalled", stalled);
    v("rock_velocity", rock_velocity);
  }
};

/// A node that is held: where the formation grips the pipe, or the slips do.
struct HeldNode
{
  int node = -1;  ///< -1: none
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double spin_angle = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("node", node);
    v("position", position);
    v("spin_angle", spin_angle);
  }
};

/// Of the friction of a rotary steerable tool's pads (forces/pads.h).
struct PadsState
{
  Eigen::Vector2d bristle = Eigen::Vector2d::Zero();  ///< along the hole and around it [m]
  double rest = 0.0;                                  ///< how long it has stuck [s]

  template <class V>
  void visit(V& v)
  {
    v("bristle", bristle);
    v("rest", rest);
  }
};

/// Everything mechanical that the next step depends on: a value. visit() is the one list of its fields (math/visit.h).
struct State
{
  explicit State(Wellbore hole) : well(std::move(hole)) {}

  Wellbore well;
  double time = 0.0;  ///< [s]
  std::vector<NodeState> nodes;
  std::vector<SpanState> spans;  ///< one per element
  MethodMemory memory;
  StepMemory step;
  DriveState drive;
  HoistState hoist;
  BitState bit;
  CutGround ground;  ///< under the bit; only of the regenerative law, its fixed place the bottom at the start
  HeldNode stuck_point;
  HeldNode slips;  ///< of the rotary table, under a joint's end; its place as if the table were where it is in the mean
  PadsState pads;
  Eigen::Vector3d lean =
      Eigen::Vector3d::Zero();  ///< of a shaft that points the bit (pointing.h), across its collar, world axes [rad]
  FaultState faults;
  HydraulicState hydraulics;
  PressureWaveState mud_waves;  ///< empty without mud.pressure_waves
  CuttingsState cuttings;
  TemperatureState temperature;
  double flow = 0.0;  ///< through string, motor and bit; constant within a step [m3/s]

  template <class V>
  void visit(V& v)
  {
    v("well", well);
    v("time", time);
    v("nodes", nodes);
    v("spans", spans);
    v("memory", memory);
    v("step", step);
    v("drive", drive);
    v("hoist", hoist);
    v("bit", bit);
    v("ground", ground);
    v("stuck_point", stuck_point);
    v("slips", slips);
    v("pads", pads);
    v("lean", lean);
    v("faults", faults);
    v("hydraulics", hydraulics);
    v("mud_waves", mud_waves);
    v("cuttings", cuttings);
    v("temperature", temperature);
    v("flow", flow);
  }
};

/// Of the block above the rotary table, which heaves [m], and its velocity there [m/s], + up.
inline double block_height(const State& state) noexcept
{
  return state.nodes.back().position.z() - state.hoist.floor.height;
}
inline double block_velocity(const State& state) noexcept
{
  return state.nodes.back().rate.velocity.z() - state.hoist.floor.speed;
}

}  // namespace drill_rig_sim

#endif
