// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_CONSTRAINED_BODIES_H
#define DRILL_RIG_SIM_REFERENCE_CONSTRAINED_BODIES_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/math/tilt_spin.h"
#include "drill_rig_sim/reference/joints.h"
#include "drill_rig_sim/rig/rigid_body.h"
#include "drill_rig_sim/reference/dae_problem.h"

namespace drill_rig_sim
{
/// How the joints' constraints g(q) = 0 enter.
enum class Formulation
{
  stabilised_index_2,  ///< Gear, Gupta, Leimkuhler (1985): g = 0 and g' = 0, with a second set of multipliers mu in q' = v - G^T
                       ///< mu
  index_3              ///< only g = 0, as it follows from mechanics: its multipliers are ill-conditioned at small steps
};

/// The errors that count as one tolerance, a local error per step.
struct BodyTolerance
{
  double position = 1e-6;          ///< [m]
  double angle = 1e-6;             ///< [rad]
  double velocity = 1e-6;          ///< [m/s]
  double angular_velocity = 1e-6;  ///< [rad/s]
  double relative = 1e-6;          ///< of the two velocities, on top
};

/// Largest violation of the joints.
struct ConstraintDrift
{
  double position = 0.0;  ///< of g [m or rad]
  double velocity = 0.0;  ///< of G v [m/s or rad/s]
};

/// Rigid bodies (string nodes are such bodies too), joints with Lagrange multipliers, and forces that a derived class adds:
///
///   x' = v - (G^T mu)_x,   r' = T(r) (w - (G^T mu)_theta)          r tilt and spin about a base (math/tilt_spin.h)
///   M v' + gyroscopic terms + R(t, q, v, s) + G^T lambda = 0       R: minus what acts on the bodies
///   s' = f(t, q, v, s)                                             further states of the derived class
///   g(q) = 0,   G v = 0                                            the second in stabilised index 2 only, with mu
///
/// Unknowns: 12 per body (x from its base [m], r [rad], v [m/s], w [rad/s], world axes), then s, lambda, mu. Multipliers lambda
/// are the joints' forces [N] and moments [N m]; mu is zero but for round-off.
class ConstrainedBodies : public DaeProblem
{
public:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  ConstrainedBodies(std::vector<RigidBody> bodies, const std::vector<BodyMotion>& start, std::vector<Joint> joints,
                    Formulation formulation, const BodyTolerance& tolerance);

  int size() const override { return constraints_at() + sets() * constraint_count_; }
  std::vector<bool> differential() const override;
  void residual(double t, const double* y, const double* rate, double* f) override;
  void jacobian(double t, const double* y, const double* rate, double c, SparseJacobian& j) override;
  void tolerances(const double* y, double* tolerance) const override;

  /// New bases where the bodies are now; y is rewritten to match. The integrator must start again.
  void renew_bases(std::vector<double>& y);
  /// Largest tilt from the bases [rad].
  double largest_tilt(const double* y) const;
  /// Velocities and angular velocities of the constructor's `start` or of the last read(), at the bases: y to begin with.
  std::vector<double> at_bases() const;
  /// Moves y onto g = 0 and G v = 0 by the least kinetic energy, and finds the rates and multipliers that belong to it.
  /// False: constraints that contradict or repeat each other.
  bool make_consistent(double t, std::vector<double>& y, std::vector<double>& rate);
  ConstraintDrift drift(const double* y);

  int body_count() const { return static_cast<int>(bodies_.size()); }
  int constraint_count() const { return constraint_count_; }
  /// Takes y apart; motion() and friends then show it.
  void read(const double* y);
  const BodyMotion& motion(int body) const { return motions_[static_cast<std::size_t>(body)]; }
  double spin(int body, const double* y) const;  ///< about the body's axis since its base [rad]
  int multipliers_at() const { return constraints_at(); }
  int further_at() const { return 12 * body_count(); }

protected:
  /// Number of further states s.
  virtual int further_count() const { return 0; }
  /// Adds R to `force`, 6 a body. read(y) has been called.
  virtual void add_forces(double t, const double* y, double* force) = 0;
  /// Adds dR/dq and dR/dv by add_force_derivative(), and every derivative with respect to s, or of f, by itself.
  virtual void add_force_jacobian(double t, const double* y, SparseJacobian& j) = 0;
  /// f.
  virtual void further_rates(double, const double*, double*) {}
  /// Tolerances of s.
  virtual void further_tolerances(const double*, double*) const {}

  /// d(force and moment on `row`)/d(position, spatial rotation) and /d(v, w) of `column`.
  void add_force_derivative(int row, int column, const Matrix6& by_place, const Matrix6& by_rate, SparseJacobian& j) const;
  std::vector<RigidBody>& bodies() { return bodies_; }
  const TiltSpin& chart(int body) const { return bases_[static_cast<std::size_t>(body)].chart; }
  const Eigen::Vector3d& base_position(int body) const { return bases_[static_cast<std::size_t>(body)].position; }
  const Eigen::Matrix3d& turn_by_coordinates(int body) const { return turns_[static_cast<std::size_t>(body)]; }

private:
  struct Base
  {
    Eigen::Vector3d position;
    TiltSpin chart;
  };

  int constraints_at() const { return further_at() + further_count(); }
  int sets() const { return formulation_ == Formulation::stabilised_index_2 ? 2 : 1; }
  template <typename Visit>
  void for_each_constraint(Visit&& visit) const;
  Eigen::Matrix<double, 12, 1> joint_rates(const Joint& joint) const;
  void add_body_jacobian(int body, const double* y, const double* rate, double c, SparseJacobian& j) const;
  void add_constraint_jacobian(const double* y, SparseJacobian& j) const;
  Eigen::MatrixXd mobility(Eigen::MatrixXd& rows, Eigen::MatrixXd& answer);
  bool project_positions(std::vector<double>& y);
  const BodyMotion& motion_or_ground(int body) const { return body < 0 ? ground_ : motion(body); }

  std::vector<RigidBody> bodies_;
  std::vector<Base> bases_;
  std::vector<Joint> joints_;
  Formulation formulation_;
  BodyTolerance tolerance_;
  int constraint_count_ = 0;
  BodyMotion ground_;
  std::vector<BodyMotion> motions_;
  std::vector<Eigen::Matrix3d> turns_;        // spatial rotation by change of r
  std::vector<Eigen::Vector3d> coordinates_;  // r
  std::vector<Vector6> pulls_;                // G^T mu, a body
  std::vector<double> forces_;
};

}  // namespace drill_rig_sim

#endif
