// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/constrained_bodies.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace
{
constexpr int kUnknowns = 12;  // a body's
constexpr int kPlace = 0, kTurn = 3, kVelocity = 6, kSpin = 9;
// multipliers follow from the other unknowns: they must not decide when Newton's method has converged
constexpr double kMultiplierTolerance = 1e12;

/// Of a free body, by columns of forces and moments. One function, because Eigen's solver is compiled anew for each type of
/// right-hand side.
Eigen::Matrix<double, 6, Eigen::Dynamic> accelerations_under(const Eigen::Matrix<double, 6, 6>& inertia,
                                                             const Eigen::Matrix<double, 6, Eigen::Dynamic>& forces)
{
  return inertia.llt().solve(forces);
}
}  // namespace

ConstrainedBodies::ConstrainedBodies(std::vector<RigidBody> bodies, const std::vector<BodyMotion>& start,
                                     std::vector<Joint> joints, Formulation formulation, const BodyTolerance& tolerance)
    : bodies_(std::move(bodies)), joints_(std::move(joints)), formulation_(formulation), tolerance_(tolerance), motions_(start)
{
  for (const BodyMotion& motion : start) bases_.push_back({motion.position, TiltSpin::about(motion.orientation)});
  for (const Joint& joint : joints_) constraint_count_ += static_cast<int>(joint.constraints.size());
  turns_.resize(start.size());
  coordinates_.resize(start.size());
  pulls_.resize(start.size());
  forces_.resize(6 * start.size());
}

std::vector<bool> ConstrainedBodies::differential() const
{
  std::vector<bool> out(static_cast<std::size_t>(size()), false);
  std::fill_n(out.begin(), constraints_at(), true);
  return out;
}

void ConstrainedBodies::tolerances(const double* y, double* tolerance) const
{
  for (int i = 0; i < body_count(); ++i)
  {
    const double* state = y + kUnknowns * i;
    double* out = tolerance + kUnknowns * i;
    const double speed = Map<const Vector3d>(state + kVelocity).norm(), spin = Map<const Vector3d>(state + kSpin).norm();
    std::fill_n(out + kPlace, 3, tolerance_.position);
    std::fill_n(out + kTurn, 3, tolerance_.angle);
    std::fill_n(out + kVelocity, 3, tolerance_.velocity + tolerance_.relative * speed);
    std::fill_n(out + kSpin, 3, tolerance_.angular_velocity + tolerance_.relative * spin);
  }
  further_tolerances(y, tolerance + further_at());
  std::fill_n(tolerance + constraints_at(), sets() * constraint_count_, kMultiplierTolerance);
}

/// Calls visit(joint, constraint, number).
template <typename Visit>
void ConstrainedBodies::for_each_constraint(Visit&& visit) const
{
  int number = 0;
  for (const Joint& joint : joints_)
    for (const Constraint& constraint : joint.constraints) visit(joint, constraint, number++);
}

void ConstrainedBodies::read(const double* y)
{
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const double* state = y + kUnknowns * i;
    BodyMotion& m = motions_[i];
    coordinates_[i] = Map<const Vector3d>(state + kTurn);
    m.position = bases_[i].position + Map<const Vector3d>(state + kPlace);
    m.orientation = bases_[i].chart.orientation(coordinates_[i]);
    m.normal = x_axis(m.orientation);
    m.velocity = Map<const Vector3d>(state + kVelocity);
    m.angular_velocity = Map<const Vector3d>(state + kSpin);
    turns_[i] = bases_[i].chart.velocity_by_rate(coordinates_[i]);
  }
}

std::vector<double> ConstrainedBodies::at_bases() const
{
  std::vector<double> y(static_cast<std::size_t>(size()), 0.0);
  for (std::size_t i = 0; i < motions_.size(); ++i)
  {
    Map<Vector3d>(y.data() + kUnknowns * i + kVelocity) = motions_[i].velocity;
    Map<Vector3d>(y.data() + kUnknowns * i + kSpin) = motions_[i].angular_velocity;
  }
  return y;
}

double ConstrainedBodies::spin(int body, const double* y) const
{
  return chart(body).spin(Map<const Vector3d>(y + kUnknowns * body + kTurn));
}

Eigen::Matrix<double, 12, 1> ConstrainedBodies::joint_rates(const Joint& joint) const
{
  const BodyMotion &a = motion_or_ground(joint.a), &b = motion_or_ground(joint.b);
  Eigen::Matrix<double, 12, 1> out;
  out << a.velocity, a.angular_velocity, b.velocity, b.angular_velocity;
  return out;
}

