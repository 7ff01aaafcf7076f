// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/rig_dae.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
// shares of rig.hoisting.block_mass
constexpr double kBlockShare = 0.4, kStatorShare = 0.4, kRotorShare = 0.2;
// centres above the shaft, which is where the rotor's is [m]
constexpr double kStatorAbove = 1.0, kBlockAbove = 4.0;
// of what the joints keep from turning: any will do
constexpr double kGyrationSquare = 1.0;  // [m2]
// motor's speed and turn, the bottom's place, and the bit's mean speed
constexpr int kMotorSpeed = 0, kMotorTurn = 1, kBottom = 2, kMeanSpeed = kBottom + 3;
// finite differences of the bit's forces: [m, rad], [m/s, rad/s]
constexpr double kPlaceStep = 1e-8, kRateStep = 1e-6;

/// Rotation since `start` as tilt across n plus spin about n, n the normal at the start.
Vector3d tilt_and_spin(const Quaterniond& start, const Quaterniond& now)
{
  const Vector3d n = x_axis(start);
  Quaterniond turned = now * start.conjugate();
  if (turned.w() < 0.0) turned.coeffs() *= -1.0;
  const double spin = 2.0 * std::atan2(turned.vec().dot(n), turned.w());
  const Quaterniond swing = turned * rotation_from_vector(-spin * n);
  const double sine = swing.vec().norm();
  const double factor = sine > 1e-8 ? 2.0 * std::atan2(sine, swing.w()) / sine : 2.0;
  return factor * swing.vec() + spin * n;
}
}  // namespace

RigDae::Rig RigDae::rig_of(const Model& model, const State& state)
{
  Rig rig;
  add_string(model.mesh(), state, rig);
  const int top = static_cast<int>(model.mesh().nodes.size()) - 1;
  const int bit = top + 1, rotor = top + 2, stator = top + 3, block = top + 4;
  const auto motion = [&rig](int body) -> BodyMotion& { return rig.motions[static_cast<std::size_t>(body)]; };
  const RigSpec& spec = model.scene().rig;
  const BodyMotion shaft = motion(top);
  for (const double share : {kRotorShare, kStatorShare, kBlockShare})
  {
    const double mass = share * spec.hoisting.block_mass, inertia = mass * kGyrationSquare;
    rig.bodies.push_back({mass, 0.0, inertia, inertia});
    rig.motions.push_back(shaft);
    rig.motions.back().angular_velocity.setZero();
  }
  rig.bodies[static_cast<std::size_t>(rotor)].spin_inertia = spec.top_drive.inertia;
  motion(rotor).angular_velocity = state.drive.speed * shaft.normal;
  motion(stator).position.z() += kStatorAbove;
  motion(block).position.z() += kBlockAbove;

  rig.joints.push_back(fixed_joint(0, motion(0), bit, motion(bit)));
  rig.joints.push_back(revolute_joint(rotor, motion(rotor), top, motion(top)));
  rig.joints.push_back(revolute_joint(stator, motion(stator), rotor, motion(rotor)));
  rig.joints.push_back(guide_rail(-1, BodyMotion(), stator, motion(stator)));
  rig.joints.push_back(fixed_joint(stator, motion(stator), block, motion(block)));
  return rig;
}

/// A body for each node of the string, and one for the bit.
void RigDae::add_string(const Mesh& mesh, const State& state, Rig& rig)
{
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
  {
    const MeshNode& node = mesh.nodes[i];
    const NodeState& s = state.nodes[i];
    rig.bodies.push_back({node.mass, 0.0, node.spin_inertia, node.tilt_inertia});
    const Vector3d n = x_axis(s.orientation);
    rig.motions.push_back({s.position, s.orientation, n, s.rate.velocity, s.rate.tilt + s.rate.spin * n});
  }
  // the bit leaves the lowest node, where the mesh has lumped it
  const double bit_inertia = 0.4 * mesh.bit_mass * mesh.bit_radius * mesh.bit_radius;
  RigidBody& lowest = rig.bodies.front();
  lowest.mass -= mesh.bit_mass;
  lowest.spin_inertia -= bit_inertia;
  lowest.tilt_inertia -= bit_inertia;
  rig.bodies.push_back({mesh.bit_mass, 0.0, bit_inertia, bit_inertia});
  rig.motions.push_back(rig.motions.front());
}

