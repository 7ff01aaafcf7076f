#include "drill_rig_sim/contact/wall_contact.h"

#include <Eigen/Geometry>

#include "drill_rig_sim/contact/friction_law.h"
#include "drill_rig_sim/contact/normal_law.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Tangent = Eigen::Ref<Eigen::Matrix<double, 6, 6>>;

/// Where section and wall meet.
struct Geometry
{
  Vector3d normal;    ///< n
  Vector3d gradient;  ///< d delta / d r_D
  Vector3d slope;     ///< P dC/ds
  double rho;
  double penetration;  ///< delta
};

inline Geometry contact_geometry(const ClosestPoint& closest, double radius, const Vector3d& position) noexcept
{
  const Vector3d d = position - closest.centre;
  Geometry g;
  g.rho = std::sqrt(d.squaredNorm() + wall_contact_smoothing * wall_contact_smoothing);
  g.penetration = g.rho - (closest.radius - radius);  // digit for digit -wall_gap()
  g.normal = d / g.rho;
  g.gradient = g.normal - closest.radius_slope * closest.md_gradient;
  g.slope = closest.centre_slope - g.normal * g.normal.dot(closest.centre_slope);
  return g;
}

/// B = dn/dr_D = (1 - n n^T - P c' (ds/dr_D)^T) / rho.
inline Matrix3d normal_derivative(const ClosestPoint& closest, const Geometry& g) noexcept
{
  Matrix3d b = -g.normal * g.normal.transpose() - g.slope * closest.md_gradient.transpose();
  b.diagonal().array() += 1.0;
  return b / g.rho;
}

/// The friction's part of a contact: force on the string and, where asked, its derivatives.
struct Friction
{
  Vector3d force = Vector3d::Zero();
  Vector3d bristle = Vector3d::Zero();
  Vector3d surface_velocity = Vector3d::Zero();
  Vector3d pull = Vector3d::Zero();            ///< k_b (z_n + slip) + c_b surface_velocity, before projection: q = P pull [N]
  Vector3d direction = Vector3d::Zero();       ///< q / |q|
  Vector3d slip_direction = Vector3d::Zero();  ///< v_t / |v_t|, or zero at rest
  double trial = 0.0;                          ///< |q| [N]
  FrictionCoefficient mu;
  bool slipping = false;
};

/// R_F.
inline double lever(const WallLaw& law, double radius) noexcept
{
  return law.friction_radius > 0.0 ? law.friction_radius : radius;
}

inline Vector3d in_plane(const Geometry& g, const Vector3d& v) noexcept
{
  return v - g.normal * g.normal.dot(v);
}

/// Return mapping of the bristle.
Friction friction_force(const Geometry& g, double normal_force, double kinetic, double radius, const ContactMotion& motion,
                        const Vector3d& bristle, const WallLaw& law) noexcept
{
  const Vector3d arm = radius * g.normal;
  Friction f;
  f.surface_velocity = motion.velocity + motion.angular_velocity.cross(arm);
  const Vector3d total_slip = bristle + motion.displacement + motion.rotation.cross(arm);
  f.pull = law.tangential_stiffness * total_slip + law.tangential_damping * f.surface_velocity;
  const Vector3d trial = in_plane(g, f.pull);
  f.trial = trial.norm();
  f.force = -trial;
  f.bristle = in_plane(g, total_slip);

  // Friction is never below kinetic: what kinetic friction holds, sticks, without a look at the Stribeck curve.
  if (f.trial <= kinetic * normal_force) return f;

  const Vector3d slip_velocity = in_plane(g, f.surface_velocity);
  const double speed = slip_velocity.norm();
  f.mu = stribeck_friction(kinetic, law.static_ratio, law.stribeck_speed, speed, law.stribeck_curve);
  const double limit = f.mu.value * normal_force;
  if (f.trial <= limit) return f;

  f.slipping = true;
  f.direction = trial / f.trial;
  f.force = -limit * f.direction;
  f.bristle = slipping_bristle(law, motion.time, in_plane(g, bristle), Vector3d((limit / law.tangential_stiffness) * f.direction));
  if (speed > 0.0) f.slip_direction = slip_velocity / speed;
  return f;
}