void ConstrainedBodies::residual(double t, const double* y, const double* rate, double* f)
{
  read(y);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  for (Vector6& pull : pulls_) pull.setZero();
  add_forces(t, y, forces_.data());

  const double* lambda = y + constraints_at();
  const double* mu = lambda + constraint_count_;
  double* violation = f + constraints_at();
  const bool stabilised = formulation_ == Formulation::stabilised_index_2;
  for_each_constraint(
      [&](const Joint& joint, const Constraint& constraint, int k)
      {
        const BodyMotion &a = motion_or_ground(joint.a), &b = motion_or_ground(joint.b);
        const JointRow row = constraint_row(constraint, a, b);
        violation[k] = constraint_value(constraint, a, b);
        if (stabilised) violation[constraint_count_ + k] = row.dot(joint_rates(joint));
        for (int side = 0; side < 2; ++side)
        {
          const int body = side == 0 ? joint.a : joint.b;
          if (body < 0) continue;
          const Vector6 column = row.segment<6>(6 * side).transpose();
          Map<Vector6>(forces_.data() + 6 * body) += lambda[k] * column;
          if (stabilised) pulls_[static_cast<std::size_t>(body)] += mu[k] * column;
        }
      });

  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const BodyMotion& m = motions_[i];
    const double* state_rate = rate + kUnknowns * i;
    double* out = f + kUnknowns * i;
    const Vector3d v = m.velocity - pulls_[i].head<3>(), w = m.angular_velocity - pulls_[i].tail<3>();
    Map<Vector3d>(out + kPlace) = Map<const Vector3d>(state_rate + kPlace) - v;
    Map<Vector3d>(out + kTurn) = Map<const Vector3d>(state_rate + kTurn) - bases_[i].chart.rate(coordinates_[i], w);
    Map<Vector6>(out + kVelocity) =
        inertia_force(bodies_[i], m, Map<const Vector6>(state_rate + kVelocity)) + Map<const Vector6>(forces_.data() + 6 * i);
  }
  double* further = f + further_at();
  further_rates(t, y, further);
  for (int k = 0; k < further_count(); ++k) further[k] = rate[further_at() + k] - further[k];
}

void ConstrainedBodies::add_force_derivative(int row, int column, const Matrix6& by_place, const Matrix6& by_rate,
                                             SparseJacobian& j) const
{
  const int r = kUnknowns * row + kVelocity, c = kUnknowns * column;
  j.add_block(r, c + kPlace, by_place.leftCols<3>());
  j.add_block(r, c + kTurn, (by_place.rightCols<3>() * turn_by_coordinates(column)).eval());
  j.add_block(r, c + kVelocity, by_rate);
}

void ConstrainedBodies::add_body_jacobian(int body, const double*, const double* rate, double c, SparseJacobian& j) const
{
  const auto i = static_cast<std::size_t>(body);
  const int at = kUnknowns * body;
  const BodyMotion& m = motions_[i];
  const TiltSpin& chart = bases_[i].chart;
  const Vector3d w = m.angular_velocity - pulls_[i].tail<3>();
  j.add_block(at + kPlace, at + kPlace, (c * Matrix3d::Identity()).eval());
  j.add_block(at + kPlace, at + kVelocity, (-Matrix3d::Identity()).eval());
  j.add_block(at + kTurn, at + kTurn, (c * Matrix3d::Identity() - chart.rate_by_coordinates(coordinates_[i], w)).eval());
  j.add_block(at + kTurn, at + kSpin, (-chart.rate_by_velocity(coordinates_[i])).eval());

  Matrix6 by_place = Matrix6::Zero();
  by_place.rightCols<3>() = inertia_by_rotation(bodies_[i], m, Map<const Vector6>(rate + at + kVelocity));
  Matrix6 by_rate = c * inertia_by_acceleration(bodies_[i], m);
  by_rate.bottomRightCorner<3, 3>() += inertia_by_angular_velocity(bodies_[i], m);
  add_force_derivative(body, body, by_place, by_rate, j);
}

