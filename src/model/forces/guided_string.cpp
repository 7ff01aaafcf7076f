#include "drill_rig_sim/model/forces/guided_string.h"

#include <cmath>

#include "drill_rig_sim/contact/surface_friction.h"
#include "drill_rig_sim/model/forces/beams.h"
#include "drill_rig_sim/model/forces/bit.h"
#include "drill_rig_sim/model/forces/inertia.h"

namespace drill_rig_sim
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Rows = Eigen::Matrix<double, 2, 6>;
using Columns = Eigen::Matrix<double, 6, 2>;

namespace
{
constexpr double kSmooth = 1.0;  // of the load on the wall, where it changes sides [N]

const Guide& guide_of(const StageContext& at, int i) noexcept
{
  return at.stage.guides[static_cast<std::size_t>(i)];
}

bool gauge(const StageContext& at, int i) noexcept
{
  return i < at.model.mesh().gauge_nodes;
}

bool guided_element(const StageContext& at, int e) noexcept
{
  return at.stage.guided_spans[static_cast<std::size_t>(e)].guided;
}

/// Of a node's six numbers, along the hole and about it.
Vector2d along_and_about(const Guide& guide, const Vector6d& v) noexcept
{
  return {guide.tangent.dot(v.head<3>()), guide.tangent.dot(v.tail<3>())};
}

/// T: what a node's coordinates do to its six.
Columns motions(const Guide& guide) noexcept
{
  Columns t;
  t << guide.tangent, Vector3d::Zero(), guide.turn, guide.tangent;
  return t;
}

Vector2d increment(const StageContext& at, int i) noexcept
{
  return along_and_about(guide_of(at, i), at.work.nodes[i].increment);
}

Vector2d rate(const StageContext& at, int i) noexcept
{
  return along_and_about(guide_of(at, i), at.work.nodes[i].rate);
}

/// EA/L and GJ/L.
Vector2d stiffness(const StageContext& at, int e) noexcept
{
  const BeamSection& section = at.model.mesh().elements[e].section;
  return {section.axial / section.length, section.torsion};
}

/// Stretch [m] and twist [rad] at the stage.
Vector2d strain(const StageContext& at, int e) noexcept
{
  const GuidedSpan& span = at.stage.guided_spans[static_cast<std::size_t>(e)];
  const Vector2d start(span.stretch * at.model.mesh().elements[e].section.length, span.twist);
  return start + increment(at, e) - increment(at, e + 1);
}

/// Tension and torque, elastic part.
Vector2d elastic(const StageContext& at, int e) noexcept
{
  return stiffness(at, e).cwiseProduct(strain(at, e));
}

/// And what structural damping adds.
Vector2d damping(const StageContext& at, int e) noexcept
{
  return at.stage.structural_damping * stiffness(at, e).cwiseProduct(rate(at, e) - rate(at, e + 1));
}

/// Of a node, without its wall: force along the hole and torque about it, in the residual's sign.
Vector2d inertia_of(const StageContext& at, int i) noexcept
{
  const RigidBody body = node_body(at.model, at.stage, i);
  return Vector2d(body.mass, body.spin_inertia).cwiseProduct(along_and_about(guide_of(at, i), at.work.nodes[i].acceleration));
}

Vector2d mud_damping(const StageContext& at, int i) noexcept
{
  const MudSpec& mud = at.model.scene().mud;
  return at.stage.immersed[static_cast<std::size_t>(i)] * at.model.mesh().nodes[i].length * Vector2d(mud.axial_damping, mud.torsional_damping);
}

Vector2d mud_of(const StageContext& at, int i) noexcept
{
  return mud_damping(at, i).cwiseProduct(rate(at, i));
}

/// Where a node's wall stands: load, its size, normal force.
struct Load
{
  Vector3d direction = Vector3d::Zero();  ///< of P, times |P|/Q'
  double size = 0.0;                      ///< Q [N]
  double normal = 0.0;                    ///< N [N]
  double normal_by_size = 1.0;            ///< dN/dQ
};

/// Q = sqrt(P^2 + q^2) - q: smooth where the load changes sides.
Load load_of(const Guide& guide, const Vector3d& push) noexcept
{
  Load load;
  const double smoothed = std::sqrt(push.squaredNorm() + kSmooth * kSmooth);
  load.direction = push / smoothed;
  load.size = smoothed - kSmooth;
  const double least = load.size * load.size / (1.0 + guide.friction * guide.friction);
  const double square = load.size * load.size - guide.held * guide.held;
  load.normal = std::sqrt(std::max(square, least));
  if (load.normal > 0.0) load.normal_by_size = square > least ? load.size / load.normal : load.normal / load.size;
  return load;
}

/// Friction at a node, with its slopes: by its own coordinates (rim, not angle), and by Q.
struct NodeFriction
{
  Vector2d force = Vector2d::Zero();  ///< wall on string, at the rim [N]
  Vector2d bristle = Vector2d::Zero();
  Matrix2d by_displacement = Matrix2d::Zero();
  Vector2d by_load = Vector2d::Zero();
  bool slipping = false;
};

SurfaceMotion surface_motion(const StageContext& at, int i) noexcept
{
  const Vector2d lever(1.0, guide_of(at, i).lever);
  SurfaceMotion motion;
  motion.displacement = increment(at, i);
  motion.velocity = rate(at, i);
  if (gauge(at, i))  // turns with the motor
  {
    motion.displacement.y() += at.stage.bit.motor_turn;
    motion.velocity.y() += at.stage.bit.motor_speed;
  }
  motion.displacement = lever.cwiseProduct(motion.displacement);
  motion.velocity = lever.cwiseProduct(motion.velocity);
  motion.velocity_coefficient = at.stage.dv_du;
  motion.time = at.stage.time;
  return motion;
}

NodeFriction sticking_friction(const StageContext& at, int i, const Load& load) noexcept
{
  const Guide& guide = guide_of(at, i);
  if (!(load.normal > 0.0) || !(guide.friction > 0.0)) return {};
  const SurfaceFriction f = surface_friction(load.normal, guide.friction, surface_motion(at, i), at.start.nodes[i].bristle.head<2>(), guide.law);
  return {f.force, f.bristle, f.by_displacement, load.normal_by_size * f.by_normal_force, f.slipping};
}

NodeFriction sliding_friction(const StageContext& at, int i, const Load& load) noexcept
{
  const Guide& guide = guide_of(at, i);
  const SlidingMotion& sliding = at.stage.sliding;
  const Vector2d motion(sliding.axial_speed, sliding.spin_speed * guide.lever);
  const double speed = motion.norm();
  if (!(speed > 0.0)) return {};
  const Vector2d mu = sliding.share * guide.friction / speed * motion;
  const double normal_by_size = 1.0 / std::sqrt(1.0 + mu.y() * mu.y());
  NodeFriction out;
  out.by_load = -normal_by_size * mu;
  out.force = load.size * out.by_load;
  out.slipping = true;
  return out;
}

using FrictionAtNode = NodeFriction (*)(const StageContext&, int, const Load&) noexcept;

/// Tensions and torques of the guided elements, damping included.
void find_tensions(const StageContext& at) noexcept
{
  for (int e = 0; e < at.model.elements(); ++e)
    if (guided_element(at, e)) at.work.guided_forces[static_cast<std::size_t>(e)] = elastic(at, e) + damping(at, e);
}

Vector2d element_force(const StageContext& at, int e) noexcept
{
  if (e < 0 || e >= at.model.elements() || !guided_element(at, e)) return Vector2d::Zero();
  return at.work.guided_forces[static_cast<std::size_t>(e)];
}

/// The part across the hole.
Vector3d across(const Guide& guide, const Vector3d& v) noexcept
{
  return v - guide.tangent * guide.tangent.dot(v);
}

/// What guided neighbours, weight and the bit's weight push a node to its wall with.
Vector3d lean_of(const StageContext& at, int i) noexcept
{
  const Guide& guide = guide_of(at, i);
  Vector3d push = element_force(at, i).x() * guide.above + element_force(at, i - 1).x() * guide.below + guide.weight;
  if (i == 0) push.z() -= bit_weight(at);
  return across(guide, push);
}

/// What pushes a node to its wall. `residual`: what other forces gave it; of the gauge, whose friction loads the motor before they are all there, that is
/// left out, and of what is guided there is none.
Vector3d push_of(const StageContext& at, int i, const double* residual) noexcept
{
  const Guide& guide = guide_of(at, i);
  const Vector3d lean = lean_of(at, i);
  if (!guide.joined || gauge(at, i)) return lean;
  return lean - across(guide, Eigen::Map<const Vector3d>(residual + 6 * i));
}

/// dF/dx of a guided element, structural damping included; 0 for others.
Vector2d element_stiffness(const StageContext& at, int e) noexcept
{
  if (e < 0 || e >= at.model.elements() || !guided_element(at, e)) return Vector2d::Zero();
  return (1.0 + at.stage.dv_du * at.stage.structural_damping) * stiffness(at, e);
}

/// The small blocks of row i but for what other forces gave in six coordinates.
void write_small_rows(const StageContext& at, int i, const Load& load, const NodeFriction& friction, BlockTridiagonal& tangent) noexcept
{
  const Guide& guide = guide_of(at, i);
  const Vector2d above = element_stiffness(at, i), below = element_stiffness(at, i - 1);
  const Vector2d lever(1.0, guide.lever);
  const Vector2d by_load = -lever.cwiseProduct(friction.by_load);  // of the residual
  const Vector2d by_above = (load.direction.dot(guide.above) * above.x()) * by_load;  // by the stretch above
  const Vector2d by_below = (load.direction.dot(guide.below) * below.x()) * by_load;
  const RigidBody body = node_body(at.model, at.stage, i);
  Matrix2d diagonal = lever.asDiagonal() * -friction.by_displacement * lever.asDiagonal();
  diagonal.diagonal() += above + below + at.stage.da_du * Vector2d(body.mass, body.spin_inertia) + at.stage.dv_du * mud_damping(at, i);
  diagonal.col(0) += by_above - by_below;
  tangent.small_diagonal(i) = diagonal;
  if (i < at.model.top() && guided_element(at, i))
  {
    tangent.small_upper(i) = (-above).asDiagonal();
    tangent.small_upper(i).col(0) -= by_above;
  }
  if (i > 0 && guided_element(at, i - 1))
  {
    tangent.small_lower(i - 1) = (-below).asDiagonal();
    tangent.small_lower(i - 1).col(0) += by_below;
  }
}

/// What other forces gave in six coordinates, brought down to two. `by_load`: of the residual by the load on the wall, which the residual's force across
/// the hole makes.
void reduce_rows(const StageContext& at, int i, const Load& load, const Vector2d& by_load, BlockTridiagonal& tangent) noexcept
{
  const Guide& guide = guide_of(at, i);
  const Columns t = motions(guide);
  Rows rows = t.transpose();
  rows.leftCols<3>() -= by_load * load.direction.transpose();
  tangent.small_diagonal(i) += rows * tangent.diagonal(i) * t;
  const auto reduce_off = [&](BlockTridiagonal::Block in_row, BlockTridiagonal::Block in_column)
  {
    const Rows reduced = rows * in_row;
    const Columns other = in_column * t;
    in_row.setZero();
    in_row.topRows<2>() = reduced;
    in_column.setZero();
    in_column.leftCols<2>() = other;
  };
  if (i < at.model.top() && !guide_of(at, i + 1).guided) reduce_off(tangent.upper(i), tangent.lower(i));
  if (i > 0 && !guide_of(at, i - 1).guided) reduce_off(tangent.lower(i - 1), tangent.upper(i - 1));
}

/// The load turned by how far friction `around` the pipe [N] makes it climb: the wall's normal force N and F balance P if it lies on the side n = (N P + F t x P)/Q^2.
Vector3d climbed(const Guide& guide, const Vector3d& push, double around) noexcept
{
  const double square = push.squaredNorm();
  if (!(square > around * around)) return push;
  return (std::sqrt(square - around * around) * push + around * guide.tangent.cross(push)) / std::sqrt(square);
}

void write_results(const StageContext& at, int i, const Vector3d& push, const Load& load, const NodeFriction& friction) noexcept
{
  const Guide& guide = guide_of(at, i);
  StageResult& result = at.work.result;
  result.bristle[i] << friction.bristle, 0.0;
  result.rest[i] = load.normal > 0.0 && guide.friction > 0.0 && !friction.slipping ? at.start.nodes[i].rest + at.stage.time : 0.0;
  result.forces.contact[i] = load.normal;
  result.forces.wall[i] = friction.force.x() * guide.tangent - push;
  at.work.push[i] = push;
  at.work.lean[i] = climbed(guide, lean_of(at, i), friction.force.y());
}

template <FrictionAtNode friction_at>
void add_at(const StageContext& at, int i, double* residual, BlockTridiagonal* tangent) noexcept
{
  const Guide& guide = guide_of(at, i);
  auto r = at_node(residual, i);
  const Vector2d above = element_force(at, i), below = element_force(at, i - 1);
  Vector2d row = above - below + inertia_of(at, i) + mud_of(at, i);
  row.x() -= guide.tangent.dot(guide.weight);
  if (guide.joined) row += motions(guide).transpose() * r;
  const Vector3d push = push_of(at, i, residual);
  const Load load = load_of(guide, push);
  const NodeFriction friction = friction_at(at, i, load);
  const Vector2d lever(1.0, guide.lever);
  row -= lever.cwiseProduct(friction.force);
  r.head<3>() = row.x() * guide.tangent;
  r.tail<3>() = row.y() * guide.tangent;
  write_results(at, i, push, load, friction);
  if (!tangent) return;
  write_small_rows(at, i, load, friction, *tangent);
  if (guide.joined) reduce_rows(at, i, load, gauge(at, i) ? Vector2d(0.0, 0.0) : Vector2d(-lever.cwiseProduct(friction.by_load)), *tangent);
}

template <FrictionAtNode friction_at>
void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  if (!at.stage.any_guided) return;
  find_tensions(at);
  for (int i = 0; i < at.model.nodes(); ++i)
    if (guide_of(at, i).guided) add_at<friction_at>(at, i, residual, tangent);
}

