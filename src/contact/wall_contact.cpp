#include "drill_rig_sim/contact/wall_contact.h"

#include "drill_rig_sim/contact/friction_law.h"
#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Tangent = Eigen::Ref<Eigen::Matrix<double, 6, 6>>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Where section and wall meet.
struct Geometry
{
  Vector3d normal;    ///< n
  Vector3d gradient;  ///< d delta / d r_D
  Vector3d slope;     ///< P dC/ds
  double rho;
  double penetration;  ///< delta
};

/// [a x m_1, a x m_2, a x m_3].
Matrix3d cross_columns(const Vector3d& a, const Matrix3d& m) noexcept
{
  Matrix3d out;
  for (int j = 0; j < 3; ++j)
  {
    out.col(j) = a.cross(m.col(j));
  }
  return out;
}

Geometry contact_geometry(const HoleSite& site, double radius, const Vector3d& position) noexcept
{
  const Vector3d d = position - site.centre;
  Geometry g;
  g.rho = std::sqrt(d.squaredNorm() + wall_contact_smoothing * wall_contact_smoothing);
  g.penetration = g.rho - (site.radius - radius);  // digit for digit -wall_gap()
  g.normal = d / g.rho;
  g.gradient = g.normal - site.radius_slope * site.md_gradient;
  g.slope = site.centre_slope - g.normal * g.normal.dot(site.centre_slope);
  return g;
}

/// B = dn/dr_D = (1 - n n^T - P c' (ds/dr_D)^T) / rho.
Matrix3d normal_derivative(const HoleSite& site, const Geometry& g) noexcept
{
  Matrix3d b = -g.normal * g.normal.transpose() - g.slope * site.md_gradient.transpose();
  b.diagonal().array() += 1.0;
  return b / g.rho;
}

/// The friction's part of a contact: force on the string and, where asked, its derivatives.
struct Friction
{
  Vector3d force = Vector3d::Zero();
  Vector3d bristle = Vector3d::Zero();
  Vector3d surface_velocity = Vector3d::Zero();
  Vector3d total_slip = Vector3d::Zero();      ///< z_n + slip, before projection
  Vector3d direction = Vector3d::Zero();       ///< z_t / |z_t|
  Vector3d slip_direction = Vector3d::Zero();  ///< v_t / |v_t|, or zero at rest
  double trial_length = 0.0;                   ///< |z_t|
  FrictionCoefficient mu;
  bool slipping = false;
};

/// Return mapping of the bristle.
Friction friction_force(const Geometry& g, double normal_force, double kinetic, double radius, const ContactMotion& motion,
                        const Vector3d& bristle, const ContactSpec& law) noexcept
{
  const Vector3d arm = radius * g.normal;
  Friction f;
  f.surface_velocity = motion.velocity + motion.angular_velocity.cross(arm);
  f.total_slip = bristle + motion.displacement + motion.rotation.cross(arm);
  const Vector3d trial = f.total_slip - g.normal * g.normal.dot(f.total_slip);
  f.trial_length = trial.norm();
  f.force = -law.tangential_stiffness * trial;
  f.bristle = trial;

  // Friction is never below kinetic: what kinetic friction holds, sticks, without a look at the Stribeck curve.
  const double pull = law.tangential_stiffness * f.trial_length;
  if (pull <= kinetic * normal_force)
  {
    return f;
  }

  const Vector3d slip_velocity = f.surface_velocity - g.normal * g.normal.dot(f.surface_velocity);
  const double speed = slip_velocity.norm();
  f.mu = stribeck_friction(kinetic, law.static_ratio, law.stribeck_speed, speed);
  const double limit = f.mu.value * normal_force;
  if (pull <= limit)
  {
    return f;
  }

  f.slipping = true;
  f.direction = trial / f.trial_length;
  f.force = -limit * f.direction;
  f.bristle = (limit / law.tangential_stiffness) * f.direction;
  if (speed > 0.0)
  {
    f.slip_direction = slip_velocity / speed;
  }
  return f;
}

/// d z_t/d(x, r). The part of r is -P skew(R_D n) = -skew(R_D n).
Matrix36 trial_derivative(const Geometry& g, const Matrix3d& b, double radius, const ContactMotion& motion,
                          const Vector3d& total_slip) noexcept
{
  const Vector3d y = radius * g.normal.cross(motion.rotation) + total_slip;
  const Vector3d row = g.normal + b.transpose() * y;
  Matrix36 out;
  out.leftCols<3>() = radius * cross_columns(motion.rotation, b) - g.normal.dot(total_slip) * b - g.normal * row.transpose();
  out.leftCols<3>().diagonal().array() += 1.0;
  out.rightCols<3>() = -radius * skew(g.normal);
  return out;
}

