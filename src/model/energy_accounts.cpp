// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/energy_accounts.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
double EnergyAccounts::stored() const noexcept
{
  return last.kinetic_all() - first.kinetic_all() + last.elastic_all() - first.elastic_all();
}

double EnergyAccounts::dissipated() const noexcept
{
  return wall_friction + wall_damping + bottom_damping + squeeze_film + mud + structural + block + gearbox + motor_slip +
         stuck_point_released + ledge + added_mass;
}

double EnergyAccounts::numerical() const noexcept
{
  return of_inertia + of_beams + of_contact + of_line + of_residual + of_rebasing;
}

double EnergyAccounts::input_magnitudes() const noexcept
{
  // the floor takes up and down what gravity gives and takes
  return std::abs(winch) + std::abs(drive) + std::abs(pump) + std::abs(heave + gravity) + std::abs(steering) + std::abs(handled);
}

double EnergyAccounts::loss_magnitudes() const noexcept
{
  double sum = std::abs(rock_thrust) + std::abs(rock_torque);
  for (const double loss : {wall_friction, wall_damping, bottom_damping, squeeze_film, mud, structural, block, gearbox,
                            motor_slip, stuck_point_released, ledge, added_mass})
    sum += std::abs(loss);
  return sum;
}

double EnergyAccounts::numerical_magnitudes() const noexcept
{
  return std::abs(of_inertia) + std::abs(of_beams) + std::abs(of_contact) + std::abs(of_line) + std::abs(of_residual) +
         std::abs(of_rebasing);
}

double EnergyAccounts::residual() const noexcept
{
  return input() - stored() - dissipated() - broken_rock() - correction - numerical();
}

double EnergyAccounts::throughput() const noexcept
{
  return std::max(input_magnitudes(), largest_kinetic);
}

double EnergyAccounts::closure() const noexcept
{
  const double all = throughput();
  return all > 0.0 ? std::abs(residual()) / all : 0.0;
}

double EnergyAccounts::numerical_share() const noexcept
{
  const double all = throughput();
  return all > 0.0 ? numerical() / all : 0.0;
}

double EnergyAccounts::numerical_of_losses() const noexcept
{
  const double all = dissipated() + broken_rock() + numerical();
  return all != 0.0 ? numerical() / all : 0.0;
}

}  // namespace drill_rig_sim
