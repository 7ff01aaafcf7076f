#include "drill_rig_sim/solve/rig_dae.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/rig/mud_motor.h"

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
// motor's speed and turn, and the bottom's place
enum Further
{
  kMotorSpeed,
  kMotorTurn,
  kBottom
};
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

RigDae::Rig RigDae::rig_of(const System& system, const SystemState& state)
{
  Rig rig;
  const Mesh& mesh = system.mesh();
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

  const RigSpec& spec = system.scene().rig;
  const double mass = spec.hoisting.block_mass;
  const int top = static_cast<int>(mesh.nodes.size()) - 1;
  const BodyMotion shaft = rig.motions[static_cast<std::size_t>(top)];
  for (const double share : {kRotorShare, kStatorShare, kBlockShare})
  {
    BodyMotion motion = shaft;
    motion.angular_velocity.setZero();
    const double inertia = share * mass * kGyrationSquare;
    rig.bodies.push_back({share * mass, 0.0, inertia, inertia});
    rig.motions.push_back(motion);
  }
  const int bit = top + 1, rotor = top + 2, stator = top + 3, block = top + 4;
  auto motion = [&rig](int body) -> BodyMotion& { return rig.motions[static_cast<std::size_t>(body)]; };
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

RigDae::RigDae(System& system, const SystemState& state, Formulation formulation, double tolerance)
    : RigDae(system, rig_of(system, state), formulation, tolerance)
{
}

RigDae::RigDae(System& system, Rig rig, Formulation formulation, double tolerance)
    : ConstrainedBodies(std::move(rig.bodies), rig.motions, std::move(rig.joints), formulation,
                        {0.01 * tolerance, 0.01 * tolerance, tolerance, tolerance, tolerance}),
      system_(system),
      tolerance_(tolerance)
{
  const auto n = static_cast<std::size_t>(string_nodes());
  motion_.nodes.resize(n);
  string_.resize(6 * n);
  contact_.resize(6 * n);
  for (BlockTridiagonal* matrix : {&string_by_place_, &string_by_both_, &contact_by_place_, &contact_by_both_})
    matrix->resize(string_nodes());
}

std::vector<double> RigDae::initial(const SystemState& state) const
{
  std::vector<double> y = at_bases();
  y.data()[further_at() + kMotorSpeed] = state.bit.motor_speed;
  return y;
}

bool RigDae::begin(double t, const SystemState& state, const Setpoints& setpoints, const std::vector<double>& y)
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
  const Mesh& mesh = system_.mesh();
  const MudSpec& mud = system_.scene().mud;
  const double bit_added = mud.added_mass * mud.density * mesh.bit_displaced;
  for (int i = 0; i < string_nodes(); ++i)
  {
    const double added = mesh.nodes[static_cast<std::size_t>(i)].added_mass - (i == 0 ? bit_added : 0.0);
    set_added(i, system_.immersed(i) * added);
  }
  set_added(bit(), system_.immersed(0) * bit_added);
  return changed;
}

NodeMotion RigDae::motion_of(int body, const double* y) const
{
  const BodyMotion& m = motion(body);
  NodeMotion out;
  out.position = m.position;
  out.orientation = m.orientation;
  // the places themselves would lose digits
  out.moved << Map<const Vector3d>(y + 12 * body) - Map<const Vector3d>(start_y_.data() + 12 * body),
      tilt_and_spin(start_orientations_[static_cast<std::size_t>(body)], m.orientation);
  out.rate << m.velocity, m.angular_velocity;
  return out;
}

/// What the system is to see of y.
void RigDae::take_motion(double t, const double* y)
{
  motion_.time = t - start_time_;
  for (int i = 0; i < string_nodes(); ++i) motion_.nodes[static_cast<std::size_t>(i)] = motion_of(i, y);
  motion_.bit = motion_of(bit(), y);
  const double* now = y + further_at();
  const double* before = start_y_.data() + further_at();
  motion_.motor_speed = now[kMotorSpeed];
  motion_.motor_turn = now[kMotorTurn] - before[kMotorTurn];
  motion_.bottom_moved = Map<const Vector3d>(now + kBottom) - Map<const Vector3d>(before + kBottom);
}