RigDae::RigDae(const Model& model, Stage& stage, Workspace& work, const State& state, Formulation formulation, double tolerance)
    : RigDae(model, stage, work, rig_of(model, state), formulation, tolerance)
{
}

RigDae::RigDae(const Model& model, Stage& stage, Workspace& work, Rig rig, Formulation formulation, double tolerance)
    : ConstrainedBodies(std::move(rig.bodies), rig.motions, std::move(rig.joints), formulation,
                        {0.01 * tolerance, 0.01 * tolerance, tolerance, tolerance, tolerance}),
      model_(model),
      stage_(stage),
      work_(work),
      tolerance_(tolerance)
{
  const auto n = static_cast<std::size_t>(string_nodes());
  motion_.nodes.resize(n);
  string_.resize(6 * n);
  contact_.resize(6 * n);
  for (BlockTridiagonal* matrix : {&string_by_place_, &string_by_both_, &contact_by_place_, &contact_by_both_})
    matrix->resize(string_nodes());
}

std::vector<double> RigDae::initial(const State& state) const
{
  std::vector<double> y = at_bases();
  y.data()[further_at() + kMotorSpeed] = state.bit.motor_speed;
  y.data()[further_at() + kMeanSpeed] = state.bit.mean_speed;
  return y;
}

bool RigDae::begin(double t, const State& state, const Setpoints& setpoints, const std::vector<double>& y)
{
  start_time_ = t;
  start_ = &state;
  setpoints_ = setpoints;
  start_y_ = y;
  read(y.data());
  start_orientations_.clear();
  for (int i = 0; i <= bit(); ++i) start_orientations_.push_back(motion(i).orientation);

  bool changed = false;
  auto set_added = [&](int body, double added)
  {
    double& value = bodies()[static_cast<std::size_t>(body)].added_mass;
    changed = changed || value != added;
    value = added;
  };
  for (int i = 0; i < string_nodes(); ++i) set_added(i, stage_.added_mass[static_cast<std::size_t>(i)]);
  return changed;
}

GivenNode RigDae::motion_of(int body, const double* y) const
{
  const BodyMotion& m = motion(body);
  GivenNode out;
  out.position = m.position;
  out.orientation = m.orientation;
  // the places themselves would lose digits
  out.increment << Map<const Vector3d>(y + 12 * body) - Map<const Vector3d>(start_y_.data() + 12 * body),
      tilt_and_spin(start_orientations_[static_cast<std::size_t>(body)], m.orientation);
  out.rate << m.velocity, m.angular_velocity;
  return out;
}

/// What the forces are to see of y: the stage's place in the step, and the motion.
void RigDae::take_motion(double t, const double* y)
{
  move_stage(model_, *start_, t - start_time_, stage_);
  for (int i = 0; i < string_nodes(); ++i) motion_.nodes[static_cast<std::size_t>(i)] = motion_of(i, y);
  motion_.bit = motion_of(bit(), y);
  stage_.bit = bit_drive_at(y, motion_.bit);
}

BitDrive RigDae::bit_drive_at(const double* y, const GivenNode& bit) const
{
  const double* now = y + further_at();
  const double* before = start_y_.data() + further_at();
  return bit_drive(now[kMotorSpeed], now[kMotorTurn] - before[kMotorTurn],
                   Map<const Vector3d>(now + kBottom) - Map<const Vector3d>(before + kBottom), now[kMeanSpeed], bit);
}