void store(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
    if (guided_element(at, e)) energy.beams += 0.5 * elastic(at, e).dot(strain(at, e));
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const RigidBody body = node_body(at.model, at.stage, i);
    const Vector2d v = rate(at, i);
    energy.kinetic += 0.5 * body.mass * v.x() * v.x();
    energy.turning += 0.5 * body.spin_inertia * v.y() * v.y();
    energy.bristles += 0.5 * guide.law.tangential_stiffness * at.work.result.bristle[i].squaredNorm();
    energy.weight -= guide.weight.dot(at.start.nodes[i].position + increment(at, i).x() * guide.tangent);
  }
}

void add_to(EnergySample& sample, NodeForce kind, int i, const Guide& guide, const Vector2d& force) noexcept
{
  auto at = at_node(sample, kind, i);
  at.head<3>() += force.x() * guide.tangent;
  at.tail<3>() += force.y() * guide.tangent;
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    if (!guided_element(at, e)) continue;
    const Guide &lower = guide_of(at, e), &upper = guide_of(at, e + 1);
    const Vector2d held = elastic(at, e), damped = damping(at, e);
    add_to(sample, NodeForce::beams, e, lower, held);
    add_to(sample, NodeForce::beams, e + 1, upper, -held);
    add_to(sample, NodeForce::structural, e, lower, damped);
    add_to(sample, NodeForce::structural, e + 1, upper, -damped);
  }
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const NodeFriction friction = sticking_friction(at, i, load_of(guide, at.work.push[i]));
    const double torque = guide.lever * friction.force.y();
    add_to(sample, NodeForce::inertia, i, guide, inertia_of(at, i));
    add_to(sample, NodeForce::mud, i, guide, mud_of(at, i));
    add_to(sample, NodeForce::friction, i, guide, {-friction.force.x(), -torque});
    if (gauge(at, i)) sample.gauge_torque -= torque;
  }
}

