// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_RIG_DAE_H
#define DRILL_RIG_SIM_REFERENCE_RIG_DAE_H

#include <vector>

#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/rig/top_drive.h"
#include "drill_rig_sim/reference/constrained_bodies.h"
#include "drill_rig_sim/model/evaluate.h"

namespace drill_rig_sim
{
/// The whole rig as a DAE: the string's nodes and the rigid bodies bit, rotor, stator and travelling block, with their joints.
///
///   crown block    is the ground (its fixed joint holds identically)
///   block          hangs on the drill line; fixed joint to the stator
///   stator         guide rail on the ground
///   rotor          revolute joint to the stator, turned by the drive's torque
///   string's top   place and axis held by the rotor (five constraints), the torque meter's spring about the axis
///   bit            fixed joint to the string's lowest node; all forces of wall, rock and film at the bit act on it
///
/// `rig.hoisting.block_mass` is split among block, stator and rotor as 0.4, 0.4 and 0.2: rigidly connected along the rail, so
/// that the split changes the joints' forces only. Their moments of inertia, but for the rotor's about its axis, meet no
/// acceleration.
///
/// Forces are those of model/forces, by evaluate_motion(), with the bristles of wall and bit mapped back from the start of the
/// interval that begin() opens. Further states: the mud motor's speed and turn, and how far the bottom of the hole has moved (m'
/// = the rock-breaking velocity): the rock recedes in time, not by an implicit law over the interval.
class RigDae : public ConstrainedBodies
{
public:
  /// Takes the places of things from `state`, joints as they then are. All must outlive it: model, and the integrator's stage and
  /// workspace, which are its own while it is at work.
  RigDae(const Model& model, Stage& stage, Workspace& work, const State& state, Formulation formulation, double tolerance);

  /// y as `state` has it, at the bases.
  std::vector<double> initial(const State& state) const;
  /// Opens an interval at time `t` [s] and state y. `state` is the same motion as y; begin_step() has taken it into the stage,
  /// and it must stay as it is until the interval's end. True: the masses are others than before (a node has gone into the mud).
  bool begin(double t, const State& state, const Setpoints& setpoints, const std::vector<double>& y);
  /// The motion y, with rates `rate`, at `t` within the interval as a stage of the fixed-step methods' model and increments u (6
  /// per node) since the interval's start. `stage`: begun at that start; moved here.
  void fill_stage(double t, const double* y, const double* rate, Stage& stage, double* u);
  /// Writes the interval's end, y at `t`, into the state that begin() took, and the hole's extension.
  void finish(double t, const std::vector<double>& y, State& state);

protected:
  int further_count() const override { return 6; }
  void add_forces(double t, const double* y, double* force) override;
  void add_force_jacobian(double t, const double* y, SparseJacobian& j) override;
  void further_rates(double t, const double* y, double* rate) override;
  void further_tolerances(const double* y, double* tolerance) const override;

private:
  struct Rig
  {
    std::vector<RigidBody> bodies;
    std::vector<BodyMotion> motions;
    std::vector<Joint> joints;
  };
  struct Drive
  {
    DriveTorque by_drive;
    double turn;                                                           // of the rotor since the start of the interval [rad]
    double speed;                                                          // [rad/s]
    double twist;                                                          // of the torque meter [rad]
    double torques() const { return by_drive.motor + by_drive.friction; }  // on the rotor [N m]
  };
  struct BlockForces
  {
    LinePull pull;
    LineDamper damper;
    BristleForce rail;
    StopForce stop;
    double hook_load() const { return pull.hook_force + damper.force; }  // [N]
    double resistance() const { return rail.force + stop.force; }        // + up [N]
  };
  using BitAnswer = Eigen::Matrix<double, 12, 1>;  // minus the force on the bit, rates of the further states

  RigDae(const Model& model, Stage& stage, Workspace& work, Rig rig, Formulation formulation, double tolerance);
  static Rig rig_of(const Model& model, const State& state);
  static void add_string(const Mesh& mesh, const State& state, Rig& rig);
  int string_nodes() const { return model_.nodes(); }
  int bit() const { return string_nodes(); }
  int rotor() const { return string_nodes() + 1; }
  int stator() const { return string_nodes() + 2; }
  int block() const { return string_nodes() + 3; }
  void take_motion(double t, const double* y);
  GivenNode motion_of(int body, const double* y) const;
  BitDrive bit_drive(double motor_speed, double motor_turn, const Eigen::Vector3d& bottom, double mean_speed,
                     const GivenNode& bit) const;
  BitDrive bit_drive_at(const double* y, const GivenNode& bit) const;
  double steady_motor_speed() const;
  Drive drive_at(const double* y) const;
  BlockForces block_forces(const double* y) const;
  void add_rig_jacobian(const double* y, SparseJacobian& j);
  void add_bit_jacobian(SparseJacobian& j);
  BitAnswer bit_rates(const Vector6d& force) const;

  const Model& model_;
  Stage& stage_;
  Workspace& work_;
  double tolerance_;
  double start_time_ = 0.0;
  const State* start_ = nullptr;
  Setpoints setpoints_;
  std::vector<double> start_y_;
  std::vector<Eigen::Quaterniond> start_orientations_;
  GivenMotion motion_;
  std::vector<double> string_, contact_;
  BlockTridiagonal string_by_place_, string_by_both_, contact_by_place_, contact_by_both_;
};

}  // namespace drill_rig_sim

#endif
