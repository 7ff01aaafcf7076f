// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_WORKSPACE_H
#define DRILL_RIG_SIM_MODEL_WORKSPACE_H

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "drill_rig_sim/contact/bit_bottom.h"
#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/kernels/history_kernel.h"
#include "drill_rig_sim/model/kernels/motion_kernel.h"
#include "drill_rig_sim/model/kernels/place_kernel.h"
#include "drill_rig_sim/model/kernels/string_columns.h"
#include "drill_rig_sim/model/kernels/string_kernel.h"
#include "drill_rig_sim/model/kernels/wall_kernel.h"
#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/profiler.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/model/work.h"

namespace drill_rig_sim
{
/// Where and how a node moves at a stage, and where it is in the hole.
struct NodeMotion
{
  Eigen::Quaterniond orientation;
  Eigen::Vector3d axis;  ///< section normal that rates and rotations are split by: at the start of the step
  Eigen::Vector3d position, normal;
  Eigen::Vector3d tilt;  ///< of the increment, across the axis [rad]
  double spin;           ///< and about it [rad]
  double carried_spin;   ///< the part of the rate that stays about the normal when that tilts: the spin; 0 where rates are given
                         ///< [rad/s]
  Vector6d increment, rate, acceleration;
  ClosestPoint closest;  ///< of hole or mast
  bool touches;          ///< the wall
};

/// The middle of an element at a stage, on its cubic between two nodes: r = (r_u + r_l)/2 + a_u + a_l, with the arms a_u = L/8
/// n_u and a_l = -L/8 n_l, n the section normals. Its motions are v = (v_u + v_l)/2 + w_u x a_u + w_l x a_l and w = (w_u +
/// w_l)/2.
struct SpanMotion
{
  Eigen::Vector3d position;
  Eigen::Vector3d upper_arm, lower_arm;  ///< at the start of the step [m]
  Vector6d increment;                    ///< displacement and rotation since then [m, rad]
  ClosestPoint closest;                  ///< of hole or mast
  bool touches;                          ///< the wall
};

/// Where the bit is over its ground (contact/cut_ground.h) at a stage, and what its flats carry.
struct BitCutPlace
{
  double angle = 0.0;   ///< [rad]
  double height = 0.0;  ///< [m]
  double flats = 0.0;   ///< [N]
};

/// What the laws with a state of their own have come to at a stage: the next step's start, once this one is accepted.
struct StageResult
{
  std::vector<Eigen::Vector3d> bristle;       ///< of the wall's friction, per node [m]
  std::vector<Eigen::Vector3d> span_bristle;  ///< and per element [m]
  std::vector<double> rest, span_rest;        ///< how long that friction has stuck, per node and element [s]
  DriveState drive;
  double drive_increment = 0.0;     ///< of the rotor since the start of the step [rad]
  double drive_acceleration = 0.0;  ///< [rad/s2]
  double rail_deflection = 0.0;     ///< HoistState::rail_deflection [m]
  std::array<DragState, 2> drags;   ///< pack-off, differential sticking
  PadsState pads;
  BitState bit;
  BottomForce bottom;
  BitCutPlace cut;  ///< regenerative law
  RigForces forces;
  double held_force = 0.0;   ///< statics: vertical force that holds the top node, + up [N]
  double held_torque = 0.0;  ///< and the torque about the string, + drives it clockwise [N m]
};

/// Scratch of one thread: nothing in it outlives a call of evaluate() and what follows it for the same stage.
struct Workspace
{
  explicit Workspace(const Model& model);

  std::vector<NodeMotion> nodes;  ///< of guided nodes only where motion_known is set: forces read them by StageContext::node()
  std::vector<SpanMotion> spans;  ///< one per element
  GuidedMotions guided;           ///< of the nodes
  std::vector<unsigned char> motion_known;  ///< per node: `nodes` holds its motion at this stage; of free nodes always
  std::vector<unsigned char>
      rows_open;  ///< per node: forces can be added to its rows (ForceRows); of free nodes always, of guided ones where one was
  StringColumns columns;  ///< the same for the batch kernels
  // batch kernels of the free string; all null: one by one, for any kind of element
  const MotionKernel* motion;
  const StringKernel* string;
  const PlaceKernel* place;
  const WallKernel* wall;
  const HistoryKernel* history;
  StageResult result;
  std::vector<double> unused;  ///< 6 per node: a residual that is not used
  Profiler profiler;           ///< where the time goes; evaluate() times its parts, its callers theirs
  Work work;                   ///< evaluate() and update() count their own, solvers theirs
};

}  // namespace drill_rig_sim

#endif