void ConstrainedBodies::add_constraint_jacobian(const double* y, SparseJacobian& j) const
{
  const double* lambda = y + constraints_at();
  const bool stabilised = formulation_ == Formulation::stabilised_index_2;
  for_each_constraint(
      [&](const Joint& joint, const Constraint& constraint, int k)
      {
        const BodyMotion &a = motion_or_ground(joint.a), &b = motion_or_ground(joint.b);
        const JointRow row = constraint_row(constraint, a, b);
        const JointHessian hessian = constraint_hessian(constraint, a, b);
        const JointRow row_rate = joint_rates(joint).transpose() * hessian;  // d(G v)/dq
        const int value_row = constraints_at() + k, rate_row = value_row + constraint_count_;
        const double mu = stabilised ? lambda[constraint_count_ + k] : 0.0;
        const int body[2] = {joint.a, joint.b};
        for (int p = 0; p < 2; ++p)
        {
          if (body[p] < 0) continue;
          const int at = kUnknowns * body[p];
          const Matrix3d& turn = turn_by_coordinates(body[p]);
          const Eigen::RowVector3d by_x = row.segment<3>(6 * p), by_theta = row.segment<3>(6 * p + 3);
          j.add_block(value_row, at + kPlace, by_x);
          j.add_block(value_row, at + kTurn, (by_theta * turn).eval());
          j.add_block(at + kVelocity, value_row, row.segment<6>(6 * p).transpose());
          for (int q = 0; q < 2; ++q)
          {
            if (body[q] < 0) continue;
            const Matrix6 block = hessian.block<6, 6>(6 * p, 6 * q);
            add_force_derivative(body[p], body[q], lambda[k] * block, Matrix6::Zero(), j);
            if (!stabilised) continue;
            const Eigen::Matrix<double, 6, 3> by_turn = mu * block.rightCols<3>() * turn_by_coordinates(body[q]);
            j.add_block(at + kPlace, kUnknowns * body[q] + kTurn, by_turn.topRows<3>());
            j.add_block(
                at + kTurn, kUnknowns * body[q] + kTurn,
                (chart(body[p]).rate_by_velocity(coordinates_[static_cast<std::size_t>(body[p])]) * by_turn.bottomRows<3>())
                    .eval());
          }
          if (!stabilised) continue;
          j.add_block(rate_row, at + kVelocity, row.segment<6>(6 * p));
          j.add_block(rate_row, at + kPlace, row_rate.segment<3>(6 * p));
          j.add_block(rate_row, at + kTurn, (row_rate.segment<3>(6 * p + 3) * turn).eval());
          j.add_block(at + kPlace, rate_row, by_x.transpose());
          j.add_block(
              at + kTurn, rate_row,
              (chart(body[p]).rate_by_velocity(coordinates_[static_cast<std::size_t>(body[p])]) * by_theta.transpose()).eval());
        }
      });
}

void ConstrainedBodies::jacobian(double t, const double* y, const double* rate, double c, SparseJacobian& j)
{
  read(y);
  for (Vector6& pull : pulls_) pull.setZero();
  if (formulation_ == Formulation::stabilised_index_2)
    for_each_constraint(
        [&](const Joint& joint, const Constraint& constraint, int k)
        {
          const JointRow row = constraint_row(constraint, motion_or_ground(joint.a), motion_or_ground(joint.b));
          const double mu = y[constraints_at() + constraint_count_ + k];
          if (joint.a >= 0) pulls_[static_cast<std::size_t>(joint.a)] += mu * row.head<6>().transpose();
          if (joint.b >= 0) pulls_[static_cast<std::size_t>(joint.b)] += mu * row.tail<6>().transpose();
        });
  for (int i = 0; i < body_count(); ++i) add_body_jacobian(i, y, rate, c, j);
  for (int k = 0; k < further_count(); ++k) j.add(further_at() + k, further_at() + k, c);
  add_force_jacobian(t, y, j);
  add_constraint_jacobian(y, j);
}

void ConstrainedBodies::renew_bases(std::vector<double>& y)
{
  read(y.data());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    bases_[i] = {motions_[i].position, TiltSpin::about(motions_[i].orientation.normalized())};
    std::fill_n(y.begin() + static_cast<std::ptrdiff_t>(kUnknowns * i), 6, 0.0);
  }
}

double ConstrainedBodies::largest_tilt(const double* y) const
{
  double most = 0.0;
  for (int i = 0; i < body_count(); ++i)
    most = std::max(most, chart(i).tilt(Map<const Vector3d>(y + kUnknowns * i + kTurn)).norm());
  return most;
}

/// Rows G of all constraints in (dx, dtheta) of all bodies, `answer` = M^-1 G^T; returns G M^-1 G^T.
MatrixXd ConstrainedBodies::mobility(MatrixXd& rows, MatrixXd& answer)
{
  rows = MatrixXd::Zero(constraint_count_, 6 * body_count());
  for_each_constraint(
      [&](const Joint& joint, const Constraint& constraint, int k)
      {
        const JointRow row = constraint_row(constraint, motion_or_ground(joint.a), motion_or_ground(joint.b));
        if (joint.a >= 0) rows.block<1, 6>(k, 6 * joint.a) += row.head<6>();
        if (joint.b >= 0) rows.block<1, 6>(k, 6 * joint.b) += row.tail<6>();
      });
  answer.resize(6 * body_count(), constraint_count_);
  for (int i = 0; i < body_count(); ++i)
  {
    answer.middleRows<6>(6 * i) = accelerations_under(inertia_by_acceleration(bodies_[static_cast<std::size_t>(i)], motion(i)),
                                                      rows.middleCols<6>(6 * i).transpose());
  }
  return rows * answer;
}