/// d friction/d(x, r), given dF_n/dx.
Matrix36 friction_derivative(const Geometry& g, const Matrix3d& b, const Friction& f, double normal_force,
                             const Vector3d& normal_force_gradient, double radius, const ContactMotion& motion,
                             const ContactSpec& law) noexcept
{
  Matrix36 dz = trial_derivative(g, b, radius, motion, f.total_slip);
  if (!f.slipping)
  {
    return -law.tangential_stiffness * dz;
  }

  // d|v_t| = e . dv_s - (n . v_s) e . dn, with e = v_t/|v_t|
  const Vector3d& e = f.slip_direction;
  const double c = motion.velocity_coefficient;
  const Vector3d through_normal = radius * e.cross(motion.angular_velocity) - g.normal.dot(f.surface_velocity) * e;
  const double speed_factor = f.mu.slope * normal_force;
  Eigen::Matrix<double, 1, 6> limit_row;
  limit_row.head<3>() =
      (f.mu.value * normal_force_gradient + speed_factor * (c * e + b.transpose() * through_normal)).transpose();
  limit_row.tail<3>() = (speed_factor * c * radius * g.normal.cross(e)).transpose();

  const double turn = f.mu.value * normal_force / f.trial_length;
  limit_row -= turn * (f.direction.transpose() * dz);
  dz *= -turn;
  dz.noalias() -= f.direction * limit_row;
  return dz;
}

/// d(force, moment)/d(x, r) from the derivatives of its parts.
void assemble_tangent(const Geometry& g, const Matrix3d& b, double normal_force, const Vector3d& normal_force_gradient,
                      double radius, const Vector3d& friction, const Matrix36& friction_tangent, Tangent tangent) noexcept
{
  tangent.topRows<3>() = friction_tangent;
  tangent.topLeftCorner<3, 3>() -= g.normal * normal_force_gradient.transpose() + normal_force * b;

  const Vector3d arm = radius * g.normal;
  for (int j = 0; j < 6; ++j)
  {
    tangent.block<3, 1>(3, j) = arm.cross(friction_tangent.col(j));
  }
  tangent.bottomLeftCorner<3, 3>() -= cross_columns(radius * friction, b);
}

void fill_result(const Geometry& g, double normal_force, const Vector3d& friction, double radius, WallForce& out) noexcept
{
  out.normal_force = normal_force;
  out.force = friction - normal_force * g.normal;
  out.moment = radius * g.normal.cross(friction);
}

WallForce evaluate(const HoleSite& site, double radius, const ContactMotion& motion, const Vector3d& bristle,
                   const ContactSpec& law, Tangent* tangent) noexcept
{
  WallForce out;
  const Geometry g = contact_geometry(site, radius, motion.position);
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
  const Friction f = friction_force(g, normal.value, site.friction, radius, motion, bristle, law);
  fill_result(g, normal.value, f.force, radius, out);
  out.bristle = f.bristle;
  out.slipping = f.slipping;
  out.friction_power = f.force.dot(f.surface_velocity);

  if (tangent != nullptr)
  {
    const Matrix3d b = normal_derivative(site, g);
    const Vector3d gradient = (normal.stiffness + motion.velocity_coefficient * normal.damping) * g.gradient +
                              normal.damping * (b.transpose() * motion.velocity);
    const Matrix36 df = friction_derivative(g, b, f, normal.value, gradient, radius, motion, law);
    assemble_tangent(g, b, normal.value, gradient, radius, f.force, df, *tangent);
  }
  return out;
}
}  // namespace

WallForce wall_contact(const HoleSite& site, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const ContactSpec& law) noexcept
{
  return evaluate(site, radius, motion, bristle, law, nullptr);
}

WallForce wall_contact(const HoleSite& site, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const ContactSpec& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  return evaluate(site, radius, motion, bristle, law, &tangent);
}

WallForce sliding_wall_contact(const HoleSite& site, double radius, const Eigen::Vector3d& position, const SlidingMotion& sliding,
                               const ContactLaw& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  WallForce out;
  tangent.setZero();
  const Geometry g = contact_geometry(site, radius, position);
  out.penetration = g.penetration;
  if (g.penetration <= 0.0)
  {
    return out;
  }

  const NormalForce normal = normal_force(law, g.penetration, 0.0);
  const double rim_speed = sliding.spin_speed * radius;
  const double speed = std::hypot(sliding.axial_speed, rim_speed);
  const double axial = speed > 0.0 ? sliding.axial_speed / speed : 0.0;
  const double around = speed > 0.0 ? rim_speed / speed : 0.0;
  const Vector3d direction = axial * site.tangent + around * site.tangent.cross(g.normal);
  const double limit = site.friction * normal.value;
  const Vector3d friction = -limit * direction;
  fill_result(g, normal.value, friction, radius, out);
  out.slipping = speed > 0.0;
  out.friction_power = -limit * speed;

  const Matrix3d b = normal_derivative(site, g);
  const Vector3d gradient = normal.stiffness * g.gradient;
  Matrix36 df = Matrix36::Zero();
  df.leftCols<3>() = -site.friction * direction * gradient.transpose() - limit * around * cross_columns(site.tangent, b);
  assemble_tangent(g, b, normal.value, gradient, radius, friction, df, tangent);
  return out;
}

}  // namespace drill_rig_sim
