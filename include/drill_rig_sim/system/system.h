#ifndef DRILL_RIG_SIM_SYSTEM_SYSTEM_H
#define DRILL_RIG_SIM_SYSTEM_SYSTEM_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/contact/bit_bottom.h"
#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/block_tridiagonal.h"
#include "drill_rig_sim/math/profiler.h"
#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/rig/top_drive.h"
#include "drill_rig_sim/scene/scene.h"
#include "drill_rig_sim/string/beam_table.h"
#include "drill_rig_sim/string/mesh.h"
#include "drill_rig_sim/system/energy_sample.h"
#include "drill_rig_sim/system/state.h"
#include "drill_rig_sim/system/work.h"
#include "drill_rig_sim/well/formation.h"

namespace drill_rig_sim
{
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Friction between string and wall.
enum class FrictionMode
{
  sticking,  ///< bristle law: dynamics
  none,      ///< frictionless statics
  up,        ///< full slip of a string that moves up the hole
  down,      ///< down the hole
  rotate     ///< that turns clockwise
};

/// How a stage of a method ties rates to the unknown increments u since the start of the step: rate = dv_du u + rate_0,
/// acceleration = da_du u + acceleration_0, node by node. Translation in world axes; rotation as tilt (world axes, across
/// the section normal at the step's start) plus spin about that normal, added up in one vector.
struct Stage
{
  double time = 0.0;               ///< from the start of the step, for the laws that advance their own state [s]
  double dv_du = 0.0;          ///< [1/s]
  double da_du = 0.0;  ///< [1/s2]
  std::vector<Vector6d> rate;          ///< rate_0
  std::vector<Vector6d> acceleration;  ///< acceleration_0
  RotorStage drive;                    ///< the same for the top drive's rotor; its time is not looked at
};

/// A node's motion given outright instead of through a stage.
struct NodeMotion
{
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
  Vector6d moved;  ///< displacement and rotation since the start of the step, for the laws with memory [m, rad]
  Vector6d rate;   ///< velocity and angular velocity, world axes [m/s, rad/s]
};

/// A motion that somebody else integrates.
struct GivenMotion
{
  double time = 0.0;              ///< since the start of the step [s]
  std::vector<NodeMotion> nodes;
  NodeMotion bit;                 ///< of the bit as a body of its own, on the string's lowest node
  double motor_speed = 0.0;       ///< of the bit relative to the string [rad/s]
  double motor_turn = 0.0;        ///< its integral since the start of the step [rad]
  Eigen::Vector3d bottom_moved = Eigen::Vector3d::Zero();  ///< of the hole's bottom since the start of the step [m]
};

/// Forces at the state that finish() made, for measurements and energy balances.
struct SystemForces
{
  std::vector<double> tension;          ///< of the elements [N]
  std::vector<double> torque;           ///< of the elements [N m]
  std::vector<double> bending_moment;   ///< at the nodes, from the element below [N m]
  std::vector<double> contact;          ///< normal, at the nodes [N]
  std::vector<Eigen::Vector3d> wall;    ///< wall on string, at the nodes [N]
  Eigen::Vector3d bit_force = Eigen::Vector3d::Zero();   ///< rock on bit [N]
  Eigen::Vector3d bit_moment = Eigen::Vector3d::Zero();  ///< rock on bit about its centre [N m]
  Eigen::Vector3d rock_force = Eigen::Vector3d::Zero();  ///< bit on rock that breaks it: bottom normal and gauge normal [N]
  double wob = 0.0;         ///< [N]
  double bit_torque = 0.0;  ///< rock against the bit's turning [N m]
  double bit_speed = 0.0;   ///< [rad/s]
  double hook_load = 0.0;   ///< of the lines on the block [N]
  double meter_torque = 0.0;  ///< [N m]
  double drive_torque = 0.0;  ///< of the top drive's motor [N m]
};

/// The mechanics of rig, string, well and rock at one instant: residual and tangent of one implicit stage. Holds the constant model
/// and scratch space, no time and no state.
///
/// Coordinates: six per node, u = (displacement, tilt + spin) since the start of the step; the rotation is exp(tilt) exp(spin n), n the
/// section normal at the start: spin is a scalar however large, and the tilt of one step is small.
/// The top node is the shaft of the top drive: height and spin are free, the rest is held by the guide rail (rows of the identity).
/// The block's mass moves with it; the rotor is condensed into the spin's row.
class System
{
public:
  System(const Scene& scene, Mesh mesh);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  const Mesh& mesh() const noexcept { return mesh_; }
  const Scene& scene() const noexcept { return scene_; }
  const Formation& formation() const noexcept { return formation_; }
  int nodes() const noexcept { return static_cast<int>(mesh_.nodes.size()); }
  Stage& stage() noexcept { return stage_; }