bool ConstrainedBodies::project_positions(std::vector<double>& y)
{
  MatrixXd rows, answer;
  for (int round = 0; round < 20; ++round)
  {
    read(y.data());
    VectorXd violation(constraint_count_);
    for_each_constraint([&](const Joint& joint, const Constraint& constraint, int k)
                        { violation[k] = constraint_value(constraint, motion_or_ground(joint.a), motion_or_ground(joint.b)); });
    if (!violation.allFinite()) return false;
    // positions of kilometres are known to 1e-12 m
    if (constraint_count_ == 0 || violation.cwiseAbs().maxCoeff() < 1e-12) return true;
    const MatrixXd m = mobility(rows, answer);
    const VectorXd pull = m.ldlt().solve(violation), move = answer * pull;
    for (int i = 0; i < body_count(); ++i)
    {
      Map<Vector3d>(y.data() + kUnknowns * i + kPlace) -= move.segment<3>(6 * i);
      Map<Vector3d>(y.data() + kUnknowns * i + kTurn) -=
          chart(i).rate_by_velocity(coordinates_[static_cast<std::size_t>(i)]) * move.segment<3>(6 * i + 3);
    }
  }
  return false;
}

bool ConstrainedBodies::make_consistent(double t, std::vector<double>& y, std::vector<double>& rate)
{
  std::fill(y.begin() + constraints_at(), y.end(), 0.0);
  rate.assign(y.size(), 0.0);
  if (!project_positions(y)) return false;

  // velocities
  read(y.data());
  MatrixXd rows, answer;
  const Eigen::LDLT<MatrixXd> mobility_factors = mobility(rows, answer).ldlt();
  VectorXd v(6 * body_count());
  for (int i = 0; i < body_count(); ++i) v.segment<6>(6 * i) = Map<const Vector6>(y.data() + kUnknowns * i + kVelocity);
  if (constraint_count_ > 0)
  {
    const VectorXd too_fast = rows * v, pull = mobility_factors.solve(too_fast);
    v -= answer * pull;
  }
  for (int i = 0; i < body_count(); ++i) Map<Vector6>(y.data() + kUnknowns * i + kVelocity) = v.segment<6>(6 * i);

  // accelerations and multipliers: M a + R + G^T lambda = 0, G a = -v^T (dG/dq) v
  std::vector<double> f(y.size());
  residual(t, y.data(), rate.data(), f.data());
  VectorXd a(6 * body_count());
  for (int i = 0; i < body_count(); ++i)
    a.segment<6>(6 * i) = -accelerations_under(inertia_by_acceleration(bodies_[static_cast<std::size_t>(i)], motion(i)),
                                               Map<const Vector6>(f.data() + kUnknowns * i + kVelocity));
  if (constraint_count_ > 0)
  {
    VectorXd off = rows * a;
    for_each_constraint(
        [&](const Joint& joint, const Constraint& constraint, int k)
        {
          const auto v_joint = joint_rates(joint);
          off[k] += v_joint.dot(constraint_hessian(constraint, motion_or_ground(joint.a), motion_or_ground(joint.b)) * v_joint);
        });
    const VectorXd lambda = mobility_factors.solve(off);
    a -= answer * lambda;
    Map<VectorXd>(y.data() + constraints_at(), constraint_count_) = lambda;
  }
  for (int i = 0; i < body_count(); ++i)
  {
    Map<Vector6>(rate.data() + kUnknowns * i + kPlace) = -Map<const Vector6>(f.data() + kUnknowns * i + kPlace);
    Map<Vector6>(rate.data() + kUnknowns * i + kVelocity) = a.segment<6>(6 * i);
  }
  for (int k = further_at(); k < constraints_at(); ++k) rate[static_cast<std::size_t>(k)] = -f[static_cast<std::size_t>(k)];
  return a.allFinite();
}

ConstraintDrift ConstrainedBodies::drift(const double* y)
{
  read(y);
  ConstraintDrift out;
  for_each_constraint(
      [&](const Joint& joint, const Constraint& constraint, int)
      {
        const BodyMotion &a = motion_or_ground(joint.a), &b = motion_or_ground(joint.b);
        out.position = std::max(out.position, std::abs(constraint_value(constraint, a, b)));
        out.velocity = std::max(out.velocity, std::abs(constraint_row(constraint, a, b).dot(joint_rates(joint))));
      });
  return out;
}

}  // namespace drill_rig_sim