void add_gauge(const StageContext& at, double*, BlockTridiagonal*) noexcept
{
  if (!at.stage.any_guided) return;
  find_tensions(at);
  for (int i = 0; gauge(at, i); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const Vector3d push = push_of(at, i, nullptr);
    const NodeFriction friction = sticking_friction(at, i, load_of(guide, push));
    at.work.result.forces.bit_moment += (guide.lever * friction.force.y()) * guide.tangent;
  }
}

void add_beams_at_guides(const StageContext& at, double* residual, BlockTridiagonal*) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    if (guide_of(at, e).guided == guide_of(at, e + 1).guided) continue;
    const Vector3d force = element_forces(at, e).force, half = 0.5 * at.stage.load[e];
    at_node(residual, e).head<3>() += force - half;
    at_node(residual, e + 1).head<3>() -= force + half;
  }
}
}  // namespace

const Force guided_string = {"guided string", Cost::guided, add<sticking_friction>, store, sample};
const Force sliding_guided_string = {"sliding guided string", Cost::guided, add<sliding_friction>, nullptr, nullptr};
const Force guided_gauge = {"guided gauge", Cost::guided, add_gauge, nullptr, nullptr};
const Force beams_at_guides = {"beams at guided nodes", Cost::guided, add_beams_at_guides, nullptr, nullptr};

}  // namespace drill_rig_sim