/// The rock recedes in time: nothing within the law's own implicit step.
BitDrive RigDae::bit_drive(double motor_speed, double motor_turn, const Vector3d& bottom, double mean_speed,
                           const GivenNode& bit) const
{
  const double speed = bit.rate.tail<3>().dot(x_axis(bit.orientation)) + motor_speed;
  return {motor_speed, motor_turn, mean_speed, drilling_speed(mean_speed, speed), 0.0, true, bottom};
}

RigDae::Drive RigDae::drive_at(const double* y) const
{
  const int top = string_nodes() - 1;
  Drive out;
  out.turn = spin(rotor(), y) - spin(rotor(), start_y_.data());
  out.speed = motion(rotor()).angular_velocity.dot(motion(rotor()).normal);
  out.twist = start_->drive.meter_twist + out.turn - (spin(top, y) - spin(top, start_y_.data()));
  out.by_drive = drive_torque(model_.scene().rig.top_drive, setpoints_.top_drive, start_->drive, stage_.time, out.turn, out.speed,
                              out.twist);
  return out;
}

RigDae::BlockForces RigDae::block_forces(const double* y) const
{
  const HoistingSpec& spec = model_.scene().rig.hoisting;
  const BodyMotion& m = motion(block());
  const int z = 12 * block() + 2;
  const double height = m.position.z() - kBlockAbove, lift = y[z] - start_y_[static_cast<std::size_t>(z)];
  const LinePull pull = line_pull(spec, height, stage_.hoist.line_length);
  return {pull, line_damper(spec, pull, m.velocity.z(), stage_.hoist.winch_speed),
          rail_bristle(spec, start_->hoist.rail_deflection).at(lift, m.velocity.z(), stage_.time),
          stop_force(spec, height, m.velocity.z())};
}

void RigDae::add_forces(double t, const double* y, double* force)
{
  take_motion(t, y);
  evaluate_motion(model_, *start_, stage_, motion_, work_, string_.data(), contact_.data(), nullptr, nullptr);
  Map<Eigen::VectorXd>(force, 6 * string_nodes()) += Map<const Eigen::VectorXd>(string_.data(), 6 * string_nodes());
  Map<Eigen::VectorXd>(force + 6, 6 * (string_nodes() - 1)) +=
      Map<const Eigen::VectorXd>(contact_.data() + 6, 6 * (string_nodes() - 1));
  Map<Vector6>(force + 6 * bit()) += Map<const Vector6>(contact_.data());

  for (const int body : {rotor(), stator(), block()})
    force[6 * body + 2] += standard_gravity * bodies()[static_cast<std::size_t>(body)].mass;
  const BlockForces on_block = block_forces(y);
  force[6 * block() + 2] -= on_block.hook_load() + on_block.resistance();
  const Drive drive = drive_at(y);
  const double meter = model_.scene().rig.top_drive.meter_stiffness * drive.twist;
  const int top = string_nodes() - 1;
  Map<Vector3d>(force + 6 * rotor() + 3) += (meter - drive.torques()) * motion(rotor()).normal;
  Map<Vector3d>(force + 6 * stator() + 3) += drive.torques() * motion(rotor()).normal;
  Map<Vector3d>(force + 6 * top + 3) -= meter * motion(top).normal;
}

void RigDae::further_rates(double, const double*, double* rate)
{
  const BitAnswer answer = bit_rates(Vector6d::Zero());
  std::copy_n(answer.data() + 6, 6, rate);
}

double RigDae::steady_motor_speed() const
{
  const MotorSpec* motor = model_.motor();
  if (!motor) return 0.0;
  return mud_motor_steady_speed(start_->flow, motor->displacement_per_rev, motor->stall_torque, motor->curve_exponent,
                                work_.result.forces.motor_torque)
      .value;
}

/// `force` and the rates of the further states at the bit's last forces.
RigDae::BitAnswer RigDae::bit_rates(const Vector6d& force) const
{
  BitAnswer out;
  out << force, (steady_motor_speed() - stage_.bit.motor_speed) / mud_motor_lag, stage_.bit.motor_speed,
      rock_velocity(model_, *start_, work_.result.forces, stage_.bit.drilling_speed, work_.nodes[0].normal),
      (work_.result.forces.bit_speed - stage_.bit.drilling_speed) / model_.bit().speed_lag;
  return out;
}

