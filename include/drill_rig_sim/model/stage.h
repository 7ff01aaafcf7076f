// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_STAGE_H
#define DRILL_RIG_SIM_MODEL_STAGE_H

#include <Eigen/Core>
#include <array>
#include <vector>

#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/columns.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/rig/top_drive.h"

namespace drill_rig_sim
{
struct GuidedKernel;
struct GuidedStepKernel;

/// What turns the bit and moves the bottom under it within the step.
struct BitDrive
{
  double motor_speed = 0.0;     ///< of the mud motor, relative to the string [rad/s]
  double motor_turn = 0.0;      ///< since the start of the step [rad]
  double mean_speed = 0.0;      ///< of the bit, behind its speed by the lag [rad/s]
  double drilling_speed = 0.0;  ///< that the rock-breaking law sees, drilling_speed() [rad/s]
  double rock_time = 0.0;       ///< over which the bottom recedes implicitly, by the law at the stage [s]
  bool bottom_known = false;    ///< another integrator has the bottom:
  Eigen::Vector3d bottom_increment = Eigen::Vector3d::Zero();  ///< how far it has receded since the start of the step [m]
};

/// What drags at a place, during the step (forces/place_drag.h).
struct PlaceDrag
{
  int node = -1;          ///< on which it acts; -1: there is none
  double most = 0.0;      ///< [N]
  double lever = 0.0;     ///< about the pipe's axis [m]
  double pressure = 0.0;  ///< of mud that a pack-off holds back [Pa]
};

/// The pads of a rotary steerable tool, during the step (forces/pads.h).
struct Pads
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< F, on the tool, across the string [N]
  double normal_force = 0.0;                         ///< |F|; 0: the rest is not looked at [N]
  Eigen::Vector3d around = Eigen::Vector3d::Zero();  ///< c, unit
  double lever = 0.0;                                ///< R [m]
  double friction = 0.0;                             ///< kinetic [-]
  WallLaw law;
};

/// One stage of a step of a method: which forces act, and how rates follow from the unknowns. A value; together with the step's
/// start and the increments u it determines every force.
///
/// Unknowns: six per node, u = (displacement, tilt + spin) since the start of the step; the rotation is exp(tilt) exp(spin n), n
/// the section normal at the start: spin is a scalar however large, and the tilt of one step is small. Node by node,
///   rate = dv_du u + rate_0,   acceleration = da_du u + acceleration_0.
struct Stage
{
  explicit Stage(const Model& model);
  /// Its columns.
  template <class V>
  void visit(V& v)
  {
    v("free", free);
    v("immersed", immersed);
    v("added_mass", added_mass);
    v("load", load);
    v("free_stretch", free_stretch);
  }

  // how the method ties rates to u
  double time = 0.0;                   ///< from the start of the step, for the laws that advance their own state [s]
  double dv_du = 0.0;                  ///< [1/s]
  double da_du = 0.0;                  ///< [1/s2]
  std::vector<Vector6d> rate;          ///< rate_0: velocity, tilt rate + spin rate n, world axes [m/s, rad/s]
  std::vector<Vector6d> acceleration;  ///< acceleration_0 [m/s2, rad/s2]
  RotorStage drive;                    ///< the same for the top drive's rotor; its time is not looked at

  // what holds during the whole step; begin_step() or begin_static() finds it
  std::vector<Eigen::Vector3d> normal;  ///< n, of the nodes
  Column free;                          ///< 1 of a free node, 0 of a guided one
  Column immersed;                      ///< 1 for a node below the rotary table, 0 above
  Column added_mass;    ///< of the mud that moves sideways with a node; of the bit none, its gauge squeezes a film [kg]
  Columns<3> load;      ///< weight of the elements in mud, less what lifts them up the annulus [N]
  Column free_stretch;  ///< of the elements, by the pump's pressure (mud_circuit.h) [-]
  bool sides_stay =
      false;  ///< guided pipe stays in the middle of its hole: a rigid string would be jerked by what going to its wall moves
  bool any_guided = false;            ///< whether there is anything in these:
  GuideColumns guides;                ///< of the nodes
  const GuidedKernel* guided_kernel;  ///< what works on them; null: one by one
  const GuidedStepKernel* guided_step_kernel;
  Runs guided_nodes, guided_elements;  ///< those that are guided
  std::array<PlaceDrag, 2> drags;      ///< pack-off, differential sticking
  Runs inner_nodes;  ///< and of these nodes those on which only the guided string's forces act, but for the bit's gauge
  double structural_damping = 0.0;  ///< [s]
  Setpoints setpoints;
  Pads pads;              ///< none in statics
  SlidingMotion sliding;  ///< of the string in the hole; statics only

  // where the laws with a time history of their own are at `time`
  HoistState hoist;
  Eigen::Vector3d lean = Eigen::Vector3d::Zero();  ///< of a shaft that points the bit (pointing.h), across the collar's section
                                                   ///< normal at the start [rad]
  BitDrive bit;
};

/// Takes `state` as the start of a step of length `step` [s], with the set points that act in it; the stage is at its end.
void begin_step(const Model& model, const State& state, double step, const Setpoints& setpoints, Stage& stage) noexcept;

/// The stage is at `time` [s] after the start of the step: methods of several stages.
void move_stage(const Model& model, const State& state, double time, Stage& stage) noexcept;

/// Statics: no rates, full slip as `sliding` says. `coefficient` c [1/s] > 0 adds the inertia of a start from rest, M c^2 u: a
/// step of pseudo-transient continuation.
void begin_static(const Model& model, const State& state, const SlidingMotion& sliding, double coefficient,
                  Stage& stage) noexcept;

}  // namespace drill_rig_sim

#endif
