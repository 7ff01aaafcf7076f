// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/bit_torque.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/bit_bottom.h"

namespace drill_rig_sim
{
TorqueLimit stribeck_bit_torque(const BitTorqueSpec& spec, double diameter, double force, double speed) noexcept
{
  const double excess = (spec.static_friction - spec.kinetic_friction) * std::exp(-std::abs(speed) / spec.speed);
  const double arm = diameter / 3.0;
  const double weight = std::max(0.0, force);
  TorqueLimit out;
  out.force_slope = force > 0.0 ? (spec.kinetic_friction + excess) * arm : 0.0;
  out.value = out.force_slope * weight;
  out.speed_slope = -excess / spec.speed * weight * arm;
  return out;
}

double implied_inclination(double diameter, double drillability, double cutting_energy) noexcept
{
  return 1.0 / (pi * diameter * drillability * cutting_energy);
}

namespace
{
/// Of the cutters alone.
TorqueLimit cutting_torque(const BitTorqueSpec& spec, double a, double force, double speed, const FormationLayer& rock) noexcept
{
  constexpr double least_speed = 1.0;
  if (spec.cutting_energy <= 0.0)
  {
    const double arm = 0.5 * a / cutter_inclination;
    return {arm * std::max(0.0, force - rock.threshold), force > rock.threshold ? arm : 0.0, 0.0};
  }
  const double turning = std::max(least_speed, std::abs(speed));
  const double per_turn = 2.0 * pi * std::pow(turning, rock.speed_exponent - 1.0);
  const RockBreakingSpeed v = rock_breaking_speed({rock.drillability * per_turn, rock.weight_exponent, rock.threshold}, force);
  const double per_depth = 0.5 * spec.cutting_energy * a * a * rock.ring.share;
  return {per_depth * v.value, per_depth * v.slope,
          std::abs(speed) > least_speed ? per_depth * v.value * (rock.speed_exponent - 1.0) / turning : 0.0};
}
}  // namespace

TorqueLimit detournay_bit_torque(const BitTorqueSpec& spec, double diameter, double force, double speed,
                                 const FormationLayer& rock) noexcept
{
  const double a = 0.5 * diameter;
  const double rubbing = 0.5 * spec.wear_friction * a;  // torque per weight on the flats
  TorqueLimit out = cutting_torque(spec, a, force, speed, rock);
  const double flats = std::max(0.0, spec.wear_weight * rock.ring.share);
  out.value += rubbing * std::clamp(force, 0.0, flats);
  out.force_slope += force > 0.0 && force < flats ? rubbing : 0.0;
  return out;
}

namespace
{
/// A face that rubs, whatever the rock.
TorqueLimit limit_of_face(const BitTorqueSpec& spec, double diameter, double force, double speed, const FormationLayer&) noexcept
{
  return stribeck_bit_torque(spec, diameter, force, speed);
}

/// By BitTorqueModel.
constexpr decltype(&detournay_bit_torque) limits[] = {
#define BIT_LAW(name, limit, ...) limit,
#include "drill_rig_sim/contact/bit_law_list.h"
};
}  // namespace

TorqueLimit bit_torque_limit(const BitTorqueSpec& spec, double diameter, double force, double speed,
                             const FormationLayer& rock) noexcept
{
  TorqueLimit out = limits[static_cast<int>(spec.model)](spec, diameter, force, speed, rock);
  if (rock.ring.lever == 1.0) return out;
  out.value *= rock.ring.lever;
  out.force_slope *= rock.ring.lever;
  out.speed_slope *= rock.ring.lever;
  return out;
}

BitTorque bit_torque(const TorqueLimit& limit, double stiffness, double twist, double slip, double speed,
                     double speed_coefficient) noexcept
{
  const double trial = twist + slip;
  BitTorque out;
  if (std::abs(stiffness * trial) <= limit.value)
  {
    out.value = stiffness * trial;
    out.spin_slope = stiffness;
    out.twist = trial;
    return out;
  }

  const double sign = trial > 0.0 ? 1.0 : -1.0;
  out.value = sign * limit.value;
  out.spin_slope = sign * limit.speed_slope * std::copysign(speed_coefficient, speed);
  out.force_slope = sign * limit.force_slope;
  out.twist = out.value / stiffness;
  out.slipping = true;
  return out;
}

double bit_bristle_stiffness(const BitTorqueSpec& spec, double diameter) noexcept
{
  constexpr double weight_per_diameter = 300e3;
  constexpr double breakaway_twist = 0.01;
  return spec.static_friction * weight_per_diameter * diameter * diameter / 3.0 / breakaway_twist;
}

}  // namespace drill_rig_sim
