// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/bit.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/bit_cut.h"
#include "drill_rig_sim/contact/bit_face.h"
#include "drill_rig_sim/contact/bit_torque.h"
#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
FormationLayer rock_of(const StageContext& at) noexcept
{
  return rock_under_bit(at.model, at.start);
}

/// Of the bit's face over the bottom's place at the start of the step [m].
double approach_of(const StageContext& at) noexcept
{
  const Vector3d to_bottom = at.start.well.bottom_position() - at.node(0).position;
  return at.model.mesh().bit_radius - to_bottom.dot(at.start.well.bottom_normal());
}

BottomForce drilled_bottom(const StageContext& at) noexcept
{
  const Vector3d down = at.start.well.bottom_normal();
  const FormationLayer rock = rock_of(at);
  const BitDrive& drive = at.stage.bit;
  const RockBreaking breaking{drilling_coefficient(rock, drive.drilling_speed), rock.weight_exponent, rock.threshold};
  const double approach = approach_of(at) - (drive.bottom_known ? drive.bottom_increment.dot(down) : 0.0);
  return bit_bottom_force(at.model.bit().bottom, approach, at.node(0).rate.head<3>().dot(down), breaking, drive.rock_time);
}

double bit_speed(const StageContext& at) noexcept
{
  return at.node(0).rate.tail<3>().dot(at.node(0).axis) + at.stage.bit.motor_speed;
}

TorqueLimit limit_under(const StageContext& at, const BottomForce& bottom, double speed) noexcept
{
  const BitSpec& bit = at.model.bit();
  return bit_torque_limit(bit.torque, bit.diameter, bottom.value, speed, rock_of(at));
}

BitTorque torque_under(const StageContext& at, const TorqueLimit& limit, double speed) noexcept
{
  return bit_torque(limit, at.model.bit_bristle_stiffness(), at.start.bit.twist, at.node(0).spin + at.stage.bit.motor_turn, speed,
                    at.stage.dv_du);
}

/// Resistance of the face that makes the torque: T = 2/3 a M, by torque [1/m].
double resistance_per_torque(const StageContext& at) noexcept
{
  return 1.5 / (at.model.mesh().bit_radius * rock_of(at).ring.lever);
}

BitFaceFriction face_friction(const StageContext& at, const TorqueLimit& limit, double speed) noexcept
{
  return bit_face_friction(resistance_per_torque(at) * limit.value, at.model.mesh().bit_radius, at.node(0).rate.head<3>(), speed,
                           at.start.well.bottom_normal());
}

/// Across the bottom, against the face's motion. `stiffness`: of the bottom's force by place, its damping included [N/m].
void put_on_face(const StageContext& at, const TorqueLimit& limit, double speed, double stiffness, const ForceRows& to) noexcept
{
  const BitFaceFriction face = face_friction(at, limit, speed);
  to.force(0).head<3>() += face.value;
  at.work.result.forces.bit_force -= face.value;
  if (!to.with_tangent()) return;
  const double c = at.stage.dv_du, per_torque = resistance_per_torque(at);
  const Vector3d by_speed = face.by_speed + (per_torque * limit.speed_slope * std::copysign(1.0, speed)) * face.by_resistance;
  auto d = to.slope(0);
  d.topLeftCorner<3, 3>() += c * face.by_velocity;
  d.topLeftCorner<3, 3>() +=
      (per_torque * limit.force_slope * stiffness) * face.by_resistance * at.start.well.bottom_normal().transpose();
  d.topRightCorner<3, 3>() += c * by_speed * at.node(0).axis.transpose();
}

/// What the rock does to the bit along the bottom's normal and about the bit's axis, and its slopes by the increments in the two.
struct RockLoad
{
  double force = 0.0;            ///< up the hole [N]
  double force_by_place = 0.0;   ///< [N/m]
  double force_by_spin = 0.0;    ///< [N/rad]
  double torque = 0.0;           ///< against clockwise turning [N m]
  double torque_by_place = 0.0;  ///< [N]
  double torque_by_spin = 0.0;   ///< [N m/rad]
};

RockLoad rock_load(const BottomForce& bottom, const BitTorque& torque, double damping_by_place) noexcept
{
  const double stiffness = bottom.stiffness + damping_by_place;
  return {bottom.value, stiffness, 0.0, torque.value, torque.force_slope * stiffness, torque.spin_slope};
}