RigDae::Drive RigDae::drive_at(const double* y) const
{
  const int top = string_nodes() - 1;
  Drive out;
  out.turn = spin(rotor(), y) - spin(rotor(), start_y_.data());
  out.speed = motion(rotor()).angular_velocity.dot(motion(rotor()).normal);
  out.twist = start_->drive.meter_twist + out.turn - (spin(top, y) - spin(top, start_y_.data()));
  const RotorState start{start_->drive.speed, start_->drive.integral, start_->drive.meter_twist};
  out.motor = drive_torque(system_.scene().rig.top_drive, setpoints_.top_drive, start, motion_.time, out.turn, out.speed);
  return out;
}

LinePull RigDae::pull_at() const
{
  return line_pull(system_.scene().rig.hoisting, motion(block()).position.z() - kBlockAbove, system_.hoist().line_length);
}

void RigDae::add_forces(double t, const double* y, double* force)
{
  take_motion(t, y);
  system_.evaluate_motion(motion_, string_.data(), contact_.data(), nullptr, nullptr);
  Map<Eigen::VectorXd>(force, 6 * string_nodes()) += Map<const Eigen::VectorXd>(string_.data(), 6 * string_nodes());
  Map<Eigen::VectorXd>(force + 6, 6 * (string_nodes() - 1)) +=
      Map<const Eigen::VectorXd>(contact_.data() + 6, 6 * (string_nodes() - 1));
  Map<Vector6>(force + 6 * bit()) += Map<const Vector6>(contact_.data());

  for (const int body : {rotor(), stator(), block()})
    force[6 * body + 2] += standard_gravity * bodies()[static_cast<std::size_t>(body)].mass;
  force[6 * block() + 2] -= pull_at().hook_force;
  const Drive drive = drive_at(y);
  const double meter = system_.scene().rig.top_drive.meter_stiffness * drive.twist;
  const int top = string_nodes() - 1;
  Map<Vector3d>(force + 6 * rotor() + 3) += (meter - drive.motor.value) * motion(rotor()).normal;
  Map<Vector3d>(force + 6 * stator() + 3) += drive.motor.value * motion(rotor()).normal;
  Map<Vector3d>(force + 6 * top + 3) -= meter * motion(top).normal;
}

void RigDae::further_rates(double, const double*, double* rate)
{
  const BitAnswer answer = bit_rates(Vector6d::Zero());
  std::copy_n(answer.data() + 6, 5, rate);
}

/// `force` and the rates of the further states at the bit's last forces.
RigDae::BitAnswer RigDae::bit_rates(const Vector6d& force) const
{
  BitAnswer out;
  out << force, (system_.steady_motor_speed() - motion_.motor_speed) / mud_motor_lag, motion_.motor_speed,
      system_.rock_velocity();
  return out;
}

void RigDae::further_tolerances(const double* y, double* tolerance) const
{
  tolerance[kMotorSpeed] = tolerance_ * (1.0 + std::abs(y[further_at() + kMotorSpeed]));
  tolerance[kMotorTurn] = 0.01 * tolerance_;
  std::fill_n(tolerance + kBottom, 3, 0.01 * tolerance_);
}

void RigDae::add_force_jacobian(double t, const double* y, SparseJacobian& j)
{
  take_motion(t, y);
  // at fixed rates, and with d/d(rate) on top
  system_.stage().dv_du = 1.0;
  system_.evaluate_motion(motion_, string_.data(), contact_.data(), &string_by_both_, &contact_by_both_);
  system_.stage().dv_du = 0.0;
  system_.evaluate_motion(motion_, string_.data(), contact_.data(), &string_by_place_, &contact_by_place_);
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
  Matrix6 line = Matrix6::Zero();
  line(2, 2) = pull_at().stiffness;
  add_force_derivative(block(), block(), line, Matrix6::Zero(), j);

  const Drive drive = drive_at(y);
  auto about = [&](int row, int column, double torque, double by_turn, double by_speed)
  {
    const Matrix3d axes = motion(row).normal * motion(column).normal.transpose();
    Matrix6 place = Matrix6::Zero(), rate = Matrix6::Zero();
    place.bottomRightCorner<3, 3>() = by_turn * axes - torque * skew(motion(column).normal);
    rate.bottomRightCorner<3, 3>() = by_speed * axes;
    add_force_derivative(row, column, place, rate, j);
  };
  const double spring = system_.scene().rig.top_drive.meter_stiffness;
  const double meter = spring * drive.twist, motor = drive.motor.value;
  about(rotor(), rotor(), meter - motor, spring - drive.motor.by_turn, -drive.motor.by_speed);
  about(rotor(), top, 0.0, -spring, 0.0);
  about(stator(), rotor(), motor, drive.motor.by_turn, drive.motor.by_speed);
  about(top, rotor(), 0.0, -spring, 0.0);
  about(top, top, -meter, spring, 0.0);
}