/// Derivative of the friction force, column by column of u.
class FrictionDerivative
{
public:
  /// @param normal_force_gradient  dF_n/dx
  FrictionDerivative(const Geometry& g, const Matrix3d& b, const Friction& f, double normal_force,
                     const Vector3d& normal_force_gradient, double radius, const ContactMotion& motion) noexcept
      : direction_(f.direction), slipping_(f.slipping)
  {
    if (!slipping_)
    {
      return;
    }
    // |f| = mu(|v_t|) F_n; d|v_t| = e . dv_s - (n . v_s) e . dn, with e = v_t/|v_t|
    share_ = f.mu.value * normal_force / f.trial;
    const Vector3d& e = f.slip_direction;
    const double c = motion.velocity_coefficient;
    const double per_speed = f.mu.slope * normal_force;
    const Vector3d through_normal = radius * e.cross(motion.angular_velocity) - g.normal.dot(f.surface_velocity) * e;
    limit_x_ = f.mu.value * normal_force_gradient + per_speed * (c * e + b.transpose() * through_normal);
    limit_r_ = per_speed * c * radius * g.normal.cross(e);
  }

  /// Column of the force from the same column of dq: j of x or of r.
  Vector3d column_x(int j, const Vector3d& trial) const noexcept { return column(limit_x_[j], trial); }
  Vector3d column_r(int j, const Vector3d& trial) const noexcept { return column(limit_r_[j], trial); }

private:
  /// sticking: -dq; slipping along m = q/|q|: -|f|/|q| (1 - m m^T) dq - m d|f|
  Vector3d column(double limit, const Vector3d& trial) const noexcept
  {
    if (!slipping_)
    {
      return -trial;
    }
    // By components: packets of two on vectors of three stall on store forwarding here, a tenth of the whole contact.
    const Vector3d& m = direction_;
    const double along = share_ * (m.x() * trial.x() + m.y() * trial.y() + m.z() * trial.z()) - limit;
    return {m.x() * along - share_ * trial.x(), m.y() * along - share_ * trial.y(), m.z() * along - share_ * trial.z()};
  }

  Vector3d direction_;
  Vector3d limit_x_ = Vector3d::Zero();  // d|f|/dx
  Vector3d limit_r_ = Vector3d::Zero();  // d|f|/dr
  bool slipping_;
  double share_ = 1.0;  // |f|/|q|
};

/// Column of x: normal force, friction and the turning arm; b = dn/dx_j, friction = d f/dx_j.
inline void write_column_x(const Geometry& g, int j, const Vector3d& b, double normal_force, double normal_slope, double radius,
                           const Vector3d& f, const Vector3d& friction, Tangent& tangent) noexcept
{
  tangent.block<3, 1>(0, j) = friction - normal_slope * g.normal - normal_force * b;
  tangent.block<3, 1>(3, j) = radius * (g.normal.cross(friction) + b.cross(f));
}

/// d(force, moment)/d(x, r).
void write_tangent(const ClosestPoint& closest, const Geometry& g, const NormalForce& normal, const Friction& f, double radius,
                   const ContactMotion& motion, const WallLaw& law, Tangent& tangent) noexcept
{
  const Matrix3d b = normal_derivative(closest, g);
  const Vector3d gradient = (normal.stiffness + motion.velocity_coefficient * normal.damping) * g.gradient +
                            normal.damping * (b.transpose() * motion.velocity);
  const FrictionDerivative derivative(g, b, f, normal.value, gradient, radius, motion);

  // q = P w, w = k (z_n + x + r x R_F n) + c_b (v + omega x R_F n), with s = k + c c_b and rho = k r + c_b omega:
  //   dq/dx = s + R_F skew(rho) B - (n . w) B - n (s n + B^T (R_F n x rho + w))^T
  const double s = law.tangential_stiffness + motion.velocity_coefficient * law.tangential_damping;
  const Vector3d turn = law.tangential_stiffness * motion.rotation + law.tangential_damping * motion.angular_velocity;
  const double along = g.normal.dot(f.pull);
  const Vector3d row = s * g.normal + b.transpose() * (radius * g.normal.cross(turn) + f.pull);
  for (int j = 0; j < 3; ++j)
  {
    const Vector3d bj = b.col(j);
    const Vector3d trial = s * Vector3d::Unit(j) + radius * turn.cross(bj) - along * bj - row[j] * g.normal;
    write_column_x(g, j, bj, normal.value, gradient[j], radius, f.force, derivative.column_x(j, trial), tangent);
  }

  // dq/dr = -s R_F skew(n)
  const Vector3d arm = radius * g.normal;
  for (int j = 0; j < 3; ++j)
  {
    const Vector3d friction = derivative.column_r(j, s * Vector3d::Unit(j).cross(arm));
    tangent.block<3, 1>(0, 3 + j) = friction;
    tangent.block<3, 1>(3, 3 + j) = arm.cross(friction);
  }
}