/// Force and moment on node 0, and where the bit pushes the rock.
void put_on_bit(const StageContext& at, const RockLoad& rock, const ForceRows& to) noexcept
{
  const NodeMotion& node = at.node(0);
  const Vector3d down = at.start.well.bottom_normal();
  const Vector3d& n = node.axis;
  auto r = to.force(0);
  r.head<3>() += rock.force * down;
  r.tail<3>() += rock.torque * n;
  r[2] += bit_weight(at);
  if (to.with_tangent() && rock.force > 0.0)
  {
    auto d = to.slope(0);
    d.topLeftCorner<3, 3>() += rock.force_by_place * down * down.transpose();
    if (rock.force_by_spin != 0.0) d.topRightCorner<3, 3>() += rock.force_by_spin * down * n.transpose();
    d.bottomLeftCorner<3, 3>() += rock.torque_by_place * n * down.transpose();
    d.bottomRightCorner<3, 3>() += rock.torque_by_spin * n * n.transpose();
  }

  RigForces& forces = at.work.result.forces;
  forces.wob = rock.force;
  forces.bit_torque = rock.torque;
  const bool guided = at.stage.guides.guided[0] != 0;  // its side force is not known
  forces.bit_force = (guided ? Vector3d(Vector3d::Zero()) : forces.wall[0]) - rock.force * down;
  for (int i = 1; i < at.model.mesh().gauge_nodes && !guided; ++i) forces.bit_force += forces.wall[i];
  forces.bit_moment -= rock.torque * n;  // the wall left the gauge's share
  forces.motor_torque = -n.dot(forces.bit_moment);
  forces.rock_force = rock.force * down;
  if (guided || forces.contact[0] <= 0.0) return;
  const Vector3d outward = node.position - node.closest.centre;
  const double offset =
      std::sqrt(outward.squaredNorm() + wall_contact_smoothing * wall_contact_smoothing);  // as the wall's law has it
  forces.rock_force += (forces.contact[0] / offset) * outward;
}

/// Bristle, mean speed and mud motor at the stage.
void advance_bit(const StageContext& at, const BitTorque& torque) noexcept
{
  BitState& end = at.work.result.bit;
  end = at.start.bit;
  end.twist = torque.twist;
  end.turned += at.stage.bit.motor_turn;
  // what was not drilled with stays in the mean: the turns that drill are those that were made
  end.mean_speed -=
      std::expm1(-at.stage.time / at.model.bit().speed_lag) * (at.work.result.forces.bit_speed - at.stage.bit.drilling_speed);
  const MotorSpec* motor = at.model.motor();
  if (!motor) return;
  const double load = at.work.result.forces.motor_torque;
  const bool locked = at.start.faults.motor_locked;
  const MudMotorSpeed steady = locked ? MudMotorSpeed()
                                      : mud_motor_steady_speed(at.start.flow, motor->displacement_per_rev, motor->stall_torque,
                                                               motor->curve_exponent, load);
  end.motor_torque = load;
  end.motor_speed = advance_mud_motor(at.start.bit.motor_speed, steady, torque.spin_slope, at.stage.time);
  end.stalled = mud_motor_stalled(at.start.flow, motor->stall_torque, locked ? motor->stall_torque : load);
}

void add_mean_drilling(const StageContext& at, const ForceRows& to) noexcept
{
  StageResult& result = at.work.result;
  result.bottom = drilled_bottom(at);
  const double damping = at.stage.dv_du * result.bottom.damping, speed = result.forces.bit_speed;
  TorqueLimit limit;
  BitTorque torque;
  if (result.bottom.value > 0.0)
  {
    limit = limit_under(at, result.bottom, speed);
    torque = torque_under(at, limit, speed);
  }
  put_on_bit(at, rock_load(result.bottom, torque, damping), to);
  if (limit.value > 0.0) put_on_face(at, limit, speed, result.bottom.stiffness + damping, to);
  advance_bit(at, torque);
}

/// The bit over its ground at the stage; its flats are to be found.
BitCutPlace place_over_ground(const StageContext& at) noexcept
{
  const double turned = at.start.nodes[0].spin_angle + at.node(0).spin + at.start.bit.turned + at.stage.bit.motor_turn;
  return {turned, at.start.ground.mean + approach_of(at), 0.0};
}

/// The weight is all the rock's: nothing of it is held.
void take_weight(const CutWeight& weight, BitCutPlace& place, BottomForce& bottom) noexcept
{
  place.flats = weight.flats;
  bottom = {};
  bottom.value = weight.weight();
}