  /// Takes `state` as the start of a step of length `step` [s]; set points act from here. The state must outlive the calls below.
  /// The stage is at the step's end.
  void begin(const SystemState& state, double step, const Setpoints& setpoints) noexcept;
  /// The stage is at `time` [s] after the start of the step: methods of several stages.
  void stage_at(double time) noexcept;
  /// Statics instead: friction as given, top node held at its height and spin, no rig.
  /// `coefficient` c [1/s] > 0 adds the inertia of a start from rest, M c^2 u: a step of pseudo-transient continuation.
  void begin_static(const SystemState& state, FrictionMode friction, double coefficient = 0.0) noexcept;

  /// Residual R(u) and, unless null, its tangent dR/du. u, residual: 6 per node, bit first.
  void evaluate(const double* u, double* residual, BlockTridiagonal* tangent) noexcept;
  /// All forces but the rig's at a motion given outright: no inertia, nothing held. `string`: of elements, weight and mud on the nodes;
  /// `contact`: of wall, rock, stuck point and the bit's weight, row 0 on the bit as a body of its own; both 6 per node, overwritten: force and
  /// moment that must be put on the node so that it does not accelerate (world axes). Tangents, unless null: with respect to positions and
  /// spatial rotations, plus the stage's dv_du times that with respect to the rates; that of `contact` has diagonal blocks only.
  /// finish() then takes this motion; the rig's share in the state is the caller's.
  void evaluate_motion(const GivenMotion& motion, double* string, double* contact, BlockTridiagonal* string_tangent,
                       BlockTridiagonal* contact_tangent) noexcept;
  /// Row 0 of `contact` alone.
  Vector6d evaluate_bit_motion(const GivenMotion& motion) noexcept;
  /// Velocity of the hole's bottom at the bit's last forces [m/s].
  Eigen::Vector3d rock_velocity() const noexcept;
  /// Steady speed of the mud motor at the bit's last forces; 0 without one [rad/s].
  double steady_motor_speed() const noexcept;
  /// Line and winch at the stage.
  const HoistState& hoist() const noexcept { return hoist_end_; }
  /// For forces(): what the caller of evaluate_motion() found at the rig.
  void note_rig(double hook_load, double meter_torque) noexcept;
  /// Share of a node's added mass that moves with it: 1 below the rotary table, 0 above.
  double immersed(int i) const noexcept { return scratch_[i].immersed; }
  /// After a solution: everything finish() takes, at u. Like evaluate() without elements and inertia, whose forces it leaves alone.
  void settle(const double* u) noexcept;
  /// Accelerations that balance the residual of the last evaluate(), whose own accelerations must be zero: explicit methods.
  void accelerate(const double* residual) noexcept;
  /// y = M x with the mass matrix of accelerate(), 6 per node each, in the coordinates of u; 0 in the rows that the guide rail holds.
  void multiply_mass(const double* x, double* y) const noexcept;
  /// Acceleration of a node at the last evaluate() or accelerate(), in the coordinates of u.
  const Vector6d& acceleration(int i) const noexcept { return scratch_[i].acceleration; }
  /// What the rotor has turned since the start of the step when the nodes have moved by u [rad].
  double drive_increment(const double* u) const noexcept;
  /// Forces inside the string at the state last evaluated or settled: tension, torque, bending moment of forces().
  void evaluate_string_forces() noexcept;
  /// Writes the state of the last evaluate() or settle(): configuration, rates, bristles, drive, hoist, bit. Its history becomes that of
  /// this step.
  /// `state` may be the one that begin() took.
  void finish(SystemState& state) const noexcept;
  /// Forces at the last evaluate().
  const SystemForces& forces() const noexcept { return forces_; }
  /// What must hold the top node in statics: vertical force [N] and torque about the string [N m] on the string.
  double top_force() const noexcept { return top_force_; }
  double top_torque() const noexcept { return top_torque_; }

  /// Of the bristle that carries a stuck bit's torque [N m/rad].
  double bit_bristle_stiffness() const noexcept { return bit_bristle_; }

  /// Velocity of the hole's bottom under the bit as finish() left it (three-dimensional rock-breaking velocity) [m/s].
  Eigen::Vector3d rock_velocity(const SystemState& state) const noexcept;

  /// The kind of element has an energy: the next two may be called.
  bool has_energy() const noexcept { return beam_.energy != nullptr; }
  /// Energies at the state last evaluated or settled, before finish().
  StoredEnergy stored_energy() const noexcept;
  /// Energies, forces and rates there, for an energy balance; the stage's accelerations must be those of the method. Leaves everything as it
  /// was. Allocates when `out` or the system has not been used for it before.
  void sample_energy(EnergySample& out) noexcept;