void RigDae::further_tolerances(const double* y, double* tolerance) const
{
  tolerance[kMotorSpeed] = tolerance_ * (1.0 + std::abs(y[further_at() + kMotorSpeed]));
  tolerance[kMotorTurn] = 0.01 * tolerance_;
  std::fill_n(tolerance + kBottom, 3, 0.01 * tolerance_);
  tolerance[kMeanSpeed] = tolerance_ * (1.0 + std::abs(y[further_at() + kMeanSpeed]));
}

void RigDae::add_force_jacobian(double t, const double* y, SparseJacobian& j)
{
  take_motion(t, y);
  // at fixed rates, and with d/d(rate) on top
  stage_.dv_du = 1.0;
  evaluate_motion(model_, *start_, stage_, motion_, work_, string_.data(), contact_.data(), &string_by_both_, &contact_by_both_);
  stage_.dv_du = 0.0;
  evaluate_motion(model_, *start_, stage_, motion_, work_, string_.data(), contact_.data(), &string_by_place_,
                  &contact_by_place_);
  auto add = [&](int row, int column, const Matrix6& place, const Matrix6& both)
  { add_force_derivative(row, column, place, both - place, j); };
  for (int i = 0; i < string_nodes(); ++i)
  {
    add(i, i, string_by_place_.diagonal(i), string_by_both_.diagonal(i));
    if (i > 0) add(i, i, contact_by_place_.diagonal(i), contact_by_both_.diagonal(i));
    if (i + 1 == string_nodes()) continue;
    add(i, i + 1, string_by_place_.upper(i), string_by_both_.upper(i));
    add(i + 1, i, string_by_place_.lower(i), string_by_both_.lower(i));
  }
  add_rig_jacobian(y, j);
  add_bit_jacobian(j);
}

void RigDae::add_rig_jacobian(const double* y, SparseJacobian& j)
{
  const int top = string_nodes() - 1;
  const BlockForces on_block = block_forces(y);
  Matrix6 by_height = Matrix6::Zero(), by_velocity = Matrix6::Zero();
  by_height(2, 2) = on_block.pull.stiffness - on_block.rail.by_move + on_block.stop.stiffness;
  by_velocity(2, 2) = on_block.damper.damping + on_block.stop.damping - on_block.rail.by_speed;
  add_force_derivative(block(), block(), by_height, by_velocity, j);

  const Drive drive = drive_at(y);
  auto about = [&](int row, int column, double torque, double by_turn, double by_speed)
  {
    const Matrix3d axes = motion(row).normal * motion(column).normal.transpose();
    Matrix6 place = Matrix6::Zero(), rate = Matrix6::Zero();
    place.bottomRightCorner<3, 3>() = by_turn * axes - torque * skew(motion(column).normal);
    rate.bottomRightCorner<3, 3>() = by_speed * axes;
    add_force_derivative(row, column, place, rate, j);
  };
  const double spring = model_.scene().rig.top_drive.meter_stiffness;
  const double meter = spring * drive.twist, motor = drive.torques();
  const double fed_back = spring * drive.by_drive.by_meter, by_turn = drive.by_drive.by_turn + fed_back;
  about(rotor(), rotor(), meter - motor, spring - by_turn, -drive.by_drive.by_speed);
  about(rotor(), top, 0.0, fed_back - spring, 0.0);
  about(stator(), rotor(), motor, by_turn, drive.by_drive.by_speed);
  if (fed_back != 0.0) about(stator(), top, 0.0, -fed_back, 0.0);
  about(top, rotor(), 0.0, -spring, 0.0);
  about(top, top, -meter, spring, 0.0);
}