void add_cutting(const StageContext& at, const ForceRows& to) noexcept
{
  StageResult& result = at.work.result;
  const BitSpec& bit = at.model.bit();
  const FormationLayer& rock = rock_of(at);
  result.cut = place_over_ground(at);
  const GroundHeight ground = ground_ahead(at.start.ground, bit.torque.blades, result.cut.angle);
  const double sunk = at.node(0).increment.head<3>().dot(at.start.well.bottom_normal());
  const CutWeight weight =
      cut_weight(bit_cut_law(bit.torque, rock), result.cut.height - ground.value, sunk, at.start.ground.flats);
  take_weight(weight, result.cut, result.bottom);

  // the torque's limit, its slopes beside it
  const CutArms arms = cut_arms(bit.torque, bit.diameter, rock);
  const double flats_arm = weight.flats < bit.torque.wear_weight ? arms.flats : 0.0;
  const TorqueLimit limit{arms.cutters * weight.cutters + arms.flats * std::min(weight.flats, bit.torque.wear_weight), 1.0, 0.0};
  const double limit_by_depth = arms.cutters * weight.cutters_by_depth + flats_arm * weight.flats_by_depth;
  const double by_depth = weight.cutters_by_depth + weight.flats_by_depth;
  BitTorque torque;
  if (limit.value > 0.0) torque = torque_under(at, limit, result.forces.bit_speed);
  put_on_bit(at,
             {weight.weight(), by_depth + weight.flats_by_height, -by_depth * ground.slope, torque.value,
              torque.force_slope * (limit_by_depth + flats_arm * weight.flats_by_height),
              torque.spin_slope - torque.force_slope * limit_by_depth * ground.slope},
             to);
  advance_bit(at, torque);
}

void add_drilling(const StageContext& at, const ForceRows& to) noexcept
{
  at.work.result.forces.bit_speed = bit_speed(at);
  (at.model.regenerative() ? add_cutting : add_mean_drilling)(at, to);
}

/// The bit's weight at rest, on ground that is still even.
void find_resting_bottom(const StageContext& at) noexcept
{
  StageResult& result = at.work.result;
  if (!at.model.regenerative())
  {
    result.bottom = bit_bottom_force(at.model.bit().bottom, approach_of(at), 0.0, RockBreaking(), 0.0);
    return;
  }
  result.cut = place_over_ground(at);
  const CutWeight weight = resting_cut_weight(bit_cut_law(at.model.bit().torque, rock_of(at)), approach_of(at));
  take_weight(weight, result.cut, result.bottom);
  result.bottom.stiffness = weight.cutters_by_depth + weight.flats_by_depth;
}

void add_resting(const StageContext& at, const ForceRows& to) noexcept
{
  StageResult& result = at.work.result;
  find_resting_bottom(at);
  result.forces.bit_speed = 0.0;
  BitTorque torque;
  torque.value = result.bottom.value > 0.0 ? at.model.scene().start.torque_on_bit : 0.0;
  put_on_bit(at, rock_load(result.bottom, torque, 0.0), to);
}

void store_bit(const StageContext& at, StoredEnergy& energy) noexcept
{
  const StageResult& result = at.work.result;
  if (!at.model.regenerative()) energy.bottom += elastic_energy(at.model.bit().bottom, result.bottom.penetration);
  energy.bit_bristle += 0.5 * at.model.bit_bristle_stiffness() * result.bit.twist * result.bit.twist;
  energy.weight += bit_weight(at) * at.node(0).position.z();
}

void sample_bit(const StageContext& at, EnergySample& sample) noexcept
{
  const StageResult& result = at.work.result;
  const Vector3d down = at.start.well.bottom_normal();
  const bool regenerative = at.model.regenerative();  // what the bit then loses on its way the rock has
  sample.bottom_elastic = regenerative ? 0.0 : elastic_force(at.model.bit().bottom, result.bottom.penetration);
  sample.bottom_damped = result.bottom.value - sample.bottom_elastic;
  sample.bottom = sample.bottom_elastic * down;
  sample.bottom_damping = sample.bottom_damped * down;
  if (result.bottom.value > 0.0 && !regenerative)
    at_node(sample, NodeForce::friction, 0).head<3>() +=
        face_friction(at, limit_under(at, result.bottom, result.forces.bit_speed), result.forces.bit_speed).value;
  sample.rock_speed = regenerative ? at.node(0).rate.head<3>().dot(down) : result.bottom.speed;
  sample.rock_advance = at.stage.bit.bottom_known ? at.stage.bit.bottom_increment.dot(down) : result.bottom.advance;
  sample.bit_torque = result.forces.bit_torque;
  sample.bit_speed = result.forces.bit_speed;
  sample.motor_speed = at.stage.bit.motor_speed;
  const MotorSpec* motor = at.model.motor();
  sample.motor_flow_speed = motor ? mud_motor_flow_speed(at.start.flow, motor->pressure_displacement()) : 0.0;
}
}  // namespace

const Force bit_on_bottom = {"bit", Cost::bit, Sum::contact, add_drilling, add_resting, add_drilling, store_bit, sample_bit};

double bit_weight(const StageContext& at) noexcept
{
  const Mesh& mesh = at.model.mesh();
  return standard_gravity * (mesh.bit_mass - at.model.scene().mud.density * mesh.bit_displaced * at.stage.immersed[0]);
}

}  // namespace drill_rig_sim