  /// Where the time goes; evaluate() times its parts, its callers theirs.
  Profiler& profiler() noexcept { return profiler_; }
  /// evaluate() and settle() count their own, solvers theirs.
  Work& work() noexcept { return work_; }

private:
  struct NodeScratch
  {
    Eigen::Vector3d normal_start;  // n at the start of the step
    Eigen::Vector3d position, normal;
    Eigen::Quaterniond orientation;
    Eigen::Vector3d tilt;
    double spin;
    Vector6d increment, rate, acceleration;
    double immersed;  // 1 below the rotary table
    ClosestPoint closest;
    Eigen::Vector3d bristle;
  };

  // What turns the bit and moves the bottom under it within the step.
  struct BitDrive
  {
    double motor_speed, motor_turn;  // relative to the string [rad/s], since the start of the step [rad]
    double drilling_speed;           // that the rock-breaking law sees [rad/s]
    double rock_time;                // over which the bottom recedes implicitly, by the law at the stage [s]
    double bottom_moved;             // and how far it is known to have receded [m]
  };

  void begin_common(const SystemState& state) noexcept;
  void configure(const double* u) noexcept;
  void take_bit(const GivenMotion& motion) noexcept;
  void add_wall(int i, double* residual, BlockTridiagonal* tangent) noexcept;
  void assemble(double* residual, BlockTridiagonal* tangent) noexcept;
  BeamPose element_pose(int e) const noexcept;
  BeamForces element_forces(int e, BeamTangent* tangent) noexcept;
  void add_elements(double* residual, BlockTridiagonal* tangent) noexcept;
  void place(int i, const NodeMotion& motion) noexcept;
  void add_mud_damping(double* residual, BlockTridiagonal* tangent) noexcept;
  void add_inertia(double* residual, BlockTridiagonal* tangent) noexcept;
  WallForce wall_force(int i, double radius, Eigen::Matrix<double, 6, 6>* block) noexcept;
  void add_squeeze_film(int i, double* residual, BlockTridiagonal* tangent) noexcept;
  void add_walls(double* residual, BlockTridiagonal* tangent) noexcept;
  void add_stuck_point(double* residual, BlockTridiagonal* tangent) noexcept;
  void add_bit(double* residual, BlockTridiagonal* tangent) noexcept;
  void add_rig(double* residual, BlockTridiagonal* tangent) noexcept;
  void hold_top(double* residual, BlockTridiagonal* tangent) noexcept;
  static void scatter(const BeamTangent& t, int e, BlockTridiagonal& tangent) noexcept;
  double mass_across(int i) const noexcept;
  double element_weight(int e, double z_lower, double z_upper) const noexcept;
  bool touches_wall(int i) const noexcept;
  double weight_potential() const noexcept;
  void sample_elements(EnergySample& out) noexcept;
  void sample_node(int i, EnergySample& out) const noexcept;
  void sample_wall(int i, EnergySample& out) noexcept;
  void sample_bit(EnergySample& out) const noexcept;
  void sample_rig(EnergySample& out) const noexcept;
  void sample_residual(std::vector<double>& out) noexcept;
  HoistState advance_hoist(const SystemState& state, double step) const noexcept;
  RotorResult drive_at(double top_spin) const noexcept;
  Eigen::Vector3d rock_velocity_at(const Wellbore& well, const Eigen::Vector3d& bit_axis) const noexcept;

  Scene scene_;
  Mesh mesh_;
  const BeamKind& beam_;
  Formation formation_;
  std::vector<ContactSpec> contact_;  // per node
  const MotorSpec* motor_ = nullptr;     // into scene_; null: none
  double bit_bristle_ = 0.0;            // [N m/rad]
  Stage stage_;
  Setpoints setpoints_;
  const SystemState* start_ = nullptr;
  bool static_ = false;
  FrictionMode friction_ = FrictionMode::sticking;
  std::vector<NodeScratch> scratch_;
  std::vector<Eigen::Vector3d> loads_;  // weight of the elements in mud [N]
  double damping_time_ = 0.0;  // structural damping [s]
  std::vector<double> unused_residual_;  // of settle()
  SystemForces forces_;
  std::vector<NodeScratch> kept_scratch_;  // of sample_energy()
  SystemForces kept_forces_;
  HoistState hoist_end_;
  DriveState drive_end_;
  BitState bit_end_;
  BitDrive bit_drive_{};
  BottomForce bottom_;
  double top_force_ = 0.0;
  double top_torque_ = 0.0;
  Profiler profiler_;
  Work work_;
};

}  // namespace drill_rig_sim

#endif