namespace
{
struct BitMotion
{
  GivenNode node;
  double motor_speed, motor_turn, mean_speed;
  Vector3d bottom;
};
using BitColumn = Eigen::Matrix<double, 12, 1>;

/// Derivative of what the bit answers to a motion, by central differences.
/// @param move  moves it along one coordinate, by `step` or back
template <class Answer, class Move>
BitColumn difference(const Answer& answer, const BitMotion& given, double step, const Move& move)
{
  BitColumn out = BitColumn::Zero();
  for (const double sign : {1.0, -1.0})
  {
    BitMotion moved = given;
    move(moved, sign * step);
    out += sign / (2.0 * step) * answer(moved);
  }
  return out;
}

/// By the place, the turn and the rates of the bit's node.
template <class Answer>
Eigen::Matrix<double, 12, 12> differences_by_node(const Answer& answer, const BitMotion& given)
{
  Eigen::Matrix<double, 12, 12> out;
  for (int k = 0; k < 3; ++k)
  {
    const auto shift = [k](BitMotion& m, double step)
    {
      m.node.position[k] += step;
      m.node.increment[k] += step;
    };
    const auto turn = [k](BitMotion& m, double step)
    {
      m.node.orientation = rotation_from_vector(step * Vector3d::Unit(k)) * m.node.orientation;
      m.node.increment[3 + k] += step;
    };
    out.col(k) = difference(answer, given, kPlaceStep, shift);
    out.col(3 + k) = difference(answer, given, kPlaceStep, turn);
  }
  for (int k = 0; k < 6; ++k)
    out.col(6 + k) = difference(answer, given, kRateStep, [k](BitMotion& m, double step) { m.node.rate[k] += step; });
  return out;
}

/// By the further states.
template <class Answer>
Eigen::Matrix<double, 12, 6> differences_by_further(const Answer& answer, const BitMotion& given)
{
  Eigen::Matrix<double, 12, 6> out;
  out.col(kMotorSpeed) = difference(answer, given, kRateStep, [](BitMotion& m, double step) { m.motor_speed += step; });
  out.col(kMotorTurn) = difference(answer, given, kPlaceStep, [](BitMotion& m, double step) { m.motor_turn += step; });
  for (int k = 0; k < 3; ++k)
    out.col(kBottom + k) = difference(answer, given, kPlaceStep, [k](BitMotion& m, double step) { m.bottom[k] += step; });
  out.col(kMeanSpeed) = difference(answer, given, kRateStep, [](BitMotion& m, double step) { m.mean_speed += step; });
  return out;
}
}  // namespace

/// The bit's own forces and the further states, by some thirty evaluations of one node.
void RigDae::add_bit_jacobian(SparseJacobian& j)
{
  const BitMotion given{motion_.bit, stage_.bit.motor_speed, stage_.bit.motor_turn, stage_.bit.mean_speed,
                        stage_.bit.bottom_increment};
  const auto answer = [this](const BitMotion& at)
  {
    stage_.bit = bit_drive(at.motor_speed, at.motor_turn, at.bottom, at.mean_speed, at.node);
    return bit_rates(evaluate_bit_motion(model_, *start_, stage_, at.node, work_));
  };
  const Eigen::Matrix<double, 12, 12> by_motion = differences_by_node(answer, given);
  const Eigen::Matrix<double, 12, 6> by_further = differences_by_further(answer, given);

  add_force_derivative(bit(), bit(), by_motion.topLeftCorner<6, 6>(), by_motion.topRightCorner<6, 6>(), j);
  const int at = 12 * bit(), further = further_at();
  j.add_block(at + 6, further, by_further.topRows<6>());
  j.add_block(further, at, (-by_motion.block<6, 3>(6, 0)).eval());
  j.add_block(further, at + 3, (-by_motion.block<6, 3>(6, 3) * turn_by_coordinates(bit())).eval());
  j.add_block(further, at + 6, (-by_motion.block<6, 6>(6, 6)).eval());
  j.add_block(further, further, (-by_further.bottomRows<6>()).eval());
}

}  // namespace drill_rig_sim