/// The bit's own forces and the further states, by central differences: some thirty evaluations of one node.
void RigDae::add_bit_jacobian(SparseJacobian& j)
{
  const GivenMotion given = motion_;
  const auto answer = [this] { return bit_rates(system_.evaluate_bit_motion(motion_)); };
  const auto column = [&](double step, const auto& move)
  {
    BitAnswer out = BitAnswer::Zero();
    for (const double sign : {1.0, -1.0})
    {
      move(sign * step);
      out += sign / (2.0 * step) * answer();
      motion_.bit = given.bit;
      motion_.motor_speed = given.motor_speed;
      motion_.motor_turn = given.motor_turn;
      motion_.bottom_moved = given.bottom_moved;
    }
    return out;
  };
  Eigen::Matrix<double, 11, 12> by_motion;
  for (int k = 0; k < 3; ++k)
  {
    by_motion.col(k) = column(kPlaceStep,
                              [&](double step)
                              {
                                motion_.bit.position[k] += step;
                                motion_.bit.moved[k] += step;
                              });
    by_motion.col(3 + k) = column(kPlaceStep,
                                  [&](double step)
                                  {
                                    motion_.bit.orientation = rotation_from_vector(step * Vector3d::Unit(k)) * given.bit.orientation;
                                    motion_.bit.moved[3 + k] += step;
                                  });
  }
  for (int k = 0; k < 6; ++k) by_motion.col(6 + k) = column(kRateStep, [&](double step) { motion_.bit.rate[k] += step; });
  Eigen::Matrix<double, 11, 5> by_further;
  by_further.col(kMotorSpeed) = column(kRateStep, [&](double step) { motion_.motor_speed += step; });
  by_further.col(kMotorTurn) = column(kPlaceStep, [&](double step) { motion_.motor_turn += step; });
  for (int k = 0; k < 3; ++k)
    by_further.col(kBottom + k) = column(kPlaceStep, [&](double step) { motion_.bottom_moved[k] += step; });

  add_force_derivative(bit(), bit(), by_motion.topLeftCorner<6, 6>(), by_motion.topRightCorner<6, 6>(), j);
  const int at = 12 * bit(), further = further_at();
  j.add_block(at + 6, further, by_further.topRows<6>());
  j.add_block(further, at, (-by_motion.block<5, 3>(6, 0)).eval());
  j.add_block(further, at + 3, (-by_motion.block<5, 3>(6, 3) * turn_by_coordinates(bit())).eval());
  j.add_block(further, at + 6, (-by_motion.block<5, 6>(6, 6)).eval());
  j.add_block(further, further, (-by_further.bottomRows<5>()).eval());
}

Vector3d RigDae::finish(double t, const std::vector<double>& y, SystemState& state)
{
  read(y.data());
  take_motion(t, y.data());
  system_.evaluate_motion(motion_, string_.data(), contact_.data(), nullptr, nullptr);
  const Drive drive = drive_at(y.data());
  const double meter = system_.scene().rig.top_drive.meter_stiffness * drive.twist;
  system_.note_rig(pull_at().hook_force, meter);
  const DriveState before = state.drive;
  const double turned = state.bit.turned + motion_.motor_turn;
  system_.finish(state);

  for (int i = 0; i < string_nodes(); ++i)
  {
    NodeState& node = state.nodes[static_cast<std::size_t>(i)];
    const BodyMotion& m = motion(i);
    const double spin_rate = m.angular_velocity.dot(m.normal);
    node.position = m.position;
    if (i + 1 < string_nodes()) node.orientation = m.orientation.normalized();
    node.rate = {m.velocity, m.angular_velocity - spin_rate * m.normal, spin_rate};
  }
  state.drive = before;
  state.drive.angle += drive.turn;
  state.drive.last_speed = before.speed;
  state.drive.last_increment = drive.turn;
  state.drive.speed = drive.speed;
  state.drive.integral = drive.motor.integral;
  state.drive.meter_twist = drive.twist;
  state.drive.limited = drive.motor.limited;
  state.bit.turned = turned;
  state.bit.rock_velocity = motion_.bottom_moved / (t - start_time_);
  state.bit.motor_speed = motion_.motor_speed;
  return motion_.bottom_moved;
}

}  // namespace drill_rig_sim
