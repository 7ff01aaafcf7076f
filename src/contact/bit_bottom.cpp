// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/bit_bottom.h"

#include <cmath>
#include <limits>

#include "drill_rig_sim/contact/normal_law.h"

namespace drill_rig_sim
{
namespace
{
/// The contact's force if the rock took `force`, and its derivatives.
struct Trial
{
  RockBreakingSpeed rock;
  NormalForce contact;
};

Trial trial_force(const ContactLaw& law, double approach, double rate, const RockBreaking& rock, double step,
                  double force) noexcept
{
  Trial t;
  t.rock = rock_breaking_speed(rock, force);
  t.contact = normal_force(law, approach - step * t.rock.value, rate - t.rock.value);
  return t;
}

/// d(contact force)/d(rock-breaking speed), <= 0.
double speed_slope(const NormalForce& contact, double step) noexcept
{
  return -(step * contact.stiffness + contact.damping);
}

/// Root of F = contact(F) between the threshold and `upper`, where contact(upper) <= upper.
double solve_force(const ContactLaw& law, double approach, double rate, const RockBreaking& rock, double step,
                   double upper) noexcept
{
  constexpr int most_iterations = 100;
  constexpr double tolerance = 4.0 * std::numeric_limits<double>::epsilon();
  double low = rock.threshold;
  double high = upper;
  double force = upper;
  for (int i = 0; i < most_iterations && high - low > tolerance * high; ++i)
  {
    const Trial t = trial_force(law, approach, rate, rock, step, force);
    const double excess = force - t.contact.value;
    if (excess == 0.0)
    {
      return force;
    }
    (excess > 0.0 ? high : low) = force;
    const double next = force - excess / (1.0 - speed_slope(t.contact, step) * t.rock.slope);
    if (std::abs(next - force) <= tolerance * force)
    {
      return next;
    }
    // Newton where it stays inside the bracket, else halve it.
    force = next > low && next < high ? next : 0.5 * (low + high);
  }
  return force;
}
}  // namespace

RockBreakingSpeed rock_breaking_speed(const RockBreaking& rock, double force) noexcept
{
  const double excess = force - rock.threshold;
  if (excess <= 0.0 || rock.coefficient <= 0.0)
  {
    return {};
  }
  const double per_excess = rock.exponent == 1.0 ? rock.coefficient : rock.coefficient * std::pow(excess, rock.exponent - 1.0);
  return {per_excess * excess, rock.exponent * per_excess};
}

BottomForce bit_bottom_force(const ContactLaw& law, double approach, double rate, const RockBreaking& rock, double step) noexcept
{
  BottomForce out;
  out.penetration = approach;

  // on a bottom that does not give way
  const NormalForce firm = normal_force(law, approach, rate);
  out.value = firm.value;
  out.stiffness = firm.stiffness;
  out.damping = firm.damping;
  if (firm.value <= rock.threshold || rock.coefficient <= 0.0)
  {
    return out;
  }

  out.value = solve_force(law, approach, rate, rock, step, firm.value);
  const Trial t = trial_force(law, approach, rate, rock, step, out.value);
  const double give = 1.0 - speed_slope(t.contact, step) * t.rock.slope;
  out.stiffness = t.contact.stiffness / give;
  out.damping = t.contact.damping / give;
  out.speed = t.rock.value;
  out.advance = step * t.rock.value;
  out.penetration = approach - out.advance;
  return out;
}

}  // namespace drill_rig_sim