inline void fill_result(const Geometry& g, double normal_force, const Vector3d& friction, double radius, WallForce& out) noexcept
{
  out.normal_force = normal_force;
  out.normal = g.normal;
  out.force = friction - normal_force * g.normal;
  out.moment = radius * g.normal.cross(friction);
}

WallForce evaluate(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Vector3d& bristle,
                   const WallLaw& law, Tangent* tangent) noexcept
{
  WallForce out;
  const Geometry g = contact_geometry(closest, radius, motion.position);
  out.penetration = g.penetration;
  if (g.penetration <= 0.0)
  {
    if (tangent != nullptr)
    {
      tangent->setZero();
    }
    return out;
  }

  const NormalForce normal = normal_force(law.law, g.penetration, g.gradient.dot(motion.velocity));
  const double arm = lever(law, radius);
  const Friction f = friction_force(g, normal.value, closest.friction, arm, motion, bristle, law);
  fill_result(g, normal.value, f.force, arm, out);
  out.bristle = f.bristle;
  out.slipping = f.slipping;
  out.friction_power = f.force.dot(f.surface_velocity);

  if (tangent != nullptr)
  {
    write_tangent(closest, g, normal, f, arm, motion, law, *tangent);
  }
  return out;
}
}  // namespace

WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law) noexcept
{
  return evaluate(closest, radius, motion, bristle, law, nullptr);
}

WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  return evaluate(closest, radius, motion, bristle, law, &tangent);
}

WallForce sliding_wall_contact(const ClosestPoint& closest, double radius, const Eigen::Vector3d& position, const SlidingMotion& sliding,
                               const WallLaw& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  WallForce out;
  tangent.setZero();
  const Geometry g = contact_geometry(closest, radius, position);
  out.penetration = g.penetration;
  if (g.penetration <= 0.0)
  {
    return out;
  }

  const NormalForce normal = normal_force(law.law, g.penetration, 0.0);
  const double arm = lever(law, radius);
  const double rim_speed = sliding.spin_speed * arm;
  const double speed = std::hypot(sliding.axial_speed, rim_speed);
  const double axial = speed > 0.0 ? sliding.axial_speed / speed : 0.0;
  const double around = speed > 0.0 ? rim_speed / speed : 0.0;
  const Vector3d direction = axial * closest.tangent + around * closest.tangent.cross(g.normal);
  const double coefficient = sliding.share * closest.friction;
  const double limit = coefficient * normal.value;
  const Vector3d friction = -limit * direction;
  fill_result(g, normal.value, friction, arm, out);
  out.slipping = speed > 0.0;
  out.friction_power = -limit * speed;

  const Matrix3d b = normal_derivative(closest, g);
  const Vector3d gradient = normal.stiffness * g.gradient;
  for (int j = 0; j < 3; ++j)
  {
    const Vector3d bj = b.col(j);
    const Vector3d df = -coefficient * gradient[j] * direction - limit * around * closest.tangent.cross(bj);
    write_column_x(g, j, bj, normal.value, gradient[j], arm, friction, df, tangent);
  }
  return out;
}

}  // namespace drill_rig_sim
